"""What the common solver needs of GetFEM: contact in the numbering of the case."""

from __future__ import annotations

from typing import Any

import numpy as np
from fmc_agreement.problem import Problem
from fmc_contact import Result
from fmc_contact_getfem import GetfemContact
from model import Model
from scipy.sparse import csr_matrix


class Touching:
    """The contact of all bodies, with the obstacles of the case; displacements (nodes, dim) of the case."""

    def __init__(self, problem: Problem, bodies: Model) -> None:
        self.bodies = bodies
        self.adapter = GetfemContact(bodies.model, bodies.variables, bodies=problem.body_of_cell, **problem.contact_options())
        self.contact = self.adapter.contact
        problem.add_obstacles(self.contact)
        self.dofs = bodies.dofs

    def found(self, u: np.ndarray) -> Result:
        """With forces on the nodes of the contact."""
        return self.adapter.evaluate(self.bodies.state(u))

    def coords(self, u: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown."""
        return self.adapter.coords(self.bodies.state(u))

    def in_case(self, forces: np.ndarray) -> np.ndarray:
        """Forces on these, in the numbering of the case, (size,)."""
        return self.adapter.on_dofs(forces)[self.dofs].ravel()

    def force(self, u: np.ndarray) -> np.ndarray:
        """Contact forces (nodes, dim), as the adapter brings them to the unknowns."""
        return self.adapter.force(self.bodies.state(u))[self.dofs]

    def tangent(self, u: np.ndarray, semidefinite: bool, symmetric: bool) -> csr_matrix:
        dofs = self.dofs.ravel()
        return self.adapter.tangent(self.bodies.state(u), semidefinite, symmetric)[dofs][:, dofs]

    def keep_patches(self, u: np.ndarray) -> Any:
        return self.adapter.keep_patches(self.bodies.state(u))

    def begin_step(self, u: np.ndarray) -> None:
        self.adapter.begin_step(self.bodies.state(u))

    def commit_step(self, u: np.ndarray) -> None:
        self.adapter.commit_step(self.bodies.state(u))
