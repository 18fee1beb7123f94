"""What GetFEM found, and what it cost."""

from __future__ import annotations

import time
from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True, eq=False)
class Solution:
    displacement: np.ndarray
    """(nodes, dim), in the case's order."""
    inner_force: np.ndarray
    """Nodal forces that balance the stresses, (nodes, dim): where nothing is held, those of the contact."""
    iterations: int
    """Linear systems solved."""
    history: list[list[float]] = field(default_factory=list)
    """Of several steps: stage, part of its load, force on the last body along each axis."""


class Clock:
    """CPU seconds of this process, user and system, lap by lap; what was spent before the first lap begins, such as on
    starting Python, is nobody's."""

    def __init__(self) -> None:
        self.laps: dict[str, float] = {}
        self._last = time.process_time()

    def lap(self, name: str) -> None:
        now = time.process_time()
        self.laps[name] = self.laps.get(name, 0.0) + now - self._last
        self._last = now
