"""Surfaces that are moved out until they press without penetration."""

import numpy as np
import pytest
from fmc_contact import MULTIPLIER, Contact, errors

K = 1e3


@pytest.fixture
def pressed():
    """A square 0.01 deep in a plane."""
    coords = np.array([[0, -0.01], [1, -0.01], [1, 0.99], [0, 0.99]])
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=K)
    contact.obstacles.add_half_space((0, 0), (0, 1))
    return contact, coords


def test_what_penetrates_presses_twice_as_much(pressed):
    contact, coords = pressed
    before = contact.evaluate(coords).bodies[0].force[1]
    found = contact.multipliers.augment(coords, penetration=1e-6)
    assert found.penetration == pytest.approx(0.01) and found.change == pytest.approx(0.01) and not found.is_converged
    assert contact.evaluate(coords).bodies[0].force[1] == pytest.approx(2 * before, rel=1e-3)
    # Weighted gaps are those of the true surfaces.
    gaps = contact.gap_constraints(coords, reach=0.1)
    assert gaps.gap / gaps.area == pytest.approx(-0.01)
    touching = coords + [0, 0.01]
    assert contact.evaluate(touching).bodies[0].force[1] == pytest.approx(before, rel=1e-3)
    assert contact.multipliers.augment(touching, penetration=1e-9).is_converged


def test_they_are_a_state_that_can_be_set(pressed):
    contact, coords = pressed
    plain = contact.evaluate(coords)
    assert contact.multipliers.augment(coords, 1e-6).multiplier_count == 2
    kept, forces = contact.multipliers.values, contact.evaluate(coords).forces
    assert kept.dtype == MULTIPLIER and kept["node"].tolist() == [0, 1] and kept["partner_kind"].tolist() == [1, 1]
    assert kept["shift"] == pytest.approx(0.01) and kept["towards"][:, 1] == pytest.approx(-1)
    contact.multipliers.augment(coords, 1e-6)
    assert contact.multipliers.values["shift"] == pytest.approx(0.02)
    contact.multipliers.values = kept
    assert np.array_equal(contact.evaluate(coords).forces, forces)
    contact.multipliers.release()
    assert len(contact.multipliers.values) == 0 and np.array_equal(contact.evaluate(coords).forces, plain.forces)


def test_what_is_refused(pressed):
    contact, coords = pressed
    for arguments in ({"penetration": -1.0}, {"penetration": 1.0, "reach": float("nan")}):
        with pytest.raises(errors.NotPositiveError):
            contact.multipliers.augment(coords, **arguments)
    contact.multipliers.augment(coords, 1e-6)
    kept = contact.multipliers.values
    for field, value, error in [
        ("node", 9, errors.NodeOutOfRangeError),
        ("shift", -1, errors.NotPositiveError),
        ("struct_size", 0, errors.StructSizeError),
        ("partner_kind", 7, errors.BadValueError),
    ]:
        bad = kept.copy()
        bad[field][0] = value
        with pytest.raises(error):
            contact.multipliers.values = bad
    with pytest.raises(errors.UnsupportedError, match="self-contact"):
        contact.set_options(self_contact=True)
    assert np.array_equal(contact.multipliers.values, kept)
    contact.multipliers.release()
    contact.set_options(law="volume")
    with pytest.raises(errors.UnsupportedError, match="not a stiffness"):
        contact.multipliers.augment(coords, 1e-6)
