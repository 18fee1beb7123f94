"""Where releases of dolfinx differ, 0.5 to 0.11: features are tested for, versions are not compared."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
import ufl
from dolfinx import fem
from dolfinx import mesh as dmesh


def vector_space(mesh: Any, order: int = 1) -> Any:
    """Displacements of this order on a mesh."""
    dim = mesh.geometry.dim
    if hasattr(fem, "functionspace"):
        return fem.functionspace(mesh, ("Lagrange", order, (dim,)))
    return fem.VectorFunctionSpace(mesh, ("Lagrange", order))


def mesh_from_cells(comm: Any, coords: np.ndarray, conn: np.ndarray, cell_type: str) -> Any:
    """A mesh of these nodes, (nodes, dim), and cells in VTK's order; all of them on rank 0, none on the others.

    The row of a node is its input number, whatever the ranks are.
    """
    name = {ours: theirs for theirs, ours in CELL_TYPES.items()}[cell_type]
    coords = np.asarray(coords, np.float64)
    dim = coords.shape[1]
    cells = np.asarray(conn, np.int64)[:, TENSOR_ORDER[cell_type]]
    if comm.rank != 0:
        coords, cells = coords[:0], cells[:0]
    cells, coords = np.ascontiguousarray(cells), np.ascontiguousarray(coords)
    if hasattr(ufl, "VectorElement"):
        element = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.Cell(name, geometric_dimension=dim), 1))
    else:
        import basix.ufl

        element = basix.ufl.element("Lagrange", name, 1, shape=(dim,))
    # The element has moved from the last place to the one before.
    order = list(inspect.signature(dmesh.create_mesh).parameters)
    if order.index("x") > order.index("e" if "e" in order else "domain"):
        return dmesh.create_mesh(comm, cells, element, coords)
    return dmesh.create_mesh(comm, cells, coords, element)


def vector_of(function: Any) -> Any:
    """The PETSc vector of a function. It does not keep the function alive."""
    return function.x.petsc_vec if hasattr(function.x, "petsc_vec") else function.vector


def create_vector(form: Any, space: Any) -> Any:
    """A PETSc vector for residuals."""
    from dolfinx.fem import petsc

    parameters = inspect.signature(petsc.create_vector).parameters
    return petsc.create_vector(form if next(iter(parameters)) in ("L", "form") else space)


def _rows(adjacency: Any, count: int, width: int) -> np.ndarray:
    array = np.asarray(adjacency.array if hasattr(adjacency, "array") else adjacency)
    # A rank may have no cells; the cell width is then unknown.
    return array.reshape(count, -1) if count else array.reshape(0, width)


def _cell_count(mesh: Any) -> int:
    cells = mesh.topology.index_map(mesh.topology.dim)
    return cells.size_local + cells.num_ghosts


def cell_geometry(mesh: Any) -> np.ndarray:
    """Geometry nodes of all cells here, ghosts last, (cells, nodes)."""
    geometry = mesh.geometry
    table = geometry.dofmaps[0] if hasattr(geometry, "dofmaps") else geometry.dofmap
    return _rows(table, _cell_count(mesh), CORNER_COUNT[cell_name(mesh)])


def cell_dofs(space: Any) -> np.ndarray:
    """Blocks of unknowns of all cells here, ghosts last, (cells, blocks)."""
    return _rows(space.dofmap.list, _cell_count(space.mesh), space.dofmap.dof_layout.num_dofs)


def cell_name(mesh: Any) -> str:
    """``triangle``, ``quadrilateral``, ``tetrahedron``, ``hexahedron``, ``prism`` or ``pyramid``."""
    kind = mesh.topology.cell_type if hasattr(mesh.topology, "cell_type") else mesh.topology.cell_types[0]
    return str(getattr(kind, "name", kind)).split(".")[-1]


def held_dofs(bc: Any) -> np.ndarray:
    """Unknowns, not blocks, of this rank that a boundary condition holds, ghosts included."""
    found = bc.dof_indices() if hasattr(bc, "dof_indices") else bc._cpp_object.dof_indices()
    return np.asarray(found[0])


# dolfinx counts the corners of quadrilaterals, hexahedra and the base of pyramids as a tensor product; VTK goes around.
# Prisms are counted as meshio counts wedges.
#
#      2-----3          3-----2          6-----7            7-----6
#      |     |          |     |         /|    /|           /|    /|
#      |     |          |     |        4-----5 |          4-----5 |
#      0-----1          0-----1        | 2---|-3          | 3---|-2
#      dolfinx          VTK            |/    |/           |/    |/
#                                      0-----1            0-----1
#
# Entry k is the corner of VTK that dolfinx counts as its k-th; both tables are their own inverse.
TENSOR_ORDER = {
    "triangle": [0, 1, 2],
    "quad": [0, 1, 3, 2],
    "tetra": [0, 1, 2, 3],
    "hexahedron": [0, 1, 3, 2, 4, 5, 7, 6],
    "wedge": [0, 1, 2, 3, 4, 5],
    "pyramid": [0, 1, 3, 2, 4],
}

CELL_TYPES = {
    "triangle": "triangle",
    "quadrilateral": "quad",
    "tetrahedron": "tetra",
    "hexahedron": "hexahedron",
    "prism": "wedge",
    "pyramid": "pyramid",
}

CORNER_COUNT = {"triangle": 3, "quadrilateral": 4, "tetrahedron": 4, "hexahedron": 8, "prism": 6, "pyramid": 5}
