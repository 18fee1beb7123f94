"""Benchmarks of friction from the literature, on meshes as coarse as show them; ``friction/study.py`` runs them in full."""

import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import trapezoid

sys.path.insert(0, str(Path(__file__).parents[1] / "friction"))

import arm
import balls
import capstan
import cylinders
import fold
import pushed_plate
import ring_on_disc
import slope

LAWS = ["depth", "fiber"]


@pytest.mark.parametrize("law", LAWS)
def test_a_strip_around_a_drum_multiplies_its_tension(law):
    """Within the square of the angle by which one facet turns to the next."""
    for coefficient, cells in ((0.1, 40), (0.3, 60)):
        strip = capstan.Capstan(cells, coefficient=coefficient, law=law)
        tensions, counts = strip.pull(8)
        assert tensions[-1] == pytest.approx(strip.exact_of_thick_strip(), rel=(np.pi / cells) ** 2)
        assert max(counts) <= 9


@pytest.mark.parametrize("law", LAWS)
def test_a_block_is_pushed_up_a_slope(law):
    """A hundred times as stiff as those of the next test, whose load tilts the slope by 0.4 to 0.7 % in the force."""
    for coefficient in (0.0, 0.1, 0.3):
        forces, counts = slope.Slope(coefficient, law=law).push(10)
        assert forces[1:] == pytest.approx(slope.exact(coefficient), rel=1e-4)
        assert max(counts) <= 10


def test_a_softer_block_tilts_the_slope():
    """By 0.4 %, as a linear model has it: more when the block is in the middle than later."""
    for coefficient in (0.0, 0.2):
        forces, _counts = slope.Slope(coefficient, young=1100).push(20)
        assert forces[3:].mean() / slope.exact(coefficient) - 1 == pytest.approx(-0.004, abs=1e-3)


@pytest.mark.parametrize("law", LAWS)
def test_an_arm_presses_the_more_the_more_friction_holds_it(law):
    for coefficient, alpha in ((0.3, 0.5), (0.6, 0.9)):
        # The stiffer contact converges linearly at 0.54; the softer one lets the block tilt by its penetration.
        for factor, most, error in ((1.25, 8, 3e-3), (10, 10, 2e-4)):
            forces, counts = arm.Arm(coefficient, alpha, law, factor).pull()
            assert forces[-1] == pytest.approx(1, abs=error)
            assert max(counts) <= most


@pytest.mark.parametrize("law", LAWS)
def test_a_plate_is_pressed_on_a_plane_and_pushed_along_it(law):
    """Published with three digits, so to 0.3 %; the mesh adds 0.2 %."""
    u, counts = pushed_plate.Plate(32, law=law).push()
    assert u == pytest.approx(pushed_plate.PUBLISHED, rel=5e-3)
    assert counts[0] <= 15


def test_whole_steps_go_on_as_long_as_they_come_nearer():
    """The second of ten steps is within 1e-8 of its end after sixteen."""
    plate = pushed_plate.Plate(64)
    full, counts = plate.full, []
    for part in (0.1, 0.2):
        plate.full = part * full
        counts += plate.push()[1]
    assert max(counts) <= 24


def test_a_soft_plane_bears_as_a_hard_one_where_no_penetration_is_wanted():
    """k = E / 10 h: by the law alone u is a fifth too small."""
    soft = pushed_plate.Plate(16, factor=0.1, penetration=1e-8)
    u, counts = soft.push()
    assert u == pytest.approx(pushed_plate.PUBLISHED, rel=5e-3)
    assert max(counts) <= 20
    # It was made stiffer on the way.
    assert soft.plate.contact.contact.options["stiffness"] > 0.1 * pushed_plate.YOUNG * 16 / pushed_plate.SIDE


def test_cylinders_that_are_dragged_have_the_traction_of_cattaneo():
    """Facets a/12: one of them in 12 is cut by the rim, and one by the end of the stick on either side."""
    pair = cylinders.Cylinders(12)
    pair.press()
    for step in range(1, 7):
        assert pair.drag(0.1 * step) <= 7
        pair.bodies.commit()
    assert pair.profile_error(0.6) < 1 / 12
    assert pair.stick_width == pytest.approx(np.sqrt(0.4), abs=1 / 12)


def test_what_a_cycle_of_dragging_loses_is_the_area_of_mindlins_loop():
    pair = cylinders.Cylinders(12)
    pair.press()
    loads, places, lost, counts = pair.loop(quarter=4)
    area = abs(cylinders.trapezoid(loads[3:], places[3:])) * cylinders.MU * cylinders.PRESS
    # Of steps of a quarter of the load the trapezoids leave out a part: 1 / (6 * 4**2) of a parabola that steep.
    assert area == pytest.approx(cylinders.loop_area(0.8), rel=0.01)
    assert lost[4:].sum() == pytest.approx(cylinders.loop_area(0.8), rel=0.03)
    assert lost.min() >= 0
    assert abs(places[-1] - places[3]) < 1e-5 * np.ptp(places)
    assert max(counts) <= 8


def test_loads_that_grow_in_proportion_make_nothing_slide():
    """Nothing slides in truth, q = mu p / 2, and facets count their slip from their touch: what is left is the error of a
    mesh of a/12, one facet of which is cut by the rim on either side, whatever the number of steps."""
    for steps in (5, 10, 20):
        pair = cylinders.Cylinders(12)
        error, counts = pair.in_proportion(steps=steps)
        assert error < 0.04
        # As area joins, its facet's force is borne by more of it: what is lost so is told, though nothing slides.
        friction = pair.result.friction
        assert friction.slip_area == 0 and 0 <= friction.dissipation < 0.01 * friction.energy
        assert max(counts) <= 10


@pytest.mark.parametrize("law", LAWS)
def test_a_ring_on_a_disc_has_the_torque_of_even_pressure(law):
    """The load is even on the grid of the ring, not on the circle: some 1e-3."""
    torques, counts = ring_on_disc.RingOnDisc(16, 2, law).turn(2, 1e-3)
    assert torques[-1] == pytest.approx(1, abs=1e-3)
    assert max(counts) <= 7


def test_the_arms_of_a_fold_rub_as_two_bodies_do():
    (alone, counts), (apart, _) = (fold.Fold(16, is_apart).pull(4) for is_apart in (False, True))
    assert np.abs(alone[:, :2] / apart[:, :2] - 1).max() < 1e-7
    assert alone[-1, 2] == pytest.approx(apart[-1, 2], rel=1e-6) and alone[-1, 2] > 0
    assert max(counts) <= 20


def test_balls_that_are_dragged_stick_within_a_circle():
    """Of a cell a/4 four triangles: of the ring of 20 at the end of the stick each half is one or the other."""
    pair = balls.Balls(4)
    pair.press(2)
    count, sticks = pair.drag(0.3)
    assert count <= 7
    assert sticks == pytest.approx((1 - 0.3) ** (1 / 3), rel=0.03)


def test_what_a_cycle_of_dragging_balls_loses_is_the_area_of_their_loop():
    """Of second order in the cells: a fifth too much with a/3."""
    pair = balls.Balls(3)
    pair.press()
    loads, places, lost, counts = pair.loop(quarter=4)
    area = abs(trapezoid(loads[3:] * balls.LARGEST_PUSH, places[3:]))
    assert area == pytest.approx(balls.loop_area(0.6), rel=0.25)
    # The loop is one of straight lines, of four steps a quarter.
    assert lost[4:].sum() == pytest.approx(area, rel=0.03) and lost.min() >= 0
    assert abs(places[-1] - places[3]) < 1e-5 * np.ptp(places)
    assert max(counts) <= 8
