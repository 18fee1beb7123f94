"""Displacements of any continuous element, read at the nodes of cells of second order."""

from __future__ import annotations

import numpy as np
import skfem
from fmc_contact.second_order import readings
from scipy.sparse import coo_matrix, csr_matrix
from skfem import CellBasis

from .errors import LayoutError

# Values of shape functions on nodes are of size one: what is smaller than this is rounding.
_ROUNDING = 1e-11


def from_unknowns(basis: CellBasis, cell_type: str, corners: np.ndarray, conn: np.ndarray) -> tuple[csr_matrix, np.ndarray]:
    """The matrix from a basis' unknowns to the nodes of cells, (nodes, unknowns), and the degrees of freedom of the
    unknowns, (unknowns, dim). ``corners``: those of the reference cell in the order of ``cell_type``; ``conn``: (cells,
    nodes). Errors: ``LayoutError`` where cells that share a node do not agree on its displacement, or uniform pressure on a
    face would not be brought back right."""
    element, dim = basis.elem.elem, basis.mesh.dim()
    name = type(element).__name__
    dofs_of_cells = basis.element_dofs[::dim]
    local = len(dofs_of_cells)
    places, weights, unread = readings(cell_type, corners)
    values = np.empty((local, len(conn), conn.shape[1]))
    for k in range(local):
        found = element.gbasis(basis.mapping, np.ascontiguousarray(places.T), k)[0]
        # A field was a tuple before it became an array.
        at_places = np.asarray(found if isinstance(found, np.ndarray) else found.value)
        if at_places.ndim != 2:
            raise LayoutError(f"the displacement is of {name}, whose functions are no numbers")
        if len(unread) and np.abs(at_places @ unread.T).max() > _ROUNDING:
            raise LayoutError(
                f"the displacement is of {name}, which has functions on the faces of tetrahedra that nodes of second order "
                "cannot follow"
            )
        values[k] = at_places @ weights.T
    values[np.abs(values) < _ROUNDING] = 0.0
    first_dofs, unknown = np.unique(dofs_of_cells, return_inverse=True)
    unknown = unknown.reshape(dofs_of_cells.shape)
    dofs = np.empty((len(first_dofs), dim), np.int64)
    for axis in range(dim):
        dofs[unknown, axis] = basis.element_dofs[axis::dim]
    # A row for every node of every cell; those of one node are the same.
    rows = np.broadcast_to(np.arange(conn.size).reshape(conn.shape), values.shape)
    cols = np.broadcast_to(unknown[:, :, None], values.shape)
    shape = (conn.size, len(first_dofs))
    of_cells = coo_matrix((values.ravel(), (rows.ravel(), cols.ravel())), shape).tocsr()
    of_cells.eliminate_zeros()
    nodes, first = np.unique(conn.ravel(), return_index=True)
    matrix = of_cells[first]
    apart = abs(of_cells - matrix[np.searchsorted(nodes, conn.ravel())])
    if apart.nnz and apart.max() > 10 * _ROUNDING:
        raise LayoutError(
            f"the displacement is of {name}: its cells do not agree where they meet, or not at a node; continuous elements, "
            "such as Lagrange elements, are wanted"
        )
    return matrix, dofs


def carrier(mesh: skfem.Mesh) -> type:
    """The element of second order whose nodes stand for a displacement of another kind."""
    for kind, element in (
        (skfem.MeshTri1, skfem.ElementTriP2),
        (skfem.MeshQuad1, skfem.ElementQuad2),
        (skfem.MeshTet1, skfem.ElementTetP2),
        (skfem.MeshHex1, skfem.ElementHex2),
    ):
        if isinstance(mesh, kind):
            return element
    raise LayoutError(f"on a mesh of {type(mesh).__name__} Lagrange elements of first order are wanted")

