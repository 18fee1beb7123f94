"""Pairs that slide and do not separate, and rough ones: options, results and refusals."""

import numpy as np
import pytest
from fmc_contact import Contact, errors
from test_ties import CONN, COORDS, squares

UPPER = np.arange(10)[:, None] >= 4


def moved(coords, *by):
    return coords + np.where(UPPER, by, 0.0)


@pytest.mark.parametrize("kind", ["no_separation", "rough"])
def test_options_come_back_and_are_released(kind):
    contact, _ = squares()
    reach = 0.05 if kind == "no_separation" else 0.0
    contact.pairs.set(0, 1, interface=kind, reach=reach)
    options = contact.pairs.options(1, 0)
    assert (options["interface"], options["reach"], options["friction_coefficient"]) == (kind, reach, None)
    assert contact.pairs.tie(0, 1).area == pytest.approx(2.0 if kind == "no_separation" else 0.0)
    contact.pairs.reset(0, 1)
    assert contact.pairs.options(0, 1)["interface"] == "contact" and contact.pairs.tie(0, 1).area == 0


def test_what_is_pulled_off_is_held_and_slides():
    contact, coords = squares()
    contact.pairs.set(0, 1, interface="no_separation")
    at = moved(coords, 0.3, 2e-3)
    result = contact.evaluate(at)
    # k times the jump times the length, along the normal alone.
    assert result.bodies[1].force == pytest.approx([0.0, -4.0], abs=1e-12)
    nodes = contact.tie_nodes(at)
    assert set(nodes.body) == {0} and nodes.traction == pytest.approx(np.tile([0.0, 2.0], (2, 1)), abs=1e-12)
    # What faces one another where a step begins is 1.7 long.
    contact.friction.begin_step(moved(coords, 0.3, 0.0))
    assert contact.pairs.tie(0, 1).area == pytest.approx(1.7)
    assert contact.evaluate(at).bodies[1].force == pytest.approx([0.0, -3.4], abs=1e-12)
    with pytest.raises(errors.UntiedError):
        contact.friction.begin_step(moved(coords, 3.0, 0.0))


def test_rough_sticks_and_opens():
    contact, coords = squares()
    contact.pairs.set(0, 1, interface="rough")
    other, _ = squares()
    other.pairs.set(0, 1, friction_coefficient=np.inf)
    assert other.pairs.options(0, 1)["friction_coefficient"] == np.inf
    for one in (contact, other):
        one.friction.begin_step(coords)
        one.friction.commit_step(moved(coords, 0.0, -1e-3))
    at = moved(coords, 5e-2, -1e-3)
    result = contact.evaluate(at)
    assert np.array_equal(result.forces, other.evaluate(at).forces)
    # The stiffness of the law by the slip, over 1.95: 50 times the pressure.
    assert result.bodies[1].force[0] == pytest.approx(-1e3 * 5e-2 * 2, rel=0.03)
    assert np.abs(contact.evaluate(moved(coords, 5e-2, 1e-3)).forces).max() == 0


def test_refusals():
    contact, _ = squares()
    with pytest.raises(errors.UnsupportedError, match="they slide freely"):
        contact.pairs.set(0, 1, interface="no_separation", friction_coefficient=0.3)
    with pytest.raises(errors.UnsupportedError, match="never slides"):
        contact.pairs.set(0, 1, interface="rough", friction_coefficient=0.3)
    with pytest.raises(errors.OptionsConflictError, match="'reach'"):
        contact.pairs.set(0, 1, interface="rough", reach=0.1)
    with pytest.raises(errors.OptionsConflictError, match="'normal_strength'"):
        contact.pairs.set(0, 1, interface="no_separation", normal_strength=0.1)
    floor = contact.obstacles.add_half_space((0, 0), (0, 1))
    with pytest.raises(errors.UnsupportedError, match="does not separate from an obstacle"):
        contact.pairs.set(0, ("obstacle", floor), interface="no_separation")
    with pytest.raises(errors.UnsupportedError, match="infinite coefficient with friction without memory"):
        Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3, friction_coefficient=np.inf, memoryless_slip=1e-3)
    contact.pairs.set(0, ("obstacle", floor), interface="rough")
    contact.pairs.set(0, 1, interface="no_separation")
    with pytest.raises(errors.UnsupportedError, match="do not separate"):
        contact.tie_constraints()
