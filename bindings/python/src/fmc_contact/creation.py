"""Cells and facets, as the library takes them."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import byref
from typing import Any, NamedTuple, Optional, Union, cast

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import View, coords_view, flat_in_z, indices, of_one_width
from ._cells import CELL_DIMENSION, CELL_NODES, CELL_TYPES, FACET_DIMENSION, FACET_NODES, FACET_TYPES
from ._handle import Handle
from ._library import library
from ._structs import fmc_cell_block, fmc_facet_block, fmc_options
from .errors import EmptyError, UnknownCellTypeError

Cells = Union[ArrayLike, Sequence[tuple[str, ArrayLike]]]
"""Node numbers (m, nodes per cell); or, without a cell type, a list of ``(cell type, node numbers)``. The same of facets."""


class Start(NamedTuple):
    """A context, and properties fixed by its mesh."""

    handle: Handle
    dim: int
    is_columns: bool


def named_blocks(conn: Cells, cell_type: str | None) -> list[tuple[str, ArrayLike]]:
    """Cells with their types."""
    if cell_type is not None:
        return [(cell_type, cast(ArrayLike, conn))]
    blocks: list[Any] = list(conn) if isinstance(conn, (list, tuple)) else [conn]
    for block in blocks:
        if not isinstance(block, (list, tuple)) or len(block) != 2 or not isinstance(block[0], str):
            raise TypeError("give cell_type with conn, or a list of (cell type, node numbers) for a mixed mesh")
    return blocks


def blocks(conn: Cells, cell_type: str | None) -> list[tuple[str, np.ndarray]]:
    named = named_blocks(conn, cell_type)
    if not named:
        raise EmptyError("there are no cells and no facets")
    for name, _ in named:
        if name not in CELL_TYPES:
            raise UnknownCellTypeError(f"no cell type {name!r}; there are {', '.join(CELL_TYPES)}")
    return [(name, indices(cells, "conn", CELL_NODES[name])) for name, cells in named]


def _body_ids(bodies: ArrayLike | None, count: int, what: str) -> list[np.ndarray]:
    if bodies is None:
        return []
    ids = indices(bodies, "bodies")
    if len(ids) != count:
        raise ValueError(f"bodies has shape {ids.shape}, expected ({count},), one number for each of the {what}")
    return [ids]


def _check_plane(flat: bool) -> None:
    if not flat:
        raise ValueError(
            "coords vary in z, but these cells are plane: pass a surface in 3D to Contact.from_facets, "
            "and a plane mesh without its z, coords[:, :2]"
        )


def from_cells(
    coords: ArrayLike, conn: Cells, cell_type: Optional[str], bodies: Optional[ArrayLike], options: fmc_options
) -> Start:
    """A context from cells; the library finds their boundary."""
    named = blocks(conn, cell_type)
    dim = CELL_DIMENSION[named[0][0]]
    view = coords_view(coords, dim)
    _check_plane(dim == 3 or flat_in_z(view))
    return _start(named, _CELLS, dim, view, bodies, options)


class _Kind(NamedTuple):
    """Kind of the entries of blocks: cells or facets."""

    what: str
    types: dict[str, int]
    block: Any
    function: str


_CELLS = _Kind("cells", CELL_TYPES, fmc_cell_block, "fmc_context_new_from_cells")
_FACETS = _Kind("facets", FACET_TYPES, fmc_facet_block, "fmc_context_new_from_facets")


def _start(
    named: list[tuple[str, np.ndarray]],
    kind: _Kind,
    dim: int,
    view: View,
    bodies: ArrayLike | None,
    options: fmc_options,
) -> Start:
    arrays = [conn for _, conn in named]
    *arrays, ids = of_one_width(arrays + (_body_ids(bodies, sum(map(len, arrays)), kind.what) or [arrays[0]]))
    function, size = getattr(library, kind.function), ids.itemsize
    structs = [kind.block(kind.types[name], size, conn.ctypes.data, len(conn)) for (name, _), conn in zip(named, arrays)]
    array = (kind.block * len(structs))(*structs)
    first = dim, byref(view.struct), array, len(structs), None if bodies is None else ids, byref(options)
    return Start(Handle(lambda to: function(*first, to), ids.dtype), dim, view.is_columns)


def _facet_blocks(facets: Cells, facet_type: str | None) -> list[tuple[str, np.ndarray]]:
    """Facets with their types; none where edges or triangles are given without a type."""
    if facet_type is not None:
        named: list[Any] = [(facet_type, facets)]
    elif isinstance(facets, (list, tuple)) and facets and all(_is_named(block) for block in facets):
        named = list(facets)
    else:
        return []
    for name, _ in named:
        if name not in FACET_TYPES:
            raise UnknownCellTypeError(f"no facet type {name!r}; there are {', '.join(FACET_TYPES)}")
    return [(name, indices(conn, "facets", FACET_NODES[name])) for name, conn in named]


def _is_named(block: object) -> bool:
    return isinstance(block, (list, tuple)) and len(block) == 2 and isinstance(block[0], str)


def _unnamed(facets: ArrayLike) -> list[tuple[str, np.ndarray]]:
    """Edges or triangles without a type."""
    shape = np.shape(facets)
    if len(shape) != 2 or shape[1] not in (2, 3):
        raise ValueError(
            f"facets has shape {shape}, expected (facets, 2) for edges or (facets, 3) for triangles; of other types "
            "give the type, or a list of (facet type, node numbers)"
        )
    return [("line" if shape[1] == 2 else "triangle", indices(facets, "facets", shape[1]))]


def from_facets(
    coords: ArrayLike, facets: Cells, facet_type: Optional[str], bodies: Optional[ArrayLike], options: fmc_options
) -> Start:
    """A context from the facets of closed bodies."""
    named = _facet_blocks(facets, facet_type) or _unnamed(cast(ArrayLike, facets))
    dim = FACET_DIMENSION[named[0][0]]
    view = coords_view(coords, dim)
    _check_plane(dim == 3 or flat_in_z(view))
    return _start(named, _FACETS, dim, view, bodies, options)
