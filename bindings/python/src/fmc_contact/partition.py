"""Contact of a mesh that the ranks of a parallel program hold in parts."""

from __future__ import annotations

from ctypes import POINTER, byref, c_int32, c_size_t, cast, sizeof
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from . import creation
from ._arrays import coords_view
from ._cells import CELL_DIMENSION, CELL_TYPES
from ._core import Core
from ._handle import Handle, guarded
from ._library import library
from ._structs import fmc_carried_slip, fmc_cell_block, fmc_gathered_counts, fmc_mesh_part, fmc_options
from .contact import Contact
from .friction import FrictionSteps
from .options import Options, changed, defaults
from .ranks import Communicator, described

if TYPE_CHECKING:
    from typing_extensions import Unpack

CARRIED_SLIP = np.dtype([("cell", np.int64), ("face", np.int32), ("part", np.int32), ("slip", np.float64, 3)])
"""Elastic slip of a boundary facet: number of its cell in the whole mesh, face of that cell as VTK counts them, which of the
facets of that face, and the slip; in 2D its last entry is 0."""


@dataclass(frozen=True)
class GatheredCounts:
    """How much of a mesh in parts was gathered: the same on all ranks, but for the own cells."""

    node_count: int
    """Nodes that every rank has."""
    cell_count: int
    """Cells that every rank has."""
    facet_count: int
    """Boundary facets that every rank has."""
    whole_facet_count: int
    """Boundary facets of the whole mesh."""
    own_cell_count: int
    """Cells that this rank gave."""
    gather_count: int
    """How often cells were gathered."""


class PartitionedFriction(FrictionSteps):
    """Friction of a contact in parts, whose facets have other numbers whenever other cells are gathered."""

    @property
    def carried_slip(self) -> np.ndarray:
        """The elastic slip that was carried into the step, of all facets where it is not zero, as ``CARRIED_SLIP``; the same on
        all ranks. With the coordinates and poses at which the step began it is all that a restart needs, on any number of ranks:
        ``begin_step`` there, then set it, on all ranks the same; it is zero for facets that are not listed. Errors:
        ``NoStepError``; on setting ``NonFiniteSlipError`` and ``UnsupportedError`` for a facet that was not gathered."""
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_carried_slip, None, 0, byref(count))
            found = np.zeros(count.value, CARRIED_SLIP)
            self._core.handle.call(library.fmc_context_carried_slip, _slips(found), len(found), byref(count))
        return found

    @carried_slip.setter
    def carried_slip(self, carried: np.ndarray) -> None:
        given = np.ascontiguousarray(carried, CARRIED_SLIP)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_carried_slip, _slips(given), len(given))


class PartitionedContact(Contact):
    """Contact of a mesh of which every rank of ``comm``, a communicator of mpi4py, has a part.

    A rank gives its own cells, ``conn`` with ``cell_type`` as a ``Contact`` takes them, and the coordinates of their nodes
    without deformation. ``node_numbers`` are the numbers of these nodes in the whole mesh, the same on all ranks that have
    them, ``cell_numbers`` those of the cells, ``bodies`` the body of each cell. Every cell belongs to one rank. ``reach``: how
    far ``gap_constraints`` may reach. All ranks make the same calls.

    ``set_coords`` takes the current coordinates of the own nodes. After it this is the contact of the cells that may be in contact,
    which all ranks have: ``coords`` are the coordinates of their nodes, for ``evaluate`` and all other methods, ``nodes`` their
    numbers in the whole mesh, and ``own_nodes`` the own node of each, -1 where there is none. Results have the bits of one rank
    with the whole mesh.

    ::

        contact.set_coords(own_coords)
        result = contact.evaluate(contact.coords)
        own_forces = contact.on_own_nodes(result.forces)

    Nodes that hang, a basis, another reference and another communicator raise ``UnsupportedError``.
    """

    friction: PartitionedFriction
    """Steps with friction, and the elastic slip that is carried from one to the next."""
    coords: np.ndarray
    """Coordinates of the nodes gathered, (n, dim)."""
    nodes: np.ndarray
    """Their numbers in the whole mesh, ascending, int64."""
    own_nodes: np.ndarray
    """The own node of each, int32; -1 for a node of other ranks alone."""

    def __init__(
        self,
        comm: Communicator,
        coords: ArrayLike,
        conn: creation.Cells,
        cell_type: str | None = None,
        *,
        node_numbers: ArrayLike,
        cell_numbers: ArrayLike,
        bodies: ArrayLike,
        stiffness: float,
        reach: float = 0.0,
        **options: Unpack[Options],
    ) -> None:
        own = changed(defaults(), {"stiffness": stiffness, **options})
        blocks = [(name, np.ascontiguousarray(cells, np.int32)) for name, cells in creation.named_blocks(conn, cell_type)]
        dim = CELL_DIMENSION[blocks[0][0]]
        view = coords_view(coords, dim)
        numbers = _numbers(node_numbers, "node_numbers", view.node_count, np.int64)
        count = sum(len(cells) for _, cells in blocks)
        cells = _numbers(cell_numbers, "cell_numbers", count, np.int64)
        ids = _numbers(bodies, "bodies", count, np.int32)
        structs = [fmc_cell_block(CELL_TYPES[name], cells.ctypes.data, len(cells)) for name, cells in blocks]
        part = fmc_mesh_part(
            sizeof(fmc_mesh_part),
            view.struct,
            numbers.ctypes.data,
            (fmc_cell_block * len(structs))(*structs),
            len(structs),
            cells.ctypes.data,
            ids.ctypes.data,
            reach,
        )
        raised: list[BaseException] = []
        ranks = described(comm, lambda function: guarded(function, raised))
        new = library.fmc_context_new_from_part
        handle = Handle(lambda to: new(dim, byref(ranks), byref(part), byref(own), to), raised)
        handle.keep("communicator", (ranks.all_gather, ranks.all_to_all))
        self._own_node_count = view.node_count
        self._take(creation.Start(handle, dim, view.is_columns), own)
        self._read_nodes()

    def set_coords(self, coords: ArrayLike) -> bool:
        """Brings the mesh to coordinates of the own nodes. Returns whether other cells were gathered: nodes, facets and cells
        then have other numbers. Slip, kept patches and frozen friction are carried over. Errors: ``LengthError``,
        ``NonFiniteCoordinateError``, ``InvertedCellError``, ``ZeroMeasureError``, ``OnOtherRankError``,
        ``RanksDifferError`` for a node in two places, ``CommunicationError``, ``BusyError``."""
        view, renumbered = coords_view(coords, self.dim), c_int32()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_bring, byref(view.struct), byref(renumbered))
        if renumbered.value:
            self._core.count()
        self._read_nodes()
        return bool(renumbered.value)

    def on_own_nodes(self, values: np.ndarray) -> np.ndarray:
        """Values at the nodes gathered, as forces, at the own nodes of this rank; 0 elsewhere. What is on a node of several
        ranks is given to all of them."""
        found = np.zeros((self._own_node_count, *values.shape[1:]), values.dtype)
        is_own = self.own_nodes >= 0
        found[self.own_nodes[is_own]] = values[is_own]
        return found

    def gathered(self) -> GatheredCounts:
        """How much was gathered."""
        counts = fmc_gathered_counts()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_gathered_counts, byref(counts))
        return GatheredCounts(*(getattr(counts, name) for name, _ in counts._fields_))

    def gathered_cells(self) -> np.ndarray:
        """Numbers in the whole mesh of the cells gathered, ascending."""
        numbers = np.empty(self.gathered().cell_count, np.int64)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_gathered_cells, numbers, len(numbers))
        return numbers

    def _take(self, start: creation.Start, options: fmc_options) -> None:
        super()._take(start, options)
        self.friction = PartitionedFriction(self._core)

    def _read_nodes(self) -> None:
        count, base = self.node_count, self._core.options.index_base
        self.nodes, own = np.empty(count, np.int64), np.empty(count, np.int32)
        self.coords = np.empty((count, self.dim))
        with self._core.handle:
            self._core.handle.call(library.fmc_context_gathered_nodes, self.nodes, own, self.coords, count)
        self.own_nodes = own - np.int32(base)


def _slips(array: np.ndarray) -> object:
    return cast(array.ctypes.data, POINTER(fmc_carried_slip))


def _numbers(given: ArrayLike, name: str, count: int, kind: type) -> np.ndarray:
    numbers = np.ascontiguousarray(given if np.size(given) else [], dtype=kind).reshape(-1)
    if len(numbers) != count:
        raise ValueError(f"{name} has {len(numbers)} entries, and {count} are expected")
    return numbers
