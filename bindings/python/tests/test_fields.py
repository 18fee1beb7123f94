"""The contact at nodes and at points: it carries the forces, and says what the geometry says."""

import numpy as np
import pytest
from fmc_contact import Contact, errors
from scenes import K


@pytest.mark.parametrize("law", ["fiber", "volume"])
@pytest.mark.parametrize("estimator", ["exact", "fibers"])
def test_nodes_carry_the_forces(squares, law, estimator):
    coords, cells = squares
    contact = Contact(coords, cells, "quad", stiffness=K, law=law, estimator=estimator)
    field, forces = contact.nodal_contact(coords), contact.evaluate(coords).forces
    np.testing.assert_allclose(-(field.pressure * field.area)[:, None] * field.normal, forces, atol=1e-11)
    assert field.touching.sum() >= 4 and not field.touching[0]
    assert (field.gap <= 0).all() and (field.gap[field.touching] < 0).all()


def test_a_strip_of_one_depth(squares):
    coords, cells = squares
    contact = Contact(coords, cells, "quad", stiffness=K, law="fiber", estimator="exact")
    field = contact.nodal_contact(coords)
    # The left side of the second square, 0.1 deep in the first.
    np.testing.assert_allclose(field.pressure[[4, 7]], 0.1 * K, rtol=1e-12)
    np.testing.assert_allclose(field.gap[[4, 7]], -0.1, rtol=1e-12)
    np.testing.assert_allclose(field.area[[4, 7]], 0.4, rtol=1e-12)
    np.testing.assert_allclose(field.normal[[4, 7]], [[-1, 0]] * 2, atol=1e-12)


def test_points_stand_on_both_sides(cubes):
    coords, cells = cubes
    contact = Contact(coords, cells, "hexahedron", stiffness=K, law="fiber", estimator="exact")
    points, result = contact.contact_points(coords), contact.evaluate(coords)
    assert len(points) > 0
    np.testing.assert_allclose(-(points.gap * points.area).sum(), result.volume, rtol=1e-12)
    assert (points.nodes[..., :4] >= 0).all() and (points.nodes[..., 4:] == -1).all()
    placed = np.einsum("msk,mskd->msd", points.weights, coords[points.nodes])
    np.testing.assert_allclose(placed, points.ends, atol=1e-12)
    np.testing.assert_allclose(points.ends[:, 0] - points.ends[:, 1], -points.gap[:, None] * points.normal, atol=1e-12)
    np.testing.assert_array_equal(points.cell, np.tile([0, 1], (len(points), 1)))
    np.testing.assert_array_equal(points.partner, points.cell)
    pushed = (points.pressure * points.area) @ points.normal
    np.testing.assert_allclose(result.bodies[1].force, pushed, rtol=1e-9, atol=1e-9)


def test_a_plane_has_no_nodes(squares):
    coords, cells = squares
    contact = Contact(coords, cells, "quad", stiffness=K, law="fiber")
    contact.obstacles.add_half_space((0, 0.05), (0, 1))
    points = contact.contact_points(coords)
    of_plane = points.is_obstacle[:, 1]
    assert of_plane.any() and (points.nodes[of_plane, 1] == -1).all() and (points.cell[of_plane, 1] == -1).all()
    np.testing.assert_allclose(points.ends[of_plane, 1, 1], 0.05, atol=1e-9)


def test_nothing_touches(squares):
    coords, cells = squares
    apart = coords + np.where(np.arange(8) > 3, 1.0, 0.0)[:, None]
    contact = Contact(coords, cells, "quad", stiffness=K)
    field = contact.nodal_contact(apart)
    assert not field.touching.any() and not field.pressure.any() and not field.normal.any()
    assert len(contact.contact_points(apart)) == 0
    with pytest.raises(errors.NonFiniteCoordinateError):
        contact.nodal_contact(np.where(coords == 0.9, np.nan, coords))


def test_points_of_the_depth_law_carry_its_force(cubes):
    coords, cells = cubes
    contact = Contact(coords, cells, "hexahedron", stiffness=K)
    points, result = contact.contact_points(coords), contact.evaluate(coords)
    placed = np.einsum("msk,mskd->msd", points.weights, coords[points.nodes])
    np.testing.assert_allclose(placed, points.ends, atol=1e-12)
    # One side is a face of four nodes, the other a place in a cell of eight.
    np.testing.assert_array_equal(np.sort((points.nodes >= 0).sum(axis=2)), np.tile([4, 8], (len(points), 1)))
    pushed = (points.pressure * points.area) @ points.normal
    np.testing.assert_allclose(result.bodies[1].force, pushed, rtol=1e-9, atol=1e-9)


def test_gaps_are_constraints(squares):
    coords, cells = squares
    contact = Contact(coords, cells, "quad", stiffness=K)
    gaps = contact.gap_constraints(coords, reach=0.3)
    # The left side of the second square is 0.1 deep in the first.
    row = np.flatnonzero((gaps.node == 4) & (gaps.body == 1))[0]
    assert gaps.gap[row] / gaps.area[row] == pytest.approx(-0.1) and not gaps.is_obstacle.any() and gaps.partner[row] == 0
    assert len(gaps.indptr) == len(gaps) + 1 == len(gaps.area) + 1
    matrix = np.zeros((len(gaps), coords.size))
    for r in range(len(gaps)):
        matrix[r, gaps.indices[gaps.indptr[r] : gaps.indptr[r + 1]]] = gaps.data[gaps.indptr[r] : gaps.indptr[r + 1]]
    # Nothing changes when all moves as one.
    np.testing.assert_allclose(matrix.reshape(len(gaps), -1, 2).sum(axis=1), 0.0, atol=1e-14)
    step = 1e-6 * np.random.default_rng(1).uniform(-1, 1, coords.shape)
    more, less = (contact.gap_constraints(coords + sign * step, reach=0.3).gap for sign in (1, -1))
    np.testing.assert_allclose((more - less) / 2, matrix @ step.ravel(), atol=1e-6 * np.abs(step).max())
    assert set(gaps.degrees_of_freedom) == set(np.flatnonzero(np.abs(matrix).sum(axis=0) > 0)) | set(gaps.indices)
    with pytest.raises(errors.NotPositiveError, match="reach"):
        contact.gap_constraints(coords, reach=-1.0)
    assert len(contact.gap_constraints(coords + np.where(np.arange(8) > 3, 9.0, 0.0)[:, None], reach=0.3)) == 0
