"""Contact of the bodies that one or several variables of a model describe."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import getfem as gf
import numpy as np
from fmc_contact import Contact, NodalContact, Result
from fmc_contact.boundary import facets_on
from fmc_contact.smoothing import SmoothesSurfaces
from numpy.typing import ArrayLike
from scipy.sparse import csr_matrix

from .errors import LayoutError
from .field import fields


class GetfemContact(SmoothesSurfaces):
    """Contact between all bodies of the displacements of a model, and with the obstacles that are added to ``contact``.

    This object keeps the Python objects of mesh and mesh_fem. They must still exist when it is made: GetFEM finds neither without them.

    Parameters
    ----------
    model : getfem.Model
        A real model.
    variables : str or sequence of str
        Name of a fem variable, or several, on one mesh or more: displacements of continuous Lagrange elements of first or second order (``FEM_PK``,
        ``FEM_QK``, ``FEM_Q2_INCOMPLETE``). First order includes prisms and pyramids. Elements may be mixed if they conform.
    stiffness : float, optional
        Stiffness of the law: pressure per length for the default law. Default 0: ``find_equilibrium`` finds one from the bodies' matrix.
        Until then an evaluation raises ``NoStiffnessError``.
    bodies : array_like of int, (cells,), optional
        Body of every cell, variable after variable, in the order of the cells' numbers. Default: bodies are the connected components.
    **options : OtherOptions
        As for ``fmc_contact.Contact``.

    Attributes
    ----------
    contact : Contact
        The contact below, for its obstacles (``contact.obstacles.add_half_space``, ...), options, pairs and so on.
    model : getfem.Model
        The model.

    Raises
    ------
    LayoutError
        For a variable of another kind or another dimension, one that is named twice, and two of the same cells.
    FmcError
        As ``fmc_contact.Contact`` raises.

    Examples
    --------
    >>> contact = GetfemContact(model, "u")
    >>> find_equilibrium(contact).iterations
    """

    contact: Contact
    """The contact below, for its obstacles (``contact.obstacles.add_half_space``, ...), options and the like."""
    model: gf.Model

    def __init__(
        self,
        model: gf.Model,
        variables: str | Sequence[str],
        *,
        stiffness: float = 0.0,
        bodies: ArrayLike | None = None,
        **options: Any,
    ) -> None:
        if model.is_complex():
            raise LayoutError("the model is complex")
        self.model, names = model, [variables] if isinstance(variables, str) else list(variables)
        if not names:
            raise ValueError("there is no variable")
        self._fields = fields(model, names)
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
                raise ValueError(f"bodies have shape {bodies.shape}, expected ({before},)")
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
        """Place of a variable in the state of the model.

        Parameters
        ----------
        variable : str
            Its name.

        Returns
        -------
        first : int
            Its first unknown.
        count : int
            How many it has.

        Raises
        ------
        LayoutError
            If it has another number of unknowns than at first.
        """
        first, count = (int(number) for number in self.model.interval_of_variable(variable))
        if count != self._fields[variable].size:
            raise LayoutError(f"'{variable}' had {self._fields[variable].size} unknowns and has {count} now")
        return first, count

    def nodes(self, variable: str, region: int | None = None) -> np.ndarray:
        """Nodes of the contact that belong to a variable, ascending: for ``contact.mesh.set_symmetry_nodes``.

        Parameters
        ----------
        variable : str
            Its name.
        region : int, optional
            A region of its mesh. Default: all nodes.

        Returns
        -------
        ndarray of int
            Numbers of the nodes.
        """
        names = self.variables
        first = sum(len(self._fields[name].coords) for name in names[: names.index(variable)])
        one = self._fields[variable]
        if region is None:
            return first + np.arange(len(one.coords))
        chosen = one.space.basic_dof_on_region(region)
        return first + np.flatnonzero(np.isin(one.dofs[:, 0], chosen))

    def set_symmetry_regions(self, *regions: int) -> None:
        """Names the regions of boundary faces that lie in planes of symmetry, and replaces earlier planes.

        See ``Mesh.set_symmetry_facets``, which is told of all facets of these regions. A region may have several planes.

        Parameters
        ----------
        *regions : int
            Regions of the mesh of any variable. Without a region there is no plane of symmetry.

        Raises
        ------
        ValueError
            If no mesh has such a region, and as ``Mesh.set_symmetry_facets`` raises.
        UnsupportedError
            If a body would have no surface left.

        Examples
        --------
        >>> contact.set_symmetry_regions(3, 4)
        """
        known = sorted({int(region) for one in self._fields.values() for region in one.mesh.regions()})
        for region in regions:
            if region not in known:
                raise ValueError(f"no mesh has a region {region!r}; there are {known}")
        first, faces = 0, [np.empty((0, 2), int)]
        for one in self._fields.values():
            faces.append(one.faces_on(regions) + [first, 0])
            first += sum(len(numbers) for *_, numbers in one.cells)
        cells, numbers = np.concatenate(faces).T
        mesh = self.contact.mesh
        mesh.set_symmetry_facets(facets_on(mesh.boundary_facets(), cells, numbers), self._undeformed)

    def coords(self, u: np.ndarray | None = None) -> np.ndarray:
        """Coordinates of the nodes of the contact at a state.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Returns
        -------
        ndarray, (nodes, dim)
            The coordinates.

        Raises
        ------
        ValueError
            If the state has another shape.
        """
        u = np.asarray(self.model.from_variables() if u is None else u)
        if u.shape != (self.size,):
            raise ValueError(f"the state has shape {u.shape}, expected ({self.size},)")
        return self._undeformed + u[self.dofs]

    def evaluate(self, u: np.ndarray | None = None) -> Result:
        """Result of the contact at a displacement; forces are those on the nodes of ``coords``.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Returns
        -------
        Result
            Energy, forces, resultants, pairs and warnings.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        """
        return self.contact.evaluate(self.coords(u))

    def force(self, u: np.ndarray | None = None) -> np.ndarray:
        """Contact forces on the degrees of freedom: an external load, to be subtracted from a residual.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Returns
        -------
        ndarray, (size,)
            The forces.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        """
        return self.on_dofs(self.evaluate(u).forces)

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        """Brings the forces of ``evaluate`` to the unknowns of the model.

        Parameters
        ----------
        forces : ndarray, (nodes, dim)
            ``Result.forces``.

        Returns
        -------
        ndarray, (size,)
            The forces.
        """
        total = np.zeros(self.size)
        total[self.dofs] = forces
        return total

    def tangent(self, u: np.ndarray | None = None, semidefinite: bool = False, symmetric: bool = False) -> csr_matrix:
        """Tangent stiffness: minus the derivative of ``force``, to be added to a stiffness matrix.

        With friction it is UNSYMMETRIC: solve with LU, or ask for ``symmetric``.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.
        semidefinite : bool
            Whether to leave out terms that can be negative, for use far from a solution.
        symmetric : bool
            Whether to return the symmetric part, with which Newton's method takes more iterations under friction.

        Returns
        -------
        scipy.sparse.csr_matrix, (size, size)
            The matrix.

        Raises
        ------
        UnsupportedError
            For a law or an estimator without a tangent.
        FmcError
            As ``Contact.evaluate`` raises.
        """
        parts = self.contact.tangent_parts(self.coords(u), semidefinite, symmetric=symmetric)
        rows, cols, values = parts.triplets()
        dofs = self.dofs.ravel()
        return csr_matrix((values, (dofs[rows], dofs[cols])), shape=(self.size, self.size))

    def nodal_contact(self, u: np.ndarray | None = None) -> NodalContact:
        """Pressure, gap, area, normal and friction at every node, for output.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Returns
        -------
        NodalContact
            Arrays over the nodes of ``coords``.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        """
        return self.contact.nodal_contact(self.coords(u))

    def on_mesh_fem(self, values: np.ndarray, variable: str) -> np.ndarray:
        """Values at the nodes of ``coords`` in the order of a scalar mesh_fem, for ``export_to_vtu``.

        Parameters
        ----------
        values : array_like, (nodes, ...)
            An array of ``nodal_contact``.
        variable : str
            A variable with the elements of the mesh_fem.

        Returns
        -------
        ndarray, (nodes of the variable, ...)
            The values.
        """
        one = self._fields[variable]
        found = np.empty((len(one.coords), *np.shape(values)[1:]))
        found[one.dofs[:, 0] // one.coords.shape[1]] = np.asarray(values)[self.nodes(variable)]
        return found

    def begin_step(self, u: np.ndarray | None = None) -> None:
        """Begins a step with friction. See ``FrictionSteps.begin_step``.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        """
        self.contact.friction.begin_step(self.coords(u))

    def commit_step(self, u: np.ndarray | None = None) -> None:
        """Accepts the step with friction, and begins the next one at its end. See ``FrictionSteps.commit_step``.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises.
        """
        self.contact.friction.commit_step(self.coords(u))

    def freeze_friction(self, u: np.ndarray | None = None) -> None:
        """Freezes friction as it is at the displacement. See ``FrictionSteps.freeze``.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises.
        """
        self.contact.friction.freeze(self.coords(u))

    def keep_patches(self, u: np.ndarray | None = None) -> int:
        """Keeps the patches of the law ``"fiber"``, so that forces are the gradient of one energy. See ``Patches.keep``.

        Call it at the start of a load step.

        Parameters
        ----------
        u : ndarray, (size,), optional
            State of the whole model, as ``from_variables`` returns it. Default: the current state.

        Returns
        -------
        int
            Number of directions that are kept; 0 with other laws.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        """
        return self.contact.patches.keep(self.coords(u))
