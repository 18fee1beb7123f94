"""Derivatives by differences, many columns at once: columns that share no row are moved together."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

EDGE = 1e-2
"""Difference of the slopes on both sides, by the largest slope, from which a function has an edge there. Of a smooth function it is the
step by the size of a facet, about 1e-5."""


def colours(pattern: Any) -> list[np.ndarray]:
    """Columns of a pattern in compressed rows, in groups that share no row; columns without an entry are in none."""
    by_column, by_row = pattern.tocsc(), pattern.tocsr()
    colour = np.full(pattern.shape[1], -1)
    for column in np.flatnonzero(np.diff(by_column.indptr)):
        rows = by_column.indices[by_column.indptr[column] : by_column.indptr[column + 1]]
        others = np.concatenate([by_row.indices[by_row.indptr[row] : by_row.indptr[row + 1]] for row in rows])
        taken = np.unique(colour[others])
        free = np.setdiff1d(np.arange(len(taken) + 1), taken, assume_unique=True)
        colour[column] = free[0]
    return [np.flatnonzero(colour == one) for one in range(colour.max(initial=-1) + 1)]


def slopes(
    function: Callable[[np.ndarray], np.ndarray], x: np.ndarray, pattern: Any, step: float, size: float = 0.0
) -> tuple[Any, np.ndarray]:
    """The derivative of a function of a vector by central differences, and the columns at which the slopes on both sides differ.

    ``pattern``: which entries may differ from zero. There are two calls for each colour. ``size``: of a slope that is not small, where all
    of them may be rounding."""
    here = function(x)

    def ends(moved: np.ndarray) -> np.ndarray:
        ahead, behind = function(x + moved), function(x - moved)
        return np.stack([ahead - behind, np.abs(ahead - 2 * here + behind)]) / step

    both, jumps, columns = _by_colours(ends, pattern, step)
    both.data /= 2
    return both, np.unique(columns[jumps > EDGE * np.abs(both.data).max(initial=size)])


def slopes_ahead(function: Callable[[np.ndarray], np.ndarray], x: np.ndarray, pattern: Any, step: float) -> Any:
    """The derivative by forward differences, with half as many calls: to 1e-6, the step relative to the size of a facet, for small terms."""
    here = function(x)
    return _by_colours(lambda moved: np.stack([function(x + moved) - here] * 2) / step, pattern, step)[0]


def _by_colours(function: Callable[[np.ndarray], np.ndarray], pattern: Any, step: float) -> tuple[Any, np.ndarray, np.ndarray]:
    """A matrix of the first row of the function's values, and the second row and the column by entry."""
    from scipy.sparse import csc_matrix

    by_column = pattern.tocsc()
    values = np.zeros((2, by_column.nnz))
    columns = np.repeat(np.arange(pattern.shape[1]), np.diff(by_column.indptr))
    for group in colours(pattern):
        moved = np.zeros(pattern.shape[1])
        moved[group] = step
        places = np.concatenate([np.arange(by_column.indptr[one], by_column.indptr[one + 1]) for one in group])
        values[:, places] = function(moved)[:, by_column.indices[places]]
    return csc_matrix((values[0], by_column.indices, by_column.indptr), pattern.shape), values[1], columns
