"""Figures of bodies pressed into one another, and of one that slides; the reference host takes its own."""

from __future__ import annotations

from typing import Callable

import numpy as np

from .faces import boundary_faces, face_normals
from .problem import Problem
from .solved import Solved

TOUCHING = 1e-6
"""Part of the largest pressure below which a node is not in contact: rounding."""

SLIDE = (2.0 / 7.5, 5.5 / 7.5)
"""Part of the last stage over which forces are compared."""

Found = "tuple[dict[str, float], np.ndarray]"


def is_compared(load: np.ndarray) -> np.ndarray:
    """Which parts of the last stage's load are within ``SLIDE``, up to rounding."""
    return (load >= SLIDE[0] - 1e-9) & (load <= SLIDE[1] + 1e-9)


class Surface:
    """Nodes on the side of a body that contact pushes against, sorted by their place: x in 2D, the distance from the last
    axis in 3D, undeformed. The pressure is the force along the last axis by the node's part of the area that looks that
    way rather than another."""

    def __init__(self, problem: Problem, body: int, forces: np.ndarray) -> None:
        x, faces = problem.coords, boundary_faces(problem.bodies[body])
        along = forces[:, -1]
        sense = np.sign(along[problem.bodies[body].nodes].sum())
        normal = face_normals(x, faces)
        size = np.linalg.norm(normal, axis=1)
        # Within 60° of the axis.
        up = np.where(-normal[:, -1] * sense > 0.5 * size, -normal[:, -1] * sense, 0.0)
        area = np.zeros(len(x))
        np.add.at(area, faces, up[:, None] / faces.shape[1])
        place = x[:, 0] if problem.dim == 2 else np.hypot(x[:, 0], x[:, 1])
        nodes = np.flatnonzero(area)
        self.nodes = nodes[np.argsort(place[nodes], kind="stable")]
        self.place, self.area = place[self.nodes], area[self.nodes]
        self.pressure = np.maximum(along[self.nodes] * sense / self.area, 0.0)
        self.touching = self.pressure > TOUCHING * self.pressure.max()

    def reach(self) -> float:
        """Place of the outermost node in contact."""
        return float(self.place[self.touching].max())

    def distance(self, low: float, high: float, by_area: bool, curve: Callable) -> float:
        """Root mean square of the distance from a curve between two places, by the curve's."""
        inside = (self.place >= low) & (self.place <= high)
        weight = self.area[inside] if by_area else 1.0
        wanted = curve(self.place[inside])
        off = (weight * (self.pressure[inside] - wanted) ** 2).sum()
        return float(np.sqrt(off / (weight * wanted**2).sum()))

    def profile(self, to: float) -> np.ndarray:
        """Place and pressure as far as a place, (places, 2)."""
        near = self.place <= to
        return np.column_stack([self.place[near], self.pressure[near]])


def figures(problem: Problem, solved: Solved) -> Found:
    """Figures of an equilibrium and its profile, or for the die its force over the slide; by the kind of the case."""
    last, kind = solved.steps[-1], problem.raw["figures"]["kind"]
    body = problem.about
    if kind == "ironing":
        return _ironing(problem, body, solved)
    forces, material = last.force, problem.bodies[body].material
    surface = Surface(problem, body, forces)
    force = problem.force_along_last_axis(forces, body)
    modulus = material.young / (1.0 - material.poisson**2)
    given = np.array(problem.raw["figures"].get("profile", [])).reshape(-1, 2)

    def true(x: np.ndarray) -> np.ndarray:
        return np.interp(x, given[:, 0], given[:, 1])

    if kind == "wedge":
        return _wedge(problem, surface, force, modulus, true if len(given) else None, last.displacement)
    if kind == "cone":
        return _cone(surface, force, modulus)
    return _punch(surface, force, true if len(given) else None)


def _wedge(problem: Problem, surface: Surface, force: float, modulus: float, true: Callable | None, u: np.ndarray) -> Found:
    """Slope 45°. The closed form has a = P/E*, p = E*/π artanh √(1 − x²/a²)."""
    a = force / modulus

    def closed(x: np.ndarray) -> np.ndarray:
        return modulus / np.pi * np.arctanh(np.sqrt(np.maximum(1.0 - (x / a) ** 2, 0.0)))

    touched = surface.nodes[surface.touching]
    found = {
        "force": force,
        "half_width": surface.reach(),
        "half_width_current": float((problem.coords + u)[touched, 0].max()),
        "profile_error_closed_form": surface.distance(0.08 * a, 1.3 * a, False, closed),
    }
    if true is not None:
        found["profile_error_true"] = surface.distance(0.003, 1.3 * a, False, true)
    return found, surface.profile(1.6 * a)


def _cone(surface: Surface, force: float, modulus: float) -> Found:
    """Slope 45°. A half-space has a = 2d/π, p = E* d/(π a) arcosh(a/r); here d is that of the force."""
    depth = np.sqrt(np.pi * force / (2.0 * modulus))
    a = 2.0 * depth / np.pi

    def closed(r: np.ndarray) -> np.ndarray:
        return modulus * depth / (np.pi * a) * np.arccosh(np.maximum(a / r, 1.0))

    found = {
        "force": force,
        "contact_radius": surface.reach(),
        "profile_error": surface.distance(0.1 * a, 1.3 * a, True, closed),
        "radial_spread": _spread(surface),
    }
    return found, surface.profile(1.6 * a)


def _spread(surface: Surface) -> float:
    """Root mean square of what a line over every eight neighbours in r leaves of the pressure, by that of the pressure;
    between 0.2 and 0.9 of the contact's radius."""
    reach = surface.reach()
    inside = (surface.place >= 0.2 * reach) & (surface.place <= 0.9 * reach)
    r, p = surface.place[inside], surface.pressure[inside]
    off = size = 0.0
    for first in range(0, len(r), 8):
        group = slice(first, first + 8)
        if len(r[group]) > 3:
            off += float(((p[group] - np.polyval(np.polyfit(r[group], p[group], 1), r[group])) ** 2).sum())
            size += float((p[group] ** 2).sum())
    return float(np.sqrt(off / size))


def _punch(surface: Surface, force: float, true: Callable | None) -> Found:
    """A half of it: the middle is at x = 0, the edge at the largest x."""
    edge = float(surface.place.max())
    middle = surface.place <= 0.1 * edge
    area, pressure = surface.area[middle], surface.pressure[middle]
    found = {
        "force": force,
        "pressure_center": float((area * pressure).sum() / area.sum()),
        "pressure_edge": float(surface.pressure.max()),
    }
    if true is not None:
        found["profile_error"] = surface.distance(0.0, 0.95 * edge, True, true)
    return found, surface.profile(edge)


def _ironing(problem: Problem, body: int, solved: Solved) -> Found:
    """Forces of the last stage. The ripple is what a cubic in the slide leaves of F_y, by its mean."""
    last = solved.steps[-1].stage
    sliding = [step for step in solved.steps if step.stage == last]
    load = np.array([step.load for step in sliding])
    force = np.array([step.force[problem.bodies[body].nodes].sum(axis=0) for step in sliding])
    inside = is_compared(load)
    at, up = 2.0 * load[inside] - 1.0, np.abs(force[inside, -1])
    mean = float(up.mean())
    found = {
        "force_y_mean": mean,
        "force_x_mid": float(force[np.argmin(np.abs(load - 0.5)), 0]),
        "steps_failed": float(solved.halvings),
    }
    if len(up) >= 5:
        rest = up - np.polyval(np.polyfit(at, up, 3), at)
        found["ripple_rms"] = float(np.sqrt((rest**2).mean()) / mean)
        found["ripple_peak_to_peak"] = float(np.ptp(rest) / mean)
    return found, np.column_stack([load, np.abs(force[:, -1])])
