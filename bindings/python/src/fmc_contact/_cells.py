"""Types of cells and facets by the names of meshio: values of ``fmc_cell_type`` and ``fmc_facet_type``, nodes, dimensions."""

from __future__ import annotations

from . import _constants as c

_CELLS = {
    "triangle": (c.FMC_TRI3, 3, 2),
    "quad": (c.FMC_QUAD4, 4, 2),
    "tetra": (c.FMC_TET4, 4, 3),
    "hexahedron": (c.FMC_HEX8, 8, 3),
    "wedge": (c.FMC_WEDGE6, 6, 3),
    "pyramid": (c.FMC_PYRAMID5, 5, 3),
    "triangle6": (c.FMC_TRI6, 6, 2),
    "quad8": (c.FMC_QUAD8, 8, 2),
    "tetra10": (c.FMC_TET10, 10, 3),
    "hexahedron20": (c.FMC_HEX20, 20, 3),
    "wedge15": (c.FMC_WEDGE15, 15, 3),
    "pyramid13": (c.FMC_PYRAMID13, 13, 3),
    "quad9": (c.FMC_QUAD9, 9, 2),
    "hexahedron27": (c.FMC_HEX27, 27, 3),
}
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
