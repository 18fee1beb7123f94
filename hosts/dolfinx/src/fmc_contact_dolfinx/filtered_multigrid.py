"""Algebraic multigrid for elasticity with contact, on any number of ranks."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from petsc4py import PETSc


class FilteredMultigrid:
    """Algebraic multigrid, with the unknowns that feel contact solved directly in between.

    Contact that is much stiffer than the bodies couples unknowns that multigrid does not see as neighbours, so that it converges ever more slowly. B
    is a cycle of multigrid, P selects the unknowns that feel contact, and S = (Pᵀ A P)⁻¹. The preconditioner M has I - M A = (I - B A)(I - P S Pᵀ
    A)(I - B A): two cycles and one direct solve on the contact. It is symmetric and positive definite if A and B are, so that conjugate gradients
    take it. It is known as AMG with filtering (arXiv 2505.18576).

    Levels are found from the bodies without contact: an aggregate that reaches from one body into the other moves as one, and coarser
    levels then see sliding badly. The matrix of each level follows from the matrix with contact.

    Parameters
    ----------
    space : FunctionSpace
        Space of the displacement, Lagrange of first order, for its rigid body motions.
    touched : callable
        Returns the unknowns of this rank that feel contact, as PETSc numbers them over all ranks. Called at every set-up.
    bodies : callable, optional
        Returns the matrix without contact. Called at the first set-up. Default: levels are found from the matrix with contact, each time.
    cycle : str
        Type of the multigrid: ``"gamg"``, or ``"hypre"`` if PETSc has it, without ``bodies``.
    filtered : bool
        False: multigrid alone.

    Raises
    ------
    ValueError
        For ``bodies`` with another multigrid than ``"gamg"``.

    Examples
    --------
    >>> FilteredMultigrid(space, lambda: problem.touched, problem.bodies).attach(pc)
    """

    def __init__(
        self,
        space: Any,
        touched: Callable[[], np.ndarray],
        bodies: Callable[[], Any] | None = None,
        cycle: str = "gamg",
        filtered: bool = True,
    ) -> None:
        if bodies is not None and cycle != "gamg":
            raise ValueError(f"levels of the bodies come from gamg, not from {cycle}")
        self._touched, self._bodies, self._cycle, self.filtered = touched, bodies, cycle, filtered
        self._rigid = rigid_motions(space)
        self._levels: list[Any] = []

    def attach(self, pc: Any) -> None:
        """Makes a PETSc preconditioner this one.

        Parameters
        ----------
        pc : PETSc.PC
            The preconditioner.
        """
        pc.setType("python")
        pc.setPythonContext(self)

    def setUp(self, pc: Any) -> None:
        """Called by PETSc whenever the matrix has changed.

        Parameters
        ----------
        pc : PETSc.PC
            The preconditioner.
        """
        self._matrix = matrix = pc.getOperators()[1]
        if self._bodies is None:
            self._multigrid = self._made(matrix, self._cycle, "contact_multigrid_")
        else:
            if not self._levels:
                found = self._made(self._bodies(), self._cycle, "contact_levels_")
                self._levels = [found.getMGInterpolation(level) for level in range(1, found.getMGLevels())]
            self._multigrid = self._cycle_on_levels(matrix)
        self._rest, self._step = matrix.createVecs()
        rows = np.sort(np.asarray(self._touched(), PETSc.IntType))
        self.count = pc.comm.tompi4py().allreduce(len(rows)) if self.filtered else 0
        """Unknowns that are solved directly."""
        if not self.count:
            return
        self._rows = PETSc.IS().createGeneral(rows, comm=pc.comm)
        inner = matrix.createSubMatrix(self._rows, self._rows)
        self._direct = PETSc.PC().create(pc.comm)
        self._direct.setOperators(inner)
        # PETSc's own factorisation knows one rank only.
        if pc.comm.size > 1 or PETSc.Sys.hasExternalPackage("mumps"):
            self._direct.setType("cholesky")
            self._direct.setFactorSolverType("mumps")
        else:
            self._direct.setType("lu")
        self._direct.setUp()
        self._inner_rest, self._inner_step = inner.createVecs()

    def _made(self, matrix: Any, kind: str, prefix: str) -> Any:
        matrix.setNearNullSpace(self._rigid)
        made = PETSc.PC().create(matrix.comm)
        made.setOperators(matrix)
        made.setType(kind)
        made.setOptionsPrefix(prefix)
        made.setFromOptions()
        made.setUp()
        return made

    def _cycle_on_levels(self, matrix: Any) -> Any:
        made = PETSc.PC().create(matrix.comm)
        made.setOperators(matrix)
        made.setType("mg")
        made.setMGLevels(1 + len(self._levels))
        for level, interpolation in enumerate(self._levels, 1):
            made.setMGInterpolation(level, interpolation)
        made.setOptionsPrefix("contact_multigrid_")
        # petsc4py has no function for it.
        options = PETSc.Options("contact_multigrid_")
        options["pc_mg_galerkin"] = "both"
        if "mg_levels_ksp_max_it" not in options:
            # Sweeps end at the border of a rank: with two of them, PETSc's default, four ranks take up to 1.25 times the iterations of one.
            options["mg_levels_ksp_max_it"] = 3
        made.setFromOptions()
        made.setUp()
        return made

    def apply(self, pc: Any, x: Any, y: Any) -> None:
        """Applies the preconditioner; called by PETSc.

        Parameters
        ----------
        pc : PETSc.PC
            The preconditioner.
        x, y : PETSc.Vec
            Argument and result.
        """
        self._multigrid.apply(x, y)
        if not self.count:
            return
        self._residual(x, y)
        part = self._rest.getSubVector(self._rows)
        part.copy(self._inner_rest)
        self._rest.restoreSubVector(self._rows, part)
        self._direct.apply(self._inner_rest, self._inner_step)
        part = y.getSubVector(self._rows)
        part.axpy(1.0, self._inner_step)
        y.restoreSubVector(self._rows, part)
        self._residual(x, y)
        self._multigrid.apply(self._rest, self._step)
        y.axpy(1.0, self._step)

    def _residual(self, x: Any, y: Any) -> None:
        self._matrix.mult(y, self._rest)
        self._rest.aypx(-1.0, x)


def rigid_motions(space: Any) -> Any:
    """The rigid body motions of a space of displacements, Lagrange of first order, for multigrid."""
    dim = space.mesh.geometry.dim
    index_map = space.dofmap.index_map
    coords = PETSc.Vec().create(space.mesh.comm)
    coords.setBlockSize(dim)
    coords.setSizes((index_map.size_local * dim, index_map.size_global * dim))
    coords.setUp()
    coords.setArray(space.tabulate_dof_coordinates()[: index_map.size_local, :dim].ravel())
    return PETSc.NullSpace().createRigidBody(coords)
