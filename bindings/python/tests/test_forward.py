"""Rates along a direction against central differences and against ``vjp``, its transpose."""

import numpy as np
import pytest
from fmc_contact import Contact, PairGradient, Pose
from fmc_contact.errors import IndexOutOfRangeError, LengthError, UnsupportedError
from test_gradients import SCENES, STEP, WITHIN, contact_of, obstacle_scene, plane


def compare(found, value):
    """``value`` takes how far to go, and returns energy and forces."""
    ends = [value(by) for by in (STEP, -STEP)]
    energy, forces = ((ends[0][one] - ends[1][one]) / (2 * STEP) for one in range(2))
    assert found.energy == pytest.approx(energy, rel=WITHIN)
    assert np.abs(found.forces - forces).max() < WITHIN * np.abs(forces).max()


def values(contact, coords):
    found = contact.evaluate(coords)
    return found.energy, found.forces


@SCENES
@pytest.mark.parametrize("law", ["depth", "volume"])
def test_by_nodes(scene, law):
    reference, cells, coords = scene()
    motion = np.random.default_rng(7).uniform(-1, 1, coords.shape)
    contact = contact_of(reference, cells, law=law, estimator="exact")
    compare(contact.jvp(coords, motion), lambda by: values(contact, coords + by * motion))


@pytest.mark.parametrize("law", ["depth", "volume"])
def test_by_the_pose_of_an_obstacle(law):
    contact, coords = obstacle_scene(law)
    normal = np.array([0.3, 1.0]) / np.hypot(0.3, 1.0)
    start, shift, turn = np.array([0.1, -0.9]), np.array([0.4, -0.7]), 0.6

    def placed(by):
        angle = 0.2 + by * turn
        rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        contact.obstacles.set_pose(0, Pose(start + by * shift, rotation))
        return values(contact, coords)

    contact.obstacles.add_half_space(start, normal)
    placed(0.0)
    found = contact.jvp(coords, positions=[shift], rotations=[[0, 0, turn]])
    size = contact.tangent(coords, obstacles=True).shape[0]
    assert size == coords.size + 2, "tangents have no rotations, as before"
    compare(found, placed)


def test_in_space_by_the_rotation_of_an_obstacle():
    coords = np.random.default_rng(1).uniform(-0.05, 0.05, (8, 3))
    coords += np.stack(np.meshgrid([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], indexing="ij"), -1).reshape(-1, 3)
    contact = Contact(coords, [[0, 4, 6, 2, 1, 5, 7, 3]], "hexahedron", stiffness=30.0)
    contact.obstacles.add_half_space((0.4, 0.5, 0.1), (0, 0, 1))
    turn, pose = np.array([0.3, -0.5, 0.2]), contact.obstacles.get(0).pose

    def turned(by):
        x, y, z = by * turn
        angle = np.linalg.norm(by * turn)
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) / (angle or 1.0)
        rotation = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
        contact.obstacles.set_pose(0, Pose(pose.position, rotation @ pose.rotation))
        return values(contact, coords)

    turned(0.0)
    compare(contact.jvp(coords, rotations=[turn]), turned)


@SCENES
def test_it_is_the_transpose_of_vjp(scene):
    reference, cells, coords = scene()
    contact = contact_of(reference, cells)
    motion, adjoint = np.random.default_rng(7).uniform(-1, 1, (2, *coords.shape))
    back = contact.vjp(coords, adjoint, energy=2.0, by=["coords", "stiffness"])
    rates = contact.jvp(coords, motion, stiffness=0.7)
    along = (back.coords * motion).sum() + 0.7 * back.stiffness
    assert 2.0 * rates.energy + (adjoint * rates.forces).sum() == pytest.approx(along, rel=1e-12)


def test_what_is_not_known_is_refused():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells, friction_coefficient=0.3)
    contact.friction.begin_step(coords)
    with pytest.raises(UnsupportedError, match="unless friction is frozen"):
        contact.jvp(coords, np.ones_like(coords))
    with pytest.raises(ValueError, match="motion has shape"):
        contact.jvp(coords, np.ones(3))
    pair = PairGradient(("body", 0), ("wall", 1), stiffness=1.0)
    with pytest.raises(ValueError, match="partner 'wall', expected body, obstacle"):
        contact.jvp(coords, pairs=[pair])
    with pytest.raises(IndexOutOfRangeError, match="row 0 of the pairs"):
        contact.jvp(coords, pairs=[PairGradient(("body", 0), ("body", 7), stiffness=1.0)])
    with pytest.raises(LengthError, match="slip"):
        contact.jvp(coords, slip=np.zeros((2, 5)))
    nothing = contact_of(reference, cells).jvp(coords)
    assert nothing.energy == 0 and not nothing.forces.any()


def test_by_what_single_pairs_have():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells)
    contact.pairs.set(0, 1, law="depth", stiffness=20.0)
    forces = contact.evaluate(coords).forces
    own = PairGradient(("body", 0), ("body", 1), stiffness=3.0)
    assert np.abs(contact.jvp(coords, stiffness=1.0, pairs=[own]).forces - forces * 4.0 / 20.0).max() < 1e-12


def test_by_friction():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells, friction_coefficient=0.3)
    contact.friction.begin_step(coords)
    dragged = coords + [[0.01 * (y > 0.1), 0.0] for _, y in coords]
    contact.friction.commit_step(dragged)
    rows = contact.vjp(dragged, np.zeros(coords.shape), by=["slip"]).slip
    rows[:, 4:6] = np.random.default_rng(3).uniform(-1, 1, (len(rows), 2))
    adjoint = np.random.default_rng(7).uniform(-1, 1, coords.shape)
    back = contact.vjp(dragged, adjoint, by=["slip", "friction"])
    rates = contact.jvp(dragged, friction=0.4, slip=rows)
    along = (back.slip[:, 4:6] * rows[:, 4:6]).sum() + 0.4 * sum(pair.friction for pair in back.pairs)
    assert along != 0 and (adjoint * rates.forces).sum() == pytest.approx(along, rel=1e-12)


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_rates_that_are_no_numbers_are_named(wrong):
    contact, coords = obstacle_scene("depth")
    contact.obstacles.add_half_space((0.1, -0.9), (0, 1))
    motion = np.zeros(coords.shape)
    motion[3, 1] = wrong
    for rates, place in (
        ({"motion": motion}, r"motion\[3, 1\]"),
        ({"positions": [(0.0, wrong)]}, r"positions\[0, 1\]"),
        ({"rotations": [(0.0, 0.0, wrong)]}, r"rotations\[0, 2\]"),
        ({"stiffness": wrong}, "stiffness"),
        ({"friction": wrong}, "friction"),
    ):
        with pytest.raises(ValueError, match=f"{place} is {wrong}, expected finite numbers"):
            contact.jvp(coords, **rates)
