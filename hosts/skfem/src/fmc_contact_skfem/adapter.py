"""Contact of the bodies that one or several bases describe."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from fmc_contact import Contact, GapConstraints, NodalContact, Result
from fmc_contact.boundary import facets_on
from fmc_contact.smoothing import SmoothesSurfaces
from numpy.typing import ArrayLike
from scipy.sparse import block_diag, csr_matrix, hstack, identity
from skfem import CellBasis

from .bases import fields_of, size_of
from .field import Field


class SkfemContact(SmoothesSurfaces):
    """Contact between all bodies of one basis or of several, and with the obstacles that are added to ``contact``.

    Meshes need not match. There is no supermesh, no search for pairs, and no side is the master. Nodes of the contact are the vertices of
    a mesh, then the other places of unknowns. Cells of second order are passed with all their nodes, curved ones (``MeshTri2``, ...) as
    they are. Other continuous elements (``ElementTriP3``, ``ElementQuadP``, bubbles, ...) are read at the nodes of cells of second order.

    Parameters
    ----------
    bases : CellBasis or list of (CellBasis, int)
        A basis of ``ElementVector`` of continuous elements in 2D or 3D. Or a list of ``(basis, offset)``, where ``offset`` is the place of
        the basis' first unknown in the vectors of the whole problem: ``[(first, 0), (second, first.N)]``. It has ``basis.N`` of them from
        there on, which belong to no other basis.
    stiffness : float
        Pressure per length for the default law. 0, the default: ``fmc_contact.find_equilibrium`` finds it from the bodies' matrix.
    size : int, optional
        Length of the vectors of the whole problem. Default: as far as the bases reach.
    bodies : array_like of int, (cells,), optional
        Body of every cell, basis after basis. Default: bodies are the connected components.
    **options : OtherOptions
        As for ``fmc_contact.Contact``.

    Attributes
    ----------
    contact : Contact
        The contact below, for its obstacles (``contact.obstacles.add_half_space``, ...), options, pairs and so on.

    Raises
    ------
    LayoutError
        For a basis of another kind or another dimension, and for bases without their offsets.
    ValueError
        If unknowns belong to two bases, an offset is no number of an unknown, or ``size`` is too small.
    FmcError
        As ``fmc_contact.Contact`` raises.

    Examples
    --------
    >>> contact = SkfemContact(basis, stiffness=1e9)
    >>> residual = stiffness @ u - load - contact.force(u)
    >>> matrix = stiffness + contact.tangent(u)
    """

    contact: Contact
    """The contact below, for its obstacles (``contact.obstacles.add_half_space``, ...), options and the like."""

    def __init__(
        self,
        bases: CellBasis | Sequence[tuple[CellBasis, int]],
        *,
        stiffness: float = 0.0,
        size: int | None = None,
        bodies: ArrayLike | None = None,
        **options: Any,
    ) -> None:
        fields = fields_of(bases)
        self.size = size_of(fields, size)
        self._dofs = np.concatenate([one.dofs for one in fields])
        self._undeformed = np.concatenate([one.coords for one in fields])
        self._fields = fields
        self._vertices: list[slice] = []
        blocks, first = [], 0
        for one in fields:
            self._vertices.append(slice(first, first + one.basis.mesh.nvertices))
            blocks.append((one.cell_type, one.conn + first))
            first += len(one.coords)
        self.contact = Contact(self._undeformed, blocks, bodies=bodies, stiffness=stiffness, **options)
        self._frame = 0
        if any(one.matrix is not None for one in fields):
            self._set_basis(fields)

    def _set_basis(self, fields: list[Field]) -> None:
        """Has the nodes moved by unknowns: x = X + B u. The undeformed X are held by the unit vectors of the axes, the first
        unknowns that the contact is shown."""
        self._frame = self.contact.dim
        parts = [identity(len(one.coords), format="csr") if one.matrix is None else one.matrix for one in fields]
        self._matrix = csr_matrix(block_diag(parts, format="csr"))
        self.contact.mesh.set_basis(csr_matrix(hstack([csr_matrix(self._undeformed), self._matrix], format="csr")))

    def nodes(self, u: np.ndarray) -> np.ndarray:
        """Coordinates of the nodes of the contact, which are the nodes of ``nodal_contact``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

        Returns
        -------
        ndarray, (nodes, dim)
            The coordinates.

        Raises
        ------
        ValueError
            If the displacement has another shape.
        """
        coords = self.coords(u)
        return self._undeformed + self._matrix @ coords[self._frame :] if self._frame else coords

    def coords(self, u: np.ndarray) -> np.ndarray:
        """Coordinates to pass to ``contact`` at a displacement.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

        Returns
        -------
        ndarray, (nodes, dim)
            The coordinates. If the unknowns of a basis are no nodes: the unit vectors of the axes, then the displacement of every unknown,
            (dim + unknowns, dim).

        Raises
        ------
        ValueError
            If the displacement has another shape.
        """
        u = np.asarray(u)
        if u.shape != (self.size,):
            raise ValueError(f"the displacement has shape {u.shape}, expected ({self.size},)")
        if self._frame:
            return np.concatenate([np.eye(self._frame), u.take(self._dofs)])
        return self._undeformed + u.take(self._dofs)

    def evaluate(self, u: np.ndarray) -> Result:
        """Result of the contact at a displacement; forces are those on the nodes of ``coords``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

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

    def force(self, u: np.ndarray) -> np.ndarray:
        """Contact forces on the degrees of freedom: an external load, to be subtracted from a residual.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

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
        """Brings the forces of ``evaluate`` to the degrees of freedom.

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
        total[self._dofs.ravel()] = forces[self._frame :].ravel()
        return total

    def nodal_contact(self, u: np.ndarray) -> NodalContact:
        """Pressure, gap, area, normal and friction at every node, for output.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

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

    def at_vertices(self, values: np.ndarray) -> list[np.ndarray]:
        """An array of ``nodal_contact`` at the vertices of each mesh, for ``mesh.save(..., point_data=...)``.

        Parameters
        ----------
        values : array_like, (nodes, ...)
            An array of ``nodal_contact``.

        Returns
        -------
        list of ndarray, (vertices, ...)
            One array for every basis.
        """
        values = np.asarray(values)
        return [values[vertices].copy() for vertices in self._vertices]

    def tangent(self, u: np.ndarray, semidefinite: bool = False, symmetric: bool = False) -> csr_matrix:
        """Tangent stiffness: minus the derivative of ``force``, to be added to a stiffness matrix.

        With friction it is UNSYMMETRIC: solve with LU, or ask for ``symmetric``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.
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
        dofs, held = self._dofs.ravel(), self._frame * self.contact.dim
        if held:
            free = (rows >= held) & (cols >= held)
            rows, cols, values = rows[free] - held, cols[free] - held, values[free]
        return csr_matrix((values, (dofs[rows], dofs[cols])), shape=(self.size, self.size))

    def gap_constraints(self, u: np.ndarray, reach: float) -> tuple[GapConstraints, csr_matrix]:
        """Weighted gaps of the nodes near a partner, and their derivative. See ``Contact.gap_constraints``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.
        reach : float
            Distance up to which nodes have gaps (length).

        Returns
        -------
        gaps : GapConstraints
            One row for every node and partner.
        matrix : scipy.sparse.csr_matrix, (rows, size)
            Derivative of the gaps with respect to the degrees of freedom.

        Raises
        ------
        NotPositiveError
            If the reach is not positive.
        FmcError
            As ``Contact.evaluate`` raises.
        """
        coords = self.coords(u)
        found = self.contact.gap_constraints(coords, reach)
        rows = csr_matrix((found.data, found.indices, found.indptr), shape=(len(found), coords.size)).tocoo()
        held = self._frame * self.contact.dim
        free = rows.col >= held
        entries = (rows.data[free], (rows.row[free], self._dofs.ravel()[rows.col[free] - held]))
        return found, csr_matrix(entries, (len(found), self.size))

    def set_symmetry_boundaries(self, *names: str) -> None:
        """Names the boundaries that lie in planes of symmetry.

        See ``Mesh.set_symmetry_facets``, which is told of all facets of these boundaries. A boundary may have several planes.

        Parameters
        ----------
        *names : str
            Names of ``mesh.boundaries``, of the mesh of any basis. Without a name there is no plane of symmetry.

        Raises
        ------
        ValueError
            If no mesh has a boundary of such a name, and as ``Mesh.set_symmetry_facets`` raises.
        UnsupportedError
            If a body would have no surface left.

        Examples
        --------
        >>> contact.set_symmetry_boundaries("left", "bottom")
        """
        known = {name for one in self._fields for name in one.basis.mesh.boundaries or {}}
        for name in names:
            if name not in known:
                raise ValueError(f"no mesh has a boundary {name!r}; there are {sorted(known)}")
        first, cells, faces = 0, [np.empty(0, np.int64)], [np.empty(0, np.int64)]
        for one in self._fields:
            of_cells, numbers = one.faces_on(names)
            cells.append(of_cells + first)
            faces.append(numbers)
            first += len(one.conn)
        mesh = self.contact.mesh
        is_named = facets_on(mesh.boundary_facets(), np.concatenate(cells), np.concatenate(faces))
        mesh.set_symmetry_facets(is_named, self.coords(np.zeros(self.size)))

    def begin_step(self, u: np.ndarray) -> None:
        """Begins a step with friction. See ``FrictionSteps.begin_step``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        """
        self.contact.friction.begin_step(self.coords(u))

    def commit_step(self, u: np.ndarray) -> None:
        """Accepts the step with friction, and begins the next one at its end. See ``FrictionSteps.commit_step``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises.
        """
        self.contact.friction.commit_step(self.coords(u))

    def freeze_friction(self, u: np.ndarray) -> None:
        """Freezes friction as it is at the displacement. See ``FrictionSteps.freeze``.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises.
        """
        self.contact.friction.freeze(self.coords(u))

    def keep_patches(self, u: np.ndarray) -> int:
        """Keeps the patches of the law ``"fiber"``, so that forces are the gradient of one energy. See ``Patches.keep``.

        Call it at the start of a load step.

        Parameters
        ----------
        u : ndarray, (size,)
            Displacement: the vector of the whole problem.

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
