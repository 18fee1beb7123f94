"""What Newton's method has found, or that it has found nothing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import FmcError
from ..result import Result


class NotConvergedError(FmcError, RuntimeError):
    """Newton's method did not find an equilibrium; ``residuals`` are those of all iterations, relative, ``iterations`` their number."""

    def __init__(self, message: str, residuals: list[float], iterations: int = 0) -> None:
        super().__init__(message)
        self.residuals, self.iterations = residuals, iterations


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """What ``newton`` found."""

    x: np.ndarray
    """The solution, in the shape of the start."""
    iterations: int
    """Number of linear solves."""
    soft_iterations: int
    """Those of them with a stiffness lower than the one asked for."""
    residuals: list[float]
    """Relative residual before each solve and at the end; not a number before prescribed displacements are reached."""
    result: Result
    """Contact at the solution."""
    reactions: np.ndarray
    """Residual at the solution, in the shape of ``x``: the forces that hold the unknowns that are not free."""
    plain_because: str = ""
    """Why the method was plain, from some iteration on; empty where it was in two levels to the end."""
    contact_iterations: int = 0
    """Dense systems solved for the contact alone, within the linear solves."""
    factorisations: int = 0
    """Sparse matrices factorised."""
    updates: int = 0
    """Updates of multipliers, where a penetration was asked for."""
    penetration: float | None = None
    """Largest mean penetration of a node at the solution, where one was asked for."""
