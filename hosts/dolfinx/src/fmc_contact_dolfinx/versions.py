"""Where releases of dolfinx differ, 0.5 to 0.11: features are tested for, versions are not compared."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
import ufl
from dolfinx import fem
from dolfinx import mesh as dmesh

from .cells import CELL_TYPES, SECOND_ORDER, sorted_places


def vector_space(mesh: Any, order: int = 1) -> Any:
    """Displacements of this order on a mesh."""
    dim = mesh.geometry.dim
    if hasattr(fem, "functionspace"):
        return fem.functionspace(mesh, ("Lagrange", order, (dim,)))
    return fem.VectorFunctionSpace(mesh, ("Lagrange", order))


def mesh_from_cells(comm: Any, coords: np.ndarray, conn: np.ndarray, cell_type: str) -> Any:
    """A mesh of these nodes, (nodes, dim), and cells in VTK's order; all of them on rank 0, none on other ranks. Cells of second order,
    ``triangle6``, ``quad9``, ``tetra10`` or ``hexahedron27``, may be curved.

    The row of a node is its input number, whatever the ranks are.
    """
    degree = 2 if cell_type in SECOND_ORDER.values() else 1
    name = {ours: theirs for theirs, ours in (SECOND_ORDER if degree == 2 else CELL_TYPES).items()}[cell_type]
    coords = np.asarray(coords, np.float64)
    dim = coords.shape[1]
    # Lagrange elements have one node on every entity, in the order of the entities.
    cells = np.asarray(conn, np.int64)[:, sorted_places(name, cell_type)]
    if comm.rank != 0:
        coords, cells = coords[:0], cells[:0]
    cells, coords = np.ascontiguousarray(cells), np.ascontiguousarray(coords)
    if hasattr(ufl, "VectorElement"):
        element = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.Cell(name, geometric_dimension=dim), degree))
    else:
        import basix.ufl

        element = basix.ufl.element("Lagrange", name, degree, shape=(dim,))
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
    return _rows(table, _cell_count(mesh), geometry_layout(mesh).num_dofs)


def geometry_layout(mesh: Any) -> Any:
    """Which geometry nodes of a cell stand on which of its entities."""
    geometry = mesh.geometry
    cmap = geometry.cmaps[0] if hasattr(geometry, "cmaps") else geometry.cmap
    return cmap.create_dof_layout()


def cell_dofs(space: Any) -> np.ndarray:
    """Blocks of unknowns of all cells here, ghosts last, (cells, blocks)."""
    return _rows(space.dofmap.list, _cell_count(space.mesh), space.dofmap.dof_layout.num_dofs)


def cell_name(mesh: Any) -> str:
    """``triangle``, ``quadrilateral``, ``tetrahedron``, ``hexahedron``, ``prism`` or ``pyramid``."""
    kind = mesh.topology.cell_type if hasattr(mesh.topology, "cell_type") else mesh.topology.cell_types[0]
    return str(getattr(kind, "name", kind)).split(".")[-1]


def is_on(tags: Any, mesh: Any) -> bool:
    """Whether mesh tags are of this mesh: where its topology is stored, since wrappers of it are made anew."""
    theirs = tags.topology if hasattr(tags, "topology") else tags.mesh.topology
    cells = [topology.connectivity(mesh.topology.dim, 0).array for topology in (theirs, mesh.topology)]
    return cells[0].ctypes.data == cells[1].ctypes.data and len(cells[0]) == len(cells[1])


def held_dofs(bc: Any) -> np.ndarray:
    """Unknowns, not blocks, of this rank that a boundary condition holds, ghosts included."""
    found = bc.dof_indices() if hasattr(bc, "dof_indices") else bc._cpp_object.dof_indices()
    return np.asarray(found[0])
