"""Options of single pairs, on a tower of three squares on a floor; every contact is 0.1 deep and 1 wide."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact, errors
from scenes import K, same_bits

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
TOWER = np.concatenate([SQUARE + [0, 0.9 * n] for n in range(3)])
CELLS = np.arange(12).reshape(3, 4)
FLOOR = ("obstacle", 0)


def tower(**options: object) -> Contact:
    contact = Contact(TOWER, CELLS, "quad", **({"stiffness": K, "law": "volume", "estimator": "exact"} | options))
    contact.obstacles.add_half_space((0, 0.1), (0, 1))
    return contact


def pressures(contact: Contact) -> dict[tuple, float]:
    return {(pair.a[1], pair.b): pair.pressure for pair in contact.evaluate(TOWER).pairs}


def test_every_pair_may_have_its_stiffness() -> None:
    contact = tower()
    contact.pairs.set(1, 0, stiffness=7 * K)
    contact.pairs.set(("body", 1), ("body", 2), law="volume", stiffness=3 * K, exponent=2)
    expected = {(0, ("body", 1)): 7 * K, (1, ("body", 2)): 3 * K * 2 * 0.1, (0, FLOOR): K}
    assert pressures(contact) == pytest.approx(expected)
    # Others follow the contact's options when they change; a law that was taken over does not.
    contact.set_options(stiffness=2 * K)
    assert pressures(contact) == pytest.approx(expected | {(0, FLOOR): 2 * K})
    contact.pairs.reset(0, 1)
    contact.pairs.reset(0, 1)
    assert pressures(contact) == pytest.approx(expected | {(0, FLOOR): 2 * K, (0, ("body", 1)): 2 * K})


def test_a_stiffness_alone_takes_the_law_with_its_exponent() -> None:
    contact = tower(exponent=2)
    contact.pairs.set(FLOOR, 0, stiffness=5 * K)
    assert contact.pairs.options(0, FLOOR) == {
        "excluded": False,
        "friction_coefficient": None,
        "surfaces": None,
        "static_coefficient": 0.0,
        "weakening_slip": 0.0,
        "gap_offset": 0.0,
        "law": "volume",
        "stiffness": 5 * K,
        "exponent": 2.0,
        "smoothing_length": 0.0,
        "interface": "contact",
        "reach": 0.0,
        "normal_strength": 0.0,
        "shear_strength": 0.0,
        "normal_energy": 0.0,
        "shear_energy": 0.0,
        "mixed_mode_exponent": 0.0,
        "viscosity": 0.0,
        "softening": "linear",
        "transverse_coefficient": None,
        "direction": None,
        "direction_of": "a",
        "normal_shape": None,
        "shear_shape": None,
        "normal_slope": None,
        "shear_slope": None,
    }
    assert pressures(contact)[0, FLOOR] == pytest.approx(5 * K * 2 * 0.1)


def test_laws_differ_from_pair_to_pair() -> None:
    contact, alone = tower(), tower(law="depth")
    contact.pairs.set(0, 1, law="depth", stiffness=K)
    for partner in (FLOOR, 2):
        alone.pairs.set(1 if partner == 2 else 0, partner, excluded=True)
    forces, of_depth = contact.evaluate(TOWER).forces, alone.evaluate(TOWER).forces
    assert len(alone.evaluate(TOWER).pairs) == 1 and np.abs(of_depth).max() > 0
    contact.pairs.set(0, 1, excluded=True)
    assert forces == pytest.approx(of_depth + contact.evaluate(TOWER).forces, abs=1e-13 * K)


def test_pairs_are_left_out() -> None:
    contact = tower()
    before = contact.evaluate(TOWER).forces
    contact.pairs.set(0, FLOOR, excluded=True)
    contact.pairs.set(2, 1, excluded=True)
    assert contact.pairs.options(1, 2)["excluded"] is True
    result = contact.evaluate(TOWER)
    assert [(pair.a, pair.b) for pair in result.pairs] == [(("body", 0), ("body", 1))]
    assert np.all(result.forces[8:] == 0) and np.all(result.obstacles[0].force == 0)
    contact.pairs.set(0, FLOOR)
    contact.pairs.reset(1, 2)
    assert same_bits(contact.evaluate(TOWER).forces, before)


def test_self_contact_of_one_body() -> None:
    contact = Contact(TOWER, CELLS, "quad", stiffness=K, law="volume", estimator="exact", bodies=[0, 0, 1])
    assert contact.evaluate(TOWER).volume == pytest.approx(0.1)
    assert contact.pairs.options(0, 0)["excluded"] is True
    contact.pairs.set(0, 0)
    assert contact.pairs.options(0, 0)["excluded"] is False
    assert contact.evaluate(TOWER).volume == pytest.approx(0.2)
    contact.set_options(self_contact=True)
    contact.pairs.set(0, 0, excluded=True)
    assert contact.evaluate(TOWER).volume == pytest.approx(0.1)


def test_what_is_refused_changes_nothing() -> None:
    contact = tower(estimator="fibers", law="fiber")
    contact.pairs.set(0, 1, stiffness=2 * K)
    before, options = contact.evaluate(TOWER).forces, contact.pairs.options(0, 1)
    for error, text, change in [
        (errors.BodyOutOfRangeError, "no body 3, only 3", lambda: contact.pairs.set(0, 3)),
        (errors.ObstacleOutOfRangeError, "no obstacle 1", lambda: contact.pairs.set(0, ("obstacle", 1))),
        (errors.UnsupportedError, "two obstacles", lambda: contact.pairs.set(FLOOR, FLOOR)),
        (errors.NotPositiveError, "pair of body 0 and body 1: 'stiffness' is NaN", lambda: contact.pairs.set(0, 1, stiffness=np.nan)),
        (errors.NotPositiveError, "'stiffness' is 0", lambda: contact.pairs.set(0, 1, law="volume")),
        (errors.OptionsConflictError, "'exponent' of a pair belongs to a law", lambda: contact.pairs.set(0, 1, exponent=2)),
        (errors.UnsupportedError, "two obstacles", lambda: contact.pairs.set(FLOOR, FLOOR, stiffness=2 * K)),
        (ValueError, "no value 'glue'", lambda: contact.pairs.set(0, 1, law="glue", stiffness=K)),
        (ValueError, "no partner 'wall'", lambda: contact.pairs.set(0, ("wall", 1))),
        (IndexError, "no body -1", lambda: contact.pairs.set(0, -1)),
        # By this number the C interface says: that of the contact.
        (ValueError, "friction_coefficient is -1", lambda: contact.pairs.set(0, 1, friction_coefficient=-1)),
    ]:
        with pytest.raises(error, match=text):
            change()
        assert contact.pairs.options(0, 1) == options
        assert same_bits(contact.evaluate(TOWER).forces, before)
    with pytest.raises(errors.BodyOutOfRangeError) as caught:
        contact.pairs.options(0, 9)
    assert caught.value.indices == {"body": (9,)}


def test_contact_begins_at_a_distance() -> None:
    contact = tower(law="depth", estimator="auto")
    # Squares are 0.1 deep in the floor, and sink in one another by as much.
    contact.pairs.set(0, FLOOR, gap_offset=0.2)
    contact.pairs.set(1, 2, gap_offset=-0.04)
    assert contact.pairs.options(0, FLOOR)["gap_offset"] == 0.2
    result = contact.evaluate(TOWER)
    found = {(pair.a[1], pair.b): pair.penetration for pair in result.pairs}
    expected = {(0, FLOOR): 0.3, (0, ("body", 1)): 0.1, (1, ("body", 2)): 0.06}
    assert found == pytest.approx(expected)
    assert result.obstacles[0].force[1] == pytest.approx(-0.3 * K)
    for offset, a, b, error in (
        (0.1, 0, 1, errors.UnsupportedError),
        (np.nan, 0, FLOOR, errors.NotPositiveError),
    ):
        with pytest.raises(error, match="offset"):
            contact.pairs.set(a, b, gap_offset=offset)
    assert contact.pairs.options(0, 1)["gap_offset"] == 0


@pytest.mark.parametrize("wrong", [1.5, 1.0, True, np.True_, "1", None])
def test_numbers_of_bodies_are_integers(wrong: object) -> None:
    contact = tower(law="depth", estimator="auto")
    calls = [
        lambda: contact.pairs.set(0, wrong, excluded=True),
        lambda: contact.pairs.set(("body", wrong), FLOOR, excluded=True),
        lambda: contact.pairs.set(0, ("obstacle", wrong), excluded=True),
        lambda: contact.pairs.reset(wrong, 0),
        lambda: contact.pairs.options(0, wrong),
        lambda: contact.pairs.tie(wrong, 0),
        lambda: contact.cohesive.interface(0, wrong, TOWER),
        lambda: contact.obstacles.get(wrong),
        lambda: contact.obstacles.remove(wrong),
    ]
    for call in calls:
        with pytest.raises(TypeError, match="is no integer"):
            call()


@pytest.mark.parametrize("wrong", [-1, 7, 1 << 64])
def test_numbers_of_no_body_are_out_of_range(wrong: int) -> None:
    contact = tower(law="depth", estimator="auto")
    for call in (contact.pairs.options, contact.pairs.reset, contact.pairs.tie):
        with pytest.raises(errors.BodyOutOfRangeError, match=f"{wrong}"):
            call(0, wrong)
    with pytest.raises(errors.ObstacleOutOfRangeError, match=f"{wrong}"):
        contact.pairs.options(0, ("obstacle", wrong))
    # Integers of numpy are integers.
    assert contact.pairs.options(np.int32(0), np.uint8(1)) == contact.pairs.options(0, 1)
