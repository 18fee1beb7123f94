"""Thick-walled rings by Lamé, in plane strain."""

from __future__ import annotations


def outside(pressure: float, inner: float, outer: float, radius: float) -> float:
    """Radial pressure at a radius of a ring that is pressed from outside."""
    return pressure * outer**2 / (outer**2 - inner**2) * (1 - inner**2 / radius**2)


def outside_displacement(pressure: float, inner: float, outer: float, radius: float, young: float, poisson: float) -> float:
    """Radial displacement at a radius of a ring that is pressed from outside."""
    part = pressure * outer**2 / (outer**2 - inner**2) * (1 + poisson) / young
    return -part * ((1 - 2 * poisson) * radius + inner**2 / radius)


def press_fit(inner: float, middle: float, outer: float, interference: float, young: float, poisson: float) -> float:
    """Pressure between two rings of one material. ``interference`` is the difference of their radii."""
    plane_young, plane_poisson = young / (1 - poisson**2), poisson / (1 - poisson)
    squares = inner**2, middle**2, outer**2
    shrinks = (squares[1] + squares[0]) / (squares[1] - squares[0]) - plane_poisson
    grows = (squares[2] + squares[1]) / (squares[2] - squares[1]) + plane_poisson
    return interference * plane_young / (middle * (shrinks + grows))
