"""Every closed form is checked once by another way: integrals of influence functions, differences, or a balance of forces."""

import numpy as np
import pytest
from fmc_suite import figures
from fmc_suite.problem import Problem, names
from fmc_suite.references import columns, friction, indentation, rings
from skfem import Basis, ElementQuad2, ElementTriP2, ElementVector, FacetBasis, LinearForm, MeshQuad, MeshTri, condense, solve
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNG, POISSON = 1000.0, 0.3


def slopes(pressure, half_width, modulus):
    """Slopes of both surfaces together at points within a strip of pressure: -2 / (pi E*) PV integral p(s) / (x - s) ds. With
    s = a sin t the singular ends vanish; the principal value is symmetric about x on a grid shifted by half a cell."""
    count = 200_000
    angles = (np.arange(count) + 0.5) * np.pi / count - np.pi / 2
    loads = pressure(half_width * np.sin(angles)) * half_width * np.cos(angles) * np.pi / count
    at = np.arange(30_000, 170_001, 20_000)
    places = half_width * np.sin(at * np.pi / count - np.pi / 2)
    return places, np.array([-2 / (np.pi * modulus) * (loads / (x - half_width * np.sin(angles))).sum() for x in places])


def test_the_line_of_hertz_lies_flat():
    """The surfaces meet: their slopes are -x / R, and the pressure sums up to the force."""
    force, radius, modulus = 0.8, 500.0, indentation.pair_modulus(YOUNG, POISSON)
    peak = indentation.line_peak(force, radius, YOUNG, POISSON)
    half_width = 2 * force / (np.pi * peak)
    places, found = slopes(lambda s: peak * np.sqrt(1 - (s / half_width) ** 2), half_width, modulus)
    assert np.abs(found + places / radius).max() < 1e-4 * half_width / radius


def test_the_middle_of_cattaneo_and_mindlin_sticks():
    """Within c the shear tractions move the surface without strain, and they sum up to Q for c/a = sqrt(1 - Q / (μ P))."""
    coefficient, peak, a, c, modulus = 0.3, 0.5, 1.0, 0.6, indentation.pair_modulus(YOUNG, POISSON)
    shear = lambda s: coefficient * peak * (np.sqrt(1 - (s / a) ** 2) - c / a * np.sqrt(np.maximum(1 - (s / c) ** 2, 0)))
    places, found = slopes(shear, a, modulus)
    inside = np.abs(places) < 0.95 * c
    assert inside.sum() > 2 and np.abs(found[inside]).max() < 1e-3 * coefficient * peak / modulus
    assert np.abs(found[~inside]).max() > 1e-2 * coefficient * peak / modulus
    middles = np.linspace(-a, a, 200_001)
    normal = np.pi * peak * a / 2
    total = shear(middles).mean() * 2 * a
    assert np.sqrt(1 - total / (coefficient * normal)) == pytest.approx(c / a, rel=1e-4)


def test_the_surface_below_a_flat_punch_is_flat():
    """The slopes vanish against p / E*, and the mean over the whole width is the force by the width."""
    force, modulus = 0.2, indentation.pair_modulus(YOUNG, POISSON)
    _, found = slopes(lambda s: force / (np.pi * np.sqrt(1 - s**2)), 1.0, modulus)
    assert np.abs(found).max() < 1e-4 * force / modulus
    assert indentation.punch_mean(force, 1.0, 1.0) == pytest.approx(force / 2)
    places = np.linspace(-0.3, 0.3, 100_001)
    mean = np.mean(force / (np.pi * np.sqrt(1 - places**2)))
    assert indentation.punch_mean(force, 1.0, 0.3) == pytest.approx(mean, rel=1e-4)


def test_the_ball_of_hertz_fits():
    """By Boussinesq: at the centre the pressure moves the surfaces by pi p0 a / (2 E*), at the edge by half of that; the difference is
    a^2 / (2 R), and the pressure sums up to 2/3 p0 pi a^2. Both integrals are taken by rings here."""
    force, radius, modulus = 1.44, 500.0, indentation.pair_modulus(YOUNG, POISSON)
    peak = indentation.ball_peak(force, radius, YOUNG, POISSON)
    a = np.sqrt(3 * force / (2 * np.pi * peak))
    # About a point at the rim: the chord at an angle has the length 2 a cos(angle); p along it is peak sqrt(r (2 a cos - r)) / a.
    angles = (np.arange(4000) + 0.5) * np.pi / 4000 - np.pi / 2
    lengths, parts = 2 * a * np.cos(angles), (np.arange(4000) + 0.5) / 4000
    along = np.sqrt(np.maximum(parts * (1 - parts), 0)).mean()
    rim = (peak * lengths**2 / a * along).sum() * np.pi / 4000 / (np.pi * modulus)
    centre = 2 * np.pi * peak * a * np.sqrt(1 - parts**2).mean() / (np.pi * modulus)
    assert centre - rim == pytest.approx(a**2 / (2 * radius), rel=1e-4)


@pytest.mark.parametrize("radii", [(600.0, 300.0), (200.0, 900.0), (500.0, 500.0)])
def test_crossed_cylinders_fit(radii):
    """By Boussinesq, in polar coordinates about the centre and about the ends of both axes: the differences are a²/(2 R). No elliptic integral
    is used: along a chord of length l through the pressure of an ellipse the integral is sqrt(q) π l²/8."""
    force, modulus = 1.44, indentation.pair_modulus(YOUNG, POISSON)
    axes, peak = indentation.ellipse(force, radii, YOUNG, POISSON), indentation.ellipse_peak(force, radii, YOUNG, POISSON)
    angles = (np.arange(200_000) + 0.5) * np.pi / 200_000 - np.pi / 2
    across = lambda a, b: np.cos(angles) ** 2 / a**2 + np.sin(angles) ** 2 / b**2
    centre = peak * np.pi / 2 * (1 / np.sqrt(across(*axes))).mean() * np.pi / (np.pi * modulus)
    for (a, b), radius in zip((axes, axes[::-1]), radii):
        lengths = 2 * np.cos(angles) / (a * across(a, b))
        end = peak * (np.sqrt(across(a, b)) * np.pi * lengths**2 / 8).mean() * np.pi / (np.pi * modulus)
        assert centre - end == pytest.approx(a**2 / (2 * radius), rel=1e-8)
    if radii[0] == radii[1]:
        assert peak == pytest.approx(indentation.ball_peak(force, radii[0], YOUNG, POISSON), rel=1e-8)


def test_a_wedge_and_a_rounded_punch_lie_flat():
    """The slopes of the surfaces are those of the wedge, and those of the rounded punch; the pressures sum up to the forces."""
    modulus, middles = indentation.pair_modulus(YOUNG, POISSON), (np.arange(1_000_000) + 0.5) / 1_000_000
    a, slope = 1.0192, 2.5e-3
    places, found = slopes(lambda s: modulus * slope / np.pi * np.arccosh(a / np.abs(s)), a, modulus)
    # The sums cross a logarithm or a root of infinite slope, so that they are right to 1e-4 of the largest slope only.
    assert np.abs(found + slope * np.sign(places)).max() < 1e-3 * slope
    total = modulus * slope * a
    pressure = modulus * slope / np.pi * np.arccosh(1 / (0.5 * middles))
    assert indentation.wedge_mean(total, slope, 0.5 * a, YOUNG, POISSON) == pytest.approx(pressure.mean(), rel=1e-5)
    assert indentation.wedge_mean(total, slope, a, YOUNG, POISSON) == pytest.approx(total / (2 * a), rel=1e-9)

    a, flat, radius = 0.98, 0.8, 100.0
    pressure = lambda s: indentation.rounded_punch_pressure(s, a, flat, radius, modulus)
    places, found = slopes(pressure, a, modulus)
    expected = -np.sign(places) * np.maximum(np.abs(places) - flat, 0) / radius
    assert (expected != 0).sum() > 1 and np.abs(found - expected).max() < 1e-3 * (a - flat) / radius
    total = indentation.rounded_punch_force(a, flat, radius, modulus)
    assert pressure(middles * a).mean() * 2 * a == pytest.approx(total, rel=1e-5)
    found = indentation.rounded_punch_mean(total, flat, radius, 0.999999 * a, YOUNG, POISSON)
    assert found == pytest.approx(total / (2 * a), rel=1e-4)


def test_a_belt_of_many_links():
    """Rigid links in balance, each pressed on the drum in its middle, without and with the lever of half the thickness."""
    friction_coefficient, links = 0.3, 20_000
    turn, pull = np.pi / 2 / links, 1.0
    for _ in range(links):
        c, s = np.cos(turn / 2), friction_coefficient * np.sin(turn / 2)
        pull *= (c + s) / (c - s)
    assert friction.belt(1.0, friction_coefficient, 90.0, 1.0, 0.0) == pytest.approx(pull, rel=1e-8)
    # The moment about the axis of the drum: the rise of the pull, at its lever, is the moment of the friction, with N = pull / R.
    small, lever = 1e-4, 1.0 + 0.02 / 2
    rise = friction.belt(1.0, friction_coefficient, small, 1.0, 0.02) - 1
    assert rise * lever == pytest.approx(friction_coefficient * np.radians(small) * 1.0, rel=1e-4)


@pytest.mark.parametrize("name", ["patch-2d-oblique", "patch-3d-oblique"])
def test_equal_pressure_makes_bodies_smaller_alike(name):
    """The displacement -e x has the stress of the figure, and leaves forces on the oblique plane only, along its normal."""
    problem = Problem.load(name)
    strain = 1e-3 if problem.dim == 3 else (1 + POISSON) * (1 - 2 * POISSON) / YOUNG
    u = -strain * (problem.points - problem.points.min(axis=0))
    assert figures.figure(problem, u[None]) < 1e-10
    (lower, upper), slope = problem.pairs[0], problem.raw["bodies"][1]["maps"][-1]["by"]
    for number, facets in enumerate((lower, upper)):
        forces, nodes = figures.contact_forces(problem, u, 0, number), np.unique(facets) - problem.firsts[number]
        assert np.abs(np.delete(forces, nodes, axis=0)).max() < 1e-10
        free = nodes[~problem.fixed[problem.firsts[number] + nodes].any(axis=1)]
        assert np.abs(forces[free, :-1] + forces[free, -1:] * np.array(slope)).max() < 1e-10
        total = 2.5 if problem.dim == 3 else 1.0
        assert forces[:, -1].sum() == pytest.approx(total if number else -total)


def test_a_press_fit_by_differences():
    """u'' + u'/r - u/r^2 = 0 in both rings by finite differences, a jump of u at the fit and one pressure there."""
    inner, middle, outer, interference, cells = 1.0, 1.5, 2.5, 1.5e-3, 2000
    lame, shear = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))

    def give(low, high, pressed):
        """Displacement of the pressed side by a pressure of 1."""
        r, h = np.linspace(low, high, cells + 1), (high - low) / cells
        matrix, right = np.zeros((cells + 1, 3)), np.zeros(cells + 1)
        matrix[1:-1] = np.stack([1 / h**2 - 1 / (2 * h * r[1:-1]), -2 / h**2 - 1 / r[1:-1] ** 2, 1 / h**2 + 1 / (2 * h * r[1:-1])], 1)
        dense = np.zeros((cells + 1, cells + 1))
        for row in range(1, cells):
            dense[row, row - 1 : row + 2] = matrix[row]
        for row, sign in ((0, 1), (cells, -1)):
            for place, weight in enumerate((-1.5, 2.0, -0.5)):
                dense[row, row + sign * place] += sign * (lame + 2 * shear) * weight / h
            dense[row, row] += lame / r[row]
        right[0 if pressed == "inner" else cells] = -1.0
        u = np.linalg.solve(dense, right)
        return u[0] if pressed == "inner" else u[-1]

    found = interference / (give(middle, outer, "inner") - give(inner, middle, "outer"))
    assert rings.press_fit(inner, middle, outer, interference, YOUNG, POISSON) == pytest.approx(found, rel=1e-4)


def test_a_ring_pressed_from_outside_by_differences():
    """The stress of the displacement is the pressure at every radius, none at the inner side; and it is in balance."""
    pressure, inner, outer, step = 10.0, 1.0, 2.5, 1e-4
    lame, shear = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))
    u = lambda r: rings.outside_displacement(pressure, inner, outer, r, YOUNG, POISSON)
    stretch = lambda r: (u(r + step) - u(r - step)) / (2 * step)
    along = lambda r: (lame + 2 * shear) * stretch(r) + lame * u(r) / r
    around = lambda r: (lame + 2 * shear) * u(r) / r + lame * stretch(r)
    for radius in (inner, 1.5, 2.0, outer):
        assert along(radius) == pytest.approx(-rings.outside(pressure, inner, outer, radius), abs=1e-5)
        slope = (along(radius + 1e-2) - along(radius - 1e-2)) / 2e-2
        assert slope + (along(radius) - around(radius)) / radius == pytest.approx(0, abs=2e-2)
    assert rings.outside(pressure, inner, outer, outer) == pytest.approx(pressure) and rings.outside(pressure, inner, outer, inner) == 0


@pytest.mark.parametrize(("kind", "element", "across"), [(MeshQuad, ElementQuad2, 4), (MeshTri, ElementTriP2, 8)])
def test_the_beam_converges_with_two_kinds_of_elements(kind, element, across):
    """The deflection on two meshes, the second twice as fine. Of a corner with a fixed side the error falls about threefold, so half of the
    change is left to come."""
    found = [deflection(kind, element(), across * times) for times in (1, 2)]
    assert found[1] + (found[1] - found[0]) / 2 == pytest.approx(Problem.load("tied-beam").reference, rel=1e-4)


def deflection(kind, element, across):
    """Mean over the end of a beam of length 10 and height 1 in plane strain, one body, under a traction of 1e-3."""
    mesh = kind.init_tensor(np.linspace(0, 10, 10 * across + 1), np.linspace(0, 1, across + 1))
    basis = Basis(mesh, ElementVector(element), intorder=4)
    end = FacetBasis(mesh, ElementVector(element), facets=mesh.facets_satisfying(lambda x: x[0] > 10 - 1e-9), intorder=4)
    mean = LinearForm(lambda v, w: v[1]).assemble(end)
    matrix = linear_elasticity(*lame_parameters(YOUNG, POISSON)).assemble(basis)
    held = basis.get_dofs(lambda x: x[0] < 1e-9).all()
    return mean @ solve(*condense(matrix, -1e-3 * mean, D=held))


@pytest.mark.parametrize("coefficient", [0.0, 0.1, 0.2, 0.3])
def test_the_push_up_a_slope_balances(coefficient):
    """Forces along the slope and across it: the friction is μ times the normal force."""
    tangent = 0.1
    push, angle = friction.slope(coefficient, tangent), np.arctan(tangent)
    normal = np.cos(angle) + push * np.sin(angle)
    assert push * np.cos(angle) - np.sin(angle) == pytest.approx(coefficient * normal)


def test_columns_in_plane_strain():
    """Hooke's law with no strain across and no stress at the sides: the strain along the column is s (1 - ν²) / E."""
    stress = -1.0
    across = POISSON * stress
    strain = (stress - POISSON * across) / YOUNG
    assert columns.displacement(1.0, [1.0, 1.0], [YOUNG, YOUNG], POISSON) == pytest.approx(2 * strain)
    # Confined, the stress across is s ν / (1 - ν), in the plane and out of it.
    across = POISSON / (1 - POISSON) * stress
    assert columns.confined_force(1.0, 1.0, 1.0, YOUNG, POISSON) == pytest.approx(YOUNG * stress / (stress - 2 * POISSON * across))
    assert columns.force(-2 * strain, 1.0, [1.0, 1.0], [YOUNG, YOUNG], POISSON) == pytest.approx(1.0)


@pytest.mark.parametrize("name", names())
def test_every_problem_says_what_it_compares(name):
    problem = Problem.load(name)
    raw = problem.raw
    assert raw["title"] and raw["figure"]["name"] and raw["reference"]["source"] and raw["reference"]["bound"] >= 0
    assert np.isfinite(problem.reference)
    arrays = problem.arrays()
    assert arrays["fixed"].any() and (problem.loads.any() or problem.prescribed.any() or raw["contact"].get("overlaps"))
    # No load acts where a displacement is prescribed, so that figures need no reactions.
    assert not (problem.loads[:, problem.fixed]).any()
