"""Planes in which the named boundaries of meshes lie."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import skfem

Plane = tuple[np.ndarray, np.ndarray]
"""A point, (dim,), and the unit normal, (dim,)."""

# As far as the library takes a face to lie in a plane: part of the longest edge.
_IN_PLANE = 1e-3


def planes_of(names: Sequence[str], meshes: Iterable[skfem.Mesh]) -> list[Plane] | None:
    """A plane for every named boundary of every mesh.

    ``None`` if a boundary lies in several planes, or if one of the planes has boundary facets without a name: a crack beside a ligament.
    """
    planes, unnamed = [], []
    for mesh in meshes:
        named = {name: np.asarray((mesh.boundaries or {}).get(name, []), np.int64) for name in names}
        for facets in named.values():
            if facets.size:
                plane = _fitted(_corners(mesh, facets))
                if not np.all(_lies_in(plane, _corners(mesh, facets))):
                    return None
                planes.append(plane)
        rest = np.setdiff1d(mesh.boundary_facets(), np.concatenate([np.empty(0, np.int64), *named.values()]))
        unnamed.append(_corners(mesh, rest))
    others = any(np.any(_lies_in(plane, corners)) for plane in planes for corners in unnamed)
    return None if others else planes


def _corners(mesh: skfem.Mesh, facets: np.ndarray) -> np.ndarray:
    """Corners of facets, (dim, corners, facets)."""
    return mesh.p[:, mesh.facets[:, facets]]


def _fitted(corners: np.ndarray) -> Plane:
    middle = corners.mean(axis=(1, 2))
    offsets = corners.reshape(len(middle), -1).T - middle
    return middle, np.linalg.svd(offsets, full_matrices=False)[2][-1]


def _lies_in(plane: Plane, corners: np.ndarray) -> np.ndarray:
    """Whether each facet lies in the plane."""
    point, normal = plane
    heights = np.abs(np.tensordot(normal, corners - point[:, None, None], 1)).max(axis=0, initial=0.0)
    extents = np.linalg.norm(corners - corners[:, :1], axis=0).max(axis=0, initial=0.0)
    return heights <= _IN_PLANE * extents
