"""Forms, boundary conditions and contact of one load step."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import dolfinx.fem.petsc as fpetsc
import numpy as np
import ufl
from dolfinx import fem
from petsc4py import PETSc

from .adapter import DolfinxContact
from .filtered_multigrid import FilteredMultigrid
from .system import System


class ContactProblem:
    """Bodies and their contact, for ``find_equilibrium``. On any number of ranks; all methods are collective.

    Parameters
    ----------
    residual : ufl form or list of ufl form
        Internal minus external forces, without contact; one for every space of the contact.
    u : Function or list of Function
        Displacements: hold the start, and receive the solution.
    bcs : sequence of DirichletBC
        Boundary conditions of all spaces.
    contact : DolfinxContact
        The contact.
    jacobian : ufl form or list of ufl form, optional
        Derivatives of the residual. Default: by UFL.

    Attributes
    ----------
    touched : ndarray of int
        Unknowns of this rank that felt contact in the last linear system, as PETSc numbers them over all ranks.

    Raises
    ------
    ValueError
        If there is not one form and one displacement for every space.

    Examples
    --------
    >>> problem = ContactProblem(residual_form, u, bcs, contact)
    >>> find_equilibrium(problem).iterations
    """

    def __init__(self, residual: Any, u: Any, bcs: Sequence[Any], contact: DolfinxContact, jacobian: Any = None) -> None:
        self.u, self.bcs, self.contact, self.us = u, list(bcs), contact, _listed(u)
        residuals = _listed(residual)
        if jacobian is None:
            jacobians = [ufl.derivative(r, u, ufl.TrialFunction(u.function_space)) for r, u in zip(residuals, self.us)]
        else:
            jacobians = _listed(jacobian)
        counts = [len(one) for one in (residuals, self.us, jacobians)]
        if counts != [contact.space_count] * 3:
            raise ValueError(f"{counts} residuals, displacements and derivatives, the contact has {contact.space_count} spaces")
        self.system = System(self.us, [fem.form(one) for one in residuals], [fem.form(one) for one in jacobians], self.bcs, contact)
        self.touched = np.empty(0, np.int64)
        self.on_unknowns: Any = None

    def functions(self, values: np.ndarray, name: str = "reactions") -> Any:
        """Values of all unknowns, such as ``Equilibrium.reactions``, as functions.

        Parameters
        ----------
        values : ndarray, (size,)
            The values.
        name : str
            Name of the functions.

        Returns
        -------
        Function or list of Function
            A list for a list of displacements.
        """
        found = []
        for u, own in zip(self.us, self.system.by_space(values)):
            found.append(fem.Function(u.function_space, name=name))
            found[-1].x.array[: own.size] = own
            found[-1].x.scatter_forward()
        return found if isinstance(self.u, (list, tuple)) else found[0]

    def bodies(self) -> Any:
        """A new matrix of one space: the derivative without contact at the current displacement, with ones where it is held. Collective.

        Returns
        -------
        PETSc.Mat
            The matrix.
        """
        matrix = fpetsc.assemble_matrix(self.system.jacobians[0], self.bcs)
        matrix.assemble()
        return matrix

    def iterative_solver(self, rtol: float = 1e-8) -> Any:
        """Conjugate gradients with algebraic multigrid (``FilteredMultigrid``), for large problems of one space on any number of ranks.

        The contact is solved directly in the preconditioner. The matrix must be symmetric: friction only if frozen (``lagged``).

        Parameters
        ----------
        rtol : float
            Relative tolerance of its linear systems.

        Returns
        -------
        PETSc.KSP
            The solver, for ``find_equilibrium``.
        """
        solver = PETSc.KSP().create(self.contact.comm)
        solver.setType("cg")
        solver.setTolerances(rtol=rtol, max_it=500)
        FilteredMultigrid(self.us[0].function_space, lambda: self.touched, self.bodies).attach(solver.getPC())
        return solver


def _listed(one: Any) -> list[Any]:
    return list(one) if isinstance(one, (list, tuple)) else [one]
