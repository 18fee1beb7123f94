"""A host's own shape functions, as a matrix from its unknowns to the nodes of the mesh."""

from __future__ import annotations

from typing import Any

import numpy as np


def compressed(matrix: Any | None, node_count: int, index_base: int) -> tuple[int, Any, Any, Any, int]:
    """What ``fmc_context_set_basis`` asks for: number of unknowns, rows, unknowns, weights and number of entries."""
    if matrix is None:
        return 0, None, None, None, 0
    if hasattr(matrix, "tocsr"):
        rows = matrix.tocsr()
        indptr, indices, data = rows.indptr, rows.indices, rows.data
    else:
        matrix = np.asarray(matrix, np.float64)
        if matrix.ndim != 2:
            raise ValueError(f"the matrix has shape {matrix.shape}, (nodes, unknowns) is wanted")
        row, indices = np.nonzero(matrix)
        indptr, data = np.concatenate([[0], np.cumsum(np.bincount(row, minlength=len(matrix)))]), matrix[row, indices]
    if matrix.shape[0] != node_count:
        raise ValueError(f"the matrix has shape {matrix.shape}, the mesh has {node_count} nodes")
    unknowns = np.ascontiguousarray(indices, np.int64) + index_base
    weights = np.ascontiguousarray(data, np.float64)
    return matrix.shape[1], np.ascontiguousarray(indptr, np.int64), unknowns, weights, len(weights)
