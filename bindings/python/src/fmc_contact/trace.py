"""The boundary of a finite element space as flat facets, for adapters.

A displacement of first or second order moves the *nodes* of a boundary face. Contact wants flat facets between
*points*: a face is divided, its points follow the shape functions, and forces on the points go back to the nodes the
same way.

    points = P nodes        node forces = P^T point forces        node tangent = P^T (point tangent) P

Nodes of a face: its corners, then for order 2 the middles of its edges, then for a quadrilateral its centre.

    edge            triangle              quadrilateral
                      2                   3---6---2
    0---2---1         | \\                 |       |
                      5   4               7   8   5
                      |     \\             |       |
                      0---3---1           0---4---1
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike


class Trace:
    """Faces of one kind in one numbering of nodes and of points.

    ``faces``, (m, corners): ids of the corners, any whole numbers, seen from outside counter-clockwise (2D: the body on
    the left). ``order`` 1 or 2 of the displacement. ``divisions`` of every edge; default: the order, so that
    every node is a point. A quadrilateral becomes four triangles about its centre, and so does each of its divisions.
    """

    nodes: np.ndarray
    """Nodes of every face, (m, nodes per face), in the order of the drawing."""
    node_count: int
    """Corners, ascending by their ids, then middles of edges, then centres."""
    corner_ids: np.ndarray
    """Ids of the corners, ascending; corner i is node i."""
    facets: np.ndarray
    """Points of the flat facets, (count, dim), face after face."""
    face_of_facet: np.ndarray
    """Face of every flat facet."""
    point_count: int
    prolongation: Any
    """P, ``scipy.sparse.csr_matrix`` (points, nodes); ``None`` where points are nodes."""

    def __init__(self, faces: ArrayLike, order: int = 1, divisions: int | None = None) -> None:
        faces = np.asarray(faces)
        if faces.ndim != 2 or faces.shape[1] not in (2, 3, 4):
            raise ValueError(f"faces has shape {faces.shape}, (faces, 2 to 4 corners) is wanted")
        if order not in (1, 2):
            raise ValueError(f"the order is {order}, 1 or 2 is wanted")
        divisions = order if divisions is None else divisions
        if divisions < 1:
            raise ValueError(f"an edge cannot be divided into {divisions}")
        self.corner_ids, corners = np.unique(faces, return_inverse=True)
        self._corners = corners.reshape(faces.shape)
        self._order, self._divisions = order, divisions
        self._number_edges()
        self._number_nodes()
        self._lay_points()

    @property
    def middles(self) -> np.ndarray:
        """Corners at the two ends of the edges whose middles are nodes, (edges, 2)."""
        return self._edges

    def straight(self, corner_coords: np.ndarray) -> np.ndarray:
        """Coordinates of all nodes where faces are straight, from those of the corners."""
        parts = [corner_coords]
        if self._order == 2:
            parts.append(corner_coords[self._edges].mean(axis=1))
            if self._corners.shape[1] == 4:
                parts.append(corner_coords[self._corners].mean(axis=1))
        return np.concatenate(parts)

    def _number_edges(self) -> None:
        corners = self._corners
        if corners.shape[1] == 2:
            pairs = corners[:, None, :]
        else:
            pairs = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2)
        low, high = pairs.min(axis=2), pairs.max(axis=2)
        self._edges, inverse = np.unique(
            np.stack([low.ravel(), high.ravel()], axis=1).reshape(-1, 2), axis=0, return_inverse=True
        )
        self._edge_of = inverse.reshape(low.shape)
        self._reversed = pairs[:, :, 0] != low

    def _number_nodes(self) -> None:
        count = len(self.corner_ids)
        parts = [self._corners]
        if self._order == 2:
            parts.append(count + self._edge_of)
            count += len(self._edges)
            if self._corners.shape[1] == 4:
                parts.append(count + np.arange(len(self._corners))[:, None])
                count += len(self._corners)
        self.nodes, self.node_count = np.concatenate(parts, axis=1), count

    def _lay_points(self) -> None:
        n, faces, kind = self._divisions, len(self._corners), self._corners.shape[1]
        corner_count, edge_count = len(self.corner_ids), len(self._edges)
        at: dict[tuple[float, ...], np.ndarray] = {}
        first = corner_count
        ends = {2: [(0,), (n,)], 3: [(0, 0), (n, 0), (0, n)], 4: [(0, 0), (n, 0), (n, n), (0, n)]}[kind]
        for corner, place in enumerate(ends):
            at[place] = self._corners[:, corner]
        for edge in range(self._edge_of.shape[1]):
            begin, end = np.array(ends[edge]), np.array(ends[(edge + 1) % kind])
            for step in range(1, n):
                # Points of an edge are numbered from its lower corner.
                from_low = np.where(self._reversed[:, edge], n - step, step)
                place = tuple((begin + (end - begin) * step // n).tolist())
                at[place] = first + self._edge_of[:, edge] * (n - 1) + from_low - 1
        first += edge_count * (n - 1)
        inside = [place for place in _inside(kind, n) if place not in at]
        for number, place in enumerate(inside):
            at[place] = first + np.arange(faces) * len(inside) + number
        self.point_count = first + faces * len(inside)
        cut = [np.stack([at[corner] for corner in facet], axis=1) for facet in _flat(kind, n)]
        self.facets = np.stack(cut, axis=1).reshape(-1, len(cut[0][0]) if faces else _width(kind))
        self.face_of_facet = np.repeat(np.arange(faces), len(cut))
        self.prolongation = None
        if self.point_count != self.node_count or self._order != n:
            self.prolongation = self._prolonged(inside)

    def _prolonged(self, inside: list[tuple[float, ...]]) -> Any:
        from scipy.sparse import csr_matrix

        n, order = self._divisions, self._order
        corner_count, edge_count, faces = len(self.corner_ids), len(self._edges), len(self._corners)
        rows, cols, values = [np.arange(corner_count)], [np.arange(corner_count)], [np.ones(corner_count)]
        edge_nodes = self._edges
        if order == 2:
            edge_nodes = np.column_stack([edge_nodes, corner_count + np.arange(edge_count)])
        first = corner_count
        for step in range(1, n):
            shapes = _shapes(2, order, (step / n,))
            for node, shape in enumerate(shapes):
                rows.append(first + np.arange(edge_count) * (n - 1) + step - 1)
                cols.append(edge_nodes[:, node])
                values.append(np.full(edge_count, shape))
        first += edge_count * (n - 1)
        for number, place in enumerate(inside):
            shapes = _shapes(self._corners.shape[1], order, tuple(x / n for x in place))
            for node, shape in enumerate(shapes):
                rows.append(first + np.arange(faces) * len(inside) + number)
                cols.append(self.nodes[:, node])
                values.append(np.full(faces, shape))
        entries = np.concatenate(values)
        there = entries != 0.0
        place = np.concatenate(rows)[there], np.concatenate(cols)[there]
        return csr_matrix((entries[there], place), shape=(self.point_count, self.node_count))


def _width(kind: int) -> int:
    return 2 if kind == 2 else 3


def _inside(kind: int, n: int) -> list[tuple[float, ...]]:
    """Places of points that are not on edges, in divisions: of a triangle those of a lattice, of a quadrilateral those
    of a lattice and the centres of its squares."""
    if kind == 2:
        return []
    if kind == 3:
        return [(i, j) for j in range(1, n) for i in range(1, n - j)]
    lattice: list[tuple[float, ...]] = [(i, j) for j in range(1, n) for i in range(1, n)]
    return lattice + [(i + 0.5, j + 0.5) for j in range(n) for i in range(n)]


def _flat(kind: int, n: int) -> list[list[tuple[float, ...]]]:
    """Corners of the flat facets that a face is cut into, turned as the face."""
    if kind == 2:
        return [[(i,), (i + 1,)] for i in range(n)]
    if kind == 3:
        up = [[(i, j), (i + 1, j), (i, j + 1)] for j in range(n) for i in range(n - j)]
        down = [[(i + 1, j), (i + 1, j + 1), (i, j + 1)] for j in range(n) for i in range(n - j - 1)]
        return [list(facet) for facet in up + down]
    facets = []
    for j in range(n):
        for i in range(n):
            around = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            facets += [[around[k], around[(k + 1) % 4], (i + 0.5, j + 0.5)] for k in range(4)]
    return facets


def _shapes(kind: int, order: int, place: tuple[float, ...]) -> list[float]:
    """Shape functions of a face at a place, in the order of its nodes."""
    if kind == 3:
        u, v = place
        w = 1.0 - u - v
        corner = [w, u, v]
        if order == 1:
            return corner
        return [c * (2.0 * c - 1.0) for c in corner] + [4.0 * w * u, 4.0 * u * v, 4.0 * v * w]

    def line(s: float) -> list[float]:
        """Of the nodes at 0, 1 and, for order 2, one half."""
        return [1.0 - s, s] if order == 1 else [(1.0 - s) * (1.0 - 2.0 * s), s * (2.0 * s - 1.0), 4.0 * s * (1.0 - s)]

    if kind == 2:
        return line(place[0])
    a, b = line(place[0]), line(place[1])
    shapes = [a[0] * b[0], a[1] * b[0], a[1] * b[1], a[0] * b[1]]
    if order == 2:
        shapes += [a[2] * b[0], a[1] * b[2], a[2] * b[1], a[0] * b[2], a[2] * b[2]]
    return shapes
