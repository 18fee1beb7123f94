"""Linear systems factorised down to some of their unknowns, which are left as a small dense system: the Schur complement."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

Solve = Callable[[np.ndarray], np.ndarray]

Condense = Callable[[Any, np.ndarray, np.ndarray], "tuple[Solve, np.ndarray]"]
"""``condense(matrix, rest, kept)``: a solver for the rows and columns ``rest`` of a matrix, and what their elimination leaves on
``kept``, ``K_cc - K_cr K_rr^-1 K_rc``, an array."""

# Rows and columns in the same order, which in 2D takes a third of the time: the pattern of the matrix is symmetric, and but for
# friction the matrix.
SYMMETRIC = {"permc_spec": "MMD_AT_PLUS_A", "diag_pivot_thresh": 0.1, "options": {"SymmetricMode": True}}

# Right-hand sides at once, where the complement is found column by column.
_COLUMNS = 64


def condense(matrix: Any, rest: np.ndarray, kept: np.ndarray) -> tuple[Solve, np.ndarray]:
    """By scipy's ``splu``, by numpy for an array. Errors: ``RuntimeError`` or ``LinAlgError`` where the rest is singular."""
    return SuperLU()(matrix, rest, kept)


class SuperLU:
    """``condense`` for one matrix after another: the order of elimination is kept for the next one of the same pattern, which then
    takes one factorisation instead of two."""

    def __init__(self) -> None:
        self._pattern: tuple[np.ndarray, ...] = ()
        self._order = np.zeros(0, np.int64)

    def __call__(self, matrix: Any, rest: np.ndarray, kept: np.ndarray) -> tuple[Solve, np.ndarray]:
        if isinstance(matrix, np.ndarray):
            inverse = np.linalg.inv(matrix[np.ix_(rest, rest)])
            across, back = matrix[np.ix_(rest, kept)], matrix[np.ix_(kept, rest)]
            return lambda right: inverse @ right, matrix[np.ix_(kept, kept)] - back @ (inverse @ across)
        corner = matrix[kept][:, kept].toarray()
        if not len(rest):
            return lambda right: right, corner
        if len(kept) and self._has_order(matrix, rest, kept):
            factors = _Whole.of(matrix, rest, self._order, kept)
            if factors is not None:
                return factors.solve_rest, factors.complement()
        return self._anew(matrix, rest, kept, corner)

    def _has_order(self, matrix: Any, rest: np.ndarray, kept: np.ndarray) -> bool:
        pattern = (matrix.indptr, matrix.indices, rest, kept)
        return len(self._pattern) == 4 and all(map(np.array_equal, self._pattern, pattern))

    def _anew(self, matrix: Any, rest: np.ndarray, kept: np.ndarray, corner: np.ndarray) -> tuple[Solve, np.ndarray]:
        from scipy.sparse.linalg import splu

        factors = splu(matrix[rest][:, rest].tocsc(), **SYMMETRIC)
        if not len(kept):
            return factors.solve, corner
        self._order = np.argsort(factors.perm_c)
        self._pattern = (matrix.indptr.copy(), matrix.indices.copy(), rest.copy(), kept.copy())
        whole = _Whole.of(matrix, rest, self._order, kept)
        if whole is not None:
            return factors.solve, whole.complement()
        across, back, found = matrix[rest][:, kept], matrix[kept][:, rest], corner
        for first in range(0, len(kept), _COLUMNS):
            columns = slice(first, first + _COLUMNS)
            found[:, columns] -= back @ factors.solve(across[:, columns].toarray())
        return factors.solve, found


class _Whole:
    """Factors of the whole matrix, ``rest`` in the order of its own factors and ``kept`` last: the complement stands in their
    last rows and columns, in a tenth of the time of solving for each column."""

    def __init__(self, factors: Any, order: np.ndarray, count: int, spring: float) -> None:
        self.factors, self.order, self.count, self.spring = factors, order, count, spring

    @classmethod
    def of(cls, matrix: Any, rest: np.ndarray, order: np.ndarray, kept: np.ndarray) -> _Whole | None:
        """``None`` where rows had to be exchanged."""
        from scipy.sparse import diags
        from scipy.sparse.linalg import splu

        all_, count = np.concatenate([rest[order], kept]), len(rest)
        whole = matrix[all_][:, all_].tocsc()
        # Springs on what is kept do not touch the rest; with them the last pivots do not vanish where contact alone holds a body.
        spring = float(abs(whole.diagonal()).max())
        springs = np.zeros(len(all_))
        springs[count:] = spring
        unchanged = {"permc_spec": "NATURAL", "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
        factors = splu((whole + diags(springs)).tocsc(), **unchanged)
        places = np.arange(len(all_))
        if not (np.array_equal(factors.perm_r, places) and np.array_equal(factors.perm_c, places)):
            return None
        return cls(factors, order, count, spring)

    def complement(self) -> np.ndarray:
        lower, upper = (part[self.count :][:, self.count :].toarray() for part in (self.factors.L, self.factors.U))
        self._held: np.ndarray = lower @ upper
        found: np.ndarray = self._held - self.spring * np.eye(len(self._held))
        return found

    def solve_rest(self, right: np.ndarray) -> np.ndarray:
        """Solution for ``rest`` with the retained unknowns fixed. A first solve, in which they move, finds their reactions."""
        whole = np.zeros((len(self.order) + len(self._held), *right.shape[1:]))
        whole[: self.count] = right[self.order]
        whole[self.count :] = -self._held @ self.factors.solve(whole)[self.count :]
        found: np.ndarray = np.empty_like(right, dtype=float)
        found[self.order] = self.factors.solve(whole)[: self.count]
        return found
