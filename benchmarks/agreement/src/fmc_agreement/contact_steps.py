"""Steps to the equilibrium of the contact with linear bodies: ``fmc_contact``'s, in the numbering of the case."""

from __future__ import annotations

from typing import Any

import numpy as np
from fmc_contact.condensed import MOST_KEPT, Condensed
from fmc_contact.errors import IndefiniteStiffnessError, InvertedCellError, SingularStiffnessError

FAILURES = (RuntimeError, np.linalg.LinAlgError, SingularStiffnessError, IndefiniteStiffnessError, InvertedCellError)


class _InCase:
    """The contact of a host, for displacements (size,)."""

    def __init__(self, touching: Any, shape: tuple[int, int]) -> None:
        self.touching, self.contact, self.shape = touching, touching.contact, shape

    def coords(self, x: np.ndarray) -> np.ndarray:
        return self.touching.coords(x.reshape(self.shape))

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        return self.touching.in_case(forces)


class ContactSteps:
    """For any number of iterations and load steps: bodies that stay as they are are factorised once."""

    def __init__(self, touching: Any, shape: tuple[int, int], free: np.ndarray) -> None:
        self.shape, self.size = shape, shape[0] * shape[1]
        self.free = free
        self.contact = _InCase(touching, shape)
        self.condensed: Condensed | None = None

    def step(
        self, u: np.ndarray, inside: np.ndarray, matrix: Any, tolerance: float, goal: float
    ) -> np.ndarray | None:
        """Change of the displacement, (nodes, dim); ``None`` where contact acts on nothing or on too much, or there is no
        equilibrium."""
        condensed = self.condensed or Condensed(self.contact, self.size, self.free)
        self.condensed = condensed
        condensed.grow(u.ravel())
        if not 0 < len(condensed.freedoms) <= MOST_KEPT:
            return None
        try:
            change, found = condensed.step(u.ravel(), np.zeros(self.size), inside.ravel(), matrix, tolerance, goal)
        except FAILURES:
            return None
        lowered = found.state != "not_converged" or found.residual < found.residual_at_start
        return change.reshape(self.shape) if lowered else None
