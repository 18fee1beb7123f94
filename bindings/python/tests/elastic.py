"""Linear elasticity of quadrilaterals in plane strain and of hexahedra, for tests that need bodies whose matrix hangs on their shape."""

import numpy as np

POISSON = 0.3


def stiffness(coords, quads, young):
    """The matrix, (2 n, 2 n) in compressed rows, by four points in each cell; ``young`` is one number, or one for each cell."""
    from scipy.sparse import csr_matrix

    first, shear = POISSON / (1 + POISSON) / (1 - 2 * POISSON), 1 / 2 / (1 + POISSON)
    law = np.array([[first + 2 * shear, first, 0], [first, first + 2 * shear, 0], [0, 0, shear]])
    corners, cells = coords[quads], np.zeros((len(quads), 8, 8))
    for a in (-1, 1) / np.sqrt(3):
        for b in (-1, 1) / np.sqrt(3):
            slopes = np.array([[b - 1, 1 - b, 1 + b, -1 - b], [a - 1, -1 - a, 1 + a, 1 - a]]) / 4
            jacobian = slopes @ corners
            by_place = np.linalg.solve(jacobian, np.broadcast_to(slopes, (len(quads), 2, 4)))
            strain = np.zeros((len(quads), 3, 8))
            strain[:, 0, ::2], strain[:, 1, 1::2] = by_place[:, 0], by_place[:, 1]
            strain[:, 2, ::2], strain[:, 2, 1::2] = by_place[:, 1], by_place[:, 0]
            weight = np.linalg.det(jacobian)[:, None, None]
            cells += weight * np.swapaxes(strain, 1, 2) @ law @ strain
    cells *= np.broadcast_to(young, len(quads))[:, None, None]
    dofs = (2 * np.asarray(quads)[:, :, None] + [0, 1]).reshape(len(quads), 8)
    rows, cols = np.repeat(dofs, 8, axis=1), np.tile(dofs, 8)
    return csr_matrix((cells.ravel(), (rows.ravel(), cols.ravel())), (coords.size, coords.size))


def bricks(cells, low, high):
    """Hexahedra of a box: coordinates and cells."""
    axes = [np.linspace(a, b, count + 1) for a, b, count in zip(low, high, cells)]
    coords = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
    number = np.arange(len(coords)).reshape([count + 1 for count in cells])
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    ends = [tuple(slice(at, count + at) for at, count in zip(corner, cells)) for corner in corners]
    return coords, np.stack([number[end].ravel() for end in ends], axis=1)


def stiffness_of_bricks(coords, cells, young):
    """The matrix of hexahedra, (3 n, 3 n) in compressed rows, by eight points in each cell."""
    from scipy.sparse import csr_matrix

    first, shear = young * POISSON / (1 + POISSON) / (1 - 2 * POISSON), young / 2 / (1 + POISSON)
    law = np.diag([2 * shear] * 3 + [shear] * 3)
    law[:3, :3] += first
    signs = np.array([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)])
    matrices = np.zeros((len(cells), 24, 24))
    for point in signs / np.sqrt(3):
        a, b, c = (1 + signs * point).T
        slopes = np.stack([signs[:, 0] * b * c, signs[:, 1] * a * c, signs[:, 2] * a * b]) / 8
        jacobian = slopes @ coords[cells]
        by_place = np.linalg.solve(jacobian, np.broadcast_to(slopes, (len(cells), 3, 8)))
        strain = np.zeros((len(cells), 6, 24))
        for axis in range(3):
            strain[:, axis, axis::3] = by_place[:, axis]
        for row, (one, other) in enumerate([(0, 1), (1, 2), (2, 0)], start=3):
            strain[:, row, one::3], strain[:, row, other::3] = by_place[:, other], by_place[:, one]
        matrices += np.linalg.det(jacobian)[:, None, None] * (np.swapaxes(strain, 1, 2) @ law @ strain)
    dofs = (3 * np.asarray(cells)[:, :, None] + np.arange(3)).reshape(len(cells), 24)
    rows, cols = np.repeat(dofs, 24, axis=1), np.tile(dofs, 24)
    return csr_matrix((matrices.ravel(), (rows.ravel(), cols.ravel())), (coords.size, coords.size))
