"""Bodies factorised once, down to the unknowns that feel contact, and the step to the equilibrium of the contact with them."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import mumps
from ._library import library
from .cholesky import Cholesky
from .contact import Contact
from .contact_step import ContactStep
from .errors import FmcError
from .schur import Condense, SuperLU

# Times that the unknowns are found to be too few in one step: contact spreads over more of them each time.
_MOST_GROWTHS = 8

MOST_EXPECTED = 1500
"""Unknowns that may feel contact before any does, at most."""

MOST_KEPT = 5000
"""Unknowns that feel contact, at most: what is left of the bodies is dense, 200 MB then, and takes half a second to solve."""


class Unknowns:
    """Which unknown moves which degree of freedom of the contact; -1: none."""

    def __init__(self, contact: Any, size: int) -> None:
        self.contact = contact
        self.inner: Contact = contact if isinstance(contact, Contact) else contact.contact
        shape = (self.inner.unknown_count, self.inner.dim)
        count = shape[0] * shape[1]
        self.of_freedom = np.arange(count)
        if contact is not self.inner:
            # Numbers brought to the unknowns as forces are say where each has gone, and ones whether by itself.
            number = np.ravel(contact.on_dofs(np.arange(1.0, count + 1.0).reshape(shape)))
            alone = np.ravel(contact.on_dofs(np.ones(shape)))
            (reached,) = np.nonzero(number)
            freedom = number[reached].astype(np.int64) - 1
            # A node may have none and stay. With a basis the first rows are no nodes: what they would be condensed to is not known.
            is_whole = len(freedom) == count or self.inner.unknown_count == self.inner.node_count
            if not (is_whole and np.array_equal(alone[reached], np.ones(len(freedom))) and len(np.unique(freedom)) == len(freedom)):
                raise ValueError("two levels need a contact whose degrees of freedom are each moved by exactly one unknown")
            self.of_freedom = np.full(count, -1)
            self.of_freedom[freedom] = reached
        if (count and int(self.of_freedom.max()) >= size) or (contact is self.inner and count != size):
            raise ValueError(f"x has {size} entries, the contact {count} degrees of freedom")

    def coords(self, x: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown."""
        return x.reshape(-1, self.inner.dim) if self.contact is self.inner else self.contact.coords(x)

    def at_freedoms(self, values: np.ndarray) -> np.ndarray:
        """Values or marks of unknowns at the degrees of freedom of the contact: 0 where no unknown moves them."""
        found: np.ndarray = values[self.of_freedom] * (self.of_freedom >= 0)
        return found

    def near(self, x: np.ndarray, reach: float) -> list[np.ndarray]:
        """Degrees of freedom of the contact that move nodes whose mean gap is below a reach, and their partners: node by node, the nearest first."""
        gaps = self.inner.gap_constraints(self.coords(x), reach)
        (rows,) = np.nonzero(gaps.gap < reach * gaps.area)
        rows = rows[np.argsort(gaps.gap[rows] / gaps.area[rows], kind="stable")]
        return [gaps.indices[gaps.indptr[row] : gaps.indptr[row + 1]] for row in rows]

    def touching(self, x: np.ndarray) -> np.ndarray:
        """Degrees of freedom of the contact in the pattern of its tangent."""
        rows, cols, _ = self.inner.tangent_parts(self.coords(x), semidefinite=True).triplets()
        return np.union1d(rows, cols)


def chosen() -> Condense:
    """The library's own factors. For matrices that are not symmetric and positive definite it takes MUMPS, if the program has imported a petsc4py
    with it, else SuperLU."""
    other = mumps.Mumps() if mumps.is_there() else SuperLU()
    return Cholesky(other) if library.fmc_has_feature(b"solver") else other


class Condensed:
    """Steps to the equilibrium of contact with bodies that are linear, for any number of iterations and load steps. ``by`` is what
    factorises them; ``None``: ``chosen()``."""

    def __init__(self, contact: Any, size: int, free: np.ndarray, by: Condense | None = None) -> None:
        self.unknowns, self.by = Unknowns(contact, size), by or chosen()
        self.free = np.zeros(size, bool)
        self.free[free] = True
        self.free_freedoms = self.unknowns.at_freedoms(self.free)
        (self.held,) = np.nonzero(~self.free_freedoms)
        self.dofs = np.zeros(0, np.int64)
        self.matrix: Any = None
        self.factorisations = 0
        self.soft_start = True

    def is_of(self, size: int, free: np.ndarray) -> bool:
        """Whether it is of these unknowns."""
        return len(self.free) == size and np.array_equal(np.flatnonzero(self.free), np.sort(free))

    def knows(self, matrix: Any) -> bool:
        """Whether there are factors of this matrix."""
        return self.matrix is not None and same_entries(self.matrix, matrix)

    @property
    def is_definite(self) -> bool:
        """Whether the bodies' matrix was found to be symmetric and positive definite where they do not touch."""
        if not isinstance(self.matrix, np.ndarray):
            return self.matrix is not None and hasattr(self.solve, "follow")
        rest = self.matrix[np.ix_(self.rest, self.rest)]
        try:
            np.linalg.cholesky(rest)
        except np.linalg.LinAlgError:
            return False
        return bool(np.abs(rest - rest.T).max(initial=0.0) <= 1e-12 * np.abs(rest).max(initial=0.0))

    def forget(self) -> None:
        """No unknown is known to feel contact."""
        self.dofs, self.matrix = np.zeros(0, np.int64), None

    def grow(self, x: np.ndarray) -> bool:
        """Adds the degrees of freedom that feel contact at ``x``; whether there were any."""
        return self._add(self.unknowns.touching(x))

    def expect(self, x: np.ndarray, moved: np.ndarray) -> None:
        """Before any contact, adds nodes that may come into contact in the prescribed motion: those nearer to a partner than the largest motion, the
        nearest first. Without them the factors would serve for one step only."""
        if len(self.dofs) or not moved.any():
            return
        way = np.linalg.norm(self.unknowns.at_freedoms(moved).reshape(-1, self.unknowns.inner.dim), axis=1).max()
        try:
            near = self.unknowns.near(x, float(way))
        except FmcError:
            return
        found: set[int] = set()
        for freedoms in near:
            found.update(freedoms[self.free_freedoms[freedoms]].tolist())
            if len(found) >= MOST_EXPECTED:
                break
        self._add(np.array(sorted(found), np.int64))

    def _add(self, found: np.ndarray) -> bool:
        found = found[self.free_freedoms[found]]
        before = len(self.dofs)
        self.dofs = np.union1d(self.dofs, found)
        if len(self.dofs) > before:
            self.matrix = None
        return len(self.dofs) > before

    def step(
        self, x: np.ndarray, moved: np.ndarray, inside: np.ndarray, matrix: Any, tolerance: float, absolute_tolerance: float = 0.0
    ) -> tuple[np.ndarray, ContactStep]:
        """Change of all unknowns from ``x``, (size,), with what is prescribed moved by ``moved``, (size,); ``inside`` and
        ``matrix`` are internal less external forces at ``x`` and their derivative, without contact.

        Errors: as ``Contact.contact_step``; ``RuntimeError`` if the bodies are unsupported without contact, or if too many unknowns feel contact."""
        self.grow(x)
        self.expect(x, moved)
        for _ in range(_MOST_GROWTHS):
            change, found = self._step(x, moved, inside, matrix, tolerance, absolute_tolerance)
            if found.state != "outside" or not self.grow(x + change):
                break
        return change, found

    def carried(self, x: np.ndarray, moved: np.ndarray, inside: np.ndarray, matrix: Any) -> np.ndarray:
        """The same change without contact, from a state without contact."""
        self.expect(x, moved)
        self._condense(matrix)
        right, change = inside + matrix @ moved, moved.copy()
        loaded = self.solve(right[self.rest])
        change[self.rest] -= loaded
        if len(self.kept):
            d = np.linalg.solve(self.schur, self.back @ loaded - right[self.kept])
            change[self.kept] += d
            change[self.rest] += self.follow(d)
        return change

    def _step(
        self, x: np.ndarray, moved: np.ndarray, inside: np.ndarray, matrix: Any, tolerance: float, absolute_tolerance: float
    ) -> tuple[np.ndarray, ContactStep]:
        self._condense(matrix)
        right = inside + matrix @ moved
        loaded = self.solve(right[self.rest])
        change = moved.copy()
        change[self.rest] -= loaded

        def changed(d: np.ndarray) -> np.ndarray:
            found = change.copy()
            found[self.kept] += d
            if len(d):
                found[self.rest] += self.follow(d)
            return found

        def place(d: np.ndarray, coords: np.ndarray) -> None:
            coords[...] = self.unknowns.coords(x + changed(d))

        start = np.ascontiguousarray(self.unknowns.coords(x + change))
        residual = right[self.kept] - self.back @ loaded
        found = self.unknowns.inner.contact_step(
            start, self.dofs, self.schur, residual, self.held, place,
            tolerance=tolerance, absolute_tolerance=absolute_tolerance, soft_start=self.soft_start,
        )
        return changed(found.displacement), found

    def _condense(self, matrix: Any) -> None:
        """Factorises the bodies on all free unknowns but those that are kept, if that was not done yet."""
        if len(self.dofs) > MOST_KEPT:
            raise RuntimeError(f"{len(self.dofs)} unknowns feel contact, more than {MOST_KEPT}")
        if self.knows(matrix):
            return
        self.kept = self.unknowns.of_freedom[self.dofs]
        rest = self.free.copy()
        rest[self.kept] = False
        (self.rest,) = np.nonzero(rest)
        self.factorisations += 1
        self.across, self.back = matrix[self.rest][:, self.kept], matrix[self.kept][:, self.rest]
        self.solve, self.schur = self.by(matrix, self.rest, self.kept)
        self.follow = getattr(self.solve, "follow", lambda d: -self.solve(self.across @ d))
        self.matrix = matrix


def same_entries(one: Any, other: Any) -> bool:
    """Whether two matrices have the same entries."""
    if one is other:
        return True
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return np.array_equal(one, other)
    return (
        one.shape == other.shape
        and np.array_equal(one.indptr, other.indptr)
        and np.array_equal(one.indices, other.indices)
        and np.array_equal(one.data, other.data)
    )
