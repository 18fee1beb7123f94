"""Axisymmetry by the Python package."""

import numpy as np
import pytest
from fmc_contact import Contact, contact_force, errors

RING = np.array([[0.5, 0.0], [1.0, 0.0], [1.0, 0.4], [0.5, 0.4]])


def test_a_ring_on_a_plane():
    contact = Contact(RING, [[0, 1, 2, 3]], "quad", stiffness=1e4, axisymmetric=True)
    contact.obstacles.add_half_space((0, 1e-3), (0, 1))
    result = contact.evaluate(RING)
    area = np.pi * (1.0**2 - 0.5**2)
    assert result.bodies[0].force[1] == pytest.approx(1e4 * 1e-3 * area, rel=1e-12)
    assert result.volume == pytest.approx(1e-3 * area, rel=1e-12)
    assert not np.any(result.bodies[0].moment)


def test_stateless_calls_too():
    coords, conn = np.vstack([RING, RING + [0, 0.399]]), [[0, 1, 2, 3], [4, 5, 6, 7]]
    result = contact_force(coords, conn, "quad", stiffness=1.0, law="volume", axisymmetric=True)
    assert result.volume == pytest.approx(1e-3 * np.pi * 0.75, rel=1e-9)


def test_what_is_refused():
    with pytest.raises(errors.NegativeRadiusError, match="node 1 lies beyond the axis") as caught:
        contact_force(RING - [0.75, 0], [[1, 2, 3, 4]], "quad", stiffness=1.0, axisymmetric=True, index_base=1)
    assert caught.value.indices == {"node": (1,)}


def test_friction_acts_on_whole_rings():
    contact = Contact(RING, [[0, 1, 2, 3]], "quad", stiffness=1e4, axisymmetric=True, friction_coefficient=0.3)
    contact.obstacles.add_half_space((0, 1e-3), (0, 1))
    contact.friction.begin_step(RING)
    result = contact.evaluate(RING + [0.01, 0])
    area = np.pi * (1.01**2 - 0.51**2)
    # The walls, 1e-3 high, do not face the plane.
    assert -result.bodies[0].friction[0] == pytest.approx(0.3 * 1e4 * 1e-3 * area, rel=1e-2)
