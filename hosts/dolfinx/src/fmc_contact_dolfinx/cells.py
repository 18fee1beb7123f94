"""Cells as dolfinx and as ``fmc_contact`` count their nodes."""

from __future__ import annotations

import basix
import numpy as np
from fmc_contact._cells import face_numbers
from fmc_contact.second_order import MIDDLES

# dolfinx counts the corners of quadrilaterals, hexahedra and the base of pyramids as a tensor product; VTK goes around.
# Prisms are counted as meshio counts wedges.
#
#      2-----3          3-----2          6-----7            7-----6
#      |     |          |     |         /|    /|           /|    /|
#      |     |          |     |        4-----5 |          4-----5 |
#      0-----1          0-----1        | 2---|-3          | 3---|-2
#      dolfinx          VTK            |/    |/           |/    |/
#                                      0-----1            0-----1
#
# Entry k is the corner of VTK that dolfinx counts as its k-th; both tables are their own inverse.
TENSOR_ORDER = {
    "triangle": [0, 1, 2],
    "quad": [0, 1, 3, 2],
    "tetra": [0, 1, 2, 3],
    "hexahedron": [0, 1, 3, 2, 4, 5, 7, 6],
    "wedge": [0, 1, 2, 3, 4, 5],
    "pyramid": [0, 1, 3, 2, 4],
}

CELL_TYPES = {
    "triangle": "triangle",
    "quadrilateral": "quad",
    "tetrahedron": "tetra",
    "hexahedron": "hexahedron",
    "prism": "wedge",
    "pyramid": "pyramid",
}

SECOND_ORDER = {
    "triangle": "triangle6",
    "quadrilateral": "quad9",
    "tetrahedron": "tetra10",
    "hexahedron": "hexahedron27",
}
"""Cells of second order whose nodes are those of Lagrange elements."""


def places(kind: str, cell_type: str) -> list[tuple[int, int]]:
    """Dimension and number of the entity of basix' cell on which every node of ``cell_type`` lies, in the order of ``fmc_contact``."""
    corners = TENSOR_ORDER[CELL_TYPES[kind]]
    numbers = {}
    for dim, entities in enumerate(basix.topology(getattr(basix.CellType, kind))):
        numbers.update({frozenset(ends): (dim, number) for number, ends in enumerate(entities)})
    middles = [numbers[frozenset(corners[k] for k in around)] for around in MIDDLES.get(cell_type, [])]
    return [(0, corner) for corner in corners] + middles


def sorted_places(kind: str, cell_type: str) -> list[int]:
    """The nodes of ``cell_type`` in the order of the entities of basix' cell."""
    found = places(kind, cell_type)
    return sorted(range(len(found)), key=found.__getitem__)


def faces(kind: str) -> np.ndarray:
    """The number that ``fmc_contact`` gives every facet of basix' cell."""
    corners = np.array(TENSOR_ORDER[CELL_TYPES[kind]])
    facets = basix.topology(getattr(basix.CellType, kind))[-2]
    is_corner = np.array([np.isin(np.arange(len(corners)), corners[list(ends)]) for ends in facets])
    return face_numbers(CELL_TYPES[kind], is_corner)
