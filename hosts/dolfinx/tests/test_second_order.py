"""Second order: cells with all their nodes, straight or curved, as the package and scikit-fem have them."""

import numpy as np
import pytest
import ufl
from dolfinx import fem
from fmc_contact import Contact
from fmc_contact.second_order import MIDDLES
from fmc_contact_dolfinx import DolfinxContact, LayoutError, by_input_number
from fmc_contact_dolfinx.cells import CELL_TYPES, SECOND_ORDER
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_of, vector_space
from mpi4py import MPI
from scenes import NAMES, block, blocks, interpolate, space

OURS = {CELL_TYPES[theirs]: ours for theirs, ours in SECOND_ORDER.items()}
LAWS = {
    "default": {},
    "fiber": {"law": "fiber", "estimator": "exact"},
    "volume": {"law": "volume", "estimator": "exact"},
}


def quadratic(kind, bend=0.0):
    """Nodes and cells of second order of the two blocks; ``bend`` moves every node, middles off their edges."""
    x, cells = blocks(kind)
    nodes, number, conn = list(x), {}, []
    for cell in cells.tolist():
        found = list(cell)
        for ends in MIDDLES[OURS[kind]]:
            corners = tuple(sorted(cell[k] for k in ends))
            if corners not in number:
                number[corners] = len(nodes)
                nodes.append(x[list(corners)].mean(axis=0))
            found.append(number[corners])
        conn.append(found)
    x = np.array(nodes)
    return x + bend * np.sin(5.0 * x + 3.0 * x[:, ::-1]), np.array(conn)


def curved(kind):
    return mesh_from_cells(MPI.COMM_WORLD, *quadratic(kind, 0.01), OURS[kind])


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("law", LAWS)
def test_forces_on_curved_cells_are_those_of_the_package(kind, law):
    """Nodes of a curved mesh have input numbers, by which both count: the same bits."""
    V = vector_space(curved(kind), 2)
    x, cells = quadratic(kind, 0.01)
    u = interpolate(fem.Function(V))
    contact = DolfinxContact(V, stiffness=1e4, **LAWS[law])
    moved = x + by_input_number(u)
    assert (contact.coords(u) == moved).all()
    alone = Contact(x, cells, OURS[kind], stiffness=1e4, **LAWS[law]).evaluate(moved)
    force = fem.Function(V)
    force.x.array[:] = contact.force(u)
    assert alone.volume > 1e-4 and (by_input_number(force) == alone.forces).all()


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("bend", [0.0, 0.01])
def test_forces_are_those_of_scikit_fem(kind, law, bend):
    """Node by node, to rounding: nodes and cells are numbered in another way.

    On curved faces in space the default law sums points up, on triangles that depend on the order of the corners.
    """
    skfem = pytest.importorskip("skfem")
    adapter = pytest.importorskip("fmc_contact_skfem")
    from fmc_contact_skfem.field import mesh_from_cells as straight_mesh

    V = vector_space(curved(kind), 2) if bend else space(kind, 2)
    u = interpolate(fem.Function(V))
    ours = DolfinxContact(V, stiffness=1e4, **LAWS[law]).force(u).reshape(-1, NAMES[kind])
    places = V.tabulate_dof_coordinates()[:, : NAMES[kind]]

    straight = straight_mesh(*blocks(kind), kind)
    names = {
        "triangle": ("MeshTri2", "ElementTriP2"),
        "quad": ("MeshQuad2", "ElementQuad2"),
        "tetra": ("MeshTet2", "ElementTetP2"),
        "hexahedron": ("MeshHex2", "ElementHex2"),
    }
    mesh_type, element = (getattr(skfem, name) for name in names[kind])
    mesh = straight
    if bend:
        mesh = mesh_type.from_mesh(straight)
        x = mesh.doflocs
        mesh = mesh_type(x + bend * np.sin(5.0 * x + 3.0 * x[::-1]), mesh.t)
    basis = skfem.Basis(mesh, skfem.ElementVector(element()))
    contact = adapter.SkfemContact(basis, stiffness=1e4, **LAWS[law])
    at = contact._undeformed
    # The nodes of one among those of the other, by their places.
    match = np.array([np.abs(places - point).sum(axis=1).argmin() for point in at])
    assert len(set(match.tolist())) == len(places) == len(at)
    assert np.abs(places[match] - at).max() < 1e-12
    v = np.zeros(contact.size)
    v[contact._dofs] = u.x.array.reshape(-1, NAMES[kind])[match]
    theirs = contact.force(v)[contact._dofs]
    assert np.abs(theirs).max() > 1e-3
    within = 1e-3 if bend and law == "default" and NAMES[kind] == 3 else 1e-8
    assert np.abs(ours[match] - theirs).max() < within * np.abs(theirs).max()


@pytest.mark.parametrize("kind", NAMES)
def test_uniform_pressure_is_the_load_of_the_shape_functions(kind):
    """On a rigid plane, as dolfinx integrates the load of its bottom."""
    from dolfinx import mesh as dmesh
    from dolfinx.fem import petsc

    dim = NAMES[kind]
    V = vector_space(mesh_from_cells(MPI.COMM_WORLD, *block(kind, 2, [0.0] * dim, [1.0] * dim), kind), 2)
    contact = DolfinxContact(V, stiffness=1e4, law="fiber", estimator="exact")
    up = np.eye(dim)[-1]
    contact.contact.obstacles.add_half_space(0.01 * up, up)
    facets = dmesh.locate_entities_boundary(V.mesh, dim - 1, lambda x: np.isclose(x[dim - 1], 0.0))
    tags = dmesh.meshtags(V.mesh, dim - 1, np.sort(facets), np.ones(len(facets), np.int32))
    ds = ufl.Measure("ds", V.mesh, subdomain_data=tags, metadata={"quadrature_degree": 4})
    load = fem.Function(V)
    petsc.assemble_vector(vector_of(load), fem.form(100.0 * ufl.TestFunction(V)[dim - 1] * ds(1)))
    expected = load.x.array
    assert np.abs(contact.force(fem.Function(V)) - expected).max() < 1e-9 * np.abs(expected).max()


def test_curved_meshes_want_second_order():
    with pytest.raises(LayoutError, match="geometry nodes"):
        DolfinxContact(vector_space(curved("triangle"), 1), stiffness=1.0)
