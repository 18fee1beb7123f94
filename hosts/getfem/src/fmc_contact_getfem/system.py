"""The system of a model: residual and matrix at a state, whatever its bricks."""

from __future__ import annotations

import getfem as gf
import numpy as np
from scipy.sparse import csc_matrix, csr_matrix


def from_getfem(matrix: gf.Spmat) -> csr_matrix:
    """A matrix of GetFEM in scipy."""
    offsets, rows = matrix.csc_ind()
    return csc_matrix((matrix.csc_val(), rows, offsets), shape=tuple(int(n) for n in matrix.size())).tocsr()


def to_getfem(matrix: csr_matrix) -> gf.Spmat:
    """A matrix of scipy in GetFEM, which takes dense parts alone: row by row."""
    found = gf.Spmat("empty", *matrix.shape)
    for row in np.flatnonzero(np.diff(matrix.indptr)):
        here = slice(matrix.indptr[row], matrix.indptr[row + 1])
        found.add([int(row)], matrix.indices[here], matrix.data[here][None, :])
    return found


def is_linear(model: gf.Model) -> bool:
    """Whether all bricks are linear: the right-hand side then has only the loads, and does not depend on the state."""
    state = model.from_variables()
    try:
        sides = []
        for moved in (state, state + 1e-6 * (1.0 + np.abs(state).max(initial=0.0)) * np.cos(np.arange(len(state)))):
            model.to_variables(moved)
            model.assembly("build_rhs")
            sides.append(model.rhs())
    finally:
        model.to_variables(state)
    return np.array_equal(*sides)


def residual_and_tangent(model: gf.Model, linear: bool) -> tuple[np.ndarray, csr_matrix]:
    """Internal less external forces at the state of the model, (size,), and their derivative."""
    model.assembly("build_all")
    side, matrix = model.rhs(), from_getfem(model.tangent_matrix())
    return (matrix @ model.from_variables() if linear else 0.0) - side, matrix
