"""Where a load step begins."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import finite, numbers
from .._index import integer


def count(name: str, value: Any, least: int) -> int:
    """A whole number that is given as an argument of this name."""
    found = integer(value)
    if found is None or not least <= found < 1 << 31:
        raise ValueError(f"{name} is {value!r}, expected an integer of at least {least}")
    return found


def start(x: ArrayLike, free: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """A copy of where it begins, and the numbers of the unknowns that are solved for, given as numbers or marks."""
    begin, marks = finite(x, "x").copy(), np.asarray(free)
    if marks.dtype == bool:
        if marks.size != begin.size:
            raise ValueError(f"free has {marks.size} marks for {begin.size} unknowns")
        return begin, np.flatnonzero(marks)
    solved_for = numbers(free, "free")
    outside = np.flatnonzero((solved_for < 0) | (solved_for >= begin.size))
    if outside.size:
        place = outside[0]
        raise ValueError(f"free[{place}] is {solved_for[place]}, and there are {begin.size} unknowns")
    if np.unique(solved_for).size != solved_for.size:
        raise ValueError("free names an unknown twice: marks are given as bool")
    return begin, solved_for
