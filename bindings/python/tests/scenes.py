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
