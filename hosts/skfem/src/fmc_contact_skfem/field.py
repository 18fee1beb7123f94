"""Which displacements can be read: vector fields of first or second order on the vertices of a mesh, and others by a matrix."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import skfem
from fmc_contact._cells import face_numbers
from fmc_contact.second_order import MIDDLES, of_nodes
from scipy.sparse import csr_matrix
from skfem import CellBasis, ElementVector

from .errors import LayoutError
from .other_basis import carrier, from_unknowns

# scikit-fem's cube counts its corners from the far end; VTK goes around the bottom, then around the top.
#
#        3-------0                7-------6
#       /|      /|               /|      /|        z
#      6-------2 |              4-------5 |        | y
#      | 5-----|-1              | 3-----|-2        |/
#      |/      |/               |/      |/         0--x
#      7-------4                0-------1
#      scikit-fem               VTK
_VTK_HEXAHEDRON = [7, 4, 1, 5, 6, 2, 0, 3]

_CELLS = [
    (skfem.MeshTri1, "triangle", [0, 1, 2]),
    (skfem.MeshQuad1, "quad", [0, 1, 2, 3]),
    (skfem.MeshTet1, "tetra", [0, 1, 2, 3]),
    (skfem.MeshHex1, "hexahedron", _VTK_HEXAHEDRON),
]
# Wedges came with scikit-fem 8; there are no pyramids.
if hasattr(skfem, "MeshWedge1"):
    _CELLS.append((skfem.MeshWedge1, "wedge", [0, 1, 2, 3, 4, 5]))

_FIRST_ORDER = (skfem.ElementTriP1, skfem.ElementQuad1, skfem.ElementTetP1, skfem.ElementHex1) + (
    (skfem.ElementWedge1,) if hasattr(skfem, "ElementWedge1") else ()
)
_SECOND_ORDER = (
    skfem.ElementTriP2, skfem.ElementQuad2, skfem.ElementQuadS2, skfem.ElementTetP2, skfem.ElementHex2,
    skfem.ElementHexS2,
)  # fmt: skip


class Field(NamedTuple):
    """One basis, as contact sees it. Its nodes are the vertices of the mesh, then the other places with unknowns."""

    basis: CellBasis
    cell_type: str
    conn: np.ndarray
    """Nodes of the cells, (cells, nodes), in the order of ``fmc_contact``."""
    dofs: np.ndarray
    """Degrees of freedom of the nodes, or of the unknowns that move them, (nodes or unknowns, dim), offset included."""
    coords: np.ndarray
    """Undeformed coordinates of the nodes, (nodes, dim)."""
    reach: int
    """One more than the last degree of freedom in the vectors of the whole problem."""
    matrix: csr_matrix | None = None
    """From unknowns to nodes, where unknowns are not the nodes."""

    def faces_on(self, boundaries: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
        """Faces on named boundaries of the mesh: their cells, and their numbers in these as ``BoundaryFacets`` counts them."""
        mesh = self.basis.mesh
        known = mesh.boundaries or {}
        facets = np.concatenate([np.empty(0, np.int64), *(known[name] for name in boundaries if name in known)])
        straight, _ = cells_of(mesh)
        order = next(order for _, name, order in _CELLS if name == straight)
        numbers = face_numbers(straight, np.array([np.isin(order, corners) for corners in mesh.elem.refdom.facets]))
        cells = mesh.f2t[0, facets]
        return cells, numbers[np.argmax(mesh.t2f[:, cells] == facets, axis=0)]


def cells_of(mesh: skfem.Mesh) -> tuple[str, np.ndarray]:
    """Type of the cells by their corners, as ``fmc_contact`` calls it, and the corners in VTK's order, (cells, corners)."""
    for kind, name, order in _CELLS:
        if isinstance(mesh, kind):
            return name, np.ascontiguousarray(mesh.t[order].T)
    raise LayoutError(
        f"a mesh of {type(mesh).__name__} is not supported: expected triangles, quadrilaterals, tetrahedra, hexahedra or wedges"
    )


def mesh_from_cells(coords: np.ndarray, conn: np.ndarray, cell_type: str) -> skfem.Mesh:
    """The mesh with these nodes, (nodes, dim), and cells in VTK's order: nodes and cells keep their numbers."""
    for kind, name, order in _CELLS:
        if name == cell_type:
            t = np.ascontiguousarray(np.asarray(conn, np.int64).T[np.argsort(order)])
            return kind(np.ascontiguousarray(np.asarray(coords, np.float64).T), t)
    raise LayoutError(f"no cells of type {cell_type!r}")


def field(basis: CellBasis, offset: int = 0) -> Field:
    """A basis, checked."""
    element = getattr(basis, "elem", None)
    if not isinstance(element, ElementVector):
        raise LayoutError(
            f"the basis has the element {type(element).__name__}, expected a displacement: "
            "ElementVector(ElementTriP1()) or the like"
        )
    mesh = basis.mesh
    dim = mesh.dim()
    if element.dim != dim:
        raise LayoutError(f"the displacement has {element.dim} components in {dim}D")
    straight, corners = cells_of(mesh)
    if basis.nelems != mesh.nelements:
        raise LayoutError("the basis is of a part of its mesh only: restrict the mesh, not the basis")
    if not isinstance(element.elem, _FIRST_ORDER + _SECOND_ORDER):
        return _other(basis, straight, int(offset))
    if mesh.elem not in _FIRST_ORDER and mesh.elem is not type(element.elem):
        raise LayoutError(
            f"the mesh has curved cells of {mesh.elem.__name__}, the displacement is of {type(element.elem).__name__}: "
            "expected the same"
        )
    if len(basis.nodal_dofs) != dim:
        raise LayoutError(f"the basis has {len(basis.nodal_dofs)} unknowns at a vertex, expected {dim}")
    if isinstance(element.elem, _FIRST_ORDER):
        cell_type, conn, dofs = straight, corners, basis.nodal_dofs.T
    else:
        cell_type, conn, dofs = _second_order(basis, straight)
    if mesh.elem is type(element.elem) and mesh.elem not in _FIRST_ORDER:
        # Its own places to the bit; every place has its components one after another.
        coords = mesh.doflocs[:, dofs[:, 0] // dim].T.copy()
    else:
        coords = basis.doflocs[:, dofs[:, 0]].T.copy()
        coords[: mesh.nvertices] = mesh.p[:, : mesh.nvertices].T
    return Field(basis, cell_type, conn, dofs + int(offset), coords, basis.N + int(offset))


def _other(basis: CellBasis, straight: str, offset: int) -> Field:
    """A displacement of another element, by cells of second order on its mesh."""
    nodes = field(CellBasis(basis.mesh, ElementVector(carrier(basis.mesh)()), intorder=2))
    order = next(order for _, name, order in _CELLS if name == straight)
    corners = basis.elem.elem.refdom.p.T[order]
    matrix, dofs = from_unknowns(basis, nodes.cell_type, corners, nodes.conn)
    return Field(basis, nodes.cell_type, nodes.conn, dofs + offset, nodes.coords, basis.N + offset, matrix)


def _second_order(basis: CellBasis, straight: str) -> tuple[str, np.ndarray, np.ndarray]:
    """Type, nodes of the cells and unknowns of the nodes."""
    dim, element = basis.mesh.dim(), basis.elem.elem
    places = element.doflocs
    cell_type = of_nodes(straight, len(places))
    assert cell_type is not None, "elements of second order have cells of second order"
    order = next(order for _, name, order in _CELLS if name == straight)
    corners = element.refdom.p.T[order]
    nodes = np.concatenate([corners, [corners[list(ends)].mean(axis=0) for ends in MIDDLES[cell_type]]])
    apart = np.abs(nodes[:, None] - places[None]).sum(axis=2)
    local = apart.argmin(axis=1)
    assert (apart.min(axis=1) == 0.0).all(), "the nodes of the element are corners and middles"
    kinds = [basis.nodal_dofs, basis.edge_dofs, basis.facet_dofs, basis.interior_dofs]
    dofs = np.concatenate([kind.T for kind in kinds if len(kind)])
    number = np.empty(basis.N, np.int64)
    number[dofs[:, 0]] = np.arange(len(dofs))
    # Unknowns of a cell: all components of a node, node after node.
    return cell_type, np.ascontiguousarray(number[basis.element_dofs[local * dim]].T), dofs
