"""Equilibrium by PETSc's SNES, with functions that are the same for every release of dolfinx."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import dolfinx.fem.petsc as fpetsc
import numpy as np
import ufl
from dolfinx import fem
from fmc_contact.errors import InvertedCellError
from fmc_contact.newton import Raising
from petsc4py import PETSc

from .adapter import DolfinxContact
from .filtered_multigrid import FilteredMultigrid
from .versions import create_vector, vector_of

FAR = 0.1
"""Part of the contact forces that the residual exceeds far from a solution."""


class ContactProblem:
    """Residual R(u; v) minus contact forces, and its derivative, for SNES.

    A trial that turns a cell inside out gives an infinite residual, so that a line search draws back.

    Parameters
    ----------
    residual : ufl form
        Internal minus external forces.
    u : Function
        Displacement: holds the start, and receives the solution.
    bcs : sequence of DirichletBC
        As for any nonlinear problem.
    contact : DolfinxContact
        The contact.
    jacobian : ufl form, optional
        Derivative of the residual. Default: by UFL.

    Attributes
    ----------
    semidefinite : bool or None
        Whether to leave out of the matrix the terms of contact that can be negative. ``None``: while the residual is more than a tenth of
        the contact forces.

    Examples
    --------
    >>> problem = ContactProblem(residual_form, u, bcs, contact)
    >>> problem.solve()
    """

    def __init__(
        self, residual: Any, u: Any, bcs: Sequence[Any], contact: DolfinxContact, jacobian: Any = None
    ) -> None:
        space = u.function_space
        self.u, self.bcs, self.contact = u, list(bcs), contact
        self.residual = fem.form(residual)
        self.jacobian = fem.form(
            ufl.derivative(residual, u, ufl.TrialFunction(space)) if jacobian is None else jacobian
        )
        self.semidefinite: bool | None = None
        self._is_far = True
        self._tangent: Any = None
        self.on_unknowns: Any = None
        self.vector = create_vector(self.residual, space)
        self.matrix = fpetsc.create_matrix(self.jacobian)

    def _take(self, x: Any) -> None:
        """Puts a vector of SNES into the displacement."""
        x.copy(vector_of(self.u))
        self.u.x.scatter_forward()

    def F(self, snes: Any, x: Any, residual: Any) -> None:
        """Residual, for ``SNES.setFunction``.

        Parameters
        ----------
        snes : PETSc.SNES
            Not used.
        x : PETSc.Vec
            Displacement.
        residual : PETSc.Vec
            Receives the residual.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        self._take(x)
        with residual.localForm() as local:
            local.set(0.0)
        fpetsc.assemble_vector(residual, self.residual)
        # The ghosts of the displacement are those of now; those of a vector of SNES need not be.
        now = vector_of(self.u)
        fpetsc.apply_lifting(residual, [self.jacobian], [self.bcs], [now], -1.0)
        residual.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
        try:
            result = self.contact.evaluate(x)
        except InvertedCellError:
            residual.set(float("inf"))
            return
        self.contact.add_forces(residual, result, -1.0)
        fpetsc.set_bc(residual, self.bcs, now, -1.0)
        self._is_far = residual.norm() > FAR * float((result.forces**2).sum()) ** 0.5

    def J(self, snes: Any, x: Any, matrix: Any, preconditioner: Any) -> None:
        """Derivative, for ``SNES.setJacobian``.

        Parameters
        ----------
        snes : PETSc.SNES
            Not used.
        x : PETSc.Vec
            Displacement.
        matrix, preconditioner : PETSc.Mat
            The second receives the derivative.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        self._take(x)
        preconditioner.zeroEntries()
        fpetsc.assemble_matrix(preconditioner, self.jacobian, self.bcs)
        preconditioner.assemble()
        semidefinite = self._is_far if self.semidefinite is None else self.semidefinite
        tangent = self.contact.tangent(x, semidefinite=semidefinite)
        self.contact.add_tangent(preconditioner, tangent, self.bcs)
        self._tangent = tangent
        if matrix != preconditioner:
            matrix.assemble()

    @property
    def touched(self) -> np.ndarray:
        """Unknowns of this rank that felt contact when the matrix was made last. Collective."""
        return np.empty(0, np.int64) if self._tangent is None else self.contact.touched(self._tangent, self.bcs)

    def bodies(self) -> Any:
        """A new matrix: the derivative without contact at the current displacement. Collective.

        Returns
        -------
        PETSc.Mat
            The matrix.
        """
        matrix = fpetsc.assemble_matrix(self.jacobian, self.bcs)
        matrix.assemble()
        return matrix

    def solver(self) -> Any:
        """A SNES with Newton's method and a direct solver. Change it by its methods or by options.

        Returns
        -------
        PETSc.SNES
            The solver.
        """
        snes = PETSc.SNES().create(self.u.function_space.mesh.comm)
        snes.setFunction(self.F, self.vector)
        snes.setJacobian(self.J, self.matrix)
        # A short step of a line search is no sign of convergence.
        snes.setTolerances(rtol=1e-10, atol=1e-12, stol=0.0, max_it=50)
        solver = snes.getKSP()
        solver.setType("preonly")
        solver.getPC().setType("lu")
        # PETSc's own factorisation knows one rank only, and is slow in 3D.
        if self.u.function_space.mesh.comm.size > 1 or PETSc.Sys.hasExternalPackage("mumps"):
            solver.getPC().setFactorSolverType("mumps")
        solver.setErrorIfNotConverged(True)
        return snes

    def iterative_solver(self, rtol: float = 1e-8) -> Any:
        """A SNES with conjugate gradients and algebraic multigrid (``FilteredMultigrid``), for large problems on any number of ranks.

        The contact is solved directly in the preconditioner. The matrix must be symmetric and positive definite: friction only if frozen.
        Near a stable equilibrium it is; far from one the terms of contact that can be negative are left out.

        Parameters
        ----------
        rtol : float
            Relative tolerance of its linear systems.

        Returns
        -------
        PETSc.SNES
            The solver.
        """
        snes = self.solver()
        solver = snes.getKSP()
        solver.setType("cg")
        solver.setTolerances(rtol=rtol, max_it=500)
        FilteredMultigrid(self.u.function_space, lambda: self.touched, self.bodies).attach(solver.getPC())
        return snes

    def solve(self, snes: Any = None, *, penetration: float | None = None, reach: float = 0.0, max_updates: int = 20) -> int:
        """Solves from the current displacement.

        With ``penetration``, surfaces are moved out from the equilibrium of the law on (``Multipliers.augment``), and stay so for the next
        load step. If an update leaves more than a quarter, the stiffness is raised fourfold, sixteenfold at most, and stays raised.

        Parameters
        ----------
        snes : PETSc.SNES, optional
            Default: ``solver()``.
        penetration : float, optional
            Penetration tolerance: largest mean penetration of a node (length). Not with friction, self-contact or a mesh in parts.
            Default: what the law leaves.
        reach : float
            As for ``Multipliers.augment``.
        max_updates : int
            Number of updates, at most.

        Returns
        -------
        int
            Number of iterations.

        Raises
        ------
        RuntimeError
            If it does not converge. The displacement is then the last one tried.
        """
        snes = self.solver() if snes is None else snes
        iterations = self._solved(snes)
        if penetration is None:
            return iterations
        raising = Raising()
        for update in range(max_updates + 1):
            found = self.contact.contact.multipliers.augment(self.contact.coords(self.u), penetration, reach)
            if found.is_converged:
                return iterations
            raising.updated(self.contact.contact, found.change)
            if update < max_updates:
                iterations += self._solved(snes)
        left = max(found.penetration, found.change)
        raise RuntimeError(f"a penetration of {left:.1e} after {max_updates} updates, {penetration:.1e} is wanted")

    def _solved(self, snes: Any) -> int:
        # SNES gets a vector of its own: the ghosts of the displacement's are updated here.
        x = vector_of(self.u).copy()
        try:
            snes.solve(None, x)
        except PETSc.Error as error:
            # Later releases of petsc4py wrap what a function of ours has raised.
            raise error.__cause__ or error from None
        self._take(x)
        reason = snes.getConvergedReason()
        if reason < 0:
            raise RuntimeError(f"no convergence after {snes.getIterationNumber()} iterations (SNES reason {reason})")
        return snes.getIterationNumber()
