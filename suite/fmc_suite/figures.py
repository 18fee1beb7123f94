"""The figure of a problem, from the displacements that a code returns: one way of measuring for all codes."""

from __future__ import annotations

import numpy as np

from . import elastic, grids
from .problem import Problem, areas
from .references import indentation


def figure(problem: Problem, displacements: np.ndarray) -> float:
    """Of displacements at the ends of the load steps, (steps, n, dim)."""
    raw = problem.raw["figure"]
    step = raw.get("step", len(problem.steps) - 1)
    return float(FIGURES[raw["kind"]](problem, displacements, step))


def error(problem: Problem, found: float) -> float:
    """Relative to the reference, or to the scale that the figure names where the reference is zero."""
    scale = problem.raw["figure"].get("scale", problem.reference)
    return float((found - problem.reference) / abs(scale))


def contact_forces(problem: Problem, u: np.ndarray, step: int, number: int) -> np.ndarray:
    """On the points of a body, (points, dim): what its stresses and loads leave over, zero on all held points."""
    first, end = problem.firsts[number : number + 2]
    body, raw = problem.bodies[number], problem.raw["bodies"][number]
    matrix = elastic.stiffness(body.points, body.cells, raw["young"], raw["poisson"])
    inner = (matrix @ u[first:end].ravel()).reshape(-1, problem.dim) - problem.loads[step, first:end]
    return np.where(problem.fixed[first:end], 0.0, inner)


def _force(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Of contact on a body along an axis."""
    raw = problem.raw["figure"]
    total = contact_forces(problem, all_u[step], step, raw["body"]).sum(axis=0)
    return float(total[grids.AXES.index(raw["axis"])])


def _held_force(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """That holds a side of a body along an axis."""
    raw = problem.raw["figure"]
    body, material = problem.bodies[raw["body"]], problem.raw["bodies"][raw["body"]]
    first, end = problem.firsts[raw["body"] : raw["body"] + 2]
    matrix = elastic.stiffness(body.points, body.cells, material["young"], material["poisson"])
    inner = (matrix @ all_u[step, first:end].ravel()).reshape(-1, problem.dim) - problem.loads[step, first:end]
    nodes = np.unique(body.sides[raw["side"]])
    return float(inner[nodes, grids.AXES.index(raw["axis"])].sum())


def _ratio(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Of the force of contact on a body along an axis to the load of the step along the last axis."""
    return _force(problem, all_u, step) / float(np.abs(problem.loads[step, :, -1].sum()))


def _displacement(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Mean over the points of a side along an axis."""
    raw = problem.raw["figure"]
    nodes = problem.nodes(raw["body"], raw["side"])
    return float(all_u[step, nodes, grids.AXES.index(raw["axis"])].mean())


def _radial_displacement(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Mean over a round side about the origin."""
    nodes = problem.nodes(problem.raw["figure"]["body"], problem.raw["figure"]["side"])
    outward = problem.points[nodes] / np.linalg.norm(problem.points[nodes], axis=1)[:, None]
    return float((all_u[step, nodes] * outward).sum(axis=1).mean())


def _stress_error(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Largest difference of the stress along the last axis, or along ``row`` and ``column``, from the given one at all places of all cells, by
    that stress."""
    wanted, worst = problem.raw["figure"]["stress"], 0.0
    row, column = problem.raw["figure"].get("row", -1), problem.raw["figure"].get("column", -1)
    for body, raw, first in zip(problem.bodies, problem.raw["bodies"], problem.firsts):
        u = all_u[step, first : first + len(body.points)]
        found = elastic.stress(body.points, body.cells, raw["young"], raw["poisson"], u)[..., row, column]
        worst = max(worst, float(np.abs(found / wanted - 1).max()))
    return worst


def _shares(problem: Problem, step: int, all_u: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Places, forces and areas of the points of the side that the figure names."""
    raw = problem.raw["figure"]
    body = problem.bodies[raw["body"]]
    facets = body.sides[raw["side"]]
    area = np.zeros(len(body.points))
    for corner in facets.T:
        np.add.at(area, corner, areas(body.points, facets) / facets.shape[1])
    nodes = np.unique(facets)
    return body.points[nodes], contact_forces(problem, all_u[step], step, raw["body"])[nodes], area[nodes]


def _radial_pressure(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Mean over a round side about the origin, of the forces away from its middle."""
    places, forces, area = _shares(problem, step, all_u)
    outward = places / np.linalg.norm(places, axis=1)[:, None]
    # A quarter: held points carry only the part of the force along the plane of symmetry, which is all of it.
    return float(abs((forces * outward).sum()) / area.sum())


def _peak(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Peak of p² = p0² (1 − x²/a² − y²/b²), fitted where the pressure is more than 0.4 of the largest, without the edge of the contact."""
    places, forces, area = _shares(problem, step, all_u)
    pressure = np.abs(forces[:, -1]) / area
    high = pressure > 0.4 * pressure.max()
    table = np.column_stack([np.ones(high.sum()), places[high, :-1] ** 2])
    return float(np.sqrt(np.linalg.lstsq(table, pressure[high] ** 2, rcond=None)[0][0]))


def _centre(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Pressure over the inner part ``within`` of a side."""
    places, forces, area = _shares(problem, step, all_u)
    near = np.abs(places[:, 0]) < problem.raw["figure"]["within"]
    return float(np.abs(forces[near, -1]).sum() / area[near].sum())


def _mindlin(problem: Problem, all_u: np.ndarray, step: int) -> float:
    """Shear traction over the inner part ``within`` of a side, by μ p0 (1 − c/a) of Cattaneo and Mindlin for the forces P and Q that the code
    has there: c/a = sqrt(1 − Q / (μ P))."""
    raw, friction = problem.raw["figure"], problem.friction
    places, forces, area = _shares(problem, step, all_u)
    shear, normal = np.abs(forces.sum(axis=0))
    peak = indentation.line_peak(normal, raw["radius"], problem.raw["bodies"][0]["young"], problem.raw["bodies"][0]["poisson"])
    near = np.abs(places[:, 0]) < raw["within"]
    expected = friction * peak * (1 - np.sqrt(max(0.0, 1 - shear / (friction * normal))))
    return float(np.abs(forces[near, 0].sum()) / area[near].sum() / expected)


FIGURES = {
    "mindlin": _mindlin,
    "force": _force,
    "held_force": _held_force,
    "ratio": _ratio,
    "displacement": _displacement,
    "radial_displacement": _radial_displacement,
    "stress_error": _stress_error,
    "radial_pressure": _radial_pressure,
    "peak": _peak,
    "centre": _centre,
}
