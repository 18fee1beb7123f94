"""The contact at nodes and at points: it carries the forces, and says what the geometry says."""

import numpy as np
import pytest
from scenes import K

from fmc_contact import Contact, errors


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
    contact = Contact(coords, cells, "quad", stiffness=K, estimator="exact")
    field = contact.nodal_contact(coords)
    # The left side of the second square, 0.1 deep in the first.
    np.testing.assert_allclose(field.pressure[[4, 7]], 0.1 * K, rtol=1e-12)
    np.testing.assert_allclose(field.gap[[4, 7]], -0.1, rtol=1e-12)
    np.testing.assert_allclose(field.area[[4, 7]], 0.4, rtol=1e-12)
    np.testing.assert_allclose(field.normal[[4, 7]], [[-1, 0]] * 2, atol=1e-12)


def test_points_stand_on_both_sides(cubes):
    coords, cells = cubes
    contact = Contact(coords, cells, "hexahedron", stiffness=K, estimator="exact")
    points, result = contact.contact_points(coords), contact.evaluate(coords)
    assert len(points) > 0
    np.testing.assert_allclose(-(points.gap * points.area).sum(), result.volume, rtol=1e-12)
    assert (points.nodes >= 0).all()
    placed = np.einsum("msk,mskd->msd", points.weights, coords[points.nodes])
    np.testing.assert_allclose(placed, points.ends, atol=1e-12)
    np.testing.assert_allclose(points.ends[:, 0] - points.ends[:, 1], -points.gap[:, None] * points.normal, atol=1e-12)
    np.testing.assert_array_equal(points.cell, np.tile([0, 1], (len(points), 1)))
    np.testing.assert_array_equal(points.partner, points.cell)
    pushed = (points.pressure * points.area) @ points.normal
    np.testing.assert_allclose(result.bodies[1].force, pushed, rtol=1e-9, atol=1e-9)


def test_a_plane_has_no_nodes(squares):
    coords, cells = squares
    contact = Contact(coords, cells, "quad", stiffness=K)
    contact.add_half_space((0, 0.05), (0, 1))
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
