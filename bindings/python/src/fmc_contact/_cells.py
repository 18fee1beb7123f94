"""Types of cells and facets by the names of meshio: values of ``fmc_cell_type`` and ``fmc_facet_type``, nodes, dimensions."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from . import _constants as c

_FAMILIES = {
    "tri": ("triangle", 3, 2), "quad": ("quad", 4, 2), "tet": ("tetra", 4, 3), "hex": ("hexahedron", 8, 3),
    "wedge": ("wedge", 6, 3), "pyramid": ("pyramid", 5, 3),
}  # fmt: skip
"""Name, number of corners and dimension of the cells whose names in C begin with the key and end with the number of nodes."""


def _cells() -> Iterator[tuple[str, tuple[int, int, int]]]:
    for number, in_c in c.FMC_CELL_TYPE.items():
        name, corners, dim = _FAMILIES[in_c.rstrip("0123456789")]
        nodes = int(in_c[len(in_c.rstrip("0123456789")) :])
        yield name if nodes == corners else f"{name}{nodes}", (number, nodes, dim)


_CELLS = dict(_cells())
_FACETS = {
    "line": (c.FMC_FACET_LINE2, 2, 2),
    "triangle": (c.FMC_FACET_TRI3, 3, 3),
    "quad": (c.FMC_FACET_QUAD4, 4, 3),
    "line3": (c.FMC_FACET_LINE3, 3, 2),
    "triangle6": (c.FMC_FACET_TRI6, 6, 3),
    "quad8": (c.FMC_FACET_QUAD8, 8, 3),
    "quad9": (c.FMC_FACET_QUAD9, 9, 3),
}

CELL_TYPES = {name: number for name, (number, _, _) in _CELLS.items()}
CELL_NODES = {name: nodes for name, (_, nodes, _) in _CELLS.items()}
CELL_DIMENSION = {name: dim for name, (_, _, dim) in _CELLS.items()}

FACET_TYPES = {name: number for name, (number, _, _) in _FACETS.items()}
FACET_NODES = {name: nodes for name, (_, nodes, _) in _FACETS.items()}
FACET_DIMENSION = {name: dim for name, (_, _, dim) in _FACETS.items()}

_FACES = {
    "triangle": "01 12 20", "quad": "01 12 23 30", "tetra": "013 123 203 021", "hexahedron": "0473 1265 0154 3762 0321 4567",
    "wedge": "012 354 0341 1452 2530", "pyramid": "0321 014 124 234 304",
}  # fmt: skip
"""Corners of the faces of cells, as ``BoundaryFacets.local_face`` counts them."""


def face_corners(cell_type: str) -> list[list[int]]:
    """The same for a type without middle nodes."""
    return [list(map(int, corners)) for corners in _FACES[cell_type].split()]


def face_numbers(cell_type: str, is_corner: np.ndarray) -> np.ndarray:
    """Numbers of faces in cells of a type without middle nodes, by which of a cell's corners are theirs: (faces, corners) of bool."""
    faces = [np.isin(np.arange(is_corner.shape[1]), corners) for corners in face_corners(cell_type)]
    same = (is_corner[:, None] == np.array(faces)).all(axis=2)
    if not same.any(axis=1).all():
        raise ValueError(f"face {int(np.argmin(same.any(axis=1)))} is no face of a {cell_type}")
    numbers: np.ndarray = np.argmax(same, axis=1)
    return numbers
