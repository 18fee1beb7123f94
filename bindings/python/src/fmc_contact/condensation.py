"""Bodies factorised once, down to the equations that feel contact, by the library itself."""

from __future__ import annotations

import weakref
from ctypes import byref
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats, numbers, vector
from ._library import check, library
from ._rows import csr_struct
from ._structs import fmc_condensation


def _free(pointer: fmc_condensation) -> None:
    library.fmc_condensation_free(byref(pointer))


class Condensation:
    """A symmetric sparse matrix K, factorised with some equations c kept for the end: ``S = K_cc - K_cr K_rr^-1 K_rc``.

    K must be positive definite on the other equations r. Sparse Cholesky factors on one thread: the same matrix gives bit-for-bit
    identical results.

    Examples
    --------
    >>> from scipy.sparse import csr_matrix
    >>> from fmc_contact import Condensation
    >>> condensation = Condensation()
    >>> condensation.factorise(csr_matrix([[2.0, -1.0], [-1.0, 2.0]]), kept=[1])
    >>> condensation.complement
    array([[1.5]])
    """

    def __init__(self) -> None:
        self._pointer = fmc_condensation()
        check(library.fmc_condensation_new(byref(self._pointer)))
        weakref.finalize(self, _free, self._pointer).atexit = False
        self._size = self._kept = 0

    def factorise(self, matrix: Any, kept: ArrayLike = ()) -> None:
        """Factorises a matrix. The next one of the same pattern takes less time.

        Parameters
        ----------
        matrix : scipy.sparse matrix, (n, n)
            The matrix.
        kept : array_like of int, (m,)
            Equations that are kept, ascending.

        Raises
        ------
        UnsymmetricError, DofOutOfRangeError, RepeatedDofError, NonFiniteStiffnessError
            The old factors stay.
        NotPositiveDefiniteError, RangeError
            There are no factors then.

        Examples
        --------
        >>> from scipy.sparse import identity
        >>> Condensation().factorise(identity(3))
        """
        rows = matrix.tocsr()
        if rows.shape[0] != rows.shape[1]:
            raise ValueError(f"matrix has shape {rows.shape}, expected a square one")
        whole, _arrays = csr_struct(rows.indptr, rows.indices, floats(rows.data, "matrix"))
        last = numbers(kept, "kept", None, np.int64 if whole.index_size == 8 else np.int32)
        check(library.fmc_condensation_factorise(self._pointer, byref(whole), last, len(last)))
        self._size, self._kept = rows.shape[0], len(last)

    @property
    def complement(self) -> np.ndarray:
        """S, (m, m), for the m equations that are kept."""
        found = np.empty((self._kept, self._kept))
        check(library.fmc_condensation_complement(self._pointer, found, found.size, None))
        return found

    def condense(self, right: ArrayLike) -> np.ndarray:
        """``b_c - K_cr K_rr^-1 b_r`` of a right-hand side b.

        Parameters
        ----------
        right : array_like, (n,)
            The right-hand side.

        Returns
        -------
        ndarray, (m,)
            Its condensed part.

        Raises
        ------
        FmcError
            If there are no factors.

        Examples
        --------
        >>> from scipy.sparse import csr_matrix
        >>> condensation = Condensation()
        >>> condensation.factorise(csr_matrix([[2.0, -1.0], [-1.0, 2.0]]), kept=[1])
        >>> condensation.condense([1.0, 0.0])
        array([0.5])
        """
        given, found = vector(right, self._size, "right"), np.empty(self._kept)
        check(library.fmc_condensation_condense(self._pointer, given, len(given), found, len(found), None))
        return found

    def expand(self, right: ArrayLike, kept: ArrayLike = ()) -> np.ndarray:
        """Solution of ``K x = b`` in the other equations, with given values in those that are kept.

        Parameters
        ----------
        right : array_like, (n,)
            The right-hand side b.
        kept : array_like, (m,)
            Values of the equations that are kept.

        Returns
        -------
        ndarray, (n,)
            All of x.

        Raises
        ------
        FmcError
            If there are no factors.

        Examples
        --------
        >>> from scipy.sparse import csr_matrix
        >>> condensation = Condensation()
        >>> condensation.factorise(csr_matrix([[2.0, -1.0], [-1.0, 2.0]]))
        >>> condensation.expand([1.0, 1.0]).round(6)
        array([1., 1.])
        """
        given, found = vector(right, self._size, "right"), np.empty(self._size)
        held = vector(kept, self._kept, "kept")
        check(library.fmc_condensation_expand(self._pointer, given, len(given), held, len(held), found, len(found), None))
        return found
