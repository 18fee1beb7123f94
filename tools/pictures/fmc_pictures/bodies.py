"""Bodies of the pictures."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[3] / "bindings/python/tests"))
from elastic import stiffness
from scenes import grid


def together(*bodies):
    """Coordinates and cells of several bodies, and the first node of each."""
    firsts = np.cumsum([0, *(len(coords) for coords, _ in bodies)])
    cells = np.concatenate([np.asarray(conn) + first for (_, conn), first in zip(bodies, firsts)])
    return np.concatenate([coords for coords, _ in bodies]), cells, firsts


def turned(coords, degrees):
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return coords @ np.array([[cos, sin], [-sin, cos]])


def outline(coords, cells):
    """Boundary edges of a mesh of quadrilaterals."""
    edges = np.concatenate([cells[:, [a, (a + 1) % 4]] for a in range(4)])
    _, place, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    return coords[edges[place[count == 1]]]


__all__ = ["grid", "outline", "stiffness", "together", "turned"]
