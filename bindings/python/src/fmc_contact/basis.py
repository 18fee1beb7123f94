"""A host's own shape functions, as a matrix from its unknowns to the nodes of the mesh."""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np

from ._arrays import floats, shape_error
from ._rows import csr_struct


def compressed(matrix: Optional[Any], node_count: int) -> tuple[int, Any, object]:
    """Number of unknowns, the matrix for ``fmc_context_set_basis``, and the arrays to which it points."""
    if matrix is None:
        return 0, None, None
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
    weights, arrays = csr_struct(indptr, indices, floats(data, "matrix"))
    return matrix.shape[1], byref(weights), (weights, arrays)
