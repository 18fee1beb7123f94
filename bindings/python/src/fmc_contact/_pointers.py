"""Arrays of numpy as arguments of the library's functions."""

from __future__ import annotations

from ctypes import c_void_p
from typing import Any

import numpy as np


class _Array(c_void_p):
    """Pointer to the first entry of a numpy array of one dtype without gaps, or ``None`` for NULL."""

    dtype: np.dtype[Any]

    @classmethod
    def from_param(cls, array: Any) -> Any:
        """The value that ctypes passes on."""
        if array is None:
            return None
        if array.dtype != cls.dtype or not array.flags.c_contiguous:
            raise TypeError(f"expected a contiguous array of dtype {cls.dtype}, not of {array.dtype}")
        return c_void_p(array.ctypes.data)


class IndexArray(c_void_p):
    """``void *`` to numbers of nodes, cells or degrees of freedom, int32 or int64 as those of the mesh; ``None`` for NULL."""

    @classmethod
    def from_param(cls, array: Any) -> Any:
        """The value that ctypes passes on."""
        if array is None:
            return None
        if array.dtype not in (np.int32, np.int64) or not array.flags.c_contiguous:
            raise TypeError(f"expected a contiguous array of dtype int32 or int64, not of {array.dtype}")
        return c_void_p(array.ctypes.data)


class Float64Array(_Array):
    """``double *``"""

    dtype = np.dtype(np.float64)


class Int32Array(_Array):
    """``int32_t *``"""

    dtype = np.dtype(np.int32)


class Int64Array(_Array):
    """``int64_t *``"""

    dtype = np.dtype(np.int64)
