"""Errors of one rank, raised on all of them: if one rank stops alone, the rest wait for ever."""

from __future__ import annotations

from typing import Any, Callable, TypeVar

from fmc_contact.errors import OnOtherRankError

T = TypeVar("T")


class OtherRankError(RuntimeError):
    """Another rank failed, and its exception could not be sent."""


def together(comm: Any, function: Callable[[], T]) -> T:
    """Calls a function that talks to no other rank. If it raises on one rank, all ranks raise: each its own exception, or else the exception of the
    first rank that has one, with a note of the rank."""
    error: BaseException | None = None
    result: Any = None
    try:
        result = function()
    except Exception as raised:
        error = raised
    if comm.size == 1:
        if error is not None:
            raise error
        return result
    from mpi4py import MPI

    # One that only says that another rank failed has no cause to tell.
    is_cause = error is not None and not isinstance(error, OnOtherRankError)
    first = comm.allreduce(comm.rank if is_cause else comm.size, MPI.MIN)
    if first == comm.size:
        if error is not None:
            raise error
        return result
    theirs = comm.bcast(_sendable(error) if comm.rank == first else None, first)
    if error is not None and is_cause:
        raise error
    raise theirs


def _sendable(error: BaseException | None) -> BaseException:
    import pickle

    try:
        pickle.loads(pickle.dumps(error))
        return error  # type: ignore[return-value]
    except Exception:
        return OtherRankError(f"{type(error).__name__}: {error}")
