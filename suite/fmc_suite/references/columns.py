"""Columns in uniform stress: bodies one on another, free at the sides, in plane strain."""

from __future__ import annotations

from collections.abc import Sequence


def plane(young: float, poisson: float) -> float:
    """E / (1 − ν²): stress by strain along a free column in plane strain."""
    return young / (1 - poisson**2)


def confined_force(approach: float, width: float, height: float, young: float, poisson: float) -> float:
    """That presses a block which can widen nowhere: uniaxial strain."""
    return width * approach / height * young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))


def displacement(pressure: float, heights: Sequence[float], youngs: Sequence[float], poisson: float, gaps: float = 0.0) -> float:
    """Of the top of a column along its axis: −p Σ h / E' and the gaps that have closed."""
    return -gaps - pressure * sum(height / plane(young, poisson) for height, young in zip(heights, youngs))


def force(approach: float, width: float, heights: Sequence[float], youngs: Sequence[float], poisson: float) -> float:
    """That presses a column whose ends approach each other beyond first touch, on the upper body."""
    return width * approach / sum(height / plane(young, poisson) for height, young in zip(heights, youngs))
