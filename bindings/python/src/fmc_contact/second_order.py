"""Positions of the nodes of cells of second order, for adapters: after the corners, each in the middle of some of them.

Nodes are in the order of meshio, which is VTK's: corners, middles of edges, of quadrilateral faces, of the cell.
"""

from __future__ import annotations

import numpy as np

_TRIANGLE = [(0, 1), (1, 2), (2, 0)]
_QUAD = [(0, 1), (1, 2), (2, 3), (3, 0)]
_TETRA = [*_TRIANGLE, (0, 3), (1, 3), (2, 3)]
_HEXAHEDRON = [*_QUAD, (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
_FACES = [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)]

MIDDLES: dict[str, list[tuple[int, ...]]] = {
    "triangle6": [*_TRIANGLE],
    "quad8": [*_QUAD],
    "quad9": [*_QUAD, (0, 1, 2, 3)],
    "tetra10": [*_TETRA],
    "hexahedron20": [*_HEXAHEDRON],
    "hexahedron27": [*_HEXAHEDRON, *_FACES, (0, 1, 2, 3, 4, 5, 6, 7)],
}
"""Corners in whose middle the nodes after the corners stand where the cell is straight."""

_FACES_OF_TETRA = [(0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)]
# Points of Gauss' rule in every direction: exact to order 15 on edges.
_GAUSS = 8

_STRAIGHT = {"triangle": 3, "quad": 4, "tetra": 4, "hexahedron": 8}


def of_nodes(straight: str, nodes: int) -> str | None:
    """The cell with the corners of ``straight`` and this number of nodes, ``straight`` itself among them; ``None``
    where there is no such cell."""
    if nodes == _STRAIGHT.get(straight):
        return straight
    name = f"{straight}{nodes}"
    return name if name in MIDDLES else None


def readings(cell_type: str, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns the relation of nodes to a field of any order: places in a cell with these ``corners``, (corners, dim); and weights of the field there
    for every node, (nodes, places). Third, (faces, places), weights of sums of the field that must vanish for uniform pressure to be transferred
    exactly.

    A corner has the field's value there. The middle of an edge is set so that the edge of second order has the field's mean, and so is the middle of
    a quadrilateral face. The volume below a face, and with it uniform pressure, is then exact for a field of any order. Up to third order on edges
    this is the field in their middle. Faces of tetrahedra have no node: functions of third order on these faces cannot be read.
    """
    dim, middles = corners.shape[1], MIDDLES[cell_type]
    at, weight = np.polynomial.legendre.leggauss(_GAUSS)
    at, weight = (1 + at) / 2, weight / 2
    places: list[np.ndarray] = list(np.asarray(corners, float))
    rows: list[dict[int, float]] = [{corner: 1.0} for corner in range(len(corners))]
    edges: dict[frozenset[int], dict[int, float]] = {}

    def mean(shape: list[np.ndarray], values: np.ndarray) -> dict[int, float]:
        """A mean by places that are added."""
        first = len(places)
        places.extend(shape)
        return {first + k: value for k, value in enumerate(values)}

    def sum_of(parts: list[tuple[float, dict[int, float]]]) -> dict[int, float]:
        total: dict[int, float] = {}
        for factor, row in parts:
            for place, value in row.items():
                total[place] = total.get(place, 0.0) + factor * value
        return total

    for around in middles:
        x = corners[list(around)]
        if len(around) == 2:
            of_edge = mean([(1 - t) * x[0] + t * x[1] for t in at], weight)
            row = sum_of([(1.5, of_edge), *((-0.25, rows[corner]) for corner in around)])
            edges[frozenset(around)] = row
        elif len(around) == 4 and dim == 3:
            square = [
                (1 - s) * (1 - t) * x[0] + s * (1 - t) * x[1] + s * t * x[2] + (1 - s) * t * x[3] for s in at for t in at
            ]
            of_face = mean(square, np.outer(weight, weight).ravel())
            sides = [edges[frozenset((around[k - 1], around[k]))] for k in range(4)]
            row = sum_of([(2.25, of_face), *((-1 / 16, rows[c]) for c in around), *((-0.25, side) for side in sides)])
        else:
            row = mean([x.mean(axis=0)], np.ones(1))
        rows.append(row)
    unread = []
    for face in _FACES_OF_TETRA if cell_type == "tetra10" else ():
        x = corners[list(face)]
        triangle = [(1 - s) * x[0] + s * (1 - t) * x[1] + s * t * x[2] for s in at for t in at]
        of_face = mean(triangle, 2 * np.outer(weight * at, weight).ravel())
        sides = [edges[frozenset((face[k - 1], face[k]))] for k in range(3)]
        unread.append(sum_of([(1.0, of_face), *((-1 / 3, side) for side in sides)]))

    def dense(lines: list[dict[int, float]]) -> np.ndarray:
        found = np.zeros((len(lines), len(places)))
        for line, entries in zip(found, lines):
            line[list(entries)] = list(entries.values())
        return found

    return np.array(places), dense(rows), dense(unread)
