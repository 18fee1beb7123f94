"""Linear elasticity of quadrilaterals in plane strain, for tests that need bodies whose matrix hangs on their shape."""

import numpy as np

POISSON = 0.3


def stiffness(coords, quads, young):
    """The matrix, (2 n, 2 n) in compressed rows, by four points in each cell."""
    from scipy.sparse import csr_matrix

    first, shear = young * POISSON / (1 + POISSON) / (1 - 2 * POISSON), young / 2 / (1 + POISSON)
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
    dofs = (2 * np.asarray(quads)[:, :, None] + [0, 1]).reshape(len(quads), 8)
    rows, cols = np.repeat(dofs, 8, axis=1), np.tile(dofs, 8)
    return csr_matrix((cells.ravel(), (rows.ravel(), cols.ravel())), (coords.size, coords.size))
