"""Entries at new places of a PETSc matrix."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import csr_matrix

FEW = 8
"""Rows with new places from which on a matrix is allocated anew: for each such row PETSc would move all that it has stored."""

_KNOWN = "fmc_contact_places"


def add_entries(petsc: Any, matrix: Any, rows: np.ndarray, cols: np.ndarray, values: np.ndarray) -> None:
    """Adds entries in rows that this rank owns, and assembles; collective."""
    _make_room(petsc, matrix, rows, cols)
    matrix.setOption(petsc.Mat.Option.NEW_NONZERO_ALLOCATION_ERR, False)
    matrix.setOption(petsc.Mat.Option.NEW_NONZERO_LOCATIONS, True)
    order = np.argsort(rows, kind="stable")
    rows, cols, values = rows[order], cols[order].astype(petsc.IntType), values[order]
    distinct, start = np.unique(rows, return_index=True)
    ends = np.append(start, len(rows)).astype(petsc.IntType)
    if len(distinct):
        matrix.setValuesIJV(ends, cols, values, addv=petsc.InsertMode.ADD, rowmap=distinct.astype(petsc.IntType))
    matrix.assemble()


def _make_room(petsc: Any, matrix: Any, rows: np.ndarray, cols: np.ndarray) -> None:
    """Reallocates a matrix with its values, if many rows have new places."""
    if matrix.getType() not in ("seqaij", "mpiaij"):
        return
    width = matrix.getSize()[1]
    places = np.unique(rows.astype(np.int64) * width + cols)
    known = matrix.getAttr(_KNOWN)
    new = places if known is None else np.setdiff1d(places, known, assume_unique=True)
    row_count = len(np.unique(new // width))
    if matrix.comm.tompi4py().allreduce(row_count) <= FEW:
        return
    matrix.setAttr(_KNOWN, places if known is None else np.union1d(places, known))
    first, last = matrix.getOwnershipRange()
    starts, columns, values = matrix.getValuesCSR()
    shape = last - first, width
    # Zeros at new places, since an assembly gives away room that is not used.
    zeros = csr_matrix((np.zeros(len(new)), (new // width - first, new % width)), shape)
    wider = _sum(csr_matrix((values, columns, starts), shape), zeros)
    begin, end = matrix.getOwnershipRangeColumn()
    is_here = (wider.indices >= begin) & (wider.indices < end)
    here = np.bincount(np.repeat(np.arange(last - first), np.diff(wider.indptr))[is_here], minlength=last - first)
    elsewhere = np.diff(wider.indptr) - here
    matrix.setPreallocationNNZ((here.astype(petsc.IntType), elsewhere.astype(petsc.IntType)))
    matrix.setValuesCSR(*(part.astype(petsc.IntType) for part in (wider.indptr, wider.indices)), wider.data)
    matrix.assemble()


def _sum(one: csr_matrix, other: csr_matrix) -> csr_matrix:
    """It keeps places with zeros; a sum of ``scipy`` drops them."""
    one, other = one.tocoo(), other.tocoo()
    places = np.concatenate([one.row, other.row]), np.concatenate([one.col, other.col])
    return csr_matrix((np.concatenate([one.data, other.data]), places), one.shape)
