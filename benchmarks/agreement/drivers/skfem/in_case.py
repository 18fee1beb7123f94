"""What the common solver needs of scikit-fem: contact in the numbering of the case."""

from __future__ import annotations

from typing import Any

import numpy as np
from fmc_agreement.problem import Problem
from fmc_contact import Result
from fmc_contact_skfem import SkfemContact
from model import Model
from scipy.sparse import csr_matrix


class Touching:
    """The contact of all bodies, with the obstacles of the case; displacements (nodes, dim) of the case."""

    def __init__(self, problem: Problem, models: list[Model]) -> None:
        first = np.cumsum([0] + [model.basis.N for model in models])
        bases = [(model.basis, int(offset)) for model, offset in zip(models, first)]
        self.adapter = SkfemContact(bases, bodies=problem.body_of_cell, **problem.contact_options())
        self.contact = self.adapter.contact
        problem.add_obstacles(self.contact)
        self.dofs = np.concatenate([(model.dofs + offset).ravel() for model, offset in zip(models, first)])

    def _on_dofs(self, u: np.ndarray) -> np.ndarray:
        found = np.empty(u.size)
        found[self.dofs] = u.ravel()
        return found

    def found(self, u: np.ndarray) -> Result:
        """With forces on the nodes of the contact."""
        return self.adapter.evaluate(self._on_dofs(u))

    def coords(self, u: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown."""
        return self.adapter.coords(self._on_dofs(u))

    def in_case(self, forces: np.ndarray) -> np.ndarray:
        """Forces on these, in the numbering of the case, (size,)."""
        return self.adapter.on_dofs(forces)[self.dofs]

    def force(self, u: np.ndarray) -> np.ndarray:
        """Contact forces (nodes, dim), as the adapter brings them to the unknowns."""
        return self.adapter.force(self._on_dofs(u))[self.dofs].reshape(u.shape)

    def tangent(self, u: np.ndarray, semidefinite: bool, symmetric: bool) -> csr_matrix:
        return self.adapter.tangent(self._on_dofs(u), semidefinite, symmetric)[self.dofs][:, self.dofs]

    def keep_patches(self, u: np.ndarray) -> Any:
        return self.adapter.keep_patches(self._on_dofs(u))

    def begin_step(self, u: np.ndarray) -> None:
        self.adapter.begin_step(self._on_dofs(u))

    def commit_step(self, u: np.ndarray) -> None:
        self.adapter.commit_step(self._on_dofs(u))
