"""Second derivative of the contact energy: minus the derivative of the nodal forces, to be added to a stiffness matrix.

Symmetric; degree of freedom ``node * dim + axis``, counted from 0. It has sparse entries and, for the law ``"volume"``,
parts of rank one, factor * outer(vector, vector), that couple all nodes of a pair.
"""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ._constants import FMC_BLOCKS, FMC_OBSTACLES
from ._handle import Handle
from ._library import library


class RankOne(NamedTuple):
    """``factor * outer(vector, vector)``; ``vector`` has an entry for every degree of freedom."""

    factor: float
    vector: np.ndarray


@dataclass(frozen=True, eq=False)
class Tangent:
    """The tangent in its parts: entries in compressed rows (CSR), and terms of rank one. Row r has the entries from
    ``offsets[r]`` to ``offsets[r + 1]``, each column once, in ascending order."""

    offsets: np.ndarray
    cols: np.ndarray
    values: np.ndarray
    rank_one: tuple[RankOne, ...]
    size: int
    """Number of degrees of freedom: rows and columns of the whole."""

    @cached_property
    def rows(self) -> np.ndarray:
        """Row of every entry."""
        return np.repeat(np.arange(self.size, dtype=self.cols.dtype), np.diff(self.offsets))

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
            dofs = np.flatnonzero(part.vector).astype(self.cols.dtype)
            block = part.factor * np.outer(part.vector[dofs], part.vector[dofs])
            parts.append((np.repeat(dofs, len(dofs)), np.tile(dofs, len(dofs)), block.ravel()))
        rows, cols, values = zip(*parts)
        return np.concatenate(rows), np.concatenate(cols), np.concatenate(values)

    def csr(self) -> Any:
        """The whole as ``scipy.sparse.csr_matrix``, (size, size)."""
        from scipy.sparse import csr_matrix

        shape = (self.size, self.size)
        if not self.rank_one:
            return csr_matrix((self.values, self.cols, self.offsets), shape=shape)
        rows, cols, values = self.triplets()
        return csr_matrix((values, (rows, cols)), shape=shape)

    def operator(self) -> Any:
        """The whole as ``scipy.sparse.linalg.LinearOperator``, without multiplying out terms of rank one."""
        from scipy.sparse.linalg import LinearOperator

        shape = (self.size, self.size)
        return LinearOperator(shape, matvec=self.__matmul__, rmatvec=self.__matmul__, dtype=np.dtype(np.float64))


def _rows(handle: Handle, flags: int, numbers: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Offsets, columns and values of the last tangent in compressed rows, with so many numbers an entry."""
    row_count, entry_count = c_size_t(), c_size_t()
    handle.call(library.fmc_context_tangent_csr_size, flags, byref(row_count), byref(entry_count))
    is_narrow = max(row_count.value, entry_count.value) <= np.iinfo(np.int32).max
    dtype = np.int32 if is_narrow else np.int64
    offsets, cols = np.empty(row_count.value + 1, dtype), np.empty(entry_count.value, dtype)
    values = np.empty(entry_count.value * numbers)
    fetch = library.fmc_context_tangent_csr if is_narrow else library.fmc_context_tangent_csr_i64
    handle.call(fetch, flags, offsets, cols, values, entry_count.value)
    return offsets, cols, values


def gather(handle: Handle, part_count: int, obstacles: bool) -> Tangent:
    """The tangent that has just been found, with so many terms of rank one, with the obstacles or without."""
    offsets, cols, values = _rows(handle, FMC_OBSTACLES if obstacles else 0, 1)
    size = len(offsets) - 1
    parts = []
    for index in range(part_count):
        factor, vector = c_double(), np.empty(size)
        handle.call(library.fmc_context_tangent_rank_one, index, byref(factor), vector, size)
        parts.append(RankOne(factor.value, vector))
    return Tangent(offsets, cols, values, tuple(parts), size)


def matrix(handle: Handle, part_count: int, obstacles: bool, dim: int, blocks: bool) -> Any:
    """The same as a matrix of scipy, ``csr_matrix`` or ``bsr_matrix``; without scipy as triplets, which have no blocks."""
    if blocks and part_count == 0:
        from scipy.sparse import bsr_matrix

        offsets, cols, values = _rows(handle, FMC_BLOCKS | (FMC_OBSTACLES if obstacles else 0), dim * dim)
        size = (len(offsets) - 1) * dim
        return bsr_matrix((values.reshape(-1, dim, dim), cols, offsets), shape=(size, size))
    parts = gather(handle, part_count, obstacles)
    if blocks:
        found = parts.csr().tobsr((dim, dim))
        found.sort_indices()
        return found
    try:
        return parts.csr()
    except ImportError:
        return parts.triplets()
