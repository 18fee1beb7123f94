"""Boundaries of finite element spaces of first order as flat facets: closed, true to the shape functions, and forces
back on the nodes."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.skin import Skin, Triplets
from fmc_contact.trace import Trace
from scenes import K

pytest.importorskip("scipy.sparse")

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]]), np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
TRIANGLES = np.concatenate([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]])
BODIES = {"edges": SQUARE, "triangles": (CUBE, TRIANGLES), "quadrilaterals": (CUBE, QUADS)}


def volume(x, facets):
    at = x[facets]
    if x.shape[1] == 2:
        return 0.5 * (at[:, 0, 0] * at[:, 1, 1] - at[:, 0, 1] * at[:, 1, 0]).sum()
    return np.einsum("ij,ij->i", at[:, 0], np.cross(at[:, 1], at[:, 2])).sum() / 6


@pytest.mark.parametrize("name", BODIES)
def test_facets_are_closed_and_nodes_move_points_by_the_shape_functions(name):
    coords, faces = BODIES[name]
    # Ids are any numbers.
    trace = Trace(7 * faces + 3)
    assert (trace.corner_ids == 7 * np.arange(len(coords)) + 3).all() and trace.node_count == len(coords)
    skin = Skin([trace])
    points = skin.points(coords)
    assert points.shape == (trace.point_count, coords.shape[1])
    assert volume(points, trace.facets) == pytest.approx(1.0, rel=1e-14)
    # The library refuses what is open, turned round or not connected.
    Contact.from_facets(points, trace.facets, stiffness=K, law="fiber")
    # Linear functions are met at every point; products of coordinates at the middles of squares too.
    linear = lambda x: x @ np.arange(1.0, 1.0 + x.shape[1]) + 0.5 + x[:, 0] * x[:, 1]
    assert skin.points(linear(coords)[:, None])[:, 0] == pytest.approx(linear(points), rel=1e-13)
    assert (skin.at_nodes(points) == coords).all()
    # Work is the same on nodes and points.
    random = np.random.default_rng(1)
    forces, moves = random.standard_normal(points.shape), random.standard_normal(coords.shape)
    assert (skin.to_nodes(forces) * moves).sum() == pytest.approx((forces * skin.points(moves)).sum(), rel=1e-12)


def test_traces_are_numbered_one_after_another():
    first, second = Trace(QUADS), Trace(TRIANGLES + 10)
    skin = Skin([first, second])
    nodes = np.concatenate([CUBE, CUBE + [2.0, 0, 0]])
    assert skin.first_node.tolist() == [0, 8, 16]
    points = skin.points(nodes)
    assert volume(points, skin.facets) == pytest.approx(2.0, rel=1e-14)
    assert Contact.from_facets(points, skin.facets, stiffness=K, law="fiber").body_count == 2
    assert points == pytest.approx(skin.prolongation @ nodes, abs=1e-15)
    assert (skin.at_nodes(points) == nodes).all()
    forces = np.random.default_rng(2).standard_normal(points.shape)
    assert skin.to_nodes(forces) == pytest.approx(skin.prolongation.T @ forces, abs=1e-13)


def test_a_matrix_of_points_becomes_one_of_nodes():
    trace = Trace(QUADS)
    skin = Skin([trace])
    random = np.random.default_rng(3)
    size = 3 * trace.point_count
    rows, cols = random.integers(0, size, (2, 200))
    values = random.standard_normal(200)
    moved = skin.tangent_to_nodes(Triplets(rows, cols, values), 3)
    dense = np.zeros((size, size))
    np.add.at(dense, (rows, cols), values)
    down = np.kron(skin.prolongation.toarray(), np.eye(3))
    found = np.zeros((24, 24))
    np.add.at(found, (moved.rows, moved.cols), moved.values)
    assert found == pytest.approx(down.T @ dense @ down, abs=1e-13)


def test_facets_carry_the_forces_of_cells():
    """A cube in a half-space, whole or by its faces: the library divides a face about its middle as well."""
    cell = [[0, 1, 3, 2, 4, 5, 7, 6]]
    trace = Trace(QUADS)
    skin = Skin([trace])
    bent = CUBE + 0.05 * np.sin(5.0 * CUBE[:, ::-1])
    whole = Contact(CUBE, [("hexahedron", cell)], stiffness=K, law="fiber", estimator="exact")
    faces = Contact.from_facets(skin.points(CUBE), skin.facets, stiffness=K, law="fiber", estimator="exact")
    for contact in (whole, faces):
        contact.obstacles.add_half_space((0.1, 0.1, 0.1), (0.1, 0.2, 1.0))
    expected = whole.evaluate(bent).forces
    found = skin.to_nodes(faces.evaluate(skin.points(bent)).forces)
    assert np.abs(expected).max() > 0.0 and np.abs(found - expected).max() < 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("faces", [np.zeros((2, 5), int), np.zeros(4, int)])
def test_other_faces_are_refused(faces):
    with pytest.raises(ValueError):
        Trace(faces)
