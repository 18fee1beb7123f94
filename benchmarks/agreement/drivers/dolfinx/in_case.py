"""What the common solver needs of dolfinx, on one rank: bodies and contact in the numbering of the case."""

from __future__ import annotations

from typing import Any

import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc as fpetsc
from fmc_agreement.problem import Problem
from fmc_contact import Result
from fmc_contact_dolfinx import DolfinxContact
from model import Model
from scipy.sparse import csr_matrix


class Part:
    """A model whose nodes are counted as in its case."""

    def __init__(self, model: Model) -> None:
        self.model = model
        block = np.empty(len(model.input_number), int)
        of_cells = model.displacement.node_blocks()
        block[model.input_number[model.displacement.given_geometry(len(of_cells)).ravel()]] = of_cells.ravel()
        self.dofs = (block[:, None] * model.dim + np.arange(model.dim)).ravel()
        """Unknown of every ``node * dim + axis``."""
        derivative = ufl.derivative(model.internal, model.u, ufl.TrialFunction(model.space))
        self.energy, self.force, self.derivative = map(fem.form, (model.energy, model.internal, derivative))
        self.is_linear = {body.material.law for body in model.problem.bodies} == {"linear-elastic"}
        self._constant: csr_matrix | None = None

    def take(self, u: np.ndarray) -> None:
        """Puts displacements (nodes, dim) into the model."""
        self.model.u.x.array[self.dofs] = u.ravel()

    def load(self) -> np.ndarray:
        """Forces of the tractions, (nodes, dim)."""
        load = self.model.load
        at = np.zeros(len(self.dofs)) if load is None else self.model.assembled(fem.form(load))[self.dofs]
        return at.reshape(-1, self.model.dim)

    def elastic(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces and strain energy."""
        self.take(u)
        force = self.model.assembled(self.force)[self.dofs]
        return force.reshape(u.shape), float(fem.assemble_scalar(self.energy))

    def stiffness(self, u: np.ndarray) -> csr_matrix:
        """Derivative of the internal forces."""
        if self._constant is not None:
            return self._constant
        self.take(u)
        assembled = fpetsc.assemble_matrix(self.derivative)
        assembled.assemble()
        starts, columns, values = assembled.getValuesCSR()
        found = csr_matrix((values, columns, starts), assembled.getSize())[self.dofs][:, self.dofs]
        assembled.destroy()
        if self.is_linear:
            self._constant = found
        return found


class Touching:
    """The contact of all bodies, with the obstacles of the case; displacements (nodes, dim) of the case."""

    def __init__(self, problem: Problem, parts: list[Part]) -> None:
        self.parts = parts
        first = np.cumsum([0] + [len(part.model.problem.bodies) for part in parts])
        bodies = [part.model.body_of_cell + number for part, number in zip(parts, first)]
        spaces = [part.model.space for part in parts]
        self.adapter = DolfinxContact(spaces, bodies=bodies, whole_mesh=True, **problem.contact_options())
        self.contact = self.adapter.contact
        problem.add_obstacles(self.contact)
        self._ends = np.cumsum([len(part.model.problem.coords) for part in parts])[:-1]

    def _taken(self, u: np.ndarray) -> list[Any]:
        for part, at in zip(self.parts, np.split(u, self._ends)):
            part.take(at)
        return [part.model.u for part in self.parts]

    def found(self, u: np.ndarray) -> Result:
        """With forces on the nodes of the contact."""
        return self.adapter.evaluate(*self._taken(u))

    def coords(self, u: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown."""
        return self.adapter.coords(*self._taken(u))

    def in_case(self, forces: np.ndarray) -> np.ndarray:
        """Forces on these, in the numbering of the case, (size,)."""
        found = self.adapter.on_unknowns(forces)
        owned = found if len(self.parts) > 1 else [found]
        return np.concatenate([force[part.dofs] for part, force in zip(self.parts, owned)])

    def force(self, u: np.ndarray) -> np.ndarray:
        """Contact forces (nodes, dim), as the adapter brings them to the unknowns."""
        return self.in_case(self.found(u).forces).reshape(u.shape)

    def tangent(self, u: np.ndarray, semidefinite: bool, symmetric: bool) -> csr_matrix:
        found = self.adapter.tangent(*self._taken(u), semidefinite=semidefinite, symmetric=symmetric)
        number = self._number_of_rows()
        return csr_matrix((found.values, (number[found.rows], number[found.cols])), (u.size, u.size))

    def _number_of_rows(self) -> np.ndarray:
        """``node * dim + axis`` of the case for every row of the adapter's tangent, spaces one after another."""
        sizes = [len(part.dofs) for part in self.parts]
        ends = np.cumsum(sizes)
        found = []
        for part, first, unknowns in zip(self.parts, ends - sizes, np.split(self.adapter.unknowns(), ends[:-1])):
            number = np.empty(len(part.dofs), int)
            number[part.dofs] = np.arange(len(part.dofs))
            found.append(first + number[unknowns])
        return np.concatenate(found)

    def keep_patches(self, u: np.ndarray) -> Any:
        return self.adapter.keep_patches(*self._taken(u))

    def begin_step(self, u: np.ndarray) -> None:
        self.adapter.begin_step(*self._taken(u))

    def commit_step(self, u: np.ndarray) -> None:
        self.adapter.commit_step(*self._taken(u))
