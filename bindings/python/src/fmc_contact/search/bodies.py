"""The bodies as a search for an equilibrium asks of them."""

from __future__ import annotations

from typing import Any, Callable, Optional, Union, cast

import numpy as np

from ..condensed import Condensed, same_entries
from ..contact import Contact
from ..errors import FmcError, IndefiniteStiffnessError, InvertedCellError, SingularStiffnessError, ZeroMeasureError
from .host import Host, Refused
from .likely import other_unknowns, refuse_columns, refuse_components, refuse_part
from .linear import factors, shifted, summed

# The last two are those of a state that bodies cannot have.
_FAILURES = (RuntimeError, np.linalg.LinAlgError, SingularStiffnessError, IndefiniteStiffnessError, InvertedCellError, ZeroMeasureError)

# Attribute of a contact: factors of linear bodies serve later load steps too.
_KEPT = "_condensed_by_search"

# Flags of the contact's tangent, as keywords.
TANGENTS = {0: {}, 2: {"semidefinite": True}, 32: {"symmetric": True}}

Residual = Callable[[np.ndarray], Any]
"""Takes the unknowns, and returns the residual, its derivative and, if it likes, the energy."""

Solve = Callable[[Any, np.ndarray], np.ndarray]
"""Takes a matrix and a right side, and returns the solution."""


class Bodies(Host):
    """The forces and the matrix of bodies, and systems of the sum of both matrices, of bodies and contact."""

    def __init__(self, host: Residual, contact: Any, shape: tuple[int, ...], free: np.ndarray, solve: Optional[Solve]) -> None:
        self.host, self.contact, self.shape, self.free, self.solve_with = host, contact, shape, free, solve
        self.size = int(np.prod(shape))
        self.comm = getattr(contact, "contact", contact).ranks.comm
        self.matrix: Any = None
        self.hints: list[str] = []
        """What the function most likely takes in place of these unknowns."""
        self._last: tuple[np.ndarray, Any] | None = None
        self._factors: tuple[Any, Any] = (None, None)

    def forces(self, x: np.ndarray, matrix: bool) -> tuple[np.ndarray, Optional[float]]:
        """Errors: ``Refused`` for a state that the host refuses."""
        if self._last is None or not np.array_equal(self._last[0], x):
            try:
                self._last = x, self.host(x.reshape(self.shape).copy())
            except FmcError as error:
                raise Refused(str(error)) from error
        residual, derivative, *rest = self._last[1]
        refuse_columns(residual, self.shape)
        residual = np.ascontiguousarray(np.ravel(residual), np.float64)
        if residual.shape != (self.size,):
            raise ValueError(f"the residual has {residual.size} entries, x has {self.size}")
        if matrix:
            is_first = self.matrix is None
            self._take(derivative)
            if is_first:
                # A copy, as the host may write its next residual to the same memory.
                residual = residual.copy()
                self.hints = other_unknowns(self._elsewhere, self.contact, x.reshape(self.shape), residual, self.matrix)
        return residual, float(rest[0]) if rest else None

    def _elsewhere(self, x: np.ndarray) -> np.ndarray:
        """The residual at a state that the search did not request."""
        self._last = None
        return np.array(self.host(x.reshape(self.shape))[0], np.float64).ravel()

    def _take(self, derivative: Any) -> None:
        """Keeps a copy: many hosts assemble into the same memory again, and the factors then belong to another matrix."""
        refuse_part(derivative, self.size)
        if self.matrix is None and isinstance(self.contact, Contact):
            refuse_components(derivative, self.contact.dim)
        rows = derivative if isinstance(derivative, np.ndarray) or hasattr(derivative, "indptr") else derivative.tocsr()
        if self.matrix is None or not same_entries(self.matrix, rows):
            self.matrix, self._factors = rows.copy(), (None, None)

    def product(self, vector: np.ndarray, magnitudes: bool) -> np.ndarray:
        found: np.ndarray = (abs(self.matrix) if magnitudes else self.matrix) @ vector
        return np.ravel(found)

    def diagonal(self) -> np.ndarray:
        found: np.ndarray = self.matrix.diagonal()
        return np.array(found, np.float64)

    def solve(self, x: np.ndarray, flags: int, shift: float, right: np.ndarray) -> np.ndarray:
        """Errors: ``Refused`` where the matrix is singular."""
        key = x.tobytes(), flags, shift
        if self._factors[0] != key:
            tangent = self.contact.tangent(x.reshape(self.shape), **TANGENTS[flags])
            total = shifted(summed(self.matrix, tangent), self.diagonal(), shift)[self.free][:, self.free]
            self.factorisations += 1
            self._factors = key, self._factored(total)
        found = np.zeros(self.size)
        try:
            found[self.free] = self._factors[1](right[self.free])
        except (RuntimeError, np.linalg.LinAlgError) as error:
            raise Refused(f"the linear solver failed: {error}") from error
        return found

    def _factored(self, matrix: Any) -> Callable[[np.ndarray], np.ndarray]:
        if self.solve_with is not None:
            own = self.solve_with
            return lambda right: own(matrix, right)
        try:
            return factors(matrix)
        except (RuntimeError, np.linalg.LinAlgError) as error:
            raise Refused(f"the linear solver failed: {error}") from error


def bodies_of(given: Union[Residual, Host], contact: Any, shape: tuple[int, ...], free: np.ndarray, solve: Optional[Solve]) -> Host:
    """Bodies of a function, or those given. Errors: ``ValueError`` for a linear solver for bodies with their own solver."""
    if not isinstance(given, Host):
        return Bodies(given, contact, shape, free, solve)
    if solve is not None:
        raise ValueError("bodies with their own solver take no solve")
    return given


def condensed_of(bodies: Bodies) -> Condensed:
    """Bodies condensed on the unknowns that feel contact, kept with the contact. Errors: ``ValueError``, ``ImportError`` where that cannot be."""
    known: Any = getattr(bodies.contact, _KEPT, None)
    if known is None or not known.is_of(bodies.size, bodies.free):
        known = Condensed(bodies.contact, bodies.size, bodies.free)
        if hasattr(bodies.contact, "__dict__"):
            setattr(bodies.contact, _KEPT, known)
    return cast(Condensed, known)


class CondensedSteps:
    """Steps to the equilibrium of the contact with bodies that are linear."""

    def __init__(self, bodies: Bodies, condensed: Condensed, is_wanted: bool) -> None:
        self.bodies, self.condensed, self.is_wanted = bodies, condensed, is_wanted
        self.iterations, self.before, self.is_first = 0, condensed.factorisations, True

    @property
    def factorisations(self) -> int:
        """Made in this load step."""
        return self.condensed.factorisations - self.before

    def step(
        self, x: np.ndarray, moved: np.ndarray, forces: np.ndarray, tolerance: float, absolute_tolerance: float
    ) -> tuple[np.ndarray, bool]:
        """Change of all unknowns, and whether the bodies have an energy that is least there. Errors: ``Refused``."""
        condensed, matrix = self.condensed, self.bodies.matrix
        is_known = condensed.knows(matrix)
        if not is_known and self.is_first:
            condensed.forget()
        enough = 0.0 if is_known or self.is_first or moved.any() else absolute_tolerance
        self.is_first = False
        try:
            step, found = condensed.step(x, moved, forces, matrix, tolerance, enough)
        except _FAILURES as error:
            raise Refused(str(error)) from error
        if found.state == "not_converged" and found.residual >= found.residual_at_start:
            raise Refused("the iterations of the contact led nowhere")
        self.iterations += found.iterations
        return step, condensed.is_definite
