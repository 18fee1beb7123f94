"""Bodies as mapped grids of quadrilaterals or hexahedra, with six named sides: ``x-``, ``x+``, ``y-``, ``y+``, ``z-``, ``z+``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

AXES = "xyz"
_QUAD = ((0, 0), (1, 0), (1, 1), (0, 1))
_CORNERS = {2: _QUAD, 3: tuple((*at, z) for z in (0, 1) for at in _QUAD)}
# Facets of a cell that runs counter-clockwise, seen from outside in the same sense.
_FACETS = {
    2: ((0, 1), (1, 2), (2, 3), (3, 0)),
    3: ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
}


@dataclass(frozen=True, eq=False)
class Body:
    """Points (n, dim), cells (m, 4 or 8) with the corners in the order of VTK, and the facets of every side."""

    points: np.ndarray
    cells: np.ndarray
    sides: dict[str, np.ndarray]
    """Facets with outward normals, by the name of the side: (facets, 2 or 4) numbers of points."""


def lines(raw: Mapping[str, Any]) -> np.ndarray:
    """Coordinates of the grid along an axis: ``from``, ``to`` and ``cells``; or ``fine`` up to ``even`` from ``from`` on, then growing;
    with ``mirrored`` the same on the other side of ``from`` too."""
    start, end = raw["from"], raw["to"]
    if "cells" in raw:
        return np.linspace(start, end, raw["cells"] + 1)
    step, growth, found = raw["fine"], raw.get("growth", 1.2), [0.0]
    whole = abs(end - start)
    while found[-1] < whole:
        found.append(found[-1] + step)
        if found[-1] > raw["even"]:
            step *= growth
    half = (end - start) * np.array(found) / found[-1]
    return np.asarray(start + (np.concatenate([-half[:0:-1], half]) if raw.get("mirrored") else half))


def body(raw: Mapping[str, Any]) -> Body:
    """The grid of a body, mapped."""
    axes = [lines(raw[axis]) for axis in AXES if axis in raw]
    dim, counts = len(axes), [len(axis) for axis in axes]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, dim)
    numbers = np.arange(len(points)).reshape(counts)
    cells = np.stack([numbers[tuple(slice(o, n - 1 + o) for o, n in zip(at, counts))].ravel() for at in _CORNERS[dim]], 1)
    on_side = {}
    for axis in range(dim):
        for name, at in (("-", 0), ("+", -1)):
            on_side[AXES[axis] + name] = numbers.take(at, axis).ravel()
    for one in raw.get("maps", []):
        points = MAPS[one["kind"]](points, one)
    cells = _oriented(points, cells)
    return Body(points, cells, {name: _facets(cells, nodes, dim) for name, nodes in on_side.items()})


def _oriented(points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """Cells that a map has turned inside out, turned back."""
    corner = points[cells]
    edges = corner[:, [1, 3] if points.shape[1] == 2 else [1, 3, 4]] - corner[:, :1]
    if np.linalg.det(edges).sum() > 0:
        return cells
    return cells[:, [0, 3, 2, 1]] if points.shape[1] == 2 else cells[:, [4, 5, 6, 7, 0, 1, 2, 3]]


def _facets(cells: np.ndarray, nodes: np.ndarray, dim: int) -> np.ndarray:
    facets = np.concatenate([cells[:, list(one)] for one in _FACETS[dim]])
    return np.asarray(facets[np.isin(facets, nodes).all(axis=1)])


def _ring(x: np.ndarray, raw: Mapping[str, Any]) -> np.ndarray:
    """x is an angle in degrees, y a radius."""
    angle, radius = np.radians(x[:, 0]), x[:, 1]
    around = [radius * np.cos(angle), radius * np.sin(angle)]
    return np.stack([*around, *x[:, 2:].T], 1)


def _crown(x: np.ndarray, raw: Mapping[str, Any]) -> np.ndarray:
    """The lowest side becomes a parabola with the curvature 1 / ``radius``, or one radius for every axis; the opposite side stays. With
    ``flat`` it is flat to there, and with ``slope`` a wedge. With ``top`` the highest side becomes so, downwards."""
    up = x[:, -1]
    part = (up.max() - up) / np.ptp(up)
    across = np.maximum(np.abs(x[:, :-1]) - raw.get("flat", 0.0), 0.0)
    rise = (across**2 / (2 * np.array(raw.get("radius", np.inf))) + raw.get("slope", 0.0) * across).sum(axis=1)
    moved = up - (1 - part) * rise if raw.get("top") else up + part * rise
    return np.column_stack([x[:, :-1], moved])


def _tilt(x: np.ndarray, raw: Mapping[str, Any]) -> np.ndarray:
    """The plane at height 0 turns about ``about`` by the slopes ``by``; planes at the height -1 and 1 stay."""
    rise = (x[:, :-1] - np.array(raw["about"])) @ np.array(raw["by"])
    return np.column_stack([x[:, :-1], x[:, -1] + rise * (1 - np.abs(x[:, -1]))])


def _skew(x: np.ndarray, raw: Mapping[str, Any]) -> np.ndarray:
    """Lines move along x by ``by`` sin(pi x), so that no two meshes of blocks match; ``width`` is 1 if not given."""
    width = raw.get("width", 1.0)
    moved = x.copy()
    moved[:, 0] += raw["by"] * np.sin(np.pi * x[:, 0] / width)
    return moved


def _corners(x: np.ndarray, raw: Mapping[str, Any]) -> np.ndarray:
    """The unit square onto a quadrilateral of four corners, counter-clockwise from that of the origin."""
    a, b, c, d = (np.array(one, float) for one in raw["points"])
    s, t = x[:, :1], x[:, 1:2]
    return np.asarray((1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d)


MAPS = {"ring": _ring, "crown": _crown, "skew": _skew, "tilt": _tilt, "corners": _corners}
