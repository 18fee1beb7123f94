"""Arrays of the caller: float64 is passed in place, other real numbers are converted, and nonsense is refused by name.

Coordinates and forces keep their layout; strides tell the library where the components are:

    rows      (n, dim)     x0 y0 | x1 y1 | ...     also (n, 3) in 2D, and any slice or transpose of such
    columns   (dim, n)     x0 x1 ... | y0 y1 ...

No mesh has as few nodes as axes, so the shape alone shows which of the two is meant.
"""

from __future__ import annotations

from ctypes import c_double
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._structs import fmc_coords, fmc_forces

_DOUBLE = 8


class View(NamedTuple):
    """An array as the library sees it. The struct points into ``array``, which must outlive it."""

    struct: Any
    array: np.ndarray
    node_count: int
    is_columns: bool


def _array(values: ArrayLike, name: str) -> np.ndarray:
    """Converts to an array as numpy does. Errors: ``TypeError`` for masked entries, ``ValueError`` for other objects."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.getmaskarray(values).any():
        raise TypeError(f"{name} has masked entries, expected numbers: fill them by .filled(), or leave them out")
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} is no array of numbers: {error}") from None


def _dtype_error(name: str, array: np.ndarray, expected: str) -> TypeError:
    hints = {"c": "take .real", "b": "convert it by .astype(float) if that is meant", "O": "its entries are Python objects"}
    hint = hints.get(array.dtype.kind)
    return TypeError(f"{name} has dtype {array.dtype}, expected {expected}" + (f": {hint}" if hint else ""))


def floats(values: ArrayLike, name: str, shape: Optional[tuple[int, ...]] = None) -> np.ndarray:
    """Numbers as float64: in place where they are, converted from other floats and integers; of a ``shape`` if one is given."""
    array = _array(values, name)
    if array.dtype.kind not in "fiu":
        raise _dtype_error(name, array, "real numbers")
    if shape is not None and array.shape != shape:
        raise shape_error(name, array.shape, str(shape))
    return array.astype(np.float64, copy=False)


def of_memory(address: Optional[int], shape: tuple[int, ...], kind: Any = c_double) -> np.ndarray:
    """Numbers of the library, in place."""
    size = int(np.prod(shape))
    if not size or address is None:
        return np.empty(shape, kind)
    found: np.ndarray = np.ctypeslib.as_array((kind * size).from_address(address))
    return found.reshape(shape)


def finite(values: ArrayLike, name: str, shape: Optional[tuple[int, ...]] = None) -> np.ndarray:
    """The same, of finite numbers. Errors: ``ValueError``, which names the first other one."""
    array = floats(values, name, shape)
    if len(others := np.argwhere(~np.isfinite(array))):
        place = tuple(int(one) for one in others[0])
        at = f"[{', '.join(map(str, place))}]" if place else ""
        raise ValueError(f"{name}{at} is {array[place]}, expected finite numbers")
    return array


def rows_of(values: ArrayLike, name: str, shape: tuple[int, ...]) -> np.ndarray:
    """The same of one shape, in dense rows."""
    return np.ascontiguousarray(floats(values, name, shape))


def vector(values: ArrayLike, length: int, name: str) -> np.ndarray:
    """A few numbers, (length,), as float64."""
    return rows_of(values, name, (length,))


def shape_error(name: str, shape: tuple[int, ...], expected: str, hint: str = "") -> ValueError:
    """Text of every message about a shape: argument, actual shape, expected shape."""
    return ValueError(f"{name} has shape {shape}, expected {expected}" + (f": {hint}" if hint else ""))


def _is_columns(shape: tuple[int, ...], dim: int, name: str) -> bool:
    if len(shape) == 2:
        if shape[1] == dim or (dim == 2 and shape[1] == 3 and shape[0] != 2):
            return False
        if shape[0] == dim:
            return True
    also = ", (nodes, 3)" if dim == 2 else ""
    raise shape_error(name, shape, f"(nodes, {dim}){also} or ({dim}, nodes) in {dim}D", "reshape it")


def _has_strides(array: np.ndarray) -> bool:
    """Whether strides in whole numbers tell where the entries are. Both zero would mean dense rows to the library, which a repeated
    number is not."""
    is_whole = array.flags.aligned and not any(stride % _DOUBLE for stride in array.strides)
    return is_whole and (array.size == 0 or any(array.strides))


def _view(struct: Any, array: np.ndarray, dim: int, name: str) -> View:
    is_columns = _is_columns(array.shape, dim, name)
    node_axis = 1 if is_columns else 0
    node_count = array.shape[node_axis]
    strides = array.strides[node_axis] // _DOUBLE, array.strides[1 - node_axis] // _DOUBLE
    return View(struct(array.ctypes.data, node_count, *strides), array, node_count, is_columns)


def coords_view(coords: ArrayLike, dim: int, name: str = "coords") -> View:
    """Coordinates to be read: float64 in place, whatever their strides; anything else that holds real numbers is converted."""
    array = floats(coords, name)
    return _view(fmc_coords, array if _has_strides(array) else array.copy(), dim, name)


def forces_view(forces: np.ndarray, dim: int, name: str = "out") -> View:
    """Forces to be written: an array of the caller's own, which can be written."""
    if not isinstance(forces, np.ndarray):
        raise TypeError(f"{name} is a {type(forces).__name__}, expected a numpy array that can be written")
    if forces.dtype != np.float64:
        raise TypeError(f"{name} has dtype {forces.dtype}, expected float64: a converted copy would not reach you")
    if not forces.flags.writeable:
        raise ValueError(f"{name} is read-only, expected an array that can be written")
    if not _has_strides(forces):
        raise ValueError(f"{name} has strides {forces.strides}, expected multiples of 8 that are not all 0: copy it by numpy.array()")
    return _view(fmc_forces, forces, dim, name)


def flat_in_z(view: View) -> bool:
    """Whether the third column of (n, 3) coordinates in 2D is to be ignored."""
    array = view.array
    return view.is_columns or array.shape[1] != 3 or array.shape[0] == 0 or bool((array[:, 2] == array[0, 2]).all())


def integers(values: ArrayLike, name: str) -> np.ndarray:
    """Whole numbers: int32 and int64 as they are, others as int64; with any shape, dense."""
    array = _array(values, name)
    if array.size == 0 and array.dtype == np.float64:
        array = array.astype(np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has dtype {array.dtype}, expected integers: convert it by .astype(numpy.int32) if they are")
    if array.dtype == np.uint64 and array.size and int(array.max()) > np.iinfo(np.int64).max:
        raise ValueError(f"{name} holds {int(array.max())}, which is no number of anything")
    return np.ascontiguousarray(array, np.int32 if array.dtype == np.int32 else np.int64)


def numbers(values: ArrayLike, name: str, length: Optional[int] = None, dtype: Any = np.int64) -> np.ndarray:
    """Whole numbers in a row, (length,)."""
    array = integers(values, name)
    if array.ndim != 1 or length not in (None, len(array)):
        raise shape_error(name, array.shape, "(numbers,)" if length is None else f"({length},)")
    if array.size and not np.iinfo(dtype).min <= int(array.min()) <= int(array.max()) <= np.iinfo(dtype).max:
        raise ValueError(f"{name} holds {int(array.max())} or {int(array.min())}, expected numbers that fit {np.dtype(dtype)}")
    return array.astype(dtype, copy=False)


def indices(values: ArrayLike, name: str, columns: Optional[int] = None) -> np.ndarray:
    """Node numbers, (m, columns), or one number for every cell, (m,)."""
    array = integers(values, name)
    if array.size == 0 and isinstance(values, (list, tuple)):
        array = np.empty((0,) if columns is None else (0, columns), np.int32)
    if columns is None and array.ndim != 1:
        raise shape_error(name, array.shape, "(cells,), one number for every cell")
    if columns is not None and (array.ndim != 2 or array.shape[1] != columns):
        hint = "transpose it" if array.ndim == 2 and array.shape[0] == columns else "reshape it"
        raise shape_error(name, array.shape, f"(cells, {columns})", hint)
    return array


def of_one_width(arrays: list[np.ndarray]) -> list[np.ndarray]:
    """The arrays with one dtype: int32 if all have it, else int64."""
    dtype = np.int32 if all(array.dtype == np.int32 for array in arrays) else np.int64
    return [array.astype(dtype, copy=False) for array in arrays]


def structured(values: np.ndarray, dtype: np.dtype, name: str) -> np.ndarray:
    """Rows of a structured array, (m,), as they were read."""
    array = np.asarray(values)
    if array.dtype != dtype:
        raise TypeError(f"{name} has dtype {array.dtype}, expected {dtype}, as it was read")
    if array.ndim != 1:
        raise shape_error(name, array.shape, "(rows,)")
    return np.ascontiguousarray(array)


def written(structs: Any, struct: Any) -> np.ndarray:
    """Structs that the library has written, as a structured array of the caller's own."""
    dtype = np.dtype(struct)
    return np.frombuffer(structs, dtype).copy() if len(structs) else np.empty(0, dtype)
