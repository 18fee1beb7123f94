"""Which displacements can be read: vector fields of first or second order on the vertices of a mesh."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import skfem
from skfem import CellBasis, ElementVector

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
_SECOND_ORDER = (skfem.ElementTriP2, skfem.ElementQuad2, skfem.ElementTetP2, skfem.ElementHex2)


class LayoutError(TypeError):
    """The degrees of freedom of a basis are not those of a displacement that contact can read."""


class Field(NamedTuple):
    """One basis, as contact sees it."""

    basis: CellBasis
    offset: int
    """First degree of freedom of the basis in the vectors of the whole problem."""
    order: int
    cell_type: str
    conn: np.ndarray
    """Corners of the cells, (cells, corners), in the order of ``fmc_contact``."""

    @property
    def dofs(self) -> np.ndarray:
        """Degrees of freedom of the vertices, (vertices, dim)."""
        return self.basis.nodal_dofs.T + self.offset


def cells_of(mesh: skfem.Mesh) -> tuple[str, np.ndarray]:
    """Type of the cells, as ``fmc_contact`` calls it, and their corners in VTK's order, (cells, corners)."""
    for kind, name, order in _CELLS:
        if isinstance(mesh, kind):
            return name, np.ascontiguousarray(mesh.t[order].T)
    raise LayoutError(
        f"a mesh of {type(mesh).__name__} is not known here: triangles, quadrilaterals, tetrahedra, hexahedra or wedges "
        "are wanted"
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
            f"the basis has the element {type(element).__name__}, a displacement is wanted: "
            "ElementVector(ElementTriP1()) or the like"
        )
    if isinstance(element.elem, _FIRST_ORDER):
        order = 1
    elif isinstance(element.elem, _SECOND_ORDER):
        order = 2
    else:
        raise LayoutError(
            f"the displacement is of {type(element.elem).__name__}, Lagrange elements of order 1 or 2 are wanted"
        )
    dim = basis.mesh.dim()
    if element.dim != dim:
        raise LayoutError(f"the displacement has {element.dim} components in {dim}D")
    cell_type, conn = cells_of(basis.mesh)
    if len(basis.nodal_dofs) != dim:
        raise LayoutError(f"the basis has {len(basis.nodal_dofs)} unknowns at a vertex, {dim} are wanted")
    if basis.nelems != basis.mesh.nelements:
        raise LayoutError("the basis is of a part of its mesh only: restrict the mesh, not the basis")
    return Field(basis, int(offset), order, cell_type, conn)
