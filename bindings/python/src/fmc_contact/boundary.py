"""The boundary facets that the library found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import written
from ._handle import Handle
from ._library import library
from ._structs import fmc_boundary_facet
from .errors import BadValueError


@dataclass(frozen=True, eq=False)
class BoundaryFacets:
    """The m boundary facets, in the order of ``contact.friction.slip``: edges in 2D, triangles in 3D, body after body.

    A quadrilateral face is four of them, one on each of its edges. A face of second order is divided first: an edge into two parts,
    a triangle or quadrilateral into four.

    Attributes
    ----------
    cell : ndarray of int, (m,)
        Cell of every facet, counted over all blocks; -1 without cells.
    local_face : ndarray of int, (m,)
        Number of its face among the faces of the cell, as VTK counts them; -1 without cells. Nodes of face 0, 1, ... by their place in the cell:
        triangle 01, 12, 20. Quadrilateral 01, 12, 23, 30. Tetrahedron 013, 123, 203, 021. Hexahedron 0473, 1265, 0154, 3762, 0321, 4567. Wedge 012,
        354, 0341, 1452, 2530. Pyramid 0321, 014, 124, 234, 304. With cells of second order these are the corners.
    nodes : ndarray of int, (m, 2) in 2D, (m, 4) in 3D
        Nodes of the face; the last of a triangle is -1. In 2D the body lies on the left, in 3D they run counter-clockwise, seen from
        outside. Of four, the facet is the triangle of the first two and the mean of all. Of a face of second order they are
        points of the part in which the facet lies: rows of ``contact.mesh.point_weights()``.
    body : ndarray of int, (m,)
        Index of its body in ``Result.bodies``.
    input_facet : ndarray of int, (m,)
        Its number among the facets given to ``Contact.from_facets``; -1 where cells were given.

    Examples
    --------
    >>> contact.mesh.boundary_facets().cell
    array([0, 0, 0, 0, 1, 1, 1, 1])
    """

    cell: np.ndarray
    local_face: np.ndarray
    nodes: np.ndarray
    body: np.ndarray
    input_facet: np.ndarray

    def __len__(self) -> int:
        return len(self.cell)


def boundary_facets(handle: Handle, dim: int) -> BoundaryFacets:
    """Asks for them."""
    found = handle.rows(fmc_boundary_facet, library.fmc_context_boundary_facets)
    facets = written(found, fmc_boundary_facet)
    columns = 2 if dim == 2 else 4
    return BoundaryFacets(
        facets["cell"].copy(),
        facets["local_face"].copy(),
        facets["nodes"][:, :columns].copy(),
        facets["body"].astype(np.int64),
        facets["input_facet"].copy(),
    )


def rows_of_facets(facets: ArrayLike, count: int) -> np.ndarray:
    """Numbers of facets that were named by these, or by one bool for each of the ``count`` facets."""
    places = np.asarray(facets)
    if places.dtype == bool:
        if places.shape != (count,):
            raise ValueError(f"'facets' has marks of shape {places.shape}, and there are {count} boundary facets")
        places = np.flatnonzero(places)
    if places.ndim != 1 or not (places.size == 0 or np.issubdtype(places.dtype, np.integer)):
        raise TypeError("'facets' must be a list of integers, or of bools")
    if places.size and places.min() < 0:
        entry = int(places.argmin())
        raise BadValueError(f"entry {entry} of 'facets' is {places[entry]}, a negative number")
    if places.size and places.max() >= count:
        entry = int(places.argmax())
        raise BadValueError(f"entry {entry} of 'facets' is {places[entry]}, and there are {count} boundary facets")
    return places.astype(np.int64)


def nodes_of(facets: BoundaryFacets, node_count: int, base: int) -> np.ndarray:
    """The nodes of facets, counted from 0; -1 for none, and for points that are no nodes."""
    from_zero = facets.nodes - base
    return np.where((facets.nodes >= 0) & (from_zero < node_count), from_zero, -1)


def corners_of(facets: BoundaryFacets, points: np.ndarray, base: int) -> np.ndarray:
    """Corners of facets, (m, dim, dim), where points are at ``points``."""
    at: np.ndarray = points[np.maximum(facets.nodes - base, 0)]
    if points.shape[1] == 2:
        return at
    is_triangle = facets.nodes[:, 3] < 0
    last = np.where(is_triangle[:, None], at[:, 2], at.mean(axis=1))
    return np.stack([at[:, 0], at[:, 1], last], axis=1)


def facets_on(facets: BoundaryFacets, cells: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Which facets lie on faces that are named by their cells, counted as in ``facets``, and by their numbers in these."""
    width = 1 + max(int(each.max(initial=0)) for each in (facets.local_face, faces))
    found: np.ndarray = np.isin(facets.cell * width + facets.local_face, np.asarray(cells, np.int64) * width + faces)
    return found
