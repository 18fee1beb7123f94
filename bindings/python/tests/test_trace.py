"""Boundaries of finite element spaces as flat facets: closed, true to the shape functions, and forces back on the
nodes."""

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
@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("divisions", [1, 2, 3, None])
def test_facets_are_closed_and_nodes_move_points_by_the_shape_functions(name, order, divisions):
    coords, faces = BODIES[name]
    # Ids are any numbers.
    trace = Trace(7 * faces + 3, order, divisions)
    assert (trace.corner_ids == 7 * np.arange(len(coords)) + 3).all()
    skin = Skin([trace])
    nodes = trace.straight(coords)
    assert nodes.shape == (trace.node_count, coords.shape[1])
    points = skin.points(nodes)
    assert points.shape == (trace.point_count, coords.shape[1])
    assert volume(points, trace.facets) == pytest.approx(1.0, rel=1e-14)
    # The library refuses what is open, turned round or not connected.
    Contact.from_facets(points, trace.facets, stiffness=K, law="fiber")
    # A polynomial of the order is met at every point.
    polynomial = lambda x: (x @ np.arange(1.0, 1.0 + x.shape[1]) + 0.5) ** order  # noqa: E731
    found = skin.points(polynomial(nodes)[:, None])[:, 0]
    if name != "quadrilaterals" or order == 1:
        assert found == pytest.approx(polynomial(points), rel=1e-13)
    # Work is the same on nodes and points.
    random = np.random.default_rng(1)
    forces, moves = random.standard_normal(points.shape), random.standard_normal(nodes.shape)
    assert (skin.to_nodes(forces) * moves).sum() == pytest.approx((forces * skin.points(moves)).sum(), rel=1e-12)


def test_second_order_of_quadrilaterals_meets_products_of_squares():
    trace = Trace(QUADS, 2, 3)
    skin = Skin([trace])
    nodes = trace.straight(CUBE)
    biquadratic = lambda x: (x[:, 0] ** 2 - x[:, 0]) * x[:, 1] ** 2 + x[:, 2] ** 2  # noqa: E731
    assert skin.points(biquadratic(nodes)[:, None])[:, 0] == pytest.approx(biquadratic(skin.points(nodes)), abs=1e-14)


def test_traces_are_numbered_one_after_another():
    first, second = Trace(QUADS), Trace(TRIANGLES + 10, 2)
    skin = Skin([first, second])
    nodes = np.concatenate([first.straight(CUBE), second.straight(CUBE + [2.0, 0, 0])])
    assert skin.first_node.tolist() == [0, 8, 8 + second.node_count]
    points = skin.points(nodes)
    assert volume(points, skin.facets) == pytest.approx(2.0, rel=1e-14)
    assert Contact.from_facets(points, skin.facets, stiffness=K, law="fiber").body_count == 2
    assert points == pytest.approx(skin.prolongation @ nodes, abs=1e-15)
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


@pytest.mark.parametrize("arguments", [(np.zeros((2, 5), int),), (SQUARE[1], 3), (SQUARE[1], 1, 0)])
def test_other_faces_orders_and_divisions_are_refused(arguments):
    with pytest.raises(ValueError):
        Trace(*arguments)
