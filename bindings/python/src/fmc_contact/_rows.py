"""Matrices of the library in compressed rows."""

from __future__ import annotations

from ctypes import byref, c_size_t
from typing import Any, Callable

import numpy as np

from ._handle import Handle
from ._library import check, library
from ._structs import fmc_csr

Rows = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Offsets, columns and values."""


def compressed_rows(
    handle: Handle, function: Callable[..., int], *first: object, index_base: int, numbers: int = 1
) -> Rows:
    """Output of a function of the library, counted from 0 as in scipy, with ``numbers`` numbers per entry."""
    offset_count, count = c_size_t(), c_size_t()
    handle.call(function, *first, None, 0, byref(offset_count), None, None, 0, byref(count))
    offsets, cols = np.empty(offset_count.value, handle.index), np.empty(count.value, handle.index)
    values = np.empty(count.value * numbers)
    handle.call(function, *first, offsets, len(offsets), None, cols, values, len(cols), None)
    offsets -= index_base
    cols -= index_base
    return offsets, cols, values


def csr_struct(indptr: Any, indices: Any, data: Any) -> tuple[fmc_csr, object]:
    """A matrix of the caller, counted from 0, for the library; and the arrays that it points to, to be kept as long."""
    wide = np.result_type(indptr, indices).itemsize > 4
    offsets, cols = (np.ascontiguousarray(one, np.int64 if wide else np.int32) for one in (indptr, indices))
    values = np.ascontiguousarray(data, np.float64)
    matrix = fmc_csr()
    check(library.fmc_csr_init(byref(matrix)))
    matrix.row_count, matrix.index_size = len(offsets) - 1, offsets.itemsize
    matrix.row_offsets, matrix.cols, matrix.values = offsets.ctypes.data, cols.ctypes.data, values.ctypes.data
    return matrix, (offsets, cols, values)
