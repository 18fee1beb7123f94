"""Friction: steps, their state, and where it is refused."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact, contact_force_step, errors
from test_depth import DEPTH, K, blocks

MU = 0.3


def block_on_block(**options: object) -> tuple[Contact, np.ndarray]:
    """The second of two blocks 1e-2 deep in the first, a step begun."""
    coords, conn = blocks(4)
    contact = Contact(coords, conn, "quad", stiffness=K, friction_coefficient=MU, **options)
    contact.friction.begin_step(coords)
    return contact, coords


def moved(coords: np.ndarray, by: float) -> np.ndarray:
    moved = coords.copy()
    moved[len(coords) // 2 :, 0] += by
    return moved


@pytest.mark.parametrize("law", ["depth", "fiber"])
def test_it_sticks_and_slides(law: str) -> None:
    contact, coords = block_on_block(law=law)
    stuck = contact.evaluate(moved(coords, 1e-3))
    assert stuck.bodies[1].friction[0] == pytest.approx(-K * 1e-3, rel=0.03)
    assert stuck.friction.energy == pytest.approx(0.5 * K * 1e-6, rel=0.03)
    slid = contact.evaluate(moved(coords, 0.02))
    normal = slid.bodies[1].force[1] - slid.bodies[1].friction[1]
    assert slid.bodies[1].friction[0] == pytest.approx(-MU * normal, rel=0.03)
    assert slid.friction.dissipation > 0 and slid.friction.slip_area > 0.9
    assert slid.forces.sum(axis=0) == pytest.approx([0, 0], abs=1e-12 * K)
    assert slid.pairs[0].friction == slid.friction


def test_a_restart_has_the_same_bits() -> None:
    contact, coords = block_on_block()
    middle, end = moved(coords, 4e-3), moved(coords, 1e-3)
    contact.friction.commit_step(middle)
    again, _ = block_on_block()
    again.friction.begin_step(middle)
    again.friction.slip = contact.friction.slip
    assert np.array_equal(again.evaluate(end).forces, contact.evaluate(end).forces)
    assert np.abs(contact.friction.slip[:, 4:7]).max() == pytest.approx(MU * DEPTH, rel=0.1)


def test_a_call_that_keeps_nothing_has_the_same_bits() -> None:
    contact, coords = block_on_block()
    conn, start, slip = blocks(4)[1], coords, None
    for by in (4e-3, 1e-3, -6e-3):
        end = moved(coords, by)
        found, slip = contact_force_step(
            start, end, conn, "quad", stiffness=K, friction_coefficient=MU, slip=slip, reference=coords
        )
        assert np.array_equal(found.forces, contact.evaluate(end).forces)
        contact.friction.commit_step(end)
        assert np.array_equal(slip, contact.friction.slip) and np.abs(slip).max() > 0
        start = end


@pytest.mark.parametrize("law", ["depth", "fiber"])
def test_fields_say_what_sticks_and_slides(law: str) -> None:
    contact, coords = block_on_block(law=law)
    for by, slides in ((1e-3, False), (0.02, True)):
        end = moved(coords, by)
        field, points = contact.nodal_contact(end), contact.contact_points(end)
        pressed = np.flatnonzero(field.area > 0.05)  # not the walls, a strip of which is sunk in
        assert np.all((field.slides if slides else field.sticks)[pressed])
        assert field.sliding[pressed] == pytest.approx(float(slides), abs=0.1) and not np.any(field.sticks & field.slides)
        found = contact.evaluate(end).bodies[0].friction
        assert (points.friction * points.area[:, None]).sum(axis=0) == pytest.approx(found, abs=1e-12 * K)
        assert np.abs(points.slip).max() == (pytest.approx(0.02 - MU * DEPTH, rel=0.05) if slides else 0)


def test_frozen_friction_has_a_symmetric_tangent() -> None:
    pytest.importorskip("scipy.sparse")
    contact, coords = block_on_block()
    slid = moved(coords, 0.02)
    full, symmetric = contact.tangent(slid), contact.tangent(slid, symmetric=True)
    size = abs(full).max()
    assert abs(full - full.T).max() > 0.1 * size and abs(symmetric - symmetric.T).max() < 1e-9 * size
    contact.friction.freeze(slid)
    frozen = contact.tangent(slid)
    assert abs(frozen - frozen.T).max() < 1e-9 * size
    contact.friction.release()
    assert abs(contact.tangent(slid) - full).max() == 0


def test_a_pair_has_a_coefficient_of_its_own() -> None:
    contact, coords = block_on_block()
    contact.pairs.set(0, 1, friction_coefficient=0.0)
    assert contact.pairs.options(0, 1)["friction_coefficient"] == 0.0
    assert contact.evaluate(moved(coords, 0.02)).friction.slip_area == 0.0


def test_what_is_refused() -> None:
    coords, conn = blocks(2)
    contact = Contact(coords, conn, "quad", stiffness=K, friction_coefficient=MU)
    for call in (contact.evaluate, contact.tangent, contact.friction.commit_step, contact.friction.freeze):
        with pytest.raises(errors.NoStepError, match="begin_step"):
            call(coords)
    with pytest.raises(errors.NoStepError):
        _ = contact.friction.slip
    contact.friction.begin_step(coords)
    assert contact.friction.slip.shape == (0, 8)
    # One vector for every facet, as an earlier version wrote it.
    with pytest.raises(errors.LengthError, match="slip"):
        contact.friction.slip = np.zeros((contact.facet_count, 2))
    slip = np.array([[2.0, 0, 1, 0, 1e-4, 0, 0, 0], [3, 0, 1, 0, np.nan, 0, 0, 0]])
    with pytest.raises(errors.NonFiniteSlipError, match="facet 3"):
        contact.friction.slip = slip
    for column, value in ((0, 99), (0, 0.5), (0, 2), (1, 1), (2, 5), (3, 1), (6, 1e-4)):
        row = np.array([2.0, 0, 1, 0, 1e-4, 0, 0, 0])
        row[column] = value
        with pytest.raises(errors.IndexOutOfRangeError, match="row 1"):
            contact.friction.slip = [slip[0], row]
    assert len(contact.friction.slip) == 0
    with pytest.raises(errors.NotPositiveError, match="friction_coefficient"):
        contact.set_options(friction_coefficient=-0.1)
    with pytest.raises(errors.UnsupportedError, match="friction_stiffness"):
        contact.set_options(law="volume")
