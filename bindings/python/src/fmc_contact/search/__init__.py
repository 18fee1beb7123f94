"""The library's search for an equilibrium, with the matrices and solvers of Python.

    history  ->  history_step  ->  history_slopes
    find, check  ->  requests, outcome  ->  adjoint  ->  at_equilibrium, coloured
                 ->  closed, saddle  ->  bodies, start  ->  likely, together, linear, condensed  ->  host, unknowns
"""

from .adjoint import Adjoint
from .bodies import TANGENTS
from .check import check_host
from .find import find_equilibrium
from .history import History, HistoryStart
from .history_step import StepAdjoint
from .host import Host, Refused
from .outcome import Equilibrium, NoSupportError, NotConvergedError

__all__ = [
    "TANGENTS",
    "Adjoint",
    "Equilibrium",
    "History",
    "HistoryStart",
    "Host",
    "NoSupportError",
    "NotConvergedError",
    "Refused",
    "StepAdjoint",
    "check_host",
    "find_equilibrium",
]
