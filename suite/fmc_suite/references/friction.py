"""Rigid bodies and belts that slide by Coulomb's law."""

from __future__ import annotations

from math import exp, radians


def coulomb(friction: float, force: float) -> float:
    """What pulls a body that slides: μ N."""
    return friction * force


def slope(friction: float, slope: float) -> float:
    """Horizontal force by weight that pushes a body up a slope: (tan α + μ) / (1 − μ tan α)."""
    return (slope + friction) / (1 - friction * slope)


def belt(force: float, friction: float, degrees: float, radius: float, thickness: float) -> float:
    """Force at the end of a belt around a drum, by the ``force`` at its other end: factor exp(μ β R / (R + t/2)). The friction acts at R, the tension
    in the middle of the belt."""
    return force * exp(friction * radians(degrees) * radius / (radius + thickness / 2))
