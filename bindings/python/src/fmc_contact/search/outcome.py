"""Result of a load step, or the reason of its failure."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ..errors import FmcError
from ..result import Result
from .adjoint import Adjoint, adjoint
from .closed import End


class NotConvergedError(FmcError, RuntimeError):
    """No equilibrium was found. ``residuals`` are the relative residuals of all states on the way, ``iterations`` is the number of linear solves."""

    def __init__(self, message: str, residuals: list[float], iterations: int = 0) -> None:
        super().__init__(message)
        self.residuals, self.iterations = residuals, iterations


class NoSupportError(NotConvergedError):
    """A body is unsupported: neither contact nor the supports of the host stop it.

    ``body`` is its id, ``direction`` the unit vector along which it moves, zeros for a rotation, and ``is_rotation`` whether it rotates.
    """

    body: int = -1
    direction: np.ndarray = np.zeros(0)
    is_rotation: bool = False


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Result of ``find_equilibrium``: an equilibrium of bodies and contact.

    Attributes
    ----------
    x : ndarray
        The solution, in the shape of the start.
    iterations : int
        Number of linear solves.
    residuals : list of float
        Relative residual of every state on the way, with the solution last.
    result : Result
        Contact at the solution.
    reactions : ndarray
        Residual at the solution, in the shape of ``x``: the forces that hold the unknowns that are not free.
    way : str
        How it was found: ``"condensed"``, ``"nearest"`` or ``"downhill"``. See ``find_equilibrium``.
    rigid_steps : int
        Rigid steps in which unsupported bodies came to rest on others.
    parts : int
        Parts in which the load step was made.
    contact_iterations : int
        Dense systems solved for the contact alone, within the linear solves.
    factorisations : int
        Sparse matrices factorised.
    updates : int
        Updates of multipliers.
    penetration : float or None
        Largest mean penetration of a node at the solution (length), if it was measured.
    warnings : list of str
        Remarks on the search, for example on bodies in unstable balance. The contact's own warnings are ``result.warnings``.
    first_touches : int
        Pairs whose slip counts from where they first touched in this step: they were apart at its start. Derivatives hold these places.

    Examples
    --------
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> from fmc_contact import find_equilibrium
    >>> find_equilibrium(bodies, contact, coords, range(16)).iterations < 10
    True
    """

    x: np.ndarray
    iterations: int
    residuals: list[float]
    result: Result
    reactions: np.ndarray
    way: str = "nearest"
    rigid_steps: int = 0
    parts: int = 1
    contact_iterations: int = 0
    factorisations: int = 0
    updates: int = 0
    penetration: Optional[float] = None
    warnings: list[str] = field(default_factory=list)
    first_touches: int = 0

    def __getstate__(self) -> dict[str, Any]:
        # Copies are of the result alone: bodies and contact are no part of it.
        return {name: value for name, value in self.__dict__.items() if name != "_end"}

    def adjoint(self, by_x: ArrayLike, by_forces: Optional[ArrayLike] = None, by: Iterable[str] = ()) -> Adjoint:
        """Derivatives of a number J(x, F) of the equilibrium, F being the contact's nodal forces: one linear solve, whatever their number.

        Call it before the contact changes. Multipliers follow the parameters: J then refers to closed gaps, and the adjoint closes the remaining gaps
        by Newton's method. This costs two or three linear solves more. With friction it is the derivative of this load step, where the last one ended
        being held. Needs scipy.

        Parameters
        ----------
        by_x : array_like
            ∂J/∂x in the shape of ``x``, entries of held unknowns too.
        by_forces : array_like, (n, dim), optional
            ∂J/∂F, such as ones along an axis on the nodes of a body, for the force on it. Default: zeros.
        by : iterable of str
            Names of ``Contact.vjp``.

        Returns
        -------
        Adjoint
            The derivatives.

        Raises
        ------
        ValueError
            If the contact has changed since, for shapes, and for names that do not exist.
        UnsupportedError
            As ``Contact.vjp``; for bodies with their own solver; for multipliers with ties.
        RuntimeError
            If the matrix is singular.

        Examples
        --------
        >>> from fmc_contact import find_equilibrium
        >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
        >>> found = find_equilibrium(bodies, contact, coords, range(16))
        >>> found.adjoint(np.ones((8, 2)), by=["stiffness"]).gradients.stiffness < 1e-9
        True
        """
        end: Optional[End] = self.__dict__.get("_end")
        if end is None:
            raise ValueError("this equilibrium is not one of find_equilibrium")
        found = adjoint(end, by_x, by_forces, by)
        if self.first_touches:
            found.warnings.append(
                f"{self.first_touches} pairs closed a gap in this step, and the places where they first touched are held: the derivative of their "
                "friction is not complete; end a step where they touch, or search with straight_slip=True"
            )
        return found
