"""Errors of ranks that make the same search: if one rank stops alone, the rest wait for ever."""

from __future__ import annotations

from typing import Any, Callable, TypeVar

import numpy as np

from ..errors import OnOtherRankError
from .host import Refused

T = TypeVar("T")

_DONE, _REFUSED, _FAILED = range(3)


def together(comm: Any, function: Callable[[], T]) -> T:
    """Calls a function on all ranks of a communicator; without one, here alone.

    A refusal of one rank is a refusal of all. Where it raises anything else on one rank, that rank raises it, and all others raise
    ``OnOtherRankError``, also those where it was refused: they may have taken that failure for a state that cannot be."""
    if comm is None or comm.size == 1:
        return function()
    error: Exception | None = None
    try:
        result = function()
    except Exception as raised:
        error = raised
    end = _DONE if error is None else _REFUSED if isinstance(error, Refused) else _FAILED
    ends, own = np.empty(comm.size, np.uint8), np.array([end], np.uint8)
    comm.Allgatherv(own, [ends, (np.ones(comm.size, np.int64), np.arange(comm.size))])
    worst = int(ends.max())
    if error is not None and end == worst:
        raise error
    rank = int(ends.argmax())
    if worst == _FAILED:
        raise OnOtherRankError(f"the search ended by an error on rank {rank}, which has the cause") from error
    if worst == _REFUSED:
        raise Refused(f"it was refused on rank {rank}")
    return result
