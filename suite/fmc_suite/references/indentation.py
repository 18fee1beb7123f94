"""Half-spaces in contact without friction: Hertz, punches and wedges (K. L. Johnson, Contact mechanics, 1985, chapters 2 to 5)."""

from __future__ import annotations

from math import acosh, asin, pi, sin, sqrt

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk


def pair_modulus(young: float, poisson: float) -> float:
    """E* of two bodies of one material."""
    return young / (1 - poisson**2) / 2


def line_peak(force: float, radius: float, young: float, poisson: float) -> float:
    """Peak pressure of a line contact: sqrt(P E* / (π R)), P by length."""
    return sqrt(force * pair_modulus(young, poisson) / (pi * radius))


def ball_peak(force: float, radius: float, young: float, poisson: float) -> float:
    """Peak pressure of a point contact: (6 P E*² / (π³ R²))^(1/3)."""
    return float((6 * force * pair_modulus(young, poisson) ** 2 / (pi**3 * radius**2)) ** (1 / 3))


def punch_mean(force: float, half_width: float, within: float) -> float:
    """Mean pressure over |x| < ``within`` under a rigid flat punch: of P / (π sqrt(a² − x²))."""
    return force / (pi * within) * asin(within / half_width)


def ellipse(force: float, radii: tuple[float, float], young: float, poisson: float) -> tuple[float, float]:
    """Semi-axes of the contact of two cylinders that cross at right angles: first along the axis in which the first radius bends. The relative
    curvatures are 1 / radii; with the pressure p0 sqrt(1 - x²/a² - y²/b²) of an ellipse, m = 1 - b²/a², their ratio is
    ((a/b)² E(m) - K(m)) / (K(m) - E(m)) (section 4.1)."""
    large, small = max(radii), min(radii)

    def excess(m: float) -> float:
        return float((ellipe(m) / (1 - m) - ellipk(m)) / (ellipk(m) - ellipe(m)) - large / small)

    m = brentq(excess, 1e-6, 1 - 1e-9, xtol=1e-14) if large > small * (1 + 1e-5) else 0.0
    # 1 / (2 R) = p0 b / (E* a²) (K - E) / m along the long axis, and P = 2/3 p0 pi a b.
    part = float((ellipk(m) - ellipe(m)) / m) if m else pi / 4
    a = (3 * force * large * part / (pi * pair_modulus(young, poisson))) ** (1 / 3)
    b = a * sqrt(1 - m)
    return (a, b) if radii[0] >= radii[1] else (b, a)


def ellipse_peak(force: float, radii: tuple[float, float], young: float, poisson: float) -> float:
    """Peak pressure of two crossed cylinders: 3 P / (2 π a b)."""
    a, b = ellipse(force, radii, young, poisson)
    return 3 * force / (2 * pi * a * b)


def wedge_mean(force: float, slope: float, within: float, young: float, poisson: float) -> float:
    """Mean pressure over |x| < ``within`` below a blunt wedge: of E* slope / π arcosh(a / x), with P = E* a slope (section 5.2)."""
    strength = pair_modulus(young, poisson) * slope
    a = force / strength
    return strength / pi * (acosh(a / within) + a / within * asin(within / a))


def rounded_punch_force(half_width: float, flat: float, radius: float, modulus: float) -> float:
    """That presses a punch, flat over |x| < ``flat`` and then of the curvature 1 / ``radius``, to a contact of this half-width."""
    edge = asin(flat / half_width)
    return modulus * half_width**2 / (4 * radius) * (pi - 2 * edge - sin(2 * edge))


def rounded_punch_pressure(x: np.ndarray, half_width: float, flat: float, radius: float, modulus: float) -> np.ndarray:
    """Below it (M. Ciavarella, D. A. Hills, G. Monno, Proc. Inst. Mech. Eng. C 212, 1998, 319–327)."""
    at, edge = np.arcsin(x / half_width), asin(flat / half_width)
    ends = np.log(np.abs(np.sin(at + edge) / np.sin(at - edge))) * np.sin(at)
    ends += np.log(np.abs(np.tan((at + edge) / 2) * np.tan((at - edge) / 2))) * sin(edge)
    return np.asarray(modulus * half_width / (2 * pi * radius) * ((pi - 2 * edge) * np.cos(at) + ends))


def rounded_punch_mean(force: float, flat: float, radius: float, within: float, young: float, poisson: float) -> float:
    """Mean of that pressure over |x| < ``within``."""
    modulus = pair_modulus(young, poisson)
    a = brentq(lambda one: rounded_punch_force(one, flat, radius, modulus) - force, flat * (1 + 1e-12), 10 * (flat + radius))
    # Middles of intervals: at |x| = flat a logarithm is infinite, and its integral is not.
    middles = (np.arange(200_000) + 0.5) / 200_000 * within
    return float(rounded_punch_pressure(middles, a, flat, radius, modulus).mean())
