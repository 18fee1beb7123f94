"""Where a load step begins."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import finite, numbers


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
