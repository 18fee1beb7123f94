"""The figures of the cases, taken from what a host found; the reference host takes its own."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.linalg import norm

from . import indentation
from .faces import boundary_faces, face_normals
from .leapfrog import History
from .problem import Problem
from .solved import Solved

INNER = 0.9
"""Within this many half widths of a line contact the rim, where facets are partly in contact, is left out."""

CUT = 0.03
"""Time cut off at both ends of a contact before its pressure is taken, s: the front is spread over some cells."""


def _integral(y: np.ndarray, x: np.ndarray) -> float:
    """Trapezoidal rule."""
    return float(0.5 * ((y[1:] + y[:-1]) * np.diff(x)).sum())


def nodal_pressures(problem: Problem, body: int, forces: np.ndarray) -> np.ndarray:
    """Pressure at every node, (nodes,): its force by its part of the undeformed surface, seen along the force."""
    size = norm(forces, axis=1)
    area = np.zeros(len(forces))
    faces = boundary_faces(problem.bodies[body])
    for nodes, normal in zip(faces, face_normals(problem.coords, faces)):
        against = -(forces[nodes] @ normal) / len(nodes) / np.maximum(size[nodes], 1e-300)
        area[nodes] += np.maximum(against, 0.0)
    touched = (size > 0.0) & (area > 0.0)
    return np.where(touched, size / np.where(touched, area, 1.0), 0.0)


def hertz(problem: Problem, forces: np.ndarray) -> tuple[dict[str, float], np.ndarray]:
    """Figures of a line contact, and its profile: place and pressure, (places, 2)."""
    body = problem.bodies[0]
    radius = problem.raw["radius"] if "radius" in problem.raw else np.ptp(problem.coords[:, 0]) / 2.0
    modulus = body.material.young / (1.0 - body.material.poisson**2)
    force = float(norm(forces[body.nodes].sum(axis=0)))
    half_width = np.sqrt(4.0 * force * radius / (np.pi * modulus))
    peak = 2.0 * force / (np.pi * half_width)
    tip = np.array([0.0, problem.coords[:, 1].min()])
    near = (np.abs(problem.coords[:, 0] - tip[0]) <= 1.3 * half_width) & (problem.coords[:, 1] - tip[1] < 0.5 * radius)
    faces = [face for face in boundary_faces(body) if near[face].all()]
    nodes = np.unique(np.concatenate(faces))
    x, p = problem.coords[nodes, 0] - tip[0], nodal_pressures(problem, 0, forces)[nodes]
    order = np.argsort(x)
    x, p = x[order], p[order]
    fitted = p > 0.3 * peak
    slope, square = np.polyfit(x[fitted] ** 2, p[fitted] ** 2, 1)
    exact = peak * np.sqrt(np.maximum(1.0 - (x / half_width) ** 2, 0.0))

    def profile_error(inside: np.ndarray) -> float:
        squares = _integral((p - exact)[inside] ** 2, x[inside]), _integral(exact[inside] ** 2, x[inside])
        return float(np.sqrt(squares[0] / squares[1]))

    found = {
        "force": force,
        "half_width": float(np.sqrt(-square / slope)),
        "peak_pressure": float(np.sqrt(square)),
        "profile_error": profile_error(np.full(len(x), True)),
        "profile_error_inner": profile_error(np.abs(x) <= INNER * half_width),
        "nodes": len(problem.coords),
    }
    return found, np.column_stack([x, p])


def balls(problem: Problem, forces: np.ndarray) -> tuple[dict[str, float], np.ndarray]:
    """Figures of a ball on its mirror image, of which the case has a part: p^2 over r^2 fitted where p is more than 0.3
    of the largest; and the profile, distance from the axis and pressure, (places, 2)."""
    pressure = nodal_pressures(problem, 0, forces)
    r = norm(problem.coords[:, :-1], axis=1)
    fitted = pressure > 0.3 * pressure.max()
    slope, square = np.polyfit(r[fitted] ** 2, pressure[fitted] ** 2, 1)
    found = {
        "force": problem.force_along_last_axis(forces, 0),
        "peak_pressure": float(np.sqrt(square)),
        "contact_radius": float(np.sqrt(-square / slope)),
    }
    touched = np.flatnonzero(pressure)
    order = touched[np.lexsort((pressure[touched], r[touched]))]
    return found, np.column_stack([r[order], pressure[order]])


def at_rest(problem: Problem, solved: Solved) -> tuple[dict[str, float], np.ndarray]:
    """Figures of an equilibrium that follow from displacements and contact forces, and what a picture shows: as a rule
    place and pressure, (places, 2), of a patch test the residual over the iterations."""
    kind, last = problem.raw["figures"]["kind"], solved.steps[-1]
    if problem.order == 2 and kind != "patch":
        # No mean pressure belongs to a node of second order, whose shape function may have no integral.
        touched = problem.bodies[problem.about].nodes
        touched = touched[norm(last.force[touched], axis=1) > 0.0]
        found = {"force": problem.force_along_last_axis(last.force, problem.about), "nodes": len(problem.coords)}
        curve = np.column_stack([problem.coords[touched, 0], np.abs(last.force[touched, -1])])
    elif kind == "patch":
        found, curve = {"nodes": len(problem.coords)}, np.column_stack([np.arange(len(solved.residuals)), solved.residuals])
    elif kind == "sliding":
        return sliding(problem, solved)
    elif kind in ("hertz", "balls"):
        found, curve = (hertz if kind == "hertz" else balls)(problem, last.force)
    else:
        found, curve = indentation.figures(problem, solved)
    return {**found, "penetration_max": last.penetration}, curve


def sliding(problem: Problem, solved: Solved) -> tuple[dict[str, float], np.ndarray]:
    """Figures of a body that is pushed along another, and its push in the last stage: part of the load and force,
    (steps, 2)."""
    nodes = problem.bodies[problem.about].nodes
    forces = np.array([step.force[nodes].sum(axis=0) for step in solved.steps])
    ratio, across = -forces[-1, 0] / abs(forces[-1, -1]), abs(forces[-1, -1])
    dissipated, stick, slip = np.array([step.sliding for step in solved.steps]).T
    found = {
        "force_ratio": float(ratio),
        "force_across": float(across),
        "dissipated": float(dissipated.sum()),
        "dissipated_least": float(dissipated.min()),
        "steps_failed": float(solved.halvings),
        "penetration_max": max(step.penetration for step in solved.steps),
    }
    if stick[-1] + slip[-1] > 0.0:
        found["stick_ratio"] = float(stick[-1] / (stick[-1] + slip[-1]))
        left = 1.0 - abs(ratio) / problem.raw["contact"]["friction_coefficient"]
        if left > 0.0:
            found["stick_error"] = float(found["stick_ratio"] / np.sqrt(left) - 1.0)
    last = [k for k, step in enumerate(solved.steps) if step.stage == solved.steps[-1].stage]
    return found, np.array([[solved.steps[k].load, abs(forces[k, 0])] for k in last])


def motion(problem: Problem, history: History, mass: np.ndarray) -> dict[str, float]:
    """Figures of a bar on a wall or of an impact; ``mass`` of every body."""
    about = problem.about
    body = problem.bodies[about]
    v0 = body.velocity
    along = -v0 / norm(v0)
    t = np.array(history.time)
    forces = np.array(history.bodies)[:, about]
    size, force = norm(forces, axis=1), forces @ along
    x = problem.coords[body.nodes]
    across = [axis for axis in range(problem.dim) if axis != np.argmax(np.abs(v0))]
    section = np.prod([np.ptp(x[:, axis]) for axis in across])
    stopping = np.sqrt(body.material.young * body.material.density) * norm(v0)
    is_wall = problem.raw["figures"]["kind"] == "wall"
    least = 0.5 * stopping * section if is_wall else 0.0
    touching = np.flatnonzero(size > least)
    lasting = np.flatnonzero(size > max(least, 0.01 * size.max()))
    start, stop = t[touching[0]], t[lasting[-1]]
    energy = np.array(history.kinetic) + np.array(history.strain) + np.array(history.contact)
    velocity = np.array(history.momentum)[-1, about] / mass[about]
    drift = float(np.abs(energy / energy[0] - 1.0).max())
    leaving = float(velocity @ along)
    if is_wall:
        inside = (t >= start + CUT) & (t <= stop - CUT)
        pressure = force[inside] / section
        return {
            "pressure_mean": float(pressure.mean()),
            "pressure_rms": float(np.sqrt(((pressure / stopping - 1.0) ** 2).mean())),
            "contact_start": float(start),
            "contact_end": float(stop),
            "exit_velocity": leaving,
            "energy_error_max": drift,
        }
    sums = norm(np.array(history.bodies).sum(axis=1), axis=1)
    return {
        "impulse": _integral(force, t),
        "contact_start": float(start),
        "contact_end": float(stop),
        "rebound": leaving,
        "sideways": float(norm(velocity - leaving * along)),
        "energy_drift": drift,
        "force_peak": float(force.max()),
        "balance_max": float(sums.max() / size.max()),
    }


def judged(problem: Problem, figures: dict[str, float]) -> list[dict[str, Any]]:
    """What the case expects, with what came out."""
    rows = []
    for expected in problem.raw["expected"]:
        value = figures.get(expected["figure"])
        tolerance = expected["tolerance"]
        is_ok = None if tolerance is None or value is None else bool(abs(value - expected["value"]) <= tolerance)
        rows.append({**expected, "found": value, "ok": is_ok})
    return rows
