"""Displacements whose unknowns are no nodes of second order: forces and tangent come back to the space's own unknowns."""

import basix
import numpy as np
import pytest
import ufl
from dolfinx import fem
from dolfinx import mesh as dmesh
from dolfinx.fem import petsc
from fmc_contact_dolfinx import DolfinxContact, LayoutError, by_input_number, set_by_input_number
from fmc_contact_dolfinx.versions import cell_dofs, mesh_from_cells, vector_of
from mpi4py import MPI
from scenes import NAMES, block
from scipy.sparse import csr_matrix

SPACES = {
    "P3": ("triangle", "Lagrange", 3),
    "P4": ("triangle", "Lagrange", 4),
    "Q3": ("quad", "Lagrange", 3),
    "S2": ("quad", "S", 2),
    "Q3 3D": ("hexahedron", "Lagrange", 3),
}


def space(name):
    kind, family, degree = SPACES[name]
    dim = NAMES[kind]
    mesh = mesh_from_cells(MPI.COMM_WORLD, *block(kind, 2, [0.0] * dim, [1.0] * dim), kind)
    if hasattr(fem, "functionspace"):
        return fem.functionspace(mesh, (family, degree, (dim,)))
    return fem.VectorFunctionSpace(mesh, (family, degree))


def on_plane(name, **options):
    V = space(name)
    dim = V.mesh.geometry.dim
    contact = DolfinxContact(V, stiffness=1e4, law="fiber", estimator="exact", **options)
    up = np.eye(dim)[-1]
    contact.contact.obstacles.add_half_space(0.01 * up, up)
    return V, contact


@pytest.mark.parametrize("name", SPACES)
def test_uniform_pressure_is_the_load_of_the_shape_functions(name):
    V, contact = on_plane(name)
    dim = V.mesh.geometry.dim
    facets = dmesh.locate_entities_boundary(V.mesh, dim - 1, lambda x: np.isclose(x[dim - 1], 0.0))
    tags = dmesh.meshtags(V.mesh, dim - 1, np.sort(facets), np.ones(len(facets), np.int32))
    ds = ufl.Measure("ds", V.mesh, subdomain_data=tags, metadata={"quadrature_degree": 8})
    load = fem.Function(V)
    petsc.assemble_vector(vector_of(load), fem.form(100.0 * ufl.TestFunction(V)[dim - 1] * ds(1)))
    expected = load.x.array
    assert np.abs(contact.force(fem.Function(V)) - expected).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.parametrize("name", SPACES)
def test_forces_are_those_of_nodes_brought_back(name):
    """Against the same cells whose nodes are moved by themselves."""
    V, contact = on_plane(name)
    u = 1e-3 * np.random.default_rng(1).standard_normal(len(fem.Function(V).x.array))
    found = contact.evaluate(u)
    dim = contact.dim
    nodes = contact._shows._undeformed + contact._shows._matrix @ contact.coords(u)[dim:]
    # Corners are where dolfinx has them.
    cell = getattr(basix.CellType, contact._fields[0].kind)
    basis = np.asarray(V.element.basix_element.tabulate(0, basix.geometry(cell)))
    basis = basis[0].reshape(basis.shape[1], -1)
    at = np.einsum("pk,ckd->cpd", basis, u.reshape(-1, dim)[cell_dofs(V)])
    corners = V.mesh.geometry.x[contact._fields[0].corner_geometry()][:, :, :dim] + at
    shown = {tuple(x) for x in np.round(nodes, 9)}
    assert all(tuple(x) in shown for x in np.round(corners.reshape(-1, dim), 9))
    contact.contact.mesh.set_basis(None)
    of_nodes = contact.contact.evaluate(nodes)
    expected = contact._shows._matrix.T @ of_nodes.forces
    assert np.abs(found.forces[dim:] - expected).max() < 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("name", SPACES)
def test_tangent_is_the_derivative_of_the_force(name):
    V, contact = on_plane(name)
    random = np.random.default_rng(2)
    size = len(fem.Function(V).x.array)
    u, way, h = 1e-3 * random.standard_normal(size), random.standard_normal(size), 1e-7
    # The bottom bulges, so that no wall is in contact, where the law "fiber" has steps.
    bulge = fem.Function(V)
    bulge.interpolate(lambda x: np.array([*(0 * x[: contact.dim - 1]), 0.2 * ((x[: contact.dim - 1] - 0.5) ** 2).sum(axis=0)]))
    u += bulge.x.array
    contact.keep_patches(u)
    by_differences = (contact.force(u - h * way) - contact.force(u + h * way)) / (2 * h)
    tangent, unknowns = contact.tangent(u), contact.unknowns()
    matrix = csr_matrix((tangent.values, (unknowns[tangent.rows], unknowns[tangent.cols])), (size, size))
    found = matrix @ way
    assert np.abs(found).max() > 0
    assert np.abs(found - by_differences).max() < 1e-6 * np.abs(found).max()


def test_what_cannot_be_read_is_refused():
    """A cubic on the face of a tetrahedron has an unknown in its middle, where there is no node."""
    SPACES["P3 3D"] = ("tetra", "Lagrange", 3)
    SPACES["DG"] = ("triangle", "DG", 2)
    try:
        with pytest.raises(LayoutError, match="faces of tetrahedra|turned"):
            DolfinxContact(space("P3 3D"), stiffness=1.0)
        with pytest.raises(LayoutError, match="Lagrange"):
            DolfinxContact(space("DG"), stiffness=1.0)
    finally:
        del SPACES["P3 3D"], SPACES["DG"]
    _V, contact = on_plane("P3")
    with pytest.raises(LayoutError, match="no nodes"):
        contact.function(np.zeros(3))


def test_displacements_of_vertices_by_input_number():
    V, _contact = on_plane("Q3")
    u = fem.Function(V)
    u.interpolate(lambda x: np.array([x[0] + 2 * x[1] ** 3, x[0] * x[1]]))
    x, _ = block("quad", 2, [0.0] * 2, [1.0] * 2)
    expected = np.column_stack([x[:, 0] + 2 * x[:, 1] ** 3, x[:, 0] * x[:, 1]])
    assert np.abs(by_input_number(u) - expected).max() < 1e-12
    with pytest.raises(LayoutError, match="no nodes"):
        set_by_input_number(u, expected)
