"""Where a load step begins, and what it moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike


def start(x: ArrayLike, free: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """A copy of where it begins, and the numbers of the unknowns that are solved for, given as numbers or marks."""
    numbers = np.asarray(free)
    return np.array(x, np.float64), np.flatnonzero(numbers) if numbers.dtype == bool else numbers


def moved(x: np.ndarray, free: np.ndarray, prescribed: ArrayLike | None) -> np.ndarray:
    """What is prescribed, less what it is, (size,)."""
    if prescribed is None:
        return np.zeros(x.size)
    values = np.asarray(prescribed, np.float64)
    if values.shape != x.shape:
        raise ValueError(f"prescribed values have shape {values.shape}, that of x is {x.shape}")
    step = (values - x).ravel()
    step[free] = 0.0
    return step
