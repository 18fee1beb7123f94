"""What comes out of a solver."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Step:
    """An equilibrium on the way. Arrays are (nodes, dim), in the case's numbering."""

    stage: int
    load: float
    """Part of the stage's load."""
    displacement: np.ndarray
    force: np.ndarray
    """Of the contact."""
    penetration: float
    """Largest; where one is wanted, the largest mean of a node."""
    sliding: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """With friction: energy taken out in the step; areas that stick and slip."""


@dataclass
class Solved:
    """The way to an equilibrium."""

    steps: list[Step] = field(default_factory=list)
    halvings: int = 0
    """Load steps that failed and were halved."""
    residuals: list[float] = field(default_factory=list)
    """By the forces, before every iteration."""
    iterations: int = 0
    """Linear systems solved."""
    seconds: float = 0.0
    """Processor time."""
    contact_seconds: float = 0.0
    """What the contact took of it."""
    contact_iterations: int = 0
    """Dense systems solved for the contact alone."""
    factorisations: int = 0
    """Sparse matrices factorised."""
    updates: int = 0
    """Of the multipliers, where a penetration is wanted."""
