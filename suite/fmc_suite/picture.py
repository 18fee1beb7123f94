"""A picture of a problem as SVG: its meshes, the sides that may touch, what is held and what is loaded."""

from __future__ import annotations

import numpy as np

from .problem import Problem

WIDTH, EDGE = 260.0, 14.0
COLOURS = ("#9db7d5", "#e0c08f", "#a9cda4", "#d3a9c4", "#c9c9a1")


def svg(problem: Problem) -> str:
    """Bodies are filled, sides of contact are red, held points are dots, and loaded ones have arrows."""
    flat = _flat(problem.points)
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = (WIDTH - 2 * EDGE) / (high - low).max()
    places = (flat - low) * scale + EDGE
    width, height = (high - low) * scale + 2 * EDGE
    places[:, 1] = height - places[:, 1]
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" role="img">']
    for number, body in enumerate(problem.bodies):
        facets = body.cells if problem.dim == 2 else np.concatenate([body.sides[side] for side in ("x+", "y-", "z+")])
        colour = COLOURS[number % len(COLOURS)]
        shapes = "".join(f"M{_path(places[facet + problem.firsts[number]])}Z" for facet in facets)
        parts.append(f'<path d="{shapes}" fill="{colour}" stroke="#555" stroke-width="0.4"/>')
    for pair in problem.pairs:
        for facets in pair:
            shapes = "".join(f"M{_path(places[facet])}" for facet in facets)
            parts.append(f'<path d="{shapes}" fill="none" stroke="#c03028" stroke-width="1.2"/>')
    held = np.unique(np.flatnonzero(problem.fixed.any(axis=1)))
    parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1.3" fill="#222"/>' for x, y in places[held]]
    parts += [_arrow(places[point], direction) for point, direction in _loads(problem)]
    return "".join([*parts, "</svg>"])


def _flat(points: np.ndarray) -> np.ndarray:
    """Points in the plane of the picture; those in space seen from above and aside."""
    if points.shape[1] == 2:
        return points
    return np.asarray(points @ np.array([[0.9, -0.25], [0.45, 0.35], [0.0, 0.9]]))


def _path(corners: np.ndarray) -> str:
    return "L".join(f"{x:.1f},{y:.1f}" for x, y in corners)


def _loads(problem: Problem) -> list[tuple[int, np.ndarray]]:
    """Some of the loaded points, with the directions of their loads in the picture."""
    step = int(np.abs(problem.loads).sum(axis=(1, 2)).argmax())
    load = problem.loads[step]
    points = np.flatnonzero(load.any(axis=1))
    chosen = points[:: max(1, len(points) // 8)]
    directions = _flat(load[chosen]) * [1.0, -1.0]
    return [(int(point), one / np.linalg.norm(one)) for point, one in zip(chosen, directions)]


def _arrow(at: np.ndarray, direction: np.ndarray) -> str:
    """An arrow that ends at a point."""
    begin, across = at - 10 * direction, np.array([-direction[1], direction[0]])
    wings = [at - 4 * direction + 2 * across, at, at - 4 * direction - 2 * across]
    return f'<path d="M{_path(np.array([begin, at]))}M{_path(np.array(wings))}" fill="none" stroke="#1b5e20"/>'
