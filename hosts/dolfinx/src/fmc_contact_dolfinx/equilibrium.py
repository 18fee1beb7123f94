"""Equilibrium at the end of a load step, by the library's search."""

from __future__ import annotations

from typing import Any

import fmc_contact
import numpy as np
from fmc_contact import Equilibrium, Result
from scipy.sparse import csr_matrix

from .adapter import DolfinxContact
from .on_ranks import OnRanks
from .problem import ContactProblem
from .system import System
from .together import together


def find_equilibrium(problem: ContactProblem, solver: Any = None, **options: Any) -> Equilibrium:
    """Equilibrium at the end of a load step, by ``fmc_contact.find_equilibrium``. On any number of ranks; collective.

    The displacements belong to the start of the step, best the last equilibrium, before the boundary conditions move them. They receive the solution,
    or stay where they are if there is none. On several ranks all of them make the same search, each with the values of all unknowns, and share
    matrices and linear systems.

    Parameters
    ----------
    problem : ContactProblem
        Its boundary conditions give the prescribed unknowns at the end of the step. The contact may be made without a stiffness.
    solver : PETSc.KSP, optional
        Linear solver, such as ``problem.iterative_solver()``. Default: on one rank as in ``fmc_contact.find_equilibrium``, which also condenses the
        bodies; on several ranks MUMPS.
    **options
        As for ``fmc_contact.find_equilibrium``: ``tolerance``, ``penetration``, ``lagged``, ...

    Returns
    -------
    Equilibrium
        As from ``fmc_contact.find_equilibrium``, the same on every rank. ``x`` and ``reactions`` are of all unknowns:
        ``problem.functions(found.reactions)``.

    Raises
    ------
    ValueError
        If the mesh of the contact is in parts.
    NoSupportError
        As ``fmc_contact.find_equilibrium`` raises, on all ranks.
    NotConvergedError
        The same.

    Examples
    --------
    >>> find_equilibrium(problem).iterations
    """
    adapter, system = problem.contact, problem.system
    if not adapter.whole_because:
        raise ValueError("the mesh is in parts, and a search needs all of it on every rank: DolfinxContact(..., in_parts=False)")
    # Kept with the problem: factors of linear bodies serve later load steps.
    if problem.on_unknowns is None:
        problem.on_unknowns = _OnUnknowns(adapter, system)
    start, prescribed, is_held = system.start(), system.prescribed(), system.held()
    bodies: Any = OnRanks(problem, problem.on_unknowns, is_held, solver)
    if adapter.comm.size == 1 and solver is None:
        bodies = lambda x: _linearised(system, x)
    end = start
    try:
        search = lambda: fmc_contact.find_equilibrium(bodies, problem.on_unknowns, start, ~is_held, prescribed, **options)
        found = together(adapter.comm, search)
        end = found.x
    finally:
        system.take(end)
    return found


def _linearised(system: System, x: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
    system.take(x)
    return system.forces(), system.stiffness()


class _OnUnknowns:
    """A contact in the numbering of all unknowns. Its tangent has the rows of this rank."""

    def __init__(self, adapter: DolfinxContact, system: System) -> None:
        self.adapter, self.contact, self.unknowns, self._by_space = adapter, adapter.contact, system.unknowns, system.by_space
        spaces = adapter.spaces()
        self._numbers = np.empty(len(spaces), np.int64)
        for space in range(adapter.space_count):
            here = spaces == space
            self._numbers[here] = self.unknowns.numbers(space, adapter.unknowns()[here])

    def evaluate(self, x: np.ndarray) -> Result:
        return self.adapter.evaluate(*self._by_space(x))

    def coords(self, x: np.ndarray) -> np.ndarray:
        return self.adapter.coords(*self._by_space(x))

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        found = self.adapter.on_unknowns(forces)
        return self.unknowns.gather(np.concatenate(found) if isinstance(found, list) else found)

    def tangent(self, x: np.ndarray, semidefinite: bool = False, symmetric: bool = False) -> csr_matrix:
        unknowns, first = self.unknowns, self.unknowns.first
        found = self.adapter.tangent(*self._by_space(x), semidefinite=semidefinite, symmetric=symmetric)
        rows, cols, values = self._numbers[found.rows] - first, self._numbers[found.cols], np.asarray(found.values)
        own = (rows >= 0) & (rows < unknowns.count)
        return csr_matrix((values[own], (rows[own], cols[own])), (unknowns.count, unknowns.size))
