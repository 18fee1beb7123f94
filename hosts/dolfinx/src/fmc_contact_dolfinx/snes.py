"""Equilibrium by PETSc's SNES, with functions that are the same for every release of dolfinx."""

from __future__ import annotations

from typing import Any, Sequence

import dolfinx.fem.petsc as fpetsc
import ufl
from dolfinx import fem
from petsc4py import PETSc

from .adapter import DolfinxContact
from .versions import create_vector, vector_of


class ContactProblem:
    """Residual R(u; v) less contact forces, and its derivative, for SNES.

    ``residual``: the UFL form of internal less external forces. ``u``: the displacement, which holds the start and
    receives the solution. ``bcs`` as for any nonlinear problem. ``jacobian``: its derivative; default: by UFL.

    ``semidefinite``: set it to leave out of the matrix what contact makes negative, for use far from a solution.
    """

    def __init__(
        self, residual: Any, u: Any, bcs: Sequence[Any], contact: DolfinxContact, jacobian: Any = None
    ) -> None:
        space = u.function_space
        self.u, self.bcs, self.contact = u, list(bcs), contact
        self.residual = fem.form(residual)
        self.jacobian = fem.form(ufl.derivative(residual, u, ufl.TrialFunction(space)) if jacobian is None else jacobian)
        self.semidefinite = False
        self.vector = create_vector(self.residual, space)
        self.matrix = fpetsc.create_matrix(self.jacobian)

    def _take(self, x: Any) -> None:
        """Puts a vector of SNES into the displacement."""
        x.copy(vector_of(self.u))
        self.u.x.scatter_forward()

    def F(self, snes: Any, x: Any, residual: Any) -> None:
        """Residual at ``x``, for ``SNES.setFunction``."""
        self._take(x)
        with residual.localForm() as local:
            local.set(0.0)
        fpetsc.assemble_vector(residual, self.residual)
        fpetsc.apply_lifting(residual, [self.jacobian], [self.bcs], [x], -1.0)
        residual.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
        self.contact.add_forces(residual, self.contact.evaluate(x), -1.0)
        fpetsc.set_bc(residual, self.bcs, x, -1.0)

    def J(self, snes: Any, x: Any, matrix: Any, preconditioner: Any) -> None:
        """Derivative at ``x``, for ``SNES.setJacobian``."""
        self._take(x)
        preconditioner.zeroEntries()
        fpetsc.assemble_matrix(preconditioner, self.jacobian, self.bcs)
        preconditioner.assemble()
        tangent = self.contact.tangent(x, semidefinite=self.semidefinite)
        self.contact.add_tangent(preconditioner, tangent, self.bcs)
        if matrix != preconditioner:
            matrix.assemble()

    def solver(self) -> Any:
        """A SNES with Newton's method and a direct solver; change it by its methods or by options."""
        snes = PETSc.SNES().create(self.u.function_space.mesh.comm)
        snes.setFunction(self.F, self.vector)
        snes.setJacobian(self.J, self.matrix)
        snes.setTolerances(rtol=1e-10, atol=1e-12, max_it=50)
        solver = snes.getKSP()
        solver.setType("preonly")
        solver.getPC().setType("lu")
        if self.u.function_space.mesh.comm.size > 1:
            solver.getPC().setFactorSolverType("mumps")
        solver.setErrorIfNotConverged(True)
        return snes

    def solve(self, snes: Any = None) -> int:
        """Solves from the displacement that is there; returns the number of iterations. Raises ``RuntimeError`` where
        there is no convergence; the displacement is then the last one tried."""
        snes = self.solver() if snes is None else snes
        # SNES gets a vector of its own: the ghosts of the displacement's are updated here.
        x = vector_of(self.u).copy()
        snes.solve(None, x)
        self._take(x)
        reason = snes.getConvergedReason()
        if reason < 0:
            raise RuntimeError(f"no convergence after {snes.getIterationNumber()} iterations (SNES reason {reason})")
        return snes.getIterationNumber()
