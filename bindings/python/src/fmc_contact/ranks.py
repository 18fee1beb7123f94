"""Ranks of a parallel program that share the work of a contact."""

from __future__ import annotations

from ctypes import byref, c_uint8
from dataclasses import dataclass, fields
from typing import Any, Callable, Optional, Protocol

import numpy as np

from ._core import Core
from ._library import check, library
from ._structs import fmc_all_gather, fmc_all_to_all, fmc_communicator, fmc_rank_counts


class Communicator(Protocol):
    """The required part of a communicator: one of mpi4py, or any object with these three.

    If it has ``Alltoallv`` too, as communicators of mpi4py have, messages for single ranks go to these alone.

    Attributes
    ----------
    rank, size : int
        Number of this rank, and of all ranks.
    """

    rank: int
    size: int

    def Allgatherv(self, sendbuf: Any, recvbuf: Any) -> Any:
        """Gathers ``sendbuf`` of all ranks into ``recvbuf``, ``[buffer, (counts, displacements)]``."""


@dataclass(frozen=True)
class RankCounts:
    """Work since the communicator was set: of this rank, except ``item_count``.

    Attributes
    ----------
    item_count : int
        Facets, bundles of lines, pieces of cells and pairs of facets that were divided among the ranks.
    own_item_count : int
        Those that this rank measured.
    call_count : int
        Calls of the communicator.
    sent_bytes : int
        Bytes that this rank sent.
    received_bytes : int
        Bytes that this rank received, its own included.

    Examples
    --------
    >>> contact.ranks.counts().call_count
    0
    """

    item_count: int
    own_item_count: int
    call_count: int
    sent_bytes: int
    received_bytes: int


class Ranks:
    """Ranks of a parallel program that share the work of a contact.

    Attributes
    ----------
    comm : Communicator or None
        The communicator that was set.

    Examples
    --------
    >>> contact.ranks.set_communicator(None)
    """

    def __init__(self, core: Core) -> None:
        self._core = core
        self.comm: Optional[Communicator] = None

    def set_communicator(self, comm: Optional[Communicator]) -> None:
        """Shares the work of evaluations among the ranks of a communicator.

        From then on every rank makes the same calls with the same coordinates, options, obstacles and history. Every rank gets the whole result,
        bit-for-bit identical to one rank. An evaluation that fails on one rank raises ``OnOtherRankError`` on all other ranks. If ranks were given
        different data, all raise ``RanksDifferError``.

        Parameters
        ----------
        comm : Communicator or None
            A communicator of mpi4py, such as ``MPI.COMM_WORLD``. ``None``: the work is not shared any more.

        Raises
        ------
        BadRankError
            If rank and size do not fit each other.
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.ranks.set_communicator(None)
        """
        handle = self._core.handle
        if comm is None:
            with handle:
                handle.call(library.fmc_context_set_communicator, None)
                handle.release("communicator")
            self.comm = None
            return
        own = described(comm, handle.guarded)
        with handle:
            handle.call(library.fmc_context_set_communicator, byref(own))
            handle.keep("communicator", (own.all_gather, own.all_to_all))
        self.comm = comm

    def counts(self) -> RankCounts:
        """Shared work since the communicator was set; zeros without a communicator.

        Returns
        -------
        RankCounts
            Work and messages.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.ranks.counts().sent_bytes
        0
        """
        counts = fmc_rank_counts()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_rank_counts, byref(counts))
        return RankCounts(*(getattr(counts, field.name) for field in fields(RankCounts)))


def described(comm: Communicator, guard: Callable[[Callable[..., None]], Callable[..., int]]) -> fmc_communicator:
    """A communicator as the library takes it; its functions are guarded by ``guard``, and kept by the caller."""
    rank, size = int(comm.rank), int(comm.size)
    all_to_all: Optional[Callable[..., Any]] = getattr(comm, "Alltoallv", None)

    def gather(_user: object, send: Optional[int], counts: object, received: Optional[int]) -> None:
        every, places = _counts(counts, size)
        comm.Allgatherv(_bytes(send, every[rank]), [_bytes(received, every.sum()), (every, places)])

    def to_single(_user: object, send: Optional[int], to: object, received: Optional[int], given: object) -> None:
        assert all_to_all is not None
        out, back = _counts(to, size), _counts(given, size)
        all_to_all([_bytes(send, out[0].sum()), out], [_bytes(received, back[0].sum()), back])

    own = fmc_communicator()
    check(library.fmc_communicator_init(byref(own)))
    own.rank, own.size = rank, size
    own.all_gather = fmc_all_gather(guard(gather))
    if all_to_all is not None:
        own.all_to_all = fmc_all_to_all(guard(to_single))
    return own


def _counts(counts: Any, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Bytes of every rank, and where they begin."""
    every = np.ctypeslib.as_array(counts, (size,)).astype(np.int64)
    return every, np.concatenate([[0], np.cumsum(every)[:-1]])


def _bytes(address: Optional[int], count: int) -> np.ndarray:
    """The bytes at an address."""
    if not count or address is None:
        return np.empty(0, np.uint8)
    return np.ctypeslib.as_array((c_uint8 * int(count)).from_address(address))
