"""The library's search for an equilibrium, with the matrices and solvers of Python.

    find, check  ->  requests, outcome  ->  adjoint  ->  at_equilibrium, coloured
                 ->  closed, saddle  ->  bodies, start  ->  likely, together, linear, condensed  ->  host, unknowns
"""

from .adjoint import Adjoint
from .bodies import TANGENTS
from .check import check_host
from .find import find_equilibrium
from .host import Host, Refused
from .outcome import Equilibrium, NoSupportError, NotConvergedError

__all__ = ["TANGENTS", "Adjoint", "Equilibrium", "Host", "NoSupportError", "NotConvergedError", "Refused", "check_host", "find_equilibrium"]
