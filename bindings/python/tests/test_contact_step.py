"""``Contact.contact_step``: bodies condensed by the host, the contact iterated by the library."""

import numpy as np
import pytest
from fmc_contact import Contact, errors

K, SPRING = 3000.0, 100.0
COORDS = np.array([[0, -0.05], [1, -0.05], [1, 0.95], [0, 0.95]])


@pytest.fixture
def square():
    """A unit square that reaches into a plane by 0.05."""
    contact = Contact(COORDS, [[0, 1, 2, 3]], "quad", stiffness=K, law="fiber", estimator="exact")
    contact.obstacles.add_half_space([0, 0], [0, 1])
    return contact


def follow(d, coords):
    coords[2, 1] += d[3]
    coords[3, 1] += d[1]


def test_two_springs_against_a_plane_are_springs_in_series(square):
    found = square.contact_step(COORDS, [0, 1, 2, 3], SPRING * np.eye(4), [0, 4, 0, 4], place=follow)
    down = -(8 - K * 0.05) / (2 * SPRING + K)
    assert found.state == "converged" and found.residual <= 1e-10 * found.scale
    assert found.displacement == pytest.approx([0, down, 0, down], abs=1e-12)
    assert 1 <= found.iterations < found.evaluation_count and found.outside_count == 0


def test_what_it_says_where_it_does_not_get_there(square):
    found = square.contact_step(COORDS, [1], [[SPRING]], [0.0])
    assert found.state == "outside" and found.outside_count >= 1
    found = square.contact_step(COORDS, [1], [[SPRING]], [0.0], held=[0, 2, 3, 4, 5, 6, 7])
    assert found.state == "converged"
    far = {"max_iterations": 1, "max_trials": 1}
    found = square.contact_step(COORDS + [0, 0.1], [0, 1, 2, 3], SPRING * np.eye(4), [0, 20, 0, 20], place=follow, **far)
    assert found.state == "not_converged" and found.residual > 1e-3 * found.scale


def test_what_is_refused(square):
    def step(dofs, stiffness, residual, **more):
        return square.contact_step(COORDS, dofs, stiffness, residual, **more)

    with pytest.raises(ValueError, match=r"stiffness has shape \(1, 1\), expected \(2, 2\)"):
        step([1, 3], [[1.0]], [0.0, 0.0])
    with pytest.raises(ValueError, match=r"residual has shape \(1,\)"):
        step([1, 3], np.eye(2), [0.0])
    with pytest.raises(errors.DofOutOfRangeError, match="freedom 8, but there are 8"):
        step([1, 8], np.eye(2), [0.0, 0.0])
    with pytest.raises(errors.RepeatedDofError, match="freedom 1 is named twice"):
        step([3, 1], np.eye(2), [0.0, 0.0])
    with pytest.raises(errors.NonFiniteStiffnessError, match="entry 0 of 'residual'"):
        step([1], [[1.0]], [np.nan])
    springs = np.diag([0.0, 1.0, 0.0, 1.0])
    with pytest.raises(errors.SingularStiffnessError, match="singular at degree of freedom 0: is every body supported"):
        step([0, 1, 2, 3], springs, np.ones(4))
    with pytest.raises(errors.IndefiniteStiffnessError, match="it is -1"):
        step([0, 1, 2, 3], springs - np.diag([1, 0, 1, 0]), np.ones(4))
    with pytest.raises(errors.NotPositiveError, match="'tolerance' is 0"):
        step([1], [[1.0]], [0.0], tolerance=0.0)
    with pytest.raises(TypeError, match="no option 'tolerence'"):
        step([1], [[1.0]], [0.0], tolerence=0.1)
    with pytest.raises(ZeroDivisionError):
        step([1], [[1.0]], [0.0], place=lambda d, coords: 1 / 0)
    with pytest.raises(errors.BusyError):
        step([1], [[1.0]], [0.0], place=lambda d, coords: square.evaluate(coords))


def test_as_little_penetration_as_is_wanted() -> None:
    # A unit square on springs of 100, 0.1 above a plane, that is pushed down by 20 at either lower node.
    coords = np.array([[0.0, 0.1], [1.0, 0.1], [1.0, 1.1], [0.0, 1.1]])
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=3000.0, law="depth")
    contact.obstacles.add_half_space((0, 0), (0, 1))

    def place(d: np.ndarray, coords: np.ndarray) -> None:
        coords[[3, 2], 1] += d[[1, 3]]

    def step() -> np.ndarray:
        found = contact.contact_step(coords, range(4), 100 * np.eye(4), [0, 20, 0, 20], range(4, 8), place)
        assert found.state == "converged"
        return found.displacement

    d, updates = step(), 0
    assert d[1] < -0.104
    while not contact.multipliers.augment(coords + [[d[0], d[1]], [d[2], d[3]], [0, d[3]], [0, d[1]]], 1e-8).is_converged:
        d, updates = step(), updates + 1
        assert updates <= 8
    assert updates > 0 and d[[1, 3]] == pytest.approx([-0.1, -0.1], abs=1.1e-8)
