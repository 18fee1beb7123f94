"""What the scenes of the tests share."""

import numpy as np

K = 1000.0
"""Stiffness of all scenes."""

TETRA_OF_CUBE = np.array([[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]])
"""Six tetrahedra about the diagonal from corner 0 to corner 6."""


def tetrahedra(cubes):
    """The cells of the cubes, each cut into six tetrahedra."""
    return cubes[:, TETRA_OF_CUBE].reshape(-1, 4)


def triangles(squares):
    """The cells of the squares, each cut into two triangles."""
    return squares[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)


def same_bits(a, b):
    """Whether two arrays of doubles are equal to the last bit."""
    return a.shape == b.shape and np.ascontiguousarray(a).tobytes() == np.ascontiguousarray(b).tobytes()


def grid(cells, x, y):
    """Squares of a rectangle."""
    nx, ny = cells
    xs, ys = np.linspace(*x, nx + 1), np.linspace(*y, ny + 1)
    coords = np.array([[a, b] for b in ys for a in xs])
    first = np.array([j * (nx + 1) + i for j in range(ny) for i in range(nx)])
    return coords, np.stack([first, first + 1, first + nx + 2, first + nx + 1], axis=1).astype(np.int32)
