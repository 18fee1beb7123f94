"""Second derivative of the contact energy: minus the derivative of the nodal forces, to be added to a stiffness matrix.

Symmetric; degree of freedom ``node * dim + axis``, counted from 0. It has sparse entries and, for the law ``"volume"``,
parts of rank one, factor * outer(vector, vector), that couple all nodes of a pair.
"""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ._arrays import View
from ._handle import Handle
from ._library import library
from ._structs import FMC_SEMIDEFINITE


class RankOne(NamedTuple):
    """``factor * outer(vector, vector)``; ``vector`` has an entry for every degree of freedom."""

    factor: float
    vector: np.ndarray


@dataclass(frozen=True, eq=False)
class Tangent:
    """The tangent in its parts: ``values[i]`` at ``rows[i]``, ``cols[i]``, each entry once; and terms of rank one."""

    rows: np.ndarray
    cols: np.ndarray
    values: np.ndarray
    rank_one: tuple[RankOne, ...]
    size: int
    """Number of degrees of freedom: rows and columns of the whole."""

    def __matmul__(self, x: np.ndarray) -> np.ndarray:
        """Product with a vector, (size,), terms of rank one included."""
        x = np.asarray(x, np.float64).reshape(self.size)
        y = np.bincount(self.rows, self.values * x[self.cols], self.size)
        for part in self.rank_one:
            y += part.factor * (part.vector @ x) * part.vector
        return y

    def triplets(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rows, columns and values of the whole, terms of rank one multiplied out; duplicates are summed."""
        parts = [(self.rows, self.cols, self.values)]
        for part in self.rank_one:
            dofs = np.flatnonzero(part.vector).astype(np.int32)
            block = part.factor * np.outer(part.vector[dofs], part.vector[dofs])
            parts.append((np.repeat(dofs, len(dofs)), np.tile(dofs, len(dofs)), block.ravel()))
        rows, cols, values = zip(*parts)
        return np.concatenate(rows), np.concatenate(cols), np.concatenate(values)

    def csr(self) -> Any:
        """The whole as ``scipy.sparse.csr_matrix``, (size, size)."""
        from scipy.sparse import csr_matrix

        rows, cols, values = self.triplets()
        return csr_matrix((values, (rows, cols)), shape=(self.size, self.size))

    def operator(self) -> Any:
        """The whole as ``scipy.sparse.linalg.LinearOperator``, without multiplying out terms of rank one."""
        from scipy.sparse.linalg import LinearOperator

        shape = (self.size, self.size)
        return LinearOperator(shape, matvec=self.__matmul__, rmatvec=self.__matmul__, dtype=np.dtype(np.float64))


def assemble(handle: Handle, coords: View, size: int, semidefinite: bool) -> Tangent:
    """Fetches the tangent at ``coords``, cut to the first ``size`` degrees of freedom."""
    entry_count, part_count = c_size_t(), c_size_t()
    flags = FMC_SEMIDEFINITE if semidefinite else 0
    handle.call(library.fmc_context_tangent, byref(coords.struct), flags, byref(entry_count), byref(part_count))
    rows, cols = np.empty(entry_count.value, np.int32), np.empty(entry_count.value, np.int32)
    values = np.empty(entry_count.value)
    handle.call(library.fmc_context_tangent_entries, rows, cols, values, entry_count.value)
    inside = (rows < size) & (cols < size)
    if not inside.all():
        rows, cols, values = rows[inside], cols[inside], values[inside]
    parts = []
    for index in range(part_count.value):
        factor, vector = c_double(), np.empty(size)
        handle.call(library.fmc_context_tangent_rank_one, index, byref(factor), vector, size)
        parts.append(RankOne(factor.value, vector))
    return Tangent(rows, cols, values, tuple(parts), size)
