"""The boundary of a finite element space of first order as flat facets, for adapters.

A displacement moves the *nodes* of a boundary face, its corners. Contact wants flat facets between *points*: an edge and
a triangle are such facets, a quadrilateral becomes four triangles about its middle, and forces on the middle go back to
the corners in equal parts.

    points = P nodes        node forces = P^T point forces        node tangent = P^T (point tangent) P
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike


class Trace:
    """Faces of one kind in one numbering of nodes and of points.

    ``faces``, (m, corners): ids of the corners, any whole numbers, seen from outside counter-clockwise (2D: the body on
    the left). Points are the nodes, then the middles of quadrilaterals.
    """

    nodes: np.ndarray
    """Nodes of every face, (m, corners)."""
    node_count: int
    """Corners, ascending by their ids."""
    corner_ids: np.ndarray
    """Ids of the corners, ascending; corner i is node i."""
    facets: np.ndarray
    """Points of the flat facets, (count, dim), face after face."""
    face_of_facet: np.ndarray
    """Face of every flat facet."""
    point_count: int
    prolongation: Any
    """P, ``scipy.sparse.csr_matrix`` (points, nodes); ``None`` where points are nodes."""

    def __init__(self, faces: ArrayLike) -> None:
        faces = np.asarray(faces)
        if faces.ndim != 2 or faces.shape[1] not in (2, 3, 4):
            raise ValueError(f"faces has shape {faces.shape}, expected (faces, 2 to 4 corners)")
        self.corner_ids, nodes = np.unique(faces, return_inverse=True)
        self.nodes, self.node_count = nodes.reshape(faces.shape), len(self.corner_ids)
        self.facets, self.face_of_facet = self.nodes, np.arange(len(faces))
        self.point_count, self.prolongation = self.node_count, None
        if faces.shape[1] == 4:
            self._about_middles()

    def _about_middles(self) -> None:
        from scipy.sparse import csr_matrix, identity, vstack

        count = len(self.nodes)
        middles = np.repeat(self.node_count + np.arange(count), 4)
        self.facets = np.column_stack([self.nodes.ravel(), np.roll(self.nodes, -1, axis=1).ravel(), middles])
        self.face_of_facet = np.repeat(np.arange(count), 4)
        self.point_count = self.node_count + count
        means = csr_matrix(
            (np.full(4 * count, 0.25), self.nodes.ravel(), 4 * np.arange(count + 1)), shape=(count, self.node_count)
        )
        self.prolongation = vstack([identity(self.node_count, format="csr"), means], format="csr")
