"""Integers, as they are given."""

from __future__ import annotations

from operator import index
from typing import Any, Optional

import numpy as np

from .errors import BodyOutOfRangeError, ObstacleOutOfRangeError

_OUT_OF_RANGE = {"body": BodyOutOfRangeError, "obstacle": ObstacleOutOfRangeError}


def integer(value: Any) -> Optional[int]:
    """An integer of any kind, and no truth value; None for anything else."""
    try:
        return None if isinstance(value, (bool, np.bool_)) else index(value)
    except TypeError:
        return None


def index_of(kind: str, number: Any) -> int:
    """The number of a body or an obstacle: an integer that is not negative. The library checks its upper bound."""
    found = integer(number)
    if found is None:
        raise TypeError(f"{kind} {number!r} is no integer")
    if not 0 <= found < 1 << 63:
        raise _OUT_OF_RANGE[kind](f"there is no {kind} {found}")
    return found
