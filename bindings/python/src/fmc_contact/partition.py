"""Contact of a mesh that the ranks of a parallel program hold in parts."""

from __future__ import annotations

from ctypes import POINTER, byref, c_int32, c_size_t, cast
from dataclasses import dataclass, fields
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import creation
from ._arrays import coords_view, numbers, shape_error, structured
from ._cells import CELL_DIMENSION, CELL_TYPES
from ._handle import Handle, guarded
from ._library import check, library
from ._structs import fmc_carried_slip, fmc_cell_block, fmc_gathered_counts, fmc_mesh_part, fmc_options
from ._unpack import Unpack
from .contact import Contact
from .errors import UnsupportedError
from .friction import FrictionSteps
from .mesh import Mesh
from .options import OtherOptions, changed, defaults
from .ranks import Communicator, described

CARRIED_SLIP = np.dtype(
    [
        ("cell", np.int64),
        ("face", np.int32),
        ("part", np.int32),
        ("partner_kind", np.int32),
        ("is_second", np.int32),
        ("partner", np.uint64),
        ("slip", np.float64, 3),
        ("slid", np.float64),
    ]
)
"""Elastic slip of a boundary facet against what it faced: number of its cell in the whole mesh, face of that cell as VTK counts them,
which of the facets of that face; 0 for a body and 1 for an obstacle, whether the facet's body is the second of that pair, index of what
it faced; the slip, whose last entry is 0 in 2D, and how far it has slid since it rested."""


@dataclass(frozen=True)
class GatheredCounts:
    """Gathered part of a mesh in parts: the same on all ranks, except for the own cells.

    Attributes
    ----------
    node_count, cell_count, facet_count : int
        Nodes, cells and boundary facets that every rank has.
    whole_facet_count : int
        Boundary facets of the whole mesh.
    own_cell_count : int
        Cells that this rank gave.
    gather_count : int
        Number of times that cells were gathered.

    Examples
    --------
    >>> partitioned.gathered().own_cell_count
    2
    """

    node_count: int
    cell_count: int
    facet_count: int
    whole_facet_count: int
    own_cell_count: int
    gather_count: int


class PartitionedFriction(FrictionSteps):
    """Steps with friction of a contact in parts, whose facets have other numbers whenever other cells are gathered.

    Examples
    --------
    >>> partitioned.friction.begin_step(partitioned.coords)
    """

    @property
    def carried_slip(self) -> np.ndarray:
        """Elastic slip carried into the step, where it is not zero: a structured array of type ``CARRIED_SLIP``, (m,).

        It is the same on all ranks. A restart on any number of ranks needs it, and the coordinates and poses at which the step began. Call
        ``begin_step`` there, then set it, the same on all ranks. Facets that are not listed have none.

        Raises
        ------
        NoStepError
            If no step has begun.
        NonFiniteSlipError, IndexOutOfRangeError, UnsupportedError
            On setting: if an entry is not finite, a row names an index that does not exist, or a facet was not gathered.

        Examples
        --------
        >>> partitioned.friction.begin_step(partitioned.coords)
        >>> len(partitioned.friction.carried_slip)
        0
        """
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_carried_slip, None, 0, byref(count))
            found = np.zeros(count.value, CARRIED_SLIP)
            self._core.handle.call(library.fmc_context_carried_slip, _slips(found), len(found), byref(count))
        return found

    @carried_slip.setter
    def carried_slip(self, carried: np.ndarray) -> None:
        rows = structured(carried, CARRIED_SLIP, "carried_slip")
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_carried_slip, _slips(rows), len(rows))


class PartitionedMesh(Mesh):
    """The mesh of a contact in parts, whose facets have other numbers whenever other cells are gathered.

    Examples
    --------
    >>> partitioned.mesh.set_symmetry_planes([((0.0, 0.0), (1.0, 0.0))])
    """

    def set_symmetry_facets(self, facets: ArrayLike, coords: ArrayLike) -> None:
        """Raises ``UnsupportedError``: set planes, the same on all ranks, or name own nodes.

        Parameters
        ----------
        facets, coords : array_like
            As for ``Mesh.set_symmetry_facets``.

        Raises
        ------
        UnsupportedError
            Always.

        Examples
        --------
        >>> partitioned.mesh.set_symmetry_planes([])
        """
        raise UnsupportedError("facets in planes of symmetry of a mesh in parts: set the planes, the same on all ranks, or name own nodes")


class PartitionedContact(Contact):
    """Contact of a mesh of which every rank has a part. All ranks make the same calls.

    ``set_coords`` takes the current coordinates of the own nodes. Afterwards this is a contact of the cells that may be in contact, which all ranks
    have. Results are bit-for-bit identical to one rank with the whole mesh. Hanging nodes, a basis, another reference and another communicator raise
    ``UnsupportedError``.

    Parameters
    ----------
    comm : Communicator
        A communicator of mpi4py.
    coords : array_like, (own nodes, dim) or (dim, own nodes)
        Undeformed coordinates of the nodes of the own cells.
    conn : array_like of int, (own cells, nodes per cell), or list of (cell type, array)
        Own cells, as for ``Contact``. Every cell belongs to one rank.
    cell_type : str, optional
        As for ``Contact``.
    node_numbers : array_like of int, (own nodes,)
        Numbers of the nodes in the whole mesh, the same on all ranks that have them.
    cell_numbers : array_like of int, (own cells,)
        Numbers of the cells in the whole mesh.
    bodies : array_like of int, (own cells,)
        Body of every cell.
    stiffness : float
        Stiffness k > 0 of the law.
    reach : float
        Largest reach of ``gap_constraints`` (length).
    **options : OtherOptions
        See ``Options``.

    Attributes
    ----------
    friction : PartitionedFriction
        Steps with friction.
    coords : ndarray, (n, dim)
        Coordinates of the nodes gathered: for ``evaluate`` and all other methods.
    nodes : ndarray of int64, (n,)
        Numbers of the nodes gathered in the whole mesh, ascending.
    own_nodes : ndarray of int32, (n,)
        The own node of each, counted from 0; -1 for a node of other ranks alone.

    Raises
    ------
    FmcError, TypeError, ValueError
        As ``Contact`` raises. ``OnOtherRankError`` if another rank failed.

    Examples
    --------
    >>> partitioned.set_coords(coords)
    False
    >>> result = partitioned.evaluate(partitioned.coords)
    >>> own_forces = partitioned.on_own_nodes(result.forces)
    """

    friction: PartitionedFriction
    coords: np.ndarray
    nodes: np.ndarray
    own_nodes: np.ndarray

    def __init__(
        self,
        comm: Communicator,
        coords: ArrayLike,
        conn: creation.Cells,
        cell_type: Optional[str] = None,
        *,
        node_numbers: ArrayLike,
        cell_numbers: ArrayLike,
        bodies: ArrayLike,
        stiffness: float,
        reach: float = 0.0,
        **options: Unpack[OtherOptions],
    ) -> None:
        own = changed(defaults(), {"stiffness": stiffness, **options})
        named = creation.blocks(conn, cell_type)
        dim = CELL_DIMENSION[named[0][0]]
        view = coords_view(coords, dim)
        count = sum(len(cells) for _, cells in named)
        of_nodes = numbers(node_numbers, "node_numbers", view.node_count)
        of_cells, ids = numbers(cell_numbers, "cell_numbers", count), numbers(bodies, "bodies", count)
        # All ranks have numbers of one width, whatever their cells are like.
        arrays = [conn.astype(np.int64, copy=False) for _, conn in named]
        structs = [fmc_cell_block(CELL_TYPES[name], 8, conn.ctypes.data, len(conn)) for (name, _), conn in zip(named, arrays)]
        part = fmc_mesh_part()
        check(library.fmc_mesh_part_init(byref(part)))
        part.coords, part.index_size, part.reach = view.struct, 8, reach
        part.node_numbers, part.cell_numbers, part.body_ids = (one.ctypes.data for one in (of_nodes, of_cells, ids))
        part.blocks, part.block_count = (fmc_cell_block * len(structs))(*structs), len(structs)
        raised: list[BaseException] = []
        ranks = described(comm, lambda function: guarded(function, raised))
        first = dim, byref(ranks), byref(part), byref(own)
        handle = Handle(lambda to: library.fmc_context_new_from_part(*first, to), ids.dtype, raised)
        handle.keep("communicator", (ranks.all_gather, ranks.all_to_all))
        self._own_node_count = view.node_count
        self._take(creation.Start(handle, dim, view.is_columns), own)
        self._read_nodes()

    def set_coords(self, coords: ArrayLike) -> bool:
        """Sets the current coordinates of the own nodes. Slip, kept patches and frozen friction are carried over.

        Parameters
        ----------
        coords : array_like, (own nodes, dim) or (dim, own nodes)
            Current coordinates.

        Returns
        -------
        bool
            Whether other cells were gathered: nodes, facets and cells then have other numbers.

        Raises
        ------
        RanksDifferError
            If a node is in two places.
        OnOtherRankError, CommunicationError
            If another rank failed, or the communicator.
        FmcError
            As ``Contact.evaluate`` raises for coordinates.

        Examples
        --------
        >>> partitioned.set_coords(coords)
        False
        """
        view, renumbered = coords_view(coords, self.dim), c_int32()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_coords, byref(view.struct), byref(renumbered))
        if renumbered.value:
            self._core.count()
        self._read_nodes()
        return bool(renumbered.value)

    def on_own_nodes(self, values: ArrayLike) -> np.ndarray:
        """Values at the nodes gathered, such as forces, at the own nodes of this rank; 0 elsewhere.

        Every rank that has a node gets its value.

        Parameters
        ----------
        values : array_like, (n, ...)
            Values at the nodes gathered.

        Returns
        -------
        ndarray, (own nodes, ...)
            Values at the own nodes.

        Raises
        ------
        ValueError
            If there are not n rows.

        Examples
        --------
        >>> partitioned.on_own_nodes(np.ones(len(partitioned.nodes)))
        array([1., 1., 1., 1., 1., 1., 1., 1.])
        """
        gathered = np.asarray(values)
        if gathered.shape[:1] != self.own_nodes.shape:
            raise shape_error("values", gathered.shape, f"({len(self.own_nodes)}, ...)")
        found = np.zeros((self._own_node_count, *gathered.shape[1:]), gathered.dtype)
        is_own = self.own_nodes >= 0
        found[self.own_nodes[is_own]] = gathered[is_own]
        return found

    def gathered(self) -> GatheredCounts:
        """Size of the gathered part.

        Returns
        -------
        GatheredCounts
            Numbers of nodes, cells and facets.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> partitioned.gathered().node_count
        8
        """
        counts = fmc_gathered_counts()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_gathered_counts, byref(counts))
        return GatheredCounts(*(getattr(counts, field.name) for field in fields(GatheredCounts)))

    def gathered_cells(self) -> np.ndarray:
        """Numbers in the whole mesh of the cells gathered.

        Returns
        -------
        ndarray of int64
            Ascending.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> partitioned.gathered_cells()
        array([0, 1])
        """
        cells = np.empty(self.gathered().cell_count, np.int64)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_gathered_cells, cells, len(cells), None)
        return cells

    def _take(self, start: creation.Start, options: fmc_options) -> None:
        super()._take(start, options)
        self.mesh, self.friction = PartitionedMesh(self._core), PartitionedFriction(self._core)

    def _read_nodes(self) -> None:
        count, base = self.node_count, self._core.options.index_base
        self.nodes, own = np.empty(count, np.int64), np.empty(count, np.int64)
        self.coords = np.empty((count, self.dim))
        with self._core.handle:
            self._core.handle.call(library.fmc_context_gathered_nodes, self.nodes, own, self.coords, count, None)
        self.own_nodes = np.where(own < 0, own, own - base).astype(np.int32)


def _slips(array: np.ndarray) -> Any:
    return cast(array.ctypes.data, POINTER(fmc_carried_slip))
