"""Bodies for a search, with a matrix distributed over ranks and a linear solver of PETSc."""

from __future__ import annotations

from typing import Any

import numpy as np
from fmc_contact.search import TANGENTS, Host, Refused
from petsc4py import PETSc
from scipy.sparse import csr_matrix, diags

from .problem import ContactProblem


class OnRanks(Host):
    """Vectors are gathered, rows of matrices stay with the rank that owns them."""

    def __init__(self, problem: ContactProblem, contact: Any, is_held: np.ndarray, solver: Any = None) -> None:
        self.problem, self.system, self.contact, self.is_held = problem, problem.system, contact, is_held
        self.unknowns, self.comm = self.system.unknowns, problem.contact.comm
        self.solver = direct_solver(problem.contact.comm) if solver is None else solver
        self._solved_for: Any = None

    def forces(self, x: np.ndarray, matrix: bool) -> tuple[np.ndarray, None]:
        self.system.take(x)
        if matrix:
            self.matrix, self._solved_for = self.system.stiffness(), None
        return self.system.forces(), None

    def product(self, vector: np.ndarray, magnitudes: bool) -> np.ndarray:
        return self.unknowns.gather((abs(self.matrix) if magnitudes else self.matrix) @ vector)

    def diagonal(self) -> np.ndarray:
        return self.unknowns.gather(self._own_diagonal())

    def _own_diagonal(self) -> np.ndarray:
        return np.array(self.matrix.diagonal(self.unknowns.first)[: self.unknowns.count])

    def solve(self, x: np.ndarray, flags: int, shift: float, right: np.ndarray) -> np.ndarray:
        key = x.tobytes(), flags, shift
        if self._solved_for != key:
            self.factorisations += 1
            self.solver.reset()
            self.solver.setOperators(self._system(x, flags, shift))
            self._solved_for = key
        solution, side = self.solver.getOperators()[0].createVecs()
        side.setArray(np.where(self.is_held, 0.0, right)[self.unknowns.own])
        try:
            self.solver.solve(side, solution)
        except PETSc.Error as error:
            self._solved_for = None
            raise Refused(f"the linear solver failed: {error}") from error
        reason, found = self.solver.getConvergedReason(), self.unknowns.gather(solution.array)
        if reason < 0 or not np.isfinite(found).all():
            raise Refused(f"the linear solver failed (KSP reason {reason})")
        found[self.is_held] = 0.0
        return found

    def _system(self, x: np.ndarray, flags: int, shift: float) -> Any:
        """The matrix of bodies and contact, ones at unknowns that are held."""
        tangent, unknowns = self.contact.tangent(x, **TANGENTS[flags]), self.unknowns
        total = (self.matrix + tangent).tocoo()
        own_held = self.is_held[unknowns.own]
        use = ~own_held[total.row] & ~self.is_held[total.col]
        added = np.where(own_held, 1.0, shift * self._own_diagonal())
        shape = unknowns.count, unknowns.size
        found = csr_matrix((total.data[use], (total.row[use], total.col[use])), shape) + diags([added], [unknowns.first], shape)
        felt = np.flatnonzero(np.diff(tangent.indptr))
        self.problem.touched = unknowns.first + felt[~own_held[felt]]
        found = found.tocsr()
        parts = found.indptr.astype(PETSc.IntType), found.indices.astype(PETSc.IntType), found.data
        sizes = (unknowns.count, unknowns.size)
        matrix = PETSc.Mat().createAIJ((sizes, sizes), self.problem.contact.dim, csr=parts, comm=unknowns.comm)
        matrix.assemble()
        return matrix


def direct_solver(comm: Any) -> Any:
    """LU, by MUMPS where it is needed or there."""
    solver = PETSc.KSP().create(comm)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    # PETSc's own factorisation knows one rank only, and is slow in 3D.
    if comm.size > 1 or PETSc.Sys.hasExternalPackage("mumps"):
        solver.getPC().setFactorSolverType("mumps")
    return solver
