"""The Schur complement by MUMPS, through PETSc: one factorisation, some five times as fast as SuperLU's two.

petsc4py has no Schur complements, so PETSc's own functions are called. On one rank: PETSc refuses more."""

from __future__ import annotations

import sys
from ctypes import CDLL, POINTER, byref, c_char_p, c_double, c_int, c_void_p
from typing import Any

import numpy as np

LU, CHOLESKY = 1, 2
"""``MatFactorType``."""

_SOLVED_WITH, _FINDS_NULL_PIVOTS, _NULL_PIVOTS = 26, 24, 28
"""MUMPS' numbers of two options and of a result; the first is 0 for the rest alone."""


def is_there() -> bool:
    """Whether the program has imported petsc4py, of real numbers of double precision, with MUMPS."""
    module = sys.modules.get("petsc4py.PETSc")
    if module is None:
        return False
    is_double = module.ScalarType is np.float64 and module.IntType in (np.int32, np.int64)
    return bool(is_double and module.Sys.hasExternalPackage("mumps"))


class Mumps:
    """``condense`` (``fmc_contact.schur``) by MUMPS: symmetric matrices by L D L^T, others by L U. Errors: ``RuntimeError`` where the
    rest is singular."""

    def __init__(self) -> None:
        from petsc4py import PETSc

        self._petsc = PETSc
        self._library = CDLL(PETSc.__file__)

    def __call__(self, matrix: Any, rest: np.ndarray, kept: np.ndarray) -> tuple[Any, np.ndarray]:
        if isinstance(matrix, np.ndarray) or not len(rest) or not len(kept):
            from .schur import condense

            return condense(matrix, rest, kept)
        factors = _Factors(self._petsc, self._library, matrix, rest, kept)
        return factors.solve, factors.complement()


class _Factors:
    """Of the rows and columns ``rest`` and ``kept``."""

    def __init__(self, petsc: Any, library: CDLL, matrix: Any, rest: np.ndarray, kept: np.ndarray) -> None:
        self._library, self._factors, self.count = library, c_void_p(), len(rest)
        order = np.concatenate([rest, kept])
        whole = matrix[order][:, order].tocsr()
        whole.sort_indices()
        difference = abs(whole - whole.T)
        is_symmetric = not difference.nnz or difference.max() <= 1e-12 * abs(whole).max()
        numbers = petsc.IntType
        self._matrix = petsc.Mat().createAIJ(
            whole.shape, csr=(whole.indptr.astype(numbers), whole.indices.astype(numbers), whole.data), comm=petsc.COMM_SELF
        )
        self._matrix.setOption(petsc.Mat.Option.SYMMETRIC, is_symmetric)
        last = petsc.IS().createStride(len(kept), self.count, 1, comm=petsc.COMM_SELF)
        handle, info = c_void_p(self._matrix.handle), (c_double * 64)()
        kind = CHOLESKY if is_symmetric else LU
        self._call("MatGetFactor", handle, c_char_p(b"mumps"), c_int(kind), byref(self._factors))
        self._call("MatFactorInfoInitialize", info)
        self._call("MatFactorSetSchurIS", self._factors, c_void_p(last.handle))
        self._call("MatMumpsSetIcntl", self._factors, c_int(_FINDS_NULL_PIVOTS), c_int(1))
        none = c_void_p()
        if is_symmetric:
            self._call("MatCholeskyFactorSymbolic", self._factors, handle, none, info)
            self._call("MatCholeskyFactorNumeric", self._factors, handle, info)
        else:
            self._call("MatLUFactorSymbolic", self._factors, handle, none, none, info)
            self._call("MatLUFactorNumeric", self._factors, handle, info)
        failed, lost = c_int(), c_int()
        self._call("MatFactorGetError", self._factors, byref(failed))
        self._call("MatMumpsGetInfog", self._factors, c_int(_NULL_PIVOTS), byref(lost))
        if failed.value or lost.value:
            raise RuntimeError("the stiffness of the part that feels no contact is singular")
        self._call("MatMumpsSetIcntl", self._factors, c_int(_SOLVED_WITH), c_int(0))
        self._right, self._found = self._matrix.createVecs()

    def __del__(self) -> None:
        if self._factors:
            self._library.MatDestroy(byref(self._factors))

    def _call(self, name: str, *arguments: Any) -> None:
        status = getattr(self._library, name)(*arguments)
        if status:
            raise RuntimeError(f"PETSc's {name} failed with {status}")

    def complement(self) -> np.ndarray:
        count = self._right.size - self.count
        schur, status, values = c_void_p(), c_int(), POINTER(c_double)()
        self._call("MatFactorCreateSchurComplement", self._factors, byref(schur), byref(status))
        try:
            self._call("MatDenseGetArrayRead", schur, byref(values))
            # By columns.
            found = np.ctypeslib.as_array(values, (count, count)).T.copy()
            self._call("MatDenseRestoreArrayRead", schur, byref(values))
        finally:
            self._library.MatDestroy(byref(schur))
        return found

    def solve(self, right: np.ndarray) -> np.ndarray:
        """Solution for ``rest``, with the retained unknowns fixed."""
        if right.ndim > 1:
            return np.stack([self.solve(column) for column in right.T], axis=1)
        whole = self._right.getArray()
        whole[: self.count], whole[self.count :] = right, 0.0
        self._call("MatSolve", self._factors, c_void_p(self._right.handle), c_void_p(self._found.handle))
        found: np.ndarray = self._found.getArray()[: self.count].copy()
        return found


def solved(matrix: Any, right: np.ndarray) -> np.ndarray:
    """Solution of a sparse system by L U. Errors: ``RuntimeError`` where it is singular."""
    from petsc4py import PETSc

    rows, numbers = matrix.tocsr(), PETSc.IntType
    arrays = rows.indptr.astype(numbers), rows.indices.astype(numbers), rows.data
    petsc, solver = PETSc.Mat().createAIJ(rows.shape, csr=arrays, comm=PETSc.COMM_SELF), PETSc.KSP().create(PETSc.COMM_SELF)
    solver.setOperators(petsc)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solver.getPC().setFactorSolverType("mumps")
    given, solution = PETSc.Vec().createWithArray(right.copy(), comm=PETSc.COMM_SELF), petsc.createVecRight()
    solver.solve(given, solution)
    found: np.ndarray = solution.array.copy()
    reason = solver.getConvergedReason()
    for one in (solver, petsc):
        one.destroy()
    if reason < 0 or not np.isfinite(found).all():
        raise RuntimeError(f"PETSc reports {reason}")
    return found
