"""The matrix from a host's unknowns to the nodes of its cells, for adapters."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix

ROUNDING = 1e-11
"""Shape functions are of size one: what is smaller is rounding of theirs."""


def nodes_from_unknowns(values: np.ndarray, unknowns: np.ndarray, conn: np.ndarray, count: int) -> csr_matrix | None:
    """The matrix, (nodes, ``count``), from shape functions cell by cell: ``values`` at the nodes, (functions, cells, nodes of
    a cell), ``unknowns`` that they belong to, (functions, cells), and the cells' nodes ``conn``, (cells, nodes of a cell).
    ``None`` where two cells do not agree on a node."""
    values = np.where(np.abs(values) < ROUNDING, 0.0, values)
    # A row for every node of every cell; those of one node are the same.
    rows = np.broadcast_to(np.arange(conn.size).reshape(conn.shape), values.shape)
    cols = np.broadcast_to(unknowns[:, :, None], values.shape)
    of_cells = coo_matrix((values.ravel(), (rows.ravel(), cols.ravel())), (conn.size, count)).tocsr()
    of_cells.eliminate_zeros()
    nodes, first = np.unique(conn.ravel(), return_index=True)
    matrix = of_cells[first]
    apart = abs(of_cells - matrix[np.searchsorted(nodes, conn.ravel())])
    return None if apart.nnz and apart.max() > 10 * ROUNDING else matrix
