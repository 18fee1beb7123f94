"""Ties with a period and with a jump: what they hold, and what is refused."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.errors import BadValueError, NonFiniteStiffnessError, NotPositiveError, UnsupportedError, UntiedError

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)


def periodic():
    contact = Contact(SQUARE, [[0, 1, 2, 3]], "quad", stiffness=1e3)
    lower, right, upper, left = (contact.mesh.add_surface([facet]) for facet in range(4))
    return contact, [contact.ties.add((right, left), period=(1, 0)), contact.ties.add((upper, lower), period=(0, 1), reach=0.2)]


def test_a_cell_has_the_strain_of_its_jumps():
    contact, ties = periodic()
    assert ties == [1, 2]
    assert (contact.ties.found(1).area, contact.ties.found(2).reach) == (1.0, 0.2)
    gradient = np.array([[0.1, -0.2], [0.3, 0.05]])
    coords = SQUARE @ (np.eye(2) + gradient).T
    assert np.abs(contact.evaluate(coords).forces).max() > 1
    for axis, tie in enumerate(ties):
        contact.ties.set_jump(tie, gradient[:, axis])
    # Rounding.
    assert np.abs(contact.evaluate(coords).forces).max() < 1e-12 * 1e3
    # The force on part A is the stiffness times how far it is short of the jump.
    contact.ties.set_jump(1, gradient[:, 0] + (0.01, 0))
    assert np.allclose(contact.ties.force(1, coords), (10, 0)) and np.allclose(contact.ties.force(2, coords), 0)
    contact.ties.remove(1)
    with pytest.raises(BadValueError):
        contact.ties.force(1, coords)


def test_a_jump_moves_a_body_on_another():
    upper = SQUARE + (0, 1)
    contact = Contact(np.concatenate([SQUARE, upper]), [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", bodies=[0, 1], stiffness=1e3)
    above, below = contact.mesh.add_surface([4]), contact.mesh.add_surface([2])
    with pytest.raises(UnsupportedError, match="in contact"):
        contact.ties.add((above, below))
    contact.pairs.set(0, 1, excluded=True)
    tie = contact.ties.add((above, below))
    contact.ties.set_jump(tie, (0.1, -0.2))
    moved = np.concatenate([SQUARE, upper + (0.1, -0.2)])
    assert np.abs(contact.evaluate(moved).forces).max() < 1e-12 * 1e3
    with pytest.raises(UnsupportedError, match="right sides"):
        contact.tie_constraints()


def test_what_cannot_be_is_refused():
    contact, _ = periodic()
    for surfaces, options, error in [
        ((2, 9), {}, BadValueError),
        ((2, -1), {}, BadValueError),
        ((2, 4), {"period": (0.3, 0)}, UntiedError),
        ((2, 4), {"period": (1, np.nan)}, NonFiniteStiffnessError),
        ((2, 4), {"period": (1, 0), "reach": -1}, NotPositiveError),
        ((2, 2), {"period": (1, 0)}, UnsupportedError),
        ((2, 4), {"period": (1, 0, 0)}, ValueError),
        ((2, "left"), {"period": (1, 0)}, TypeError),
    ]:
        with pytest.raises(error):
            contact.ties.add(surfaces, **options)
    for call in (lambda: contact.ties.set_jump(3, (0, 0)), lambda: contact.ties.found(0), lambda: contact.ties.remove(7)):
        with pytest.raises(BadValueError):
            call()
