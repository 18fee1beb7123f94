"""Wear, as the package has it."""

import numpy as np
import pytest
from fmc_contact import Contact, LawResponse, errors

K, WEAR = 1e3, (1e-4, 3e-4)
SQUARES = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.25, 0.999], [0.75, 0.999], [0.75, 2], [0.25, 2]])


def blocks(**options) -> Contact:
    """A small block on a larger one, 0.001 deep."""
    contact = Contact(SQUARES, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=K, **options)
    contact.pairs.set_wear(0, 1, *WEAR)
    contact.friction.begin_step(SQUARES)
    return contact


def slid(by: float) -> np.ndarray:
    coords = SQUARES.copy()
    coords[4:, 0] += by
    return coords


def test_both_blocks_lose_what_archard_says() -> None:
    contact = blocks()
    contact.wear.set_cycles(10)
    assert not contact.wear.depth.any()
    contact.friction.commit_step(slid(0.1))
    pressure, width = K * 0.001, 0.5
    expected = np.array(WEAR) * pressure * width * 0.1 * 10
    # Rims as wide as the penetration.
    assert contact.wear.volumes == pytest.approx(expected, rel=5e-3)
    depth = contact.wear.depth
    assert depth[4:6] == pytest.approx(WEAR[1] * pressure, rel=1e-9) and not depth[[0, 1, 6, 7]].any()
    # The large block wears by its nodes, over all of its face.
    assert depth[2:4].sum() / 2 == pytest.approx(expected[0], rel=5e-3)
    rows = contact.wear.facets
    assert rows[:, 3].sum() == pytest.approx(expected.sum(), rel=5e-3) and rows.shape[1] == 4


def test_a_restart_has_the_same_bits() -> None:
    contact, other = blocks(friction_coefficient=0.3), blocks(friction_coefficient=0.3)
    contact.friction.commit_step(slid(0.1))
    other.wear.facets = contact.wear.facets
    other.friction.begin_step(slid(0.1))
    other.friction.slip = contact.friction.slip
    for one in (contact, other):
        one.friction.commit_step(slid(0.15))
    assert np.array_equal(contact.evaluate(slid(0.2)).forces, other.evaluate(slid(0.2)).forces)
    assert np.array_equal(contact.wear.facets, other.wear.facets)
    contact.wear.facets = np.zeros((0, 4))
    assert not contact.wear.volumes.any()


def test_options_of_the_pair_and_its_wear_leave_one_another() -> None:
    contact = blocks()
    contact.pairs.set(0, 1, friction_coefficient=0.2)
    assert contact.pairs.wear(1, 0) == WEAR[::-1]
    contact.pairs.set_wear(0, 1, 0.0)
    assert contact.pairs.options(0, 1)["friction_coefficient"] == 0.2
    assert contact.pairs.wear(0, 1) == (0.0, 0.0)
    contact.pairs.set_wear(0, 1, 1e-3)
    contact.pairs.reset(0, 1)
    assert contact.pairs.wear(0, 1) == (0.0, 0.0)
    # A pair that has never had options does not get any by not wearing: its self-contact stays off.
    contact.pairs.set_wear(0, 0, 0.0)
    assert contact.pairs.options(0, 0)["excluded"]


def test_a_law_of_named_parts_leaves_the_wear_of_the_other_faces() -> None:
    grid = np.array([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]], float)
    cells = [[0, 1, 4, 3], [1, 2, 5, 4], [6, 7, 10, 9], [7, 8, 11, 10]]
    contact = Contact(grid, cells, "quad", bodies=[0, 0, 1, 1], stiffness=K)
    middle = grid[contact.mesh.boundary_facets().nodes].mean(1)
    left = contact.mesh.add_surface((middle[:, 1] == 1) & (middle[:, 0] < 1))
    contact.pairs.set_wear(0, 1, *WEAR)

    def spring(points):
        return LawResponse(K * points.jump, np.broadcast_to(K * np.eye(2), points.axes.shape))

    contact.pairs.set(0, 1, interface="law", law=spring, surfaces=(left, left))
    assert contact.pairs.wear(0, 1) == WEAR


def test_what_cannot_wear_is_refused() -> None:
    contact = blocks()
    floor = ("obstacle", contact.obstacles.add_half_space((0, 0), (0, 1)))
    with pytest.raises(errors.UnsupportedError, match="an obstacle, which does not wear"):
        contact.pairs.set_wear(0, floor, 0.0, 1.0)
    with pytest.raises(errors.UnsupportedError, match="a body with itself"):
        contact.pairs.set_wear(0, 0, 1.0)
    with pytest.raises(errors.NotPositiveError, match="wear_coefficient"):
        contact.pairs.set_wear(0, 1, -1.0)
    with pytest.raises(errors.UnsupportedError, match="law volume"):
        contact.pairs.set(0, 1, law="volume", stiffness=1.0)
    with pytest.raises(errors.UnsupportedError, match="that are tied"):
        contact.pairs.set(0, 1, interface="tied", reach=0.1)
    with pytest.raises(errors.UnsupportedError, match="or one by your own law"):
        contact.pairs.set(0, 1, interface="law", law=lambda points: LawResponse(points.jump, np.zeros((2, 2))), reach=0.1)
    with pytest.raises(errors.NotPositiveError, match="wear_cycles"):
        contact.wear.set_cycles(0)
    with pytest.raises(errors.LengthError, match="facets"):
        contact.wear.facets = np.zeros((2, 3))
    with pytest.raises(errors.IndexOutOfRangeError, match="row 0"):
        contact.wear.facets = np.full((1, 4), 77.0)
    with pytest.raises(errors.NotPositiveError):
        contact.wear.facets = np.array([[0.0, 0.0, -1.0, 0.0]])
    assert contact.pairs.wear(0, 1) == WEAR


def test_a_step_that_wears_more_than_the_penetration_is_told() -> None:
    contact = blocks()
    contact.wear.set_cycles(100)
    found = contact.evaluate(slid(0.1))
    assert [warning.kind for warning in found.warnings] == ["large_wear"], found.warnings
