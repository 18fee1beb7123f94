"""Linear elasticity of quadrilaterals in plane strain and of hexahedra, by full integration: the suite's own, for figures and hosts."""

from __future__ import annotations

from itertools import product

import numpy as np
from scipy.sparse import csr_matrix

_AT = 1 / np.sqrt(3)
_QUAD = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
_SIGNS = {4: _QUAD, 8: np.array([(*at, z) for z in (-1, 1) for at in _QUAD], float)}


def gradients(points: np.ndarray, cells: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gradients of the shape functions, (cells, places, corners, dim), and weights, (cells, places), at the places of integration."""
    signs = _SIGNS[cells.shape[1]]
    dim, found, weights = points.shape[1], [], []
    for place in product((-_AT, _AT), repeat=dim):
        factors = (1 + signs * np.array(place)) / 2
        local = np.stack([signs[:, a] / 2 * np.delete(factors, a, 1).prod(1) for a in range(dim)], 1)
        jacobian = np.einsum("eni,na->eia", points[cells], local)
        found.append(np.einsum("na,eai->eni", local, np.linalg.inv(jacobian)))
        weights.append(np.linalg.det(jacobian))
    return np.stack(found, 1), np.stack(weights, 1)


def stiffness(points: np.ndarray, cells: np.ndarray, young: float, poisson: float) -> csr_matrix:
    """Over the unknowns ``point * dim + axis`` of all points."""
    lame, shear = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))
    slopes, weights = gradients(points, cells)
    dim, by = points.shape[1], "eq,eqni,eqmj->enimj"
    local = lame * np.einsum(by, weights, slopes, slopes, optimize=True)
    local += shear * np.einsum("eq,eqnj,eqmi->enimj", weights, slopes, slopes, optimize=True)
    plain = shear * np.einsum("eq,eqnk,eqmk->enm", weights, slopes, slopes, optimize=True)
    local += np.einsum("enm,ij->enimj", plain, np.eye(dim))
    unknowns = (cells[:, :, None] * dim + np.arange(dim)).reshape(len(cells), -1)
    local = local.reshape(len(cells), unknowns.shape[1], -1)
    rows, cols = np.broadcast_arrays(unknowns[:, :, None], unknowns[:, None, :])
    return csr_matrix((local.ravel(), (rows.ravel(), cols.ravel())), shape=(points.size, points.size))


def stress(points: np.ndarray, cells: np.ndarray, young: float, poisson: float, u: np.ndarray) -> np.ndarray:
    """At the places of integration, (cells, places, dim, dim)."""
    lame, shear = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))
    slopes, _ = gradients(points, cells)
    gradient = np.einsum("eni,eqnj->eqij", u[cells], slopes)
    strain = (gradient + gradient.swapaxes(-1, -2)) / 2
    trace = np.trace(strain, axis1=-2, axis2=-1)
    return np.asarray(2 * shear * strain + lame * trace[..., None, None] * np.eye(points.shape[1]))
