"""Thin plates of hexahedra, most of whose nodes lie on the surface."""

from __future__ import annotations

import numpy as np


def plate(divisions: int, height: float) -> tuple[np.ndarray, np.ndarray]:
    """A unit square, 0.1 thick, of two layers: nodes (n, 3) and cells in VTK's order."""
    ticks = [np.linspace(0, 1, divisions + 1)] * 2 + [np.linspace(height, height + 0.1, 3)]
    coords = np.stack(np.meshgrid(*ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    number = np.arange(len(coords)).reshape(divisions + 1, divisions + 1, 3)
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    at = [number[i : i + divisions, j : j + divisions, k : k + 2].ravel() for i, j, k in corners]
    return coords, np.stack(at, axis=1)
