"""Contact of the bodies that one or several variables of a model describe."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import getfem as gf
import numpy as np
from fmc_contact import Contact, NodalContact, Result
from numpy.typing import ArrayLike
from scipy.sparse import csr_matrix

from .errors import LayoutError
from .field import field


class GetfemContact:
    """Contact between all bodies of the displacements ``variables`` of a model, with the obstacles that are added to
    ``contact``.

    ``variables``: the name of a fem variable, or several, each with a mesh of its own or not; with as many components as its mesh
    has axes, of continuous Lagrange elements of first or second order (``FEM_PK``, ``FEM_QK``, ``FEM_Q2_INCOMPLETE``; of
    first order also prisms and pyramids), mixed where they fit. ``bodies``: one number for every cell, variable
    after variable, in the order of the cells' numbers; default: bodies are the connected components. ``stiffness`` and
    the other keywords are those of ``fmc_contact.Contact``.

    The Python objects of mesh and mesh_fem have to be there when this one is made, which keeps them: GetFEM finds neither without.

    A displacement ``u`` is the state of the whole model, as ``from_variables`` has it; default: that of now.

    Errors: ``LayoutError`` for a variable of another kind; those of ``fmc_contact.errors``.
    """

    contact: Contact
    """The contact below, for its obstacles (``contact.obstacles.add_half_space``, ...), options and the like."""
    model: gf.Model

    def __init__(
        self,
        model: gf.Model,
        variables: str | Sequence[str],
        *,
        stiffness: float,
        bodies: ArrayLike | None = None,
        **options: Any,
    ) -> None:
        if model.is_complex():
            raise LayoutError("the model is complex")
        self.model, names = model, [variables] if isinstance(variables, str) else list(variables)
        if not names:
            raise ValueError("there is no variable")
        self._fields = {name: field(model, name) for name in names}
        self._undeformed = np.concatenate([one.coords for one in self._fields.values()])
        blocks, cells, first, before = [], [], 0, 0
        for one in self._fields.values():
            for kind, conn, numbers in one.cells:
                blocks.append((kind, conn + first))
                cells.append(numbers + before)
            first += len(one.coords)
            before += sum(len(numbers) for *_, numbers in one.cells)
        if bodies is not None:
            bodies = np.asarray(bodies)
            if bodies.shape != (before,):
                raise ValueError(f"bodies have shape {bodies.shape}, ({before},) is wanted")
            bodies = bodies[np.concatenate(cells)]
        self.contact = Contact(self._undeformed, blocks, bodies=bodies, stiffness=stiffness, **options)

    @property
    def variables(self) -> list[str]:
        """Names of the displacements."""
        return list(self._fields)

    @property
    def size(self) -> int:
        """Number of unknowns of the model."""
        return self.model.nbdof()

    @property
    def dofs(self) -> np.ndarray:
        """Unknowns of the nodes in the state of the model, (nodes, dim): another variable may have moved them."""
        return np.concatenate([one.dofs + self.interval(name)[0] for name, one in self._fields.items()])

    def interval(self, variable: str) -> tuple[int, int]:
        """First unknown of a variable in the state of the model, and how many it has."""
        first, count = (int(number) for number in self.model.interval_of_variable(variable))
        if count != self._fields[variable].size:
            raise LayoutError(f"'{variable}' had {self._fields[variable].size} unknowns and has {count} now")
        return first, count

    def nodes(self, variable: str, region: int | None = None) -> np.ndarray:
        """Nodes of the contact that are of a variable, ascending, all or those of a region of its mesh: for
        ``contact.mesh.set_symmetry_nodes``."""
        names = self.variables
        first = sum(len(self._fields[name].coords) for name in names[: names.index(variable)])
        one = self._fields[variable]
        if region is None:
            return first + np.arange(len(one.coords))
        chosen = one.space.basic_dof_on_region(region)
        return first + np.flatnonzero(np.isin(one.dofs[:, 0], chosen))

    def coords(self, u: np.ndarray | None = None) -> np.ndarray:
        """Coordinates of the nodes at the state ``u``, (nodes, dim)."""
        u = np.asarray(self.model.from_variables() if u is None else u)
        if u.shape != (self.size,):
            raise ValueError(f"the state has shape {u.shape}, ({self.size},) is wanted")
        return self._undeformed + u[self.dofs]

    def evaluate(self, u: np.ndarray | None = None) -> Result:
        """All that ``fmc_contact`` says at a state: energy, resultants, warnings; forces on the nodes of ``coords``. Errors:
        those of ``Contact.evaluate``."""
        return self.contact.evaluate(self.coords(u))

    def force(self, u: np.ndarray | None = None) -> np.ndarray:
        """Contact forces on the unknowns of the model, (size,): to be added to its right-hand side."""
        return self.on_dofs(self.evaluate(u).forces)

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        """Forces of ``evaluate`` brought to the unknowns of the model, (size,)."""
        total = np.zeros(self.size)
        total[self.dofs] = forces
        return total

    def tangent(self, u: np.ndarray | None = None, semidefinite: bool = False, symmetric: bool = False) -> csr_matrix:
        """Minus the derivative of ``force``, (size, size): to be added to the tangent matrix. UNSYMMETRIC with friction: solve
        with LU, or ask for ``symmetric``, which takes more iterations. ``semidefinite`` leaves out what can be negative,
        for use far from a solution."""
        parts = self.contact.tangent_parts(self.coords(u), semidefinite, symmetric=symmetric)
        rows, cols, values = parts.triplets()
        dofs = self.dofs.ravel()
        return csr_matrix((values, (dofs[rows], dofs[cols])), shape=(self.size, self.size))

    def nodal_contact(self, u: np.ndarray | None = None) -> NodalContact:
        """Pressure, gap, area and normal at a state, on the nodes of ``coords``. Errors: those of ``Contact.evaluate``."""
        return self.contact.nodal_contact(self.coords(u))

    def on_mesh_fem(self, values: np.ndarray, variable: str) -> np.ndarray:
        """Values at the nodes of ``coords``, (nodes, ...), in the order of a mesh_fem of one component with the elements of the
        variable, for ``export_to_vtu``: (nodes of the variable, ...)."""
        one = self._fields[variable]
        found = np.empty((len(one.coords), *np.shape(values)[1:]))
        found[one.dofs[:, 0] // one.coords.shape[1]] = np.asarray(values)[self.nodes(variable)]
        return found

    def begin_step(self, u: np.ndarray | None = None) -> None:
        """Begins a step with friction at ``u``. See ``FrictionSteps.begin_step``."""
        self.contact.friction.begin_step(self.coords(u))

    def commit_step(self, u: np.ndarray | None = None) -> None:
        """Accepts the step with friction that ends at ``u``, and begins the next. See ``FrictionSteps.commit_step``."""
        self.contact.friction.commit_step(self.coords(u))

    def freeze_friction(self, u: np.ndarray | None = None) -> None:
        """Freezes friction as it is at ``u``. See ``FrictionSteps.freeze``."""
        self.contact.friction.freeze(self.coords(u))

    def keep_patches(self, u: np.ndarray | None = None) -> int:
        """Keeps the directions of the law ``"fiber"`` found at ``u``, so that forces are the gradient of one energy: for the
        start of a load step. See ``Patches.keep``."""
        return self.contact.patches.keep(self.coords(u))
