"""``find_equilibrium`` with friction: slip is counted from where the host's step began, whatever the search tried."""

import numpy as np
import pytest
from fmc_contact import Contact, NoSupportError, find_equilibrium
from scenes import K

YOUNG, WEIGHT, MU = 100.0, 1.0, 0.3


def springs(coords, pairs, ground=0.0):
    """Springs along the axes between nodes, and sideways to the ground."""
    matrix = np.diag([ground, 0.0] * len(coords))
    for a, b, axis in pairs:
        p, q = 2 * a + axis, 2 * b + axis
        matrix[[p, q], [p, q]] += YOUNG / 2
        matrix[[p, q], [q, p]] -= YOUNG / 2
    return matrix


@pytest.fixture
def block():
    """A unit square that stands on a plane, by its weight alone. Coordinates, contact, and the host with a push to the side."""
    coords = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    edges = [(0, 3, 1), (1, 2, 1), (0, 1, 0), (3, 2, 0)]
    matrix = springs(coords, edges)
    # Shear, so that the square keeps its angles.
    for shear in (np.array([-1, 1, -1, -1, 1, -1, 1, 1.0]), np.array([0, 1, 0, -1, 0, 1, 0, -1.0])):
        matrix += YOUNG / 8 * np.outer(shear, shear)
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=K, friction_coefficient=MU)
    contact.obstacles.add_half_space([0, 0], [0, 1])

    def host(push):
        load = np.zeros((4, 2))
        load[:, 1], load[:2, 0] = -WEIGHT / 4, push / 2
        return lambda x: (matrix @ (x - coords).ravel() - load.ravel(), matrix)

    return coords, contact, host


def fresh_forces(block_contact, begun, slip, x):
    """Of a contact that has never searched, with a step begun at these coordinates."""
    block_contact.friction.begin_step(begun)
    if slip is not None:
        block_contact.friction.slip = slip
    return block_contact.evaluate(x).forces


def another(coords):
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=K, friction_coefficient=MU)
    contact.obstacles.add_half_space([0, 0], [0, 1])
    return contact


def test_a_loose_block_that_is_pushed_to_and_fro_sticks_as_if_nothing_had_been_tried(block):
    coords, contact, host = block
    x = coords
    contact.friction.begin_step(x)
    for push in (0.0, 0.1, 0.2, 0.0, -0.2, 0.1):
        slip = contact.friction.slip.copy()
        found = find_equilibrium(host(push), contact, x, range(8))
        assert np.array_equal(found.result.forces, fresh_forces(another(coords), x, slip, found.x))
        assert found.result.forces[:, 0].sum() == pytest.approx(-push, abs=1e-8) and not found.warnings
        contact.friction.commit_step(found.x)
        x = found.x
    # What never slides stands where the last push has it, whatever came between.
    start = another(coords)
    start.friction.begin_step(coords)
    pressed = find_equilibrium(host(0.0), start, coords, range(8)).x
    start.friction.commit_step(pressed)
    once = find_equilibrium(host(0.1), start, pressed, range(8)).x
    assert np.abs(x - once).max() < 1e-3 * np.abs(once - coords).max()


@pytest.mark.parametrize("push", [0.105, 0.12, 0.15])
def test_bodies_that_springs_hardly_hold_keep_their_step(push):
    """Two squares, one above the other; settling them leads nowhere, and the equilibrium is sought from the start."""
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.1], [1, 1.1], [1, 2.1], [0, 2.1]])
    edges = [(0, 3, 1), (1, 2, 1), (4, 7, 1), (5, 6, 1)] + [(n, n + 1, 0) for n in (0, 2, 4, 6)]
    matrix = springs(coords, edges, ground=1e-4)
    free, target = np.arange(4, 12), coords.copy()
    target[6:] += [0.01, -push]
    results = []
    for _ in range(2):
        contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=K, friction_coefficient=0.1)
        contact.friction.begin_step(coords)
        if results:
            results.append(contact.evaluate(results[0].x))
        else:
            results.append(find_equilibrium(lambda x: (matrix @ (x - coords).ravel(), matrix), contact, coords, free, target, straight_slip=True))
    assert np.array_equal(results[0].result.forces, results[1].forces)


def test_a_refused_step_leaves_the_one_that_has_begun(block):
    coords, contact, host = block
    contact.friction.begin_step(coords)
    pressed = find_equilibrium(host(0.0), contact, coords, range(8)).x
    contact.friction.commit_step(pressed)
    held = find_equilibrium(host(0.2), contact, pressed, range(8)).x
    before = contact.evaluate(held).forces
    # From a guess that is not where the step began, with more than friction can bear.
    with pytest.raises(NoSupportError):
        find_equilibrium(host(2 * MU * WEIGHT), contact, held, range(8))
    assert np.array_equal(contact.evaluate(held).forces, before)


def test_a_block_that_is_pushed_has_no_penetration_where_none_is_wanted(block):
    """Of a contact a tenth as stiff as the block: the law alone leaves a tenth of its height."""
    coords, contact, host = block
    contact.set_options(stiffness=YOUNG / 10)
    contact.friction.begin_step(coords)
    x = coords
    for push in (0.0, 0.2, 0.1):
        found = find_equilibrium(host(push), contact, x, range(8), penetration=1e-7)
        assert found.penetration <= 1e-7 and np.abs(found.x[:2, 1]).max() < 1e-6
        assert found.result.forces[:, 0].sum() == pytest.approx(-push, abs=1e-8)
        contact.friction.commit_step(found.x)
        x = found.x
    # Other options leave all as it is.
    before = contact.evaluate(x).forces
    contact.set_options(threads=2)
    assert np.array_equal(contact.evaluate(x).forces, before)


def test_a_law_made_stiffer_leaves_the_pull_of_what_is_carried(block):
    coords, contact, host = block
    contact.friction.begin_step(coords)
    pressed = find_equilibrium(host(0.0), contact, coords, range(8)).x
    contact.friction.commit_step(pressed)
    held = find_equilibrium(host(0.2), contact, pressed, range(8)).x
    contact.friction.commit_step(held)
    before = contact.evaluate(held)
    contact.stiffen(4.0)
    # At rest the slip is all carried: the traction is k_T times it.
    assert contact.evaluate(held).forces[:, 0].sum() == pytest.approx(before.forces[:, 0].sum(), rel=1e-12)
    contact.stiffen(0.25)
    assert np.array_equal(contact.evaluate(held).forces, before.forces)
