"""Bodies factorised once, down to the equations that feel contact, by the library itself."""

from __future__ import annotations

import weakref
from ctypes import byref
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import vector
from ._library import check, library
from ._structs import fmc_condensation
from .errors import NotPositiveDefiniteError


def _free(pointer: fmc_condensation) -> None:
    library.fmc_condensation_free(byref(pointer))


class Condensation:
    """A symmetric sparse matrix K, factorised with some equations c kept for the end: ``S = K_cc - K_cr K_rr^-1 K_rc``, with r the
    others, on which K has to be positive definite. Sparse Cholesky factors on one thread: same matrix, same bits."""

    def __init__(self) -> None:
        self._pointer = fmc_condensation()
        check(library.fmc_condensation_new(byref(self._pointer)))
        weakref.finalize(self, _free, self._pointer).atexit = False
        self._size = self._kept = 0

    def factorise(self, matrix: Any, kept: ArrayLike = ()) -> None:
        """Factorises a matrix (n, n) of scipy.sparse; ``kept``: equations, ascending. The next one of the same pattern takes less.

        Errors: ``UnsymmetricError``, ``FreedomOutOfRangeError``, ``RepeatedFreedomError``, ``NonFiniteStiffnessError``, which leave
        the factors that there were; ``NotPositiveDefiniteError`` and ``RangeError``, after which there are none."""
        rows = matrix.tocsr()
        if rows.shape[0] != rows.shape[1]:
            raise ValueError(f"a square matrix is wanted, this is of shape {rows.shape}")
        offsets, cols, last = (np.ascontiguousarray(one, np.int64) for one in (rows.indptr, rows.indices, np.ravel(kept)))
        values = np.ascontiguousarray(rows.data, np.float64)
        arguments = rows.shape[0], offsets, cols, values, last, len(last)
        status = library.fmc_condensation_factorise(self._pointer, *arguments)
        check(status)
        self._size, self._kept = rows.shape[0], len(last)

    @property
    def complement(self) -> np.ndarray:
        """S, (m, m), for the m equations that are kept."""
        found = np.empty((self._kept, self._kept))
        check(library.fmc_condensation_complement(self._pointer, found, found.size))
        return found

    def condense(self, right: ArrayLike) -> np.ndarray:
        """``b_c - K_cr K_rr^-1 b_r``, (m,), of a right side (n,)."""
        given, found = vector(right, self._size, "right"), np.empty(self._kept)
        check(library.fmc_condensation_condense(self._pointer, given, len(given), found, len(found)))
        return found

    def expand(self, right: ArrayLike, kept: ArrayLike = ()) -> np.ndarray:
        """Solution of ``K x = b`` in the other equations with those that are kept as given (m,): all of x, (n,)."""
        given, found = vector(right, self._size, "right"), np.empty(self._size)
        held = vector(kept, self._kept, "kept")
        check(library.fmc_condensation_expand(self._pointer, given, len(given), held, len(held), found, len(found)))
        return found
