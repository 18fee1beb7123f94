"""What Newton's method has found, or that it has found nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..errors import FmcError
from ..result import Result


class NotConvergedError(FmcError, RuntimeError):
    """Newton's method did not find an equilibrium. ``residuals`` are the relative residuals of all iterations, ``iterations`` is their number."""

    def __init__(self, message: str, residuals: list[float], iterations: int = 0) -> None:
        super().__init__(message)
        self.residuals, self.iterations = residuals, iterations


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Result of ``newton``.

    Attributes
    ----------
    x : ndarray
        The solution, in the shape of the start.
    iterations : int
        Number of linear solves.
    soft_iterations : int
        Those of them with a lower stiffness than asked for.
    residuals : list of float
        Relative residual before each solve and at the end; nan before prescribed displacements are reached.
    result : Result
        Contact at the solution.
    reactions : ndarray
        Residual at the solution, in the shape of ``x``: the forces that hold the unknowns that are not free.
    plain_because : str
        Why Newton's method was undamped and without condensation, from some iteration on; empty if it was two-level to the end.
    contact_iterations : int
        Dense systems solved for the contact alone, within the linear solves.
    factorisations : int
        Sparse matrices factorised.
    updates : int
        Updates of multipliers, if a penetration was asked for.
    penetration : float or None
        Largest mean penetration of a node at the solution (length), if one was asked for.

    Examples
    --------
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> from fmc_contact import newton
    >>> newton(bodies, contact, coords, range(16), young=1e4).iterations < 10
    True
    """

    x: np.ndarray
    iterations: int
    soft_iterations: int
    residuals: list[float]
    result: Result
    reactions: np.ndarray
    plain_because: str = ""
    contact_iterations: int = 0
    factorisations: int = 0
    updates: int = 0
    penetration: Optional[float] = None
