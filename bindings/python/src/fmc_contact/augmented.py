"""Contact with as little penetration as is asked for: an augmented Lagrangian over Newton's method.

The pressure at a node is ``p = max(0, λ - k g)`` with its mean gap g and a multiplier λ. After each equilibrium λ
becomes p, and the next one penetrates less, at the same k. See Alart and Curnier, CMAME 92 (1991), without friction; the
updates are Uzawa's.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike

from .contact import Contact
from .gaps import GapConstraints
from .newton import NotConvergedError, newton

# Part of a penetration that an update may leave; where it leaves more, k is raised by the factor that follows.
_SLOW = 0.25
_RAISE = 4.0

# Reach of the gaps, by the bodies' extent: what opens farther in one iteration is taken for apart.
_REACH = 0.05


@dataclass(frozen=True, eq=False)
class Augmented:
    """What ``augmented`` found."""

    x: np.ndarray
    """The solution, in the shape of the start."""
    penetrations: list[float]
    """Largest mean penetration at a node: with the law alone, and after each update."""
    iterations: list[int]
    """Linear solves: of the equilibrium with the law, and after each update."""
    stiffness: float
    """Pressure by penetration of the last update."""
    gaps: GapConstraints
    """The nodes near a partner, one side of every pair, at the solution."""
    pressure: np.ndarray
    """Of each row of ``gaps``, at least 0."""
    reactions: np.ndarray
    """Residual at the solution, in the shape of ``x``: the forces that hold the unknowns that are not free."""


def augmented(
    residual_and_tangent: Callable[[np.ndarray], tuple[np.ndarray, Any]],
    contact: Any,
    x: ArrayLike,
    free: ArrayLike,
    prescribed: ArrayLike | None = None,
    *,
    young: float,
    penetration: float,
    reach: float | None = None,
    max_updates: int = 20,
    **options: Any,
) -> Augmented:
    """Equilibrium at the end of a load step in which no node in contact penetrates by more than ``penetration`` on
    average over its part of the surface, a length, however soft the contact is.

    It begins with the equilibrium with the law, by ``newton``; all arguments but these are its own: ``reach``, how far from a
    partner gaps are measured, default a twentieth of the bodies' extent; ``max_updates``. k is the law's stiffness, and
    is raised where an update leaves more than a quarter of the penetration. Of two bodies in contact the one with more
    nodes there has the multipliers.

    For ``Contact``, ``SkfemContact`` and others with ``gap_constraints``. The matrix is symmetric. Errors:
    ``NotConvergedError``, also where ``max_updates`` do not reach the penetration; ``ValueError`` for shapes, a
    penetration that is not positive, friction, and contact of a body with itself.
    """
    inner: Contact = contact if isinstance(contact, Contact) else contact.contact
    if not penetration > 0:
        raise ValueError(f"the penetration is {penetration}, a positive one is wanted")
    if inner.options["friction_coefficient"] or inner.options["cohesion"]:
        raise ValueError("an augmented Lagrangian with friction is not there: take newton")
    if inner.options["self_contact"]:
        raise ValueError("an augmented Lagrangian of a body in contact with itself is not there: take newton")
    start = newton(residual_and_tangent, contact, x, free, prescribed, young=young, **options)
    if reach is None:
        reach = _REACH * float(np.ptp(_coords(contact, start.x), axis=0).max())
    law = _Multipliers(contact, reach, float(inner.options["stiffness"]))  # type: ignore[arg-type]
    law.update(start.x)
    # The multipliers' contact is linear where it is closed, and has no step of its own.
    options["two_level"] = False
    found, iterations, penetrations = start, [start.iterations], [law.penetration]
    while penetrations[-1] > penetration:
        if len(penetrations) > max_updates:
            raise NotConvergedError(
                f"a penetration of {penetrations[-1]:.1e} after {max_updates} updates, {penetration:.1e} is wanted",
                found.residuals,
            )
        found = newton(residual_and_tangent, law, found.x, free, young=young, **options)
        law.update(found.x)
        iterations.append(found.iterations)
        penetrations.append(law.penetration)
        if penetrations[-1] > _SLOW * penetrations[-2]:
            law.stiffness *= _RAISE
    return Augmented(found.x, penetrations, iterations, law.stiffness, law.gaps, law.pressure, found.reactions)


def _coords(contact: Any, x: np.ndarray) -> np.ndarray:
    return x if isinstance(contact, Contact) else contact.coords(x)


@dataclass(frozen=True, eq=False)
class _Result:
    forces: np.ndarray
    # No law: nothing is to be softened.
    penetration: float = 0.0


class _Multipliers:
    """Pressures at nodes in place of a law, as ``newton`` wants a contact."""

    def __init__(self, contact: Any, reach: float, stiffness: float) -> None:
        self.source, self.reach, self.stiffness, self.contact = contact, reach, stiffness, self
        self.chosen: dict[tuple[int, int], int] = {}
        self.known, self.multiplier = np.empty(0, np.int64), np.empty(0)

    @property
    def options(self) -> dict[str, float]:
        return {"stiffness": self.stiffness}

    def set_options(self, stiffness: float) -> None:
        """That of the multipliers is their own."""

    def find(self, x: np.ndarray) -> Any:
        """Gaps and their derivative by the unknowns; pressures there."""
        gaps, matrix = self._rows(x)
        mine = self._of_one_side(gaps)
        self.gaps, matrix = _taken(gaps, mine), matrix[mine]
        self.keys = _keys(self.gaps)
        multiplier = np.zeros(len(self.keys))
        if len(self.known):
            place = np.minimum(np.searchsorted(self.known, self.keys), len(self.known) - 1)
            multiplier = np.where(self.known[place] == self.keys, self.multiplier[place], 0.0)
        self.pressure = np.maximum(0.0, multiplier - self.stiffness * self.gaps.gap / self.gaps.area)
        return matrix

    def _rows(self, x: np.ndarray) -> tuple[GapConstraints, Any]:
        from scipy.sparse import csr_matrix

        if not isinstance(self.source, Contact):
            return self.source.gap_constraints(x, self.reach)
        gaps = self.source.gap_constraints(x, self.reach)
        return gaps, csr_matrix((gaps.data, gaps.indices, gaps.indptr), shape=(len(gaps), x.size))

    def _of_one_side(self, gaps: GapConstraints) -> np.ndarray:
        """Rows of the side of every pair that has more of them when the two meet, of equals that of the first body."""
        mine = gaps.area > 0
        of_bodies = mine & ~gaps.is_obstacle
        low, high = np.minimum(gaps.body, gaps.partner), np.maximum(gaps.body, gaps.partner)
        for a, b in np.unique(np.column_stack([low, high])[of_bodies], axis=0).tolist():
            pair = of_bodies & (low == a) & (high == b)
            if (a, b) not in self.chosen:
                count = [np.count_nonzero(pair & (gaps.body == body)) for body in (a, b)]
                self.chosen[a, b] = b if count[1] > count[0] else a
            mine &= ~pair | (gaps.body == self.chosen[a, b])
        return np.flatnonzero(mine)

    def update(self, x: np.ndarray) -> None:
        """Pressures become multipliers."""
        self.find(x)
        order = np.argsort(self.keys)
        self.known, self.multiplier = self.keys[order], self.pressure[order]
        self.penetration = float(np.max(-self.gaps.gap / self.gaps.area, initial=0.0))

    def evaluate(self, x: np.ndarray) -> _Result:
        return _Result(self.find(x).T @ self.pressure)

    def tangent(self, x: np.ndarray, semidefinite: bool) -> Any:
        from scipy.sparse import diags

        matrix = self.find(x)
        pressed = self.pressure > 0
        rows = matrix[pressed]
        return (rows.T @ diags(self.stiffness / self.gaps.area[pressed]) @ rows).tocsr()


def _taken(gaps: GapConstraints, rows: np.ndarray) -> GapConstraints:
    """Some of the rows."""
    counts = np.diff(gaps.indptr)[rows]
    entries = np.repeat(gaps.indptr[rows] - np.r_[0, np.cumsum(counts)[:-1]], counts) + np.arange(counts.sum())
    of_rows = {key: getattr(gaps, key)[rows] for key in ("node", "body", "is_obstacle", "partner", "gap", "area")}
    return replace(
        gaps, **of_rows, data=gaps.data[entries], indices=gaps.indices[entries], indptr=np.r_[0, np.cumsum(counts)]
    )


def _keys(gaps: GapConstraints) -> np.ndarray:
    """A number for every node and partner, the same whatever else is near."""
    return (gaps.node.astype(np.int64) << 32) | (gaps.partner.astype(np.int64) << 1) | gaps.is_obstacle
