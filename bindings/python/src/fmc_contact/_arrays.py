"""Arrays of the caller, passed in place: checked for what the library cannot see, and never converted.

Coordinates and forces keep their layout; strides tell the library where the components are:

    rows      (n, dim)     x0 y0 | x1 y1 | ...     also (n, 3) in 2D, and any slice or transpose of such
    columns   (dim, n)     x0 x1 ... | y0 y1 ...

No mesh has as few nodes as axes, so the shape alone says which of them is meant.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._structs import fmc_coords, fmc_forces

_DOUBLE = 8


class View(NamedTuple):
    """An array as the library sees it. The struct points into ``array``, which must outlive it."""

    struct: fmc_coords | fmc_forces
    array: np.ndarray
    node_count: int
    is_columns: bool


def _is_columns(shape: tuple[int, ...], dim: int, name: str) -> bool:
    if len(shape) == 2:
        if shape[1] == dim or (dim == 2 and shape[1] == 3 and shape[0] != 2):
            return False
        if shape[0] == dim:
            return True
    wanted = f"(nodes, {dim}){' or (nodes, 3)' if dim == 2 else ''} or ({dim}, nodes)"
    raise ValueError(f"{name} has shape {shape}, {wanted} is wanted in {dim}D: reshape it")


def _view(struct: type, array: np.ndarray, dim: int, name: str) -> View:
    if array.dtype != np.float64:
        raise TypeError(f"{name} has dtype {array.dtype}, float64 is wanted: convert it by .astype(numpy.float64)")
    is_columns = _is_columns(array.shape, dim, name)
    node_axis = 1 if is_columns else 0
    strides = array.strides[node_axis], array.strides[1 - node_axis]
    # Both strides zero would mean dense rows to the library, which a repeated number is not.
    if not array.flags.aligned or any(stride % _DOUBLE for stride in strides) or (array.size and strides == (0, 0)):
        raise ValueError(f"{name} has strides {array.strides} that float64 cannot have: copy it by numpy.array()")
    node_count = array.shape[node_axis]
    pointers = (array.ctypes.data, node_count, strides[0] // _DOUBLE, strides[1] // _DOUBLE)
    return View(struct(*pointers), array, node_count, is_columns)


def coords_view(coords: ArrayLike, dim: int, name: str = "coords") -> View:
    """Coordinates to be read. Nested lists and tuples of numbers become an array; arrays are taken as they are."""
    is_list = isinstance(coords, (list, tuple))
    return _view(fmc_coords, np.asarray(coords, dtype=np.float64 if is_list else None), dim, name)


def forces_view(forces: np.ndarray, dim: int, name: str = "out") -> View:
    """Forces to be written: an array of the caller's own, which can be written."""
    if not isinstance(forces, np.ndarray):
        raise TypeError(f"{name} is a {type(forces).__name__}, a numpy array is wanted that can be written")
    if not forces.flags.writeable:
        raise ValueError(f"{name} is read-only: give an array that can be written")
    return _view(fmc_forces, forces, dim, name)


def flat_in_z(view: View) -> bool:
    """Whether the third column of (n, 3) coordinates in 2D is to be ignored."""
    array = view.array
    return view.is_columns or array.shape[1] != 3 or array.shape[0] == 0 or bool((array[:, 2] == array[0, 2]).all())


def indices(values: ArrayLike, name: str, columns: int | None = None) -> np.ndarray:
    """Node numbers (m, columns), or one number for every cell (m,): int32 and int64 as they are, others as int64.

    Copied only where they have gaps; the library copies topology anyway.
    """
    array = np.asarray(values)
    if array.size == 0 and isinstance(values, (list, tuple)):
        array = np.empty((0,) if columns is None else (0, columns), np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has dtype {array.dtype}, integers are wanted: convert by .astype(numpy.int32)")
    if columns is None and array.ndim != 1:
        raise ValueError(f"{name} has shape {array.shape}, one number for every cell is wanted")
    if columns is not None and (array.ndim != 2 or array.shape[1] != columns):
        hint = "transpose it" if array.ndim == 2 and array.shape[0] == columns else "reshape it"
        raise ValueError(f"{name} has shape {array.shape}, (cells, {columns}) is wanted: {hint}")
    if array.dtype == np.uint64 and array.size and int(array.max()) > np.iinfo(np.int64).max:
        raise ValueError(f"{name} holds {int(array.max())}, which is no number of anything")
    return np.ascontiguousarray(array, np.int32 if array.dtype == np.int32 else np.int64)


def of_one_width(arrays: list[np.ndarray]) -> list[np.ndarray]:
    """The arrays with one dtype: int32 if all have it, else int64."""
    dtype = np.int32 if all(array.dtype == np.int32 for array in arrays) else np.int64
    return [array.astype(dtype, copy=False) for array in arrays]


def vector(values: ArrayLike, length: int, name: str) -> np.ndarray:
    """A few numbers, (length,), as float64."""
    array = np.ascontiguousarray(values, np.float64)
    if array.shape != (length,):
        raise ValueError(f"{name} has shape {array.shape}, ({length},) is wanted")
    return array
