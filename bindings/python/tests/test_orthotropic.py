"""Friction with another coefficient across a direction, on a block on a floor."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from fmc_contact import Contact, errors, find_equilibrium
from scenes import same_bits

K, DEPTH, ALONG, ACROSS = 1e3, 1e-3, 0.5, 0.2
FLOOR = ("obstacle", 0)
CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1.0]]) - [0, 0, DEPTH]
DIRECTION = np.array([0.8, -0.5, 0.3])


def block() -> Contact:
    contact = Contact(CUBE, np.arange(8)[None], "hexahedron", stiffness=K)
    contact.obstacles.add_half_space((0, 0, 0), (0, 0, 1))
    return contact


def slid(contact: Contact, way: np.ndarray) -> np.ndarray:
    """Friction by the normal force after three steps this way."""
    contact.friction.begin_step(CUBE)
    for step in (1, 2):
        contact.friction.commit_step(CUBE + step * way)
    body = contact.evaluate(CUBE + 3 * way).bodies[0]
    return np.array(body.friction) / (body.force[2] - body.friction[2])


@pytest.mark.parametrize("direction_of", ["a", "b"])
@pytest.mark.parametrize("angle", [0.0, 0.4, 1.3, 2.9])
def test_the_force_is_normal_to_the_ellipse(direction_of: str, angle: float) -> None:
    contact = block()
    contact.pairs.set(
        0, FLOOR, friction_coefficient=ALONG, transverse_coefficient=ACROSS, direction=DIRECTION, direction_of=direction_of
    )
    way = np.array([np.cos(angle), np.sin(angle), 0])
    along = DIRECTION * [1, 1, 0] / np.hypot(*DIRECTION[:2])
    axes = np.array([along, np.cross([0, 0, 1], along)])
    mu, part = np.array([ALONG, ACROSS]), axes @ way
    expected = -(mu**2 * part / np.linalg.norm(mu * part)) @ axes
    # Walls that are sunk in bear a thousandth.
    assert slid(contact, way) == pytest.approx(expected, abs=2 * DEPTH)


@pytest.mark.parametrize("lagged", [False, True])
def test_a_search_slides_it_by_the_ellipse(lagged: bool) -> None:
    contact = block()
    contact.pairs.set(0, FLOOR, friction_coefficient=ALONG, transverse_coefficient=ACROSS, direction=(1, 0, 0))
    x = CUBE
    contact.friction.begin_step(x)
    # Springs pull every node along a line, and down.
    for step in range(1, 6):
        to = CUBE + [0.05 * step * np.cos(1.2), 0.05 * step * np.sin(1.2), -0.01]
        x = find_equilibrium(lambda x, to=to: (K * (x - to).ravel(), K * np.eye(24)), contact, x, np.arange(24), lagged=lagged).x
        contact.friction.commit_step(x)
    body = contact.evaluate(x).bodies[0]
    friction = np.array(body.friction)
    mu, way = np.array([ALONG, ACROSS]), np.array([np.cos(1.2), np.sin(1.2)])
    # It lags behind the springs, by less at every step; walls that are sunk in bear a part.
    expected = -(mu**2) * way / np.linalg.norm(mu * way)
    assert friction[:2] / (body.force[2] - friction[2]) == pytest.approx(expected, abs=0.01)


def test_options_come_back_in_either_order_and_are_taken_back() -> None:
    contact = block()
    contact.pairs.set(0, FLOOR, friction_coefficient=ALONG, transverse_coefficient=ACROSS, direction=DIRECTION, direction_of="b")
    found, swapped = contact.pairs.options(0, FLOOR), contact.pairs.options(FLOOR, 0)
    assert (found["transverse_coefficient"], found["direction"], found["direction_of"]) == (ACROSS, tuple(DIRECTION), "b")
    assert swapped == found | {"direction_of": "a"}
    forces = slid(contact, np.array([1.0, 0, 0]))
    other = block()
    other.pairs.set(FLOOR, 0, **{name: value for name, value in swapped.items() if value is not None})
    assert same_bits(slid(other, np.array([1.0, 0, 0])), forces)
    contact.pairs.set(0, FLOOR, friction_coefficient=ALONG)
    assert contact.pairs.options(0, FLOOR)["direction"] is None
    assert slid(contact, np.array([1.0, 0, 0])) == pytest.approx([-ALONG, 0, 0], abs=2 * DEPTH)


def test_a_direction_across_the_faces_is_told() -> None:
    contact = block()
    contact.pairs.set(0, FLOOR, friction_coefficient=ALONG, transverse_coefficient=ACROSS, direction=(0, 0, 1))
    assert slid(contact, np.array([0, 1.0, 0])) == pytest.approx([0, -ACROSS, 0], abs=2 * DEPTH)
    (warning,) = contact.evaluate(CUBE).warnings
    assert warning.kind == "no_friction_direction" and "perpendicular" in warning.text


@pytest.mark.parametrize(
    ("error", "text", "values"),
    [
        (errors.NotPositiveError, "'transverse_coefficient' is -1", {"transverse_coefficient": -1}),
        (errors.NotPositiveError, "'transverse_coefficient' is NaN", {"transverse_coefficient": np.nan}),
        (errors.NotPositiveError, "entry 1 of 'direction' is NaN", {"direction": (1, np.nan, 0)}),
        (errors.NotPositiveError, "'length of direction' is 0", {"direction": (0, 0, 0)}),
        (ValueError, "direction has 2 numbers", {"direction": (1, 0)}),
        (ValueError, "no value 'c'", {"direction_of": "c"}),
        (ValueError, "go together", {"direction": None}),
        (ValueError, "go together", {"transverse_coefficient": None}),
        (errors.UnsupportedError, "never slides", {"friction_coefficient": None, "interface": "rough"}),
    ],
)
def test_what_has_no_meaning_is_refused(error: type[Exception], text: str, values: dict[str, Any]) -> None:
    contact = block()
    usual: dict[str, Any] = {"friction_coefficient": ALONG, "transverse_coefficient": ACROSS, "direction": (1, 0, 0)}
    contact.pairs.set(0, FLOOR, **usual)
    before = contact.pairs.options(0, FLOOR)
    with pytest.raises(error, match=text):
        contact.pairs.set(0, FLOOR, **(usual | values))
    assert contact.pairs.options(0, FLOOR) == before
