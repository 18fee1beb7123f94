"""Half-spaces in contact without friction: Hertz and the flat punch (K. L. Johnson, Contact mechanics, 1985, chapters 2 to 4)."""

from __future__ import annotations

from math import asin, pi, sqrt


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
