"""Numbers of the unknowns of all spaces over all ranks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .space import Displacement


class Unknowns:
    """Rank after rank, and of a rank space after space: as PETSc counts the rows of a matrix. Collective."""

    def __init__(self, comm: Any, fields: Sequence[Displacement]) -> None:
        self.comm = comm
        self._owned = np.array(comm.allgather([field.owned * field.dim for field in fields])).reshape(comm.size, -1)
        """How many a rank has of a space."""
        self._ends = np.cumsum(self._owned, axis=0)
        flat = self._owned.ravel()
        self._begins = (np.cumsum(flat) - flat).reshape(self._owned.shape)
        self._counts = self._owned.sum(axis=1)
        self.size = int(self._counts.sum())
        self.count = int(self._counts[comm.rank])
        """Unknowns of this rank."""
        self.first = int(self._counts[: comm.rank].sum())
        self.own = slice(self.first, self.first + self.count)

    def numbers(self, space: int, of_space: np.ndarray) -> np.ndarray:
        """Of unknowns that are counted over all ranks in their own space."""
        ends = self._ends[:, space]
        rank = np.searchsorted(ends, of_space, side="right")
        return self._begins[rank, space] + of_space - (ends - self._owned[:, space])[rank]

    def by_space(self, own: np.ndarray) -> list[np.ndarray]:
        """Values that this rank owns, one array for every space."""
        return np.split(own, np.cumsum(self._owned[self.comm.rank])[:-1])

    def gather(self, own: np.ndarray) -> np.ndarray:
        """Values of all unknowns from the values that this rank owns, bit-for-bit identical on every rank. Collective."""
        if self.comm.size == 1:
            return np.array(own)
        found = np.empty(self.size, own.dtype)
        self.comm.Allgatherv(np.ascontiguousarray(own), [found, self._counts])
        return found
