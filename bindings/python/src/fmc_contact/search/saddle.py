"""The linear system of an equilibrium with multipliers: the effect of unknowns and shifts of surfaces on forces and gaps."""

from __future__ import annotations

from typing import Any, Callable, Optional

import numpy as np

from .at_equilibrium import AtEquilibrium
from .bodies import Solve
from .linear import factors

Both = tuple[np.ndarray, np.ndarray]


class Saddle:
    """``A dx + B ds`` are the forces that a change of the unknowns and of the shifts adds, ``G dx`` the opening of gaps.

    Offsets turn with the surfaces: ``o = s t(x)``."""

    def __init__(self, at: AtEquilibrium, matrix: Any, unknown: np.ndarray, free: np.ndarray, solve: Optional[Solve]) -> None:
        """``unknown`` is the unknown of every coordinate, negative for none; ``matrix`` the matrix of the bodies."""
        from scipy.sparse import csr_matrix, diags

        self.free, self.own, self.shifts = free, solve, at.values["shift"]
        count, size, places = len(at.values), matrix.shape[0], np.arange(len(at.values) * at.dim)
        along = diags(np.repeat(self.shifts, at.dim)) @ at.towards_by_coords
        self.forces_by_coords = at.by_coords + at.by_offsets @ along
        towards = at.values["towards"][:, : at.dim].ravel()
        self.forces_by_shifts = at.by_offsets @ csr_matrix((towards, (places, places // at.dim)), (count * at.dim, count))
        moved = np.flatnonzero(unknown >= 0)
        self.to_coords = csr_matrix((np.ones(len(moved)), (moved, unknown[moved])), (at.coords.size, size))
        self.total = (csr_matrix(matrix) - self.to_coords.T @ self.forces_by_coords @ self.to_coords).tocsr()
        self.gaps = (at.gaps_by_coords @ self.to_coords).tocsr()
        self.by_shifts = (-self.to_coords.T @ self.forces_by_shifts).tocsr()
        self._all: Optional[Callable[[np.ndarray, np.ndarray, str], Both]] = None

    def transposed(self, right: np.ndarray, of_shifts: np.ndarray) -> Both:
        """λ of all unknowns and μ."""
        found = np.zeros(len(right))
        found[self.free], of_gaps = self._of_all(right[self.free], of_shifts, "T")
        return found, of_gaps

    def closing(self, residual: np.ndarray, gaps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Changes of all unknowns and of the shifts that close the gaps; a node that would be pulled loses its multiplier."""
        kept, found = np.ones(len(gaps), bool), np.zeros(len(residual))
        while True:
            right = -(residual - self.by_shifts @ np.where(kept, 0.0, self.shifts))[self.free]
            solve = self._of_all if kept.all() else self._of(kept)
            found[self.free], of_kept = solve(right, -gaps[kept], "N")
            shifts = -self.shifts.copy()
            shifts[kept] = of_kept
            pulled = kept & (self.shifts + shifts <= 0)
            if not pulled.any():
                return found, shifts
            kept &= ~pulled

    def _of_all(self, right: np.ndarray, of_gaps: np.ndarray, which: str) -> Both:
        self._all = self._all or self._of(np.ones(len(self.shifts), bool))
        return self._all(right, of_gaps, which)

    def _of(self, kept: np.ndarray) -> Callable[[np.ndarray, np.ndarray, str], Both]:
        """A solver with these multipliers; ``"T"`` for the transposed system."""
        from scipy.sparse import bmat

        free, own = self.free, self.own
        block, across, back = self.total[free][:, free], self.by_shifts[free][:, kept], self.gaps[kept][:, free]
        if own is None and kept.any():
            from scipy.sparse.linalg import splu

            both = splu(bmat([[block, across], [back, None]], "csc"))

            def by_factors(right: np.ndarray, below: np.ndarray, which: str) -> Both:
                solution = both.solve(np.concatenate([right, below]), which)
                return solution[: len(free)], solution[len(free) :]

            return by_factors

        def by_columns(right: np.ndarray, below: np.ndarray, which: str) -> Both:
            of = (block, across, back) if which == "N" else (block.T, back.T, across.T)
            matrix, first, second = (one.tocsr() for one in of)
            solve = factors(matrix) if own is None else lambda side: own(matrix, side)
            alone = solve(right)
            if not kept.any():
                return alone, np.zeros(0)
            columns = np.stack([solve(first[:, [one]].toarray().ravel()) for one in range(len(below))], axis=1)
            lower = np.linalg.solve(second @ columns, second @ alone - below)
            return alone - columns @ lower, lower

        return by_columns
