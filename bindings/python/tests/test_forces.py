"""Forces against closed forms, differences of the energy, and the stateless call of the C interface."""

from ctypes import byref, c_double

import numpy as np
import pytest
from fmc_contact import Contact, contact_force
from fmc_contact._cells import CELL_TYPES
from fmc_contact._library import check, library
from fmc_contact._structs import fmc_cell_block
from fmc_contact.options import changed, defaults
from scenes import K, same_bits, tetrahedra, triangles

# Lines are near the exact answer: the strip's ends are met by a few of many lines.
SEED = 2
TOLERANCE = {"exact": 1e-12, "fibers": 0.02}


@pytest.mark.parametrize("estimator", ["exact", "fibers"])
@pytest.mark.parametrize("law", ["volume", "fiber"])
@pytest.mark.parametrize("cell_type", ["triangle", "quad"])
def test_strip_between_two_squares(squares, cell_type, law, estimator):
    coords, conn = squares
    cells = triangles(conn) if cell_type == "triangle" else conn
    # With this seed an odd number of lines meets the strip: the two halves of an even one agree, and tell no error.
    seed = {} if estimator == "exact" else {"seed": SEED}
    result = contact_force(coords, cells, cell_type, stiffness=K, law=law, estimator=estimator, **seed)
    # Overlap 0.1 x 0.8: traction k ("volume") or k times the depth 0.1 ("fiber"), over the height 0.8.
    push = K * 0.8 if law == "volume" else K * 0.1 * 0.8
    energy = K * 0.08 if law == "volume" else K * 0.1**2 / 2 * 0.8
    tolerance = TOLERANCE[estimator]
    assert result.volume == pytest.approx(0.08, rel=tolerance)
    assert result.energy == pytest.approx(energy, rel=tolerance)
    assert result.bodies[0].force == pytest.approx([-push, 0], abs=push * tolerance)
    assert result.bodies[1].force == pytest.approx([push, 0], abs=push * tolerance)
    assert result.bodies[0].id == 0 and result.bodies[0].node_count == 4
    assert result.forces[:4].sum(0) == pytest.approx(result.bodies[0].force, abs=1e-9)
    moments = np.cross(np.c_[coords, np.zeros(8)], np.c_[result.forces, np.zeros(8)])
    assert moments[4:].sum(0) == pytest.approx(result.bodies[1].moment, abs=1e-9)
    (pair,) = result.pairs
    assert pair.a == ("body", 0) and pair.b == ("body", 1)
    assert pair.volume == result.volume and result.warnings == () and result.obstacles == ()
    assert (result.volume_standard_error == 0) == (estimator == "exact")


@pytest.mark.parametrize("estimator", ["exact", "fibers"])
@pytest.mark.parametrize("law", ["volume", "fiber"])
@pytest.mark.parametrize("cell_type", ["tetra", "hexahedron"])
def test_slab_between_two_cubes(cubes, cell_type, law, estimator):
    coords, conn = cubes
    cells = tetrahedra(conn) if cell_type == "tetra" else conn
    result = contact_force(coords, cells, cell_type, stiffness=K, law=law, estimator=estimator)
    # Overlap 0.8 x 1 x 0.1, pressed along z over the area 0.8.
    push = K * 0.8 if law == "volume" else K * 0.1 * 0.8
    assert result.volume == pytest.approx(0.08, rel=TOLERANCE[estimator])
    # The law "volume" also pushes along x, where the slab ends 0.1 high.
    across = K * 0.1 if law == "volume" else 0.0
    assert result.bodies[1].force == pytest.approx([across, 0, push], abs=0.03 * push)
    assert np.abs(result.forces.sum(0)).max() < 1e-9 * push


@pytest.mark.parametrize(("law", "estimator", "h"), [("volume", "exact", 1e-5), ("fiber", "fibers", 1e-7)])
def test_force_is_minus_the_gradient_of_the_energy(cubes, law, estimator, h):
    # Lines that are kept make an energy of many small steps; the difference must stay between two of them.
    coords, conn = cubes
    coords = coords + 0.02 * np.random.default_rng(1).standard_normal(coords.shape)
    contact = Contact(coords, conn, "hexahedron", stiffness=K, law=law, estimator=estimator, momentum_correction=False)
    contact.patches.keep(coords)
    forces = contact.evaluate(coords).forces
    direction = np.random.default_rng(2).standard_normal(coords.shape)
    after, before = (contact.evaluate(coords + sign * h * direction).energy for sign in (1, -1))
    # Roundoff: the energy, about 10, to 1e-15 over h; truncation: h^2 against the overlap's depth of 0.1.
    assert (before - after) / (2 * h) == pytest.approx(np.vdot(forces, direction), rel=1e-6)


@pytest.mark.parametrize("dtype", [np.int32, np.int64])
@pytest.mark.parametrize("with_bodies", [False, True])
def test_same_bits_as_the_stateless_call(squares, dtype, with_bodies):
    coords, conn = squares
    conn = conn.astype(dtype)
    bodies = np.array([7, 3], dtype) if with_bodies else None
    result = contact_force(coords, conn, "quad", stiffness=K, bodies=bodies, law="volume")
    forces, volume = np.empty((8, 2)), c_double()
    options = changed(defaults(), {"stiffness": K, "law": "volume"})
    block = fmc_cell_block(CELL_TYPES["quad"], conn.itemsize, conn.ctypes.data, 2)
    arguments = byref(block), 1, bodies, byref(options), None, forces, byref(volume)
    check(library.fmc_contact_force(2, coords, 8, *arguments))
    assert same_bits(result.forces, forces) and result.volume == volume.value
    assert [body.id for body in result.bodies] == ([3, 7] if with_bodies else [0, 1])


def test_surface_from_facets_gives_the_forces_of_its_cells(cubes, squares):
    coords, conn = squares
    edges = conn[:, [[0, 1], [1, 2], [2, 3], [3, 0]]].reshape(-1, 2)
    options = {"stiffness": K, "law": "volume", "estimator": "exact"}
    contact = Contact.from_facets(coords, edges, **options, bodies=np.repeat([5, 6], 4))
    assert (contact.dim, contact.node_count, contact.facet_count, contact.body_count) == (2, 8, 8, 2)
    expected = contact_force(coords, conn, "quad", **options)
    assert contact.evaluate(coords).forces == pytest.approx(expected.forces, abs=1e-9)
    # Corner 0 sees a tetrahedron's facets counter-clockwise from outside.
    tetra = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    shell = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    body = Contact.from_facets(tetra, shell, stiffness=K)
    assert (body.dim, body.facet_count, body.body_count) == (3, 4, 1)


def test_mixed_mesh_gives_the_forces_of_one_type(squares):
    coords, conn = squares
    options = {"stiffness": K, "law": "volume", "estimator": "exact"}
    mixed = contact_force(coords, [("quad", conn[:1]), ("triangle", triangles(conn[1:]).astype(np.int64))], **options)
    assert mixed.forces == pytest.approx(contact_force(coords, conn, "quad", **options).forces, abs=1e-9)
    named = Contact(coords, [("quad", conn[:1]), ("triangle", triangles(conn[1:]))], bodies=[4, 9, 9], **options)
    assert [body.id for body in named.evaluate(coords).bodies] == [4, 9]


def test_warnings_say_what_they_are_about(squares):
    coords, conn = squares
    inside = coords.copy()
    inside[4:] = 0.5 + 0.1 * (coords[4:] - coords[4])
    contact = Contact(coords, conn, "quad", stiffness=K, law="volume", estimator="exact")
    told = []
    contact.set_log(told.append)
    (warning,) = contact.evaluate(inside).warnings
    assert warning.kind == "swallowed_body" and "body" in warning.text
    assert told == [warning.text]
    contact.set_log(None)
    contact.evaluate(inside)
    assert len(told) == 1


def test_what_a_log_raises_comes_out(squares):
    coords, conn = squares
    inside = coords.copy()
    inside[4:] = 0.5 + 0.1 * (coords[4:] - coords[4])
    contact = Contact(coords, conn, "quad", stiffness=K, law="volume", estimator="exact")

    def refuse(text):
        raise RuntimeError(text)

    contact.set_log(refuse)
    with pytest.raises(RuntimeError, match="body"):
        contact.evaluate(inside)
