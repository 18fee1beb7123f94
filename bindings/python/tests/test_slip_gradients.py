"""Derivatives by the slip at the start of a step, and of the slip at its end, against central differences."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.errors import IndexOutOfRangeError, LengthError, UnsupportedError
from scenes import grid
from test_gradients import SCENES, disturbed, space

STEP = 1e-6


def begun(scene, slide, **options):
    """A contact within a step, some of whose facets carry slip, the coordinates at its end, and where it began."""
    reference, cells, coords = scene()
    contact = Contact(reference, cells, **{"stiffness": 30.0, "friction_coefficient": 0.3, **options})
    way = np.zeros(coords.shape)
    way[cells[1][1].min() :] = [*[slide] * (contact.dim - 1), 0.02]
    contact.friction.begin_step(coords + way)
    contact.friction.commit_step(coords + 0.3 * way)
    return contact, coords, coords + 0.3 * way


def factors(contact, coords, seed=3):
    """Factors of the forces, and of the slip at the end of every facet in contact."""
    random = np.random.default_rng(seed)
    adjoint = random.uniform(-1, 1, coords.shape)
    rows = contact.vjp(coords, np.zeros(coords.shape), by=["slip"]).slip
    rows[:, 4 : 4 + contact.dim] = 30.0 * random.uniform(-1, 1, (len(rows), contact.dim))
    return adjoint, rows


def value(contact, coords, begin, slip, adjoint, rows):
    """J, after which the step is as it was."""
    contact.friction.begin_step(begin)
    contact.friction.slip = slip
    forces = contact.evaluate(coords).forces
    contact.friction.commit_step(coords)
    ends = {tuple(row[:4]): row[4:7] for row in contact.friction.slip}
    contact.friction.begin_step(begin)
    contact.friction.slip = slip
    return (adjoint * forces).sum() + sum(row[4:7] @ ends.get(tuple(row[:4]), np.zeros(3)) for row in rows)


def compare(found, slope, scale):
    assert abs(found - slope) < 1e-7 * scale, (found, slope)


@SCENES
@pytest.mark.parametrize("slide", [0.002, 0.02, 0.3], ids=["stick", "both", "slip"])
@pytest.mark.parametrize("options", [{}, {"friction_stiffness": 20.0}], ids=["of the law", "of its own"])
def test_by_what_a_step_carries(scene, slide, options):
    contact, coords, begin = begun(scene, slide, **options)
    before = contact.friction.slip
    adjoint, rows = factors(contact, coords)
    found = contact.vjp(coords, adjoint, by=["slip", "stiffness", "friction"], slip_adjoint=rows)
    totals = contact.evaluate(coords).friction
    part = totals.slip_area / (totals.slip_area + totals.stick_area)
    assert {0.002: part < 0.1, 0.02: 0 < part < 1, 0.3: part > 0.6}[slide], part
    of = dict(zip(map(tuple, found.slip[:, :4]), found.slip[:, 4:7]))
    random = np.random.default_rng(5)
    along = np.zeros(before.shape)
    along[:, 4 : 4 + contact.dim] = random.uniform(-1, 1, (len(before), contact.dim))
    ends = [value(contact, coords, begin, before + by * along, adjoint, rows) for by in (STEP, -STEP)]
    expected = sum(of.get(tuple(row[:4]), np.zeros(3)) @ rate[4:7] for row, rate in zip(before, along))
    # Where all slides in the plane, nothing depends on the slip.
    size = max(np.linalg.norm(found.slip[:, 4:7]), 1.0)
    compare(expected, (ends[0] - ends[1]) / (2 * STEP), size)
    for name, at in (("stiffness", 30.0), ("friction_coefficient", 0.3)):
        ends = []
        for by in (STEP, -STEP):
            contact.set_options(**{name: at + by})
            ends.append(value(contact, coords, begin, before, adjoint, rows))
        contact.set_options(**{name: at})
        got = sum(getattr(pair, name.split("_")[0]) for pair in found.pairs)
        compare(got, (ends[0] - ends[1]) / (2 * STEP), max(abs(got), size / at))


@pytest.mark.parametrize("slide", [0.02, 0.3], ids=["both", "slip"])
def test_with_another_coefficient_across_a_direction(slide):
    contact, coords, begin = begun(space, slide)
    contact.pairs.set(0, 1, friction_coefficient=0.3, transverse_coefficient=0.1, direction=(1, 0.4, 0), direction_of="a")
    contact.friction.begin_step(begin)
    before = contact.friction.slip
    adjoint, rows = factors(contact, coords)
    found = contact.vjp(coords, adjoint, by=["slip", "stiffness"], slip_adjoint=rows)
    along = np.zeros(before.shape)
    along[:, 4:7] = np.random.default_rng(5).uniform(-1, 1, (len(before), 3))
    ends = [value(contact, coords, begin, before + by * along, adjoint, rows) for by in (STEP, -STEP)]
    of = dict(zip(map(tuple, found.slip[:, :4]), found.slip[:, 4:7]))
    expected = sum(of.get(tuple(row[:4]), np.zeros(3)) @ rate[4:7] for row, rate in zip(before, along))
    size = np.linalg.norm(found.slip[:, 4:7])
    compare(expected, (ends[0] - ends[1]) / (2 * STEP), size)
    ends = []
    for by in (STEP, -STEP):
        contact.set_options(stiffness=30.0 + by)
        ends.append(value(contact, coords, begin, before, adjoint, rows))
    compare(found.stiffness, (ends[0] - ends[1]) / (2 * STEP), max(abs(found.stiffness), size / 30.0))


def test_a_stick_without_memory_carries_nothing():
    reference, cells, coords = grid_scene()
    contact = Contact(reference, cells, stiffness=30.0, friction_coefficient=0.3, memoryless_slip=0.01)
    begin = coords + [0.004, 0.01] * (np.arange(len(coords)) >= 24)[:, None]
    contact.friction.begin_step(begin)
    adjoint, rows = factors(contact, coords)
    found = contact.vjp(coords, adjoint, by=["slip", "stiffness"], slip_adjoint=rows)
    assert len(rows) and not found.slip[:, 4:].any()
    ends = []
    for by in (STEP, -STEP):
        contact.set_options(stiffness=30.0 + by)
        ends.append((adjoint * contact.evaluate(coords).forces).sum())
    compare(found.stiffness, (ends[0] - ends[1]) / (2 * STEP), abs(found.stiffness))


def grid_scene():
    (a, of_a), (b, of_b) = grid((5, 3), (0, 1.5), (-1, 0)), grid((3, 3), (0.3, 1.3), (0, 0.8))
    reference = disturbed(np.concatenate([a, b]), 1)
    coords = disturbed(reference, 2)
    coords[len(a) :, 1] -= 0.25
    return reference, [("quad", of_a), ("quad", of_b + len(a))], coords


def test_nothing_changes_and_nothing_is_told_where_it_is_not_asked_for():
    contact, coords, _ = begun(grid_scene, 0.02)
    before, forces = contact.friction.slip, contact.evaluate(coords).forces
    adjoint, rows = factors(contact, coords)
    assert contact.vjp(coords, adjoint, by=["friction"]).slip is None
    contact.vjp(coords, adjoint, by=["slip"], slip_adjoint=rows)
    assert np.array_equal(contact.friction.slip, before) and np.array_equal(contact.evaluate(coords).forces, forces)


def test_what_is_not_known_is_refused():
    contact, coords, _ = begun(grid_scene, 0.02)
    adjoint, rows = factors(contact, coords)
    with pytest.raises(UnsupportedError, match="slip at the end of a step by coordinates"):
        contact.vjp(coords, by=["positions"], slip_adjoint=rows)
    with pytest.raises(LengthError, match="slip_adjoint"):
        contact.vjp(coords, by=["slip"], slip_adjoint=rows[:, :5])
    with pytest.raises(IndexOutOfRangeError):
        contact.vjp(coords, by=["slip"], slip_adjoint=np.concatenate([rows, rows[:1]]))
    contact.friction.freeze(coords)
    with pytest.raises(UnsupportedError, match="slip between steps while friction is frozen"):
        contact.vjp(coords, adjoint, by=["slip"])
    with pytest.raises(UnsupportedError, match="stiffness of a pair while friction is frozen"):
        contact.vjp(coords, adjoint, by=["stiffness"])
    contact.friction.release()
    contact.set_options(static_coefficient=0.4, weakening_slip=0.1)
    with pytest.raises(UnsupportedError, match="static friction, which carries more than slip"):
        contact.vjp(coords, adjoint, by=["slip"])
    contact.set_options(static_coefficient=0.0, weakening_slip=0.0, cohesion=0.1)
    with pytest.raises(UnsupportedError, match="stiffness of a pair with cohesion"):
        contact.vjp(coords, adjoint, by=["stiffness"])


def test_rates_by_the_stiffness():
    contact, coords, _ = begun(grid_scene, 0.02)
    rates = contact.jvp(coords, stiffness=2.0)
    assert np.abs(rates.forces - contact.evaluate(coords).forces / 15.0).max() < 1e-12
    # With a stiffness of its own the stick stays as stiff, and limits grow.
    contact.set_options(friction_stiffness=20.0)
    rates, ends = contact.jvp(coords, stiffness=2.0), []
    for by in (STEP, -STEP):
        contact.set_options(stiffness=30.0 + 2.0 * by)
        ends.append(contact.evaluate(coords).forces)
    expected = (ends[0] - ends[1]) / (2 * STEP)
    assert np.abs(rates.forces - expected).max() < 1e-7 * np.abs(expected).max()
