"""Where a load step begins, and what it moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import floats, numbers


def start(x: ArrayLike, free: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """A copy of where it begins, and the numbers of the unknowns that are solved for, given as numbers or marks."""
    marks = np.asarray(free)
    return floats(x, "x").copy(), np.flatnonzero(marks) if marks.dtype == bool else numbers(free, "free")


def moved(x: np.ndarray, free: np.ndarray, prescribed: ArrayLike | None) -> np.ndarray:
    """What is prescribed, less what it is, (size,)."""
    if prescribed is None:
        return np.zeros(x.size)
    values = floats(prescribed, "prescribed", x.shape)
    step: np.ndarray = (values - x).ravel()
    step[free] = 0.0
    return step
