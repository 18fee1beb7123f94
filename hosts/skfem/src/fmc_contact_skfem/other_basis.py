"""Displacements of any continuous element, read at the nodes of cells of second order."""

from __future__ import annotations

import numpy as np
import skfem
from fmc_contact.other_basis import ROUNDING, nodes_from_unknowns
from fmc_contact.second_order import readings
from scipy.sparse import csr_matrix
from skfem import CellBasis

from .errors import LayoutError


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
        if len(unread) and np.abs(at_places @ unread.T).max() > ROUNDING:
            raise LayoutError(
                f"the displacement is of {name}, which has functions on the faces of tetrahedra that nodes of second order "
                "cannot follow"
            )
        values[k] = at_places @ weights.T
    first_dofs, unknown = np.unique(dofs_of_cells, return_inverse=True)
    unknown = unknown.reshape(dofs_of_cells.shape)
    dofs = np.empty((len(first_dofs), dim), np.int64)
    for axis in range(dim):
        dofs[unknown, axis] = basis.element_dofs[axis::dim]
    matrix = nodes_from_unknowns(values, unknown, conn, len(first_dofs))
    if matrix is None:
        raise LayoutError(
            f"the displacement is of {name}: its cells do not agree where they meet, or not at a node; expected continuous elements, "
            "such as Lagrange elements"
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
    raise LayoutError(f"on a mesh of {type(mesh).__name__}: expected Lagrange elements of first order")

