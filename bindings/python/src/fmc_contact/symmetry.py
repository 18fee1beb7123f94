"""Planes in which facets lie, and the facets that lie in planes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Optional

import numpy as np

Plane = tuple[np.ndarray, np.ndarray]
"""A point, (dim,), and the unit normal, (dim,)."""

# As far as the library takes a facet to lie in a plane: part of its longest edge.
_IN_PLANE = 1e-3

# As many as the library finds from nodes.
_MOST_PLANES = 1000


def symmetry_of(facets: np.ndarray, nodes: np.ndarray, is_named: np.ndarray) -> tuple[list[Plane], Optional[np.ndarray]]:
    """The planes in which the named ones of all boundary facets, (facets, dim, dim), lie, and ``None``. If other facets lie in them, as at a
    crack beside a ligament, the nodes of those that are named, ascending. ``nodes``, (facets, nodes), are those of the faces of the facets, -1
    for none.

    Errors: ``ValueError`` for facets of a curved surface, and if nodes cannot tell which facets are named."""
    planes = planes_through(facets[is_named])
    if not lie_in(planes, facets[~is_named]).any():
        return planes, None
    check_nodes(cut_by_nodes(facets, nodes, is_named), is_named)
    named = np.unique(nodes[is_named])
    return planes, named[named >= 0]


def check_nodes(is_cut: np.ndarray, is_named: np.ndarray) -> None:
    """Refuses facets that nodes do not tell from others.

    Errors: ``ValueError``."""
    missed, added = int((is_named & ~is_cut).sum()), int((is_cut & ~is_named).sum())
    if missed or added:
        raise ValueError(
            f"other facets lie in the planes of the {int(is_named.sum())} named ones, and their nodes do not tell them apart: they would leave out "
            f"{missed} of them, and name {added} others. Use smaller cells there, two across a slice, or set_symmetry_planes"
        )


def divided(faces: np.ndarray) -> np.ndarray:
    """Facets, (facets, dim, dim), of faces by their corners, (faces, corners, dim): of a quadrilateral the triangles about its centre, as in
    ``Mesh.boundary_facets``, one on each of its edges in turn."""
    count, corners, dim = faces.shape
    if corners == dim:
        return faces
    centres = np.broadcast_to(faces.mean(axis=1, keepdims=True), faces.shape)
    return np.stack([faces, np.roll(faces, -1, axis=1), centres], axis=2).reshape(count * corners, dim, dim)


def planes_through(facets: np.ndarray) -> list[Plane]:
    """The planes in which facets, (facets, dim, dim), lie. Each is fitted to all facets in it. They depend on the order of corners in a facet, but
    not on the order of the facets.

    Errors: ``ValueError`` for facets of a curved surface."""
    areas = _areas(facets)
    # Large ones say best where their plane is.
    order = np.lexsort([*facets.reshape(len(facets), facets.shape[2] ** 2).T, -areas])
    left = facets[order[areas[order] > 0.0]]
    planes: list[Plane] = []
    while len(left):
        if len(planes) == _MOST_PLANES:
            raise ValueError(f"the facets lie in more than {_MOST_PLANES} planes: are they of a curved surface?")
        plane, inside = _widest(left)
        planes.append(plane)
        left = left[~inside]
    return planes


def lie_in(planes: Sequence[Plane], facets: np.ndarray) -> np.ndarray:
    """Whether each facet lies in one of the planes, (facets,)."""
    extents = np.linalg.norm(facets - facets[:, :1], axis=2).max(axis=1, initial=0.0)
    found = np.zeros(len(facets), bool)
    for point, normal in planes:
        found |= np.abs((facets - point) @ normal).max(axis=1, initial=0.0) <= _IN_PLANE * extents
    return found


def cut_by_nodes(facets: np.ndarray, nodes: np.ndarray, is_named: np.ndarray) -> np.ndarray:
    """Which facets the library takes to lie in planes of symmetry where it knows the nodes of those that are named: facets with such nodes
    alone, in the fewest planes that hold all of these. ``nodes``, (facets, nodes), are those of the faces of the facets, -1 for none."""
    may_be = (np.isin(nodes, nodes[is_named]) | (nodes < 0)).all(axis=1)
    of_planes = []
    for plane in planes_through(facets[may_be]):
        held = nodes[may_be & lie_in([plane], facets)]
        of_planes.append((plane, np.unique(held[held >= 0])))
    chosen = []
    while of_planes:
        place = int(np.argmax([len(held) for _, held in of_planes]))
        plane, most = of_planes.pop(place)
        chosen.append(plane)
        rest = [(other, np.setdiff1d(held, most)) for other, held in of_planes]
        of_planes = [(other, held) for other, held in rest if len(held)]
    is_cut: np.ndarray = may_be & lie_in(chosen, facets)
    return is_cut


def _areas(facets: np.ndarray) -> np.ndarray:
    along = facets[:, 1:] - facets[:, :1]
    found: np.ndarray = np.linalg.norm(along[:, 0] if facets.shape[2] == 2 else np.cross(along[:, 0], along[:, 1]), axis=1)
    return found


def _widest(facets: np.ndarray) -> tuple[Plane, np.ndarray]:
    """The plane of the first facet, fitted to all that lie in it, and which do."""
    plane = _fitted(facets[:1])
    inside = lie_in([plane], facets)
    inside[0] = True
    while True:
        wider = _fitted(facets[inside])
        grown = lie_in([wider], facets)
        if not grown[inside].all():
            return plane, inside
        if grown.sum() == inside.sum():
            return wider, inside
        plane, inside = wider, grown


def _fitted(facets: np.ndarray) -> Plane:
    points = facets.reshape(-1, facets.shape[2])
    middle = points.mean(axis=0)
    offsets = points - middle
    # Sums in one order, so that all ranks find the same.
    moments = (offsets[:, :, None] * offsets[:, None, :]).sum(axis=0)
    return middle, np.linalg.eigh(moments)[1][:, 0]
