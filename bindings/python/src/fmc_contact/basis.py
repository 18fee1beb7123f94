"""A host's own shape functions, as a matrix from its unknowns to the nodes of the mesh."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._arrays import floats, shape_error


def compressed(matrix: Optional[Any], node_count: int, index_base: int) -> tuple[int, Any, Any, Any, int]:
    """What ``fmc_context_set_basis`` asks for: number of unknowns, rows, unknowns, weights and number of entries."""
    if matrix is None:
        return 0, None, None, None, 0
    if hasattr(matrix, "tocsr"):
        rows = matrix.tocsr()
        indptr, indices, data = rows.indptr, rows.indices, rows.data
    else:
        matrix = floats(matrix, "matrix")
        if matrix.ndim != 2:
            raise shape_error("matrix", matrix.shape, f"({node_count}, unknowns)")
        row, indices = np.nonzero(matrix)
        indptr, data = np.concatenate([[0], np.cumsum(np.bincount(row, minlength=len(matrix)))]), matrix[row, indices]
    if matrix.shape[0] != node_count:
        raise shape_error("matrix", matrix.shape, f"({node_count}, unknowns)")
    unknowns = np.ascontiguousarray(indices, np.int64) + index_base
    weights = np.ascontiguousarray(floats(data, "matrix"))
    return matrix.shape[1], np.ascontiguousarray(indptr, np.int64), unknowns, weights, len(weights)
