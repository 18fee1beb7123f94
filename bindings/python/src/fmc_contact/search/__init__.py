"""The library's search for an equilibrium, with the matrices and solvers of Python.

    find, check  ->  requests  ->  bodies, unknowns  ->  linear, condensed  ->  outcome
"""

from .check import check_host
from .find import find_equilibrium
from .outcome import Balanced, NoSupportError

__all__ = ["Balanced", "NoSupportError", "check_host", "find_equilibrium"]
