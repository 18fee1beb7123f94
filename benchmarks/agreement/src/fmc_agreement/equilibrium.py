"""Bodies at rest: ``fmc_contact.find_equilibrium`` for hosts that bring internal forces, their derivative, and contact.

Everything is in the numbering of the case: displacements and forces (nodes, dim), unknowns ``node * dim + axis``.
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from fmc_contact import Equilibrium as Found
from fmc_contact import NotConvergedError, find_equilibrium
from scipy.sparse import csr_matrix

from .problem import Problem
from .touching import InCase, Touching


class Elastic(Protocol):
    """Internal forces and their derivative."""

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]: ...

    def stiffness(self, u: np.ndarray) -> csr_matrix: ...


class Equilibrium:
    """A problem, and what the search has taken for it."""

    def __init__(self, problem: Problem, elastic: Elastic, touching: Touching, load: np.ndarray) -> None:
        self.problem, self.elastic, self.touching = problem, elastic, InCase(touching, problem.coords.shape)
        self.full_load, self.load = load, load
        self.free = np.flatnonzero(~problem.held)
        self.options: dict[str, Any] = {"max_iterations": problem.raw["load_steps"]["most_iterations"]}
        self.iterations = self.contact_iterations = self.factorisations = self.updates = 0
        self.residuals: list[float] = []

    def host(self, u: np.ndarray) -> tuple[np.ndarray, csr_matrix, float]:
        """Residual without contact, its derivative, and energy."""
        inside, strain = self.elastic.internal(u)
        if not np.isfinite(strain):
            inside = np.full_like(inside, np.nan)
        return inside - self.load, self.elastic.stiffness(u), strain - float((self.load * u).sum())

    def find(self, u: np.ndarray, prescribed: np.ndarray, tolerance: float, **options: Any) -> Found:
        """Equilibrium from a displacement. Errors: those of ``fmc_contact.find_equilibrium``."""
        try:
            found = find_equilibrium(
                self.host, self.touching, u, self.free, prescribed, tolerance=tolerance,
                find_patches=True, lagged=self.problem.has_friction, **self.options, **options,
            )  # fmt: skip
        except NotConvergedError as error:
            self.iterations += error.iterations
            raise
        self.iterations += found.iterations
        self.contact_iterations += found.contact_iterations
        self.factorisations += found.factorisations
        self.updates += found.updates
        self.residuals += found.residuals
        return found
