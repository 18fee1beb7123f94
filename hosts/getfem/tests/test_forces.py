"""Forces and tangent on the unknowns of a model, against the package itself and against differences."""

import getfem as gf
import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact_getfem import GetfemContact
from fmc_contact_getfem.cells import TYPES, element, mesh_from_cells, reference_places
from fmc_contact_getfem.field import field
from scenes import ELEMENTS, OPTIONS, moved, touching


@pytest.mark.parametrize("name", ["FEM_PK(2,1)", "FEM_QK(2,1)", "FEM_PK(3,1)", "FEM_QK(3,1)"])
def test_first_order_gives_the_bits_of_the_package(name):
    scene = touching(name)
    state = moved(scene.model)
    coords, cells, first = [], [], 0
    around = {"QK": [0, 1, 3, 2, 4, 5, 7, 6], "PK": [0, 1, 2, 3]}[name[4:6]]
    kind = {"FEM_PK(2,1)": "triangle", "FEM_QK(2,1)": "quad", "FEM_PK(3,1)": "tetra", "FEM_QK(3,1)": "hexahedron"}[name]
    for mesh in scene.meshes:
        points = mesh.pid_from_cvid()[0].reshape(mesh.nbcvs(), -1)
        cells.append((kind, points[:, [corner for corner in around if corner < points.shape[1]]] + first))
        coords.append(mesh.pts().T)
        first += mesh.nbpts()
    undeformed, displacement = np.concatenate(coords), np.empty((first, len(coords[0][0])))
    first = 0
    for variable, mesh, space in zip("uv", scene.meshes, scene.spaces):
        # Unknowns and points, found by their places.
        places = space.basic_dof_nodes()[:, :: space.qdim()].T
        near = np.abs(mesh.pts().T[:, None] - places[None]).sum(axis=2).argmin(axis=1)
        values = scene.model.variable(variable).reshape(-1, space.qdim())
        displacement[first : first + mesh.nbpts()] = values[near]
        first += mesh.nbpts()
    alone = Contact(undeformed, cells, **OPTIONS).evaluate(undeformed + displacement)
    ours = scene.contact.evaluate(state)
    assert alone.volume > 1e-4
    assert (ours.forces == alone.forces).all() and ours.energy == alone.energy


@pytest.mark.parametrize("name", ELEMENTS)
def test_force_is_minus_the_slope_of_the_energy(name):
    scene = touching(name)
    contact, state = scene.contact, moved(scene.model)
    contact.keep_patches(state)
    direction, step = np.random.default_rng(2).standard_normal(len(state)), 1e-6
    energies = [contact.evaluate(state + sign * step * direction).energy for sign in (-1, 1)]
    # Central differences of an energy with a continuous second derivative: the step squared, and rounding by the step.
    assert (energies[1] - energies[0]) / (2 * step) == pytest.approx(-contact.force(state) @ direction, rel=1e-6)


@pytest.mark.parametrize("name", ELEMENTS)
def test_forces_keep_their_sum_and_are_those_of_the_overlap(name):
    """Pressure k over the flat face of the narrower block: each element shares it out on its own nodes."""
    scene = touching(name, law="volume", exponent=1.0)
    result, force = scene.contact.evaluate(), scene.contact.force()
    dim = scene.spaces[0].qdim()
    for number, variable in enumerate("uv"):
        first, count = scene.contact.interval(variable)
        sums = force[first : first + count].reshape(-1, dim).sum(axis=0)
        assert sums == pytest.approx(result.bodies[number].force, rel=1e-12, abs=1e-12 * np.abs(force).max())
    area = 0.4 ** (dim - 1)
    assert result.volume == pytest.approx(0.02 * area, rel=1e-12)
    assert result.bodies[1].force[-1] == pytest.approx(1e4 * area, rel=1e-12)
    # As GetFEM's own integral over that face has it.
    mesh, _space = scene.meshes[1], scene.spaces[1]
    mesh.set_region(9, mesh.faces_from_pid(np.flatnonzero(mesh.pts()[-1] < 0.98 + 1e-9)))
    shared = gf.asm_generic(gf.MeshIm(mesh, 5), 1, f"1e4*Test_v({dim})", 9, scene.model)
    first, count = scene.contact.interval("v")
    up = slice(first + dim - 1, first + count, dim)
    assert np.abs(force[up] - shared[up]).max() < 1e-9 * np.abs(shared).max()


def test_cells_may_be_mixed_and_the_mesh_may_have_others():
    """A square beside a triangle, one body, in one variable; what has no element there is not seen."""
    mesh = gf.Mesh("empty", 2)
    mesh.add_convex(gf.GeoTrans("GT_PK(2,1)"), [[5.0, 6.0, 5.0], [0.0, 0.0, 1.0]])
    mesh.add_convex(gf.GeoTrans("GT_PK(2,1)"), [[1.0, 2.0, 1.0], [0.0, 0.0, 1.0]])
    mesh.add_convex(gf.GeoTrans("GT_QK(2,1)"), [[0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]])
    space = gf.MeshFem(mesh, 2)
    space.set_fem(gf.Fem("FEM_PK(2,1)"), [1])
    space.set_fem(gf.Fem("FEM_QK(2,1)"), [2])
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    contact = GetfemContact(model, "u", stiffness=1e4)
    assert contact.contact.body_count == 1 and contact.contact.node_count == 5
    contact.contact.obstacles.add_half_space([0.0, 0.01], [0.0, 1.0])
    # Depth 0.01 over a length of 2; at the triangle's tip, whose depth is bounded by its other side, a little less.
    assert contact.evaluate().bodies[0].force[1] == pytest.approx(200.0, rel=0.02)
    # Bodies of the caller's: in the order of the cells' numbers, whatever the order of their kinds.
    apart = GetfemContact(model, "u", bodies=[7, 3], stiffness=1e4)
    apart.contact.obstacles.add_half_space([0.0, 0.01], [0.0, 1.0])
    by_number = {one.force[1] for one in apart.evaluate().bodies}
    assert max(by_number) == pytest.approx(100.0, rel=0.02) and apart.contact.body_count == 2


@pytest.mark.parametrize("kind", TYPES)
def test_a_mesh_from_cells_keeps_their_numbers(kind):
    """One cell, sheared."""
    places = reference_places(kind)
    coords = places @ np.triu(0.1 + np.eye(places.shape[1]))
    mesh = mesh_from_cells(coords, [np.arange(len(coords))], kind)
    space = gf.MeshFem(mesh, places.shape[1])
    space.set_fem(element(kind))
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    found = field(model, "u")
    ((name, conn, cells),) = found.cells
    assert name == kind and conn.tolist() == [list(range(len(coords)))] and cells.tolist() == [0]
    assert found.coords == pytest.approx(coords, abs=1e-15)


def test_bodies_that_touch_have_a_mesh_each():
    with pytest.raises(ValueError, match="at one place"):
        mesh_from_cells([[0, 0], [1, 0], [0, 1], [0, 0]], [[0, 1, 2]], "triangle")


def test_curved_cells_are_where_their_nodes_are():
    """A disc of six curved triangles: pieces of parabolas, whose area is 0.24 % below a circle's, a hexagon's 17 %."""
    angle = np.arange(12) * np.pi / 6
    rim = np.column_stack([np.cos(angle), np.sin(angle)])
    middles = 0.5 * rim[::2]
    coords = np.concatenate([[[0.0, 0.0]], rim, middles])
    conn = [[0, 1 + 2 * k, 1 + (2 * k + 2) % 12, 13 + k, 2 + 2 * k, 13 + (k + 1) % 6] for k in range(6)]
    mesh = mesh_from_cells(coords, conn, "triangle6")
    space = gf.MeshFem(mesh, 2)
    space.set_fem(element("triangle6"))
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    contact = GetfemContact(model, "u", stiffness=1.0, law="volume", exponent=1.0)
    assert (contact.coords() == coords).all()
    contact.contact.obstacles.add_half_space([0.0, 5.0], [0.0, 1.0])
    # Triangles, and segments of parabolas: two thirds of chord by height.
    half = np.pi / 6
    area = 6 * (np.sin(half) * np.cos(half) + 4 / 3 * np.sin(half) * (1 - np.cos(half)))
    assert contact.evaluate().volume == pytest.approx(area, rel=1e-12)


def test_fields_go_back_to_a_mesh_fem_and_regions_to_nodes():
    scene = touching("FEM_QK(2,2)")
    contact, mesh = scene.contact, scene.meshes[1]
    scalar = gf.MeshFem(mesh, 1)
    scalar.set_fem(gf.Fem("FEM_QK(2,2)"))
    found = contact.on_mesh_fem(contact.coords(), "v")
    assert found == pytest.approx(scalar.basic_dof_nodes().T, abs=1e-15)
    pressure = contact.on_mesh_fem(contact.nodal_contact().pressure, "v")
    height = scalar.basic_dof_nodes()[1]
    low = height < 0.98 + 1e-9
    # The sides of the lowest cells, with their middle nodes at 1.055, reach into the lower block too.
    assert (pressure[low] > 0.0).all() and not pressure[height > 1.2].any()
    mesh.set_region(7, mesh.faces_from_pid(np.flatnonzero(mesh.pts()[1] < 0.98 + 1e-9)))
    assert contact.coords()[contact.nodes("v", 7)][:, 1] == pytest.approx(np.full(low.sum(), 0.98), abs=1e-15)
    assert len(contact.nodes("v")) == len(found)


def test_numbers_of_cells_may_have_gaps():
    """A mesh from which cells were deleted has the forces of a mesh that never had them."""
    forces = []
    for extra in (0, 3):
        model, kept = gf.Model("real"), []
        for name, low in (("u", 0.0), ("v", 0.98)):
            mesh, square = gf.Mesh("empty", 2), np.array([[0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]])
            cells = [mesh.add_convex(gf.GeoTrans("GT_QK(2,1)"), square + [[9.0 + k], [9.0]]) for k in range(extra)]
            for column in range(2):
                mesh.add_convex(gf.GeoTrans("GT_QK(2,1)"), square + [[column], [low]])
            for cell in cells:
                mesh.del_convex(cell)
            space = gf.MeshFem(mesh, 2)
            space.set_fem(gf.Fem("FEM_QK(2,1)"))
            model.add_fem_variable(name, space)
            kept.append((mesh, space))
        assert kept[0][0].cvid()[0] == extra
        forces.append(GetfemContact(model, ["u", "v"], **OPTIONS).force())
    assert np.abs(forces[0]).max() > 0.1 and np.array_equal(*forces)
