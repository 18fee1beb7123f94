"""Rigid bodies that slide by Coulomb's law."""

from __future__ import annotations


def coulomb(friction: float, force: float) -> float:
    """What pulls a body that slides: μ N."""
    return friction * force


def slope(friction: float, slope: float) -> float:
    """Horizontal force by weight that pushes a body up a slope: (tan α + μ) / (1 − μ tan α)."""
    return (slope + friction) / (1 - friction * slope)
