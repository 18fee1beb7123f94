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
    if isinstance(matrix, np.ndarray):
        inverse = np.linalg.inv(matrix[np.ix_(rest, rest)])
        across, back = matrix[np.ix_(rest, kept)], matrix[np.ix_(kept, rest)]
        return lambda right: inverse @ right, matrix[np.ix_(kept, kept)] - back @ (inverse @ across)
    corner = matrix[kept][:, kept].toarray()
    if not len(rest):
        return lambda right: right, corner
    from scipy.sparse.linalg import splu

    factors = splu(matrix[rest][:, rest].tocsc(), **SYMMETRIC)
    if not len(kept):
        return factors.solve, corner
    found = _of_factors(matrix, rest[np.argsort(factors.perm_c)], kept)
    if found is None:
        across, back, found = matrix[rest][:, kept], matrix[kept][:, rest], corner
        for first in range(0, len(kept), _COLUMNS):
            columns = slice(first, first + _COLUMNS)
            found[:, columns] -= back @ factors.solve(across[:, columns].toarray())
    return factors.solve, found


def _of_factors(matrix: Any, rest: np.ndarray, kept: np.ndarray) -> np.ndarray | None:
    """The complement as the last rows and columns of the factors of the whole matrix, ``rest`` being in the order of its own
    factors: in a tenth of the time of solving for each column. ``None`` where rows had to be exchanged."""
    from scipy.sparse import diags
    from scipy.sparse.linalg import splu

    order, count = np.concatenate([rest, kept]), len(rest)
    whole = matrix[order][:, order].tocsc()
    # Springs on what is kept do not touch the rest; with them the last pivots do not vanish where contact alone holds a body.
    spring = float(abs(whole.diagonal()).max())
    springs = np.zeros(len(order))
    springs[count:] = spring
    unchanged = {"permc_spec": "NATURAL", "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
    factors = splu((whole + diags(springs)).tocsc(), **unchanged)
    places = np.arange(len(order))
    if not (np.array_equal(factors.perm_r, places) and np.array_equal(factors.perm_c, places)):
        return None
    lower, upper = factors.L[count:][:, count:].toarray(), factors.U[count:][:, count:].toarray()
    return lower @ upper - spring * np.eye(len(kept))
