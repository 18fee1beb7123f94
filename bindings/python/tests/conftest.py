"""Meshes that the tests share."""

import numpy as np
import pytest
from scenes import grid


@pytest.fixture
def squares():
    """A unit square and one a little lower that overlap by a strip 0.1 wide and 0.8 high: coordinates and cells."""
    coords = [[0, 0], [1, 0], [1, 1], [0, 1], [0.9, 0.1], [1.9, 0.1], [1.9, 0.9], [0.9, 0.9]]
    return np.array(coords, float), np.array([[0, 1, 2, 3], [4, 5, 6, 7]], np.int32)


@pytest.fixture
def cubes():
    """Two unit cubes, the upper one 0.1 deep in the lower and 0.2 aside: coordinates and cells."""
    base = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    cube = np.vstack([np.c_[base, np.zeros(4)], np.c_[base, np.ones(4)]])
    return np.vstack([cube, cube + [0.2, 0.0, 0.9]]), np.arange(16, dtype=np.int32).reshape(2, 8)


@pytest.fixture
def blocks():
    """Two rows of squares that press on one another: coordinates and cells."""
    (a, of_a), (b, of_b) = grid((600, 2), (0, 2), (0, 1)), grid((530, 2), (0.2, 1.7), (0.99, 2))
    return np.concatenate([a, b]), np.concatenate([of_a, of_b + len(a)])
