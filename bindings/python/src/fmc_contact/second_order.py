"""Where the nodes of cells of second order stand, for adapters: after the corners, each in the middle of some of them.

Nodes are in the order of meshio, which is that of VTK: corners, middles of edges, of quadrilateral faces, of the cell.
"""

from __future__ import annotations

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

_STRAIGHT = {"triangle": 3, "quad": 4, "tetra": 4, "hexahedron": 8}


def of_nodes(straight: str, nodes: int) -> str | None:
    """The cell with the corners of ``straight`` and this number of nodes, ``straight`` itself among them; ``None``
    where there is no such cell."""
    if nodes == _STRAIGHT.get(straight):
        return straight
    name = f"{straight}{nodes}"
    return name if name in MIDDLES else None
