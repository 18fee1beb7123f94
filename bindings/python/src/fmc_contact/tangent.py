"""Second derivative of the contact energy: minus the derivative of the nodal forces, to be added to a stiffness matrix.

Symmetric; degree of freedom ``node * dim + axis``, counted from 0. It has sparse entries and, for the law ``"volume"``,
parts of rank one, factor * outer(vector, vector), that couple all nodes of a pair.
"""

from __future__ import annotations

from ctypes import byref, c_double
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import vector
from ._constants import FMC_CSR_BLOCKS, FMC_CSR_OBSTACLES
from ._handle import Handle
from ._library import library
from ._rows import compressed_rows


class RankOne(NamedTuple):
    """A term of rank one, ``factor * outer(vector, vector)``.

    Attributes
    ----------
    factor : float
        The factor.
    vector : ndarray, (size,)
        An entry for every degree of freedom.

    Examples
    --------
    >>> contact.set_options(law="volume", exponent=2.0)
    >>> contact.tangent_parts(coords).rank_one[0].vector.shape
    (16,)
    """

    factor: float
    vector: np.ndarray


@dataclass(frozen=True, eq=False)
class Tangent:
    """The tangent in its parts: sparse entries in compressed rows, and terms of rank one.

    Row r has the entries from ``offsets[r]`` to ``offsets[r + 1]``, each column once, ascending.

    Attributes
    ----------
    offsets : ndarray of int, (size + 1,)
        Where the rows begin.
    cols : ndarray of int
        Column of every entry.
    values : ndarray
        Value of every entry (force per length).
    rank_one : tuple of RankOne
        Terms of rank one, of the law ``"volume"``: one for every pair.
    size : int
        Number of degrees of freedom: rows and columns of the whole.

    Examples
    --------
    >>> parts = contact.tangent_parts(coords)
    >>> np.allclose(parts @ np.ones(16), 0.0)
    True
    """

    offsets: np.ndarray
    cols: np.ndarray
    values: np.ndarray
    rank_one: tuple[RankOne, ...]
    size: int

    @cached_property
    def rows(self) -> np.ndarray:
        """Row of every entry."""
        return np.repeat(np.arange(self.size, dtype=self.cols.dtype), np.diff(self.offsets))

    def __matmul__(self, x: ArrayLike) -> np.ndarray:
        """Product with a vector, (size,), terms of rank one included."""
        values = vector(np.ravel(x), self.size, "x")
        y: np.ndarray = np.bincount(self.rows, self.values * values[self.cols], self.size)
        for part in self.rank_one:
            y += part.factor * (part.vector @ values) * part.vector
        return y

    def triplets(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rows, columns and values of the whole, with terms of rank one multiplied out.

        Returns
        -------
        rows, cols, values : ndarray
            Duplicates are summed.

        Examples
        --------
        >>> rows, cols, values = contact.tangent_parts(coords).triplets()
        """
        parts = [(self.rows, self.cols, self.values)]
        for part in self.rank_one:
            dofs = np.flatnonzero(part.vector).astype(self.cols.dtype)
            block = part.factor * np.outer(part.vector[dofs], part.vector[dofs])
            parts.append((np.repeat(dofs, len(dofs)), np.tile(dofs, len(dofs)), block.ravel()))
        rows, cols, values = zip(*parts)
        return np.concatenate(rows), np.concatenate(cols), np.concatenate(values)

    def csr(self) -> Any:
        """The whole as a matrix of scipy.

        Returns
        -------
        scipy.sparse.csr_matrix, (size, size)
            The matrix, with terms of rank one multiplied out.

        Raises
        ------
        ImportError
            Without scipy.

        Examples
        --------
        >>> contact.tangent_parts(coords).csr().shape
        (16, 16)
        """
        from scipy.sparse import csr_matrix

        shape = (self.size, self.size)
        if not self.rank_one:
            return csr_matrix((self.values, self.cols, self.offsets), shape=shape)
        rows, cols, values = self.triplets()
        return csr_matrix((values, (rows, cols)), shape=shape)

    def operator(self) -> Any:
        """The whole as a linear operator of scipy, without multiplying out terms of rank one.

        Returns
        -------
        scipy.sparse.linalg.LinearOperator, (size, size)
            The operator.

        Raises
        ------
        ImportError
            Without scipy.

        Examples
        --------
        >>> contact.tangent_parts(coords).operator().shape
        (16, 16)
        """
        from scipy.sparse.linalg import LinearOperator

        shape = (self.size, self.size)
        return LinearOperator(shape, matvec=self.__matmul__, rmatvec=self.__matmul__, dtype=np.dtype(np.float64))


def gather(handle: Handle, part_count: int, obstacles: bool, index_base: int) -> Tangent:
    """The tangent that has just been found, with so many terms of rank one, with the obstacles or without."""
    flags = FMC_CSR_OBSTACLES if obstacles else 0
    offsets, cols, values = compressed_rows(handle, library.fmc_context_tangent_csr, flags, index_base=index_base)
    size = len(offsets) - 1
    parts = []
    for index in range(part_count):
        factor, entries = c_double(), np.empty(size)
        handle.call(library.fmc_context_tangent_rank_one, index, byref(factor), entries, size)
        parts.append(RankOne(factor.value, entries))
    return Tangent(offsets, cols, values, tuple(parts), size)


def matrix(handle: Handle, part_count: int, obstacles: bool, dim: int, blocks: bool, index_base: int) -> Any:
    """The same as a matrix of scipy, ``csr_matrix`` or ``bsr_matrix``; without scipy as triplets, which have no blocks."""
    if blocks and part_count == 0:
        from scipy.sparse import bsr_matrix

        flags = FMC_CSR_BLOCKS | (FMC_CSR_OBSTACLES if obstacles else 0)
        rows = compressed_rows(handle, library.fmc_context_tangent_csr, flags, index_base=index_base, numbers=dim * dim)
        offsets, cols, values = rows
        size = (len(offsets) - 1) * dim
        return bsr_matrix((values.reshape(-1, dim, dim), cols, offsets), shape=(size, size))
    parts = gather(handle, part_count, obstacles, index_base)
    if blocks:
        found = parts.csr().tobsr((dim, dim))
        found.sort_indices()
        return found
    try:
        return parts.csr()
    except ImportError:
        return parts.triplets()
