"""Where a load step begins."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import floats, numbers


def start(x: ArrayLike, free: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """A copy of where it begins, and the numbers of the unknowns that are solved for, given as numbers or marks."""
    marks = np.asarray(free)
    return floats(x, "x").copy(), np.flatnonzero(marks) if marks.dtype == bool else numbers(free, "free")
