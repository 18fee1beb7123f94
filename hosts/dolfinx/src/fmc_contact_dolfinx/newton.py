"""Equilibrium by the Newton's method of ``fmc_contact``, on one rank."""

from __future__ import annotations

from typing import Any

import dolfinx.fem.petsc as fpetsc
import fmc_contact
import numpy as np
from fmc_contact import Equilibrium, Result
from scipy.sparse import csr_matrix

from .adapter import DolfinxContact
from .snes import ContactProblem
from .versions import held_dofs, vector_of


def newton(problem: ContactProblem, *, young: float, **options: Any) -> Equilibrium:
    """Equilibrium at the end of a load step, by ``fmc_contact.newton``, on one rank.

    The displacement is that of the step's start, best the last equilibrium, not yet moved by the boundary conditions. It receives the
    solution.

    Parameters
    ----------
    problem : ContactProblem
        Its boundary conditions give the prescribed unknowns at the end of the step.
    young : float
        Young's modulus of the softest body (pressure).
    **options
        As for ``fmc_contact.newton``, including ``penetration``.

    Returns
    -------
    Equilibrium
        As from ``fmc_contact.newton``; ``x`` are all unknowns.

    Raises
    ------
    NotImplementedError
        On several ranks: use ``ContactProblem.solve``.
    NotConvergedError
        As ``fmc_contact.newton`` raises.

    Examples
    --------
    >>> newton(problem, young=1e9).iterations
    """
    space = problem.u.function_space
    comm = space.mesh.comm
    if comm.size > 1:
        raise NotImplementedError(f"newton runs on one rank, these are {comm.size}: ContactProblem.solve runs on any")
    start = vector_of(problem.u).array.copy()
    prescribed = vector_of(problem.u).copy()
    fpetsc.set_bc(prescribed, problem.bcs)
    held = [held_dofs(bc) for bc in problem.bcs]
    free = np.setdiff1d(np.arange(start.size), np.concatenate(held) if held else [])
    # Kept with the problem: factors of linear bodies serve later load steps.
    if problem.on_unknowns is None:
        problem.on_unknowns = _OnUnknowns(problem.contact)
    found = fmc_contact.newton(
        lambda x: _bodies(problem, x), problem.on_unknowns, start, free, prescribed.array, young=young, **options
    )
    _take(problem, found.x)
    return found


class _OnUnknowns:
    """A contact in the numbering of the unknowns, as ``fmc_contact.newton`` wants it."""

    def __init__(self, adapter: DolfinxContact) -> None:
        self.adapter, self.contact = adapter, adapter.contact

    def evaluate(self, x: np.ndarray) -> Result:
        return self.adapter.evaluate(x)

    def coords(self, x: np.ndarray) -> np.ndarray:
        return self.adapter.coords(x)

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        return self.adapter.on_unknowns(forces)

    def tangent(self, x: np.ndarray, semidefinite: bool) -> csr_matrix:
        found, unknown = self.adapter.tangent(x, semidefinite=semidefinite), self.adapter.unknowns()
        return csr_matrix((found.values, (unknown[found.rows], unknown[found.cols])), (x.size, x.size))


def _take(problem: ContactProblem, x: np.ndarray) -> None:
    problem.u.x.array[: x.size] = x
    problem.u.x.scatter_forward()


def _bodies(problem: ContactProblem, x: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
    """The residual without contact, and its derivative, of all unknowns, the held ones too."""
    _take(problem, x)
    residual = fpetsc.assemble_vector(problem.residual)
    matrix = fpetsc.assemble_matrix(problem.jacobian)
    matrix.assemble()
    starts, columns, values = matrix.getValuesCSR()
    found = residual.array.copy(), csr_matrix((values, columns, starts), matrix.getSize())
    residual.destroy()
    matrix.destroy()
    return found
