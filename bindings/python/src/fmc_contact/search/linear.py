"""Linear systems with bodies and contact."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from .. import mumps
from .._library import library
from ..condensation import Condensation
from ..errors import NotPositiveDefiniteError, RangeError, UnsymmetricError
from ..schur import SYMMETRIC


def summed(bodies: Any, contact: Any) -> Any:
    """Both tangents; an array if the tangent of the bodies is one. Without scipy, the tangent of the contact comes as triplets."""
    if isinstance(contact, tuple):
        rows, cols, values = contact
        total = np.array(bodies, np.float64)
        np.add.at(total, (rows, cols), values)
        return total
    return bodies + contact.toarray() if isinstance(bodies, np.ndarray) else (bodies + contact).tocsr()


def shifted(matrix: Any, diagonal: np.ndarray, shift: float) -> Any:
    """The matrix with a part of a diagonal added."""
    if shift == 0.0:
        return matrix
    if isinstance(matrix, np.ndarray):
        return matrix + np.diag(shift * diagonal)
    from scipy.sparse import diags

    return (matrix + diags(shift * diagonal)).tocsr()


def factors(matrix: Any) -> Callable[[np.ndarray], np.ndarray]:
    """A solver for one matrix and any right sides: the library's Cholesky factors. For a matrix that is not symmetric and positive definite it
    takes MUMPS, if the program has imported a petsc4py with it, else scipy's ``splu``. Arrays by numpy. Errors: ``RuntimeError`` or
    ``LinAlgError`` where it is singular."""
    if isinstance(matrix, np.ndarray):
        return lambda right: np.linalg.solve(matrix, right)
    if library.fmc_has_feature(b"solver"):
        own = Condensation()
        try:
            own.factorise(matrix)
            return own.expand
        except (NotPositiveDefiniteError, UnsymmetricError, RangeError):
            pass
    if mumps.is_there():
        return lambda right: mumps.solved(matrix, right)
    from scipy.sparse.linalg import splu

    solve: Callable[[np.ndarray], np.ndarray] = splu(matrix.tocsc(), **SYMMETRIC).solve
    return solve
