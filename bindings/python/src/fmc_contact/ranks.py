"""Ranks of a parallel program that share the work of a contact."""

from __future__ import annotations

from ctypes import byref, c_uint8
from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Protocol

import numpy as np

from ._library import check, library
from ._structs import fmc_all_gather, fmc_all_to_all, fmc_communicator, fmc_rank_counts

if TYPE_CHECKING:
    from ._core import Core


class Communicator(Protocol):
    """What is used of a communicator: one of mpi4py, or anything with the same three. Where it has ``Alltoallv`` too, as that has, what is
    for single ranks goes to these alone."""

    rank: int
    size: int

    def Allgatherv(self, sendbuf: object, recvbuf: object) -> None:
        """Gathers ``sendbuf`` of all ranks into ``recvbuf``, ``[buffer, (counts, displacements)]``."""


@dataclass(frozen=True)
class RankCounts:
    """What ranks did since the communicator was set: of this rank, but for ``item_count``."""

    item_count: int
    """Facets, bundles of lines, pieces of cells and pairs of facets that were divided among the ranks."""
    own_item_count: int
    """Those that this rank measured."""
    call_count: int
    """Calls of the communicator."""
    sent_bytes: int
    """Bytes that this rank sent."""
    received_bytes: int
    """Bytes that it received, its own too."""


class Ranks:
    """Ranks of a parallel program that share the work of a contact."""

    def __init__(self, core: Core) -> None:
        self._core = core

    def set_communicator(self, comm: Communicator | None) -> None:
        """Shares the work of evaluations with the ranks of ``comm``, a communicator of mpi4py (``MPI.COMM_WORLD``, or
        ``mesh.comm`` of dolfinx); ``None``: no more. From then on every rank makes the same calls with the same coordinates,
        options, obstacles and history, and gets the whole result, with the bits of one rank alone.

        An evaluation that fails on one rank fails on all, with ``OnOtherRankError`` there; ranks that were given different
        things are all told so, by ``RanksDifferError``. Errors: ``BadRankError``, ``BusyError``."""
        if comm is None:
            with self._core.handle:
                self._core.handle.call(library.fmc_context_set_communicator, None)
                self._core.handle.release("communicator")
            return
        given = described(comm, self._core.handle.guarded)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_communicator, byref(given))
            self._core.handle.keep("communicator", (given.all_gather, given.all_to_all))

    def counts(self) -> RankCounts:
        """What was shared since the communicator was set; zeros without one. Errors: ``BusyError``."""
        counts = fmc_rank_counts()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_rank_counts, byref(counts))
        return RankCounts(*(getattr(counts, name) for name, _ in counts._fields_))


def described(comm: Communicator, guard: Callable[[Callable[..., None]], Callable[..., int]]) -> fmc_communicator:
    """A communicator as the library takes it; its functions are guarded by ``guard``, and kept by the caller."""
    rank, size = int(comm.rank), int(comm.size)

    def gather(_user: object, send: int, counts: object, received: int) -> None:
        every, places = _counts(counts, size)
        comm.Allgatherv(_bytes(send, every[rank]), [_bytes(received, every.sum()), (every, places)])

    def to_single(_user: object, send: int, to: object, received: int, given: object) -> None:
        to, given = _counts(to, size), _counts(given, size)
        comm.Alltoallv([_bytes(send, to[0].sum()), to], [_bytes(received, given[0].sum()), given])

    given = fmc_communicator()
    check(library.fmc_communicator_init(byref(given)))
    given.rank, given.size = rank, size
    given.all_gather = fmc_all_gather(guard(gather))
    if hasattr(comm, "Alltoallv"):
        given.all_to_all = fmc_all_to_all(guard(to_single))
    return given


def _counts(counts: object, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Bytes of every rank, and where they begin."""
    every = np.ctypeslib.as_array(counts, (size,)).astype(np.int64)
    return every, np.concatenate([[0], np.cumsum(every)[:-1]])


def _bytes(address: int | None, count: int) -> np.ndarray:
    """The bytes at an address."""
    if not count:
        return np.empty(0, np.uint8)
    return np.ctypeslib.as_array((c_uint8 * int(count)).from_address(address))
