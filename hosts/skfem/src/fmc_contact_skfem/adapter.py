"""Contact of the bodies that one or several bases describe."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from fmc_contact import Contact, GapConstraints, NodalContact, Result
from numpy.typing import ArrayLike
from scipy.sparse import block_diag, csr_matrix, hstack, identity
from skfem import CellBasis

from .field import Field, field


class SkfemContact:
    """Contact between all bodies of one basis or of several, with the obstacles that are added to ``contact``.

    ``bases``: a ``Basis`` of ``ElementVector`` of P1, P2, Q1, Q2, serendipity or other continuous elements in 2D or 3D, or
    of ``ElementWedge1``; or a list of ``(basis, offset)`` where ``offset`` is the place of the basis' first unknown in the
    vectors of the whole problem. ``size``: length of these vectors; default: as far as the bases reach. ``bodies``: one
    number for every cell, basis after basis; default: bodies are the connected components. ``stiffness`` and the other
    keywords are those of ``fmc_contact.Contact``.

    Meshes need not match: there is no supermesh, no search for pairs, and no side is the master.

    Other continuous elements (``ElementTriP3``, ``ElementTriP4``, ``ElementQuadP``, bubbles, ...) are read at the nodes of cells of
    second order: see ``other_basis`` and ``nodes``.

    Nodes of the contact are the vertices of a mesh, then the other places of unknowns; cells of second order are passed
    with all their nodes, curved ones (``MeshTri2``, ...) as they are.

    Errors: ``LayoutError`` for a basis of another kind; those of ``fmc_contact.errors``.
    """

    contact: Contact
    """The contact below, for its obstacles (``contact.obstacles.add_half_space``, ...), options and the like."""

    def __init__(
        self,
        bases: CellBasis | Sequence[tuple[CellBasis, int]],
        *,
        stiffness: float,
        size: int | None = None,
        bodies: ArrayLike | None = None,
        **options: Any,
    ) -> None:
        pairs = bases if isinstance(bases, (list, tuple)) else [(bases, 0)]
        fields = [field(*pair) for pair in pairs]
        if not fields:
            raise ValueError("there is no basis")
        self._dofs = np.concatenate([one.dofs for one in fields])
        self._undeformed = np.concatenate([one.coords for one in fields])
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
        reach = max(one.reach for one in fields)
        self.size = reach if size is None else size
        if self.size < reach:
            raise ValueError(f"vectors of {self.size} entries are too short, the bases reach to {reach}")

    def _set_basis(self, fields: list[Field]) -> None:
        """Has the nodes moved by unknowns: x = X + B u. The undeformed X are held by the unit vectors of the axes, the first
        unknowns that the contact is shown."""
        self._frame = self.contact.dim
        parts = [identity(len(one.coords), format="csr") if one.matrix is None else one.matrix for one in fields]
        self._matrix = csr_matrix(block_diag(parts, format="csr"))
        self.contact.mesh.set_basis(csr_matrix(hstack([csr_matrix(self._undeformed), self._matrix], format="csr")))

    def nodes(self, u: np.ndarray) -> np.ndarray:
        """Where the nodes of the contact are at the displacement ``u``, (nodes, dim): those of ``nodal_contact``."""
        coords = self.coords(u)
        return self._undeformed + self._matrix @ coords[self._frame :] if self._frame else coords

    def coords(self, u: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown at the displacement ``u``, (size,): (nodes, dim). Where a basis is not of
        nodes, the unit vectors of the axes, then displacements, of every unknown: (dim + unknowns, dim)."""
        u = np.asarray(u)
        if u.shape != (self.size,):
            raise ValueError(f"the displacement has shape {u.shape}, ({self.size},) is wanted")
        if self._frame:
            return np.concatenate([np.eye(self._frame), u.take(self._dofs)])
        return self._undeformed + u.take(self._dofs)

    def evaluate(self, u: np.ndarray) -> Result:
        """All that ``fmc_contact`` says at a displacement: energy, resultants, warnings; forces on the nodes of
        ``coords``. Errors: those of ``Contact.evaluate``."""
        return self.contact.evaluate(self.coords(u))

    def force(self, u: np.ndarray) -> np.ndarray:
        """Contact forces on the degrees of freedom, (size,): an external load, to be subtracted from a residual."""
        return self.on_dofs(self.evaluate(u).forces)

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        """Forces of ``evaluate`` brought to the degrees of freedom, (size,)."""
        total = np.zeros(self.size)
        total[self._dofs.ravel()] = forces[self._frame :].ravel()
        return total

    def nodal_contact(self, u: np.ndarray) -> NodalContact:
        """Pressure, gap, area and normal at a displacement, on the nodes of ``coords``. Errors: those of
        ``Contact.evaluate``."""
        return self.contact.nodal_contact(self.coords(u))

    def at_vertices(self, values: np.ndarray) -> list[np.ndarray]:
        """An array of ``nodal_contact``, (nodes, ...), at the vertices of each basis' mesh, (vertices, ...) for every
        basis: for ``mesh.save(..., point_data=...)``."""
        values = np.asarray(values)
        return [values[vertices].copy() for vertices in self._vertices]

    def tangent(self, u: np.ndarray, semidefinite: bool = False, symmetric: bool = False) -> csr_matrix:
        """Minus the derivative of ``force``, (size, size): to be added to a stiffness matrix. UNSYMMETRIC with friction:
        solve with LU, or ask for ``symmetric``, which takes more iterations. ``semidefinite`` leaves out what can be
        negative, for use far from a solution."""
        parts = self.contact.tangent_parts(self.coords(u), semidefinite, symmetric=symmetric)
        rows, cols, values = parts.triplets()
        dofs, held = self._dofs.ravel(), self._frame * self.contact.dim
        if held:
            free = (rows >= held) & (cols >= held)
            rows, cols, values = rows[free] - held, cols[free] - held, values[free]
        return csr_matrix((values, (dofs[rows], dofs[cols])), shape=(self.size, self.size))

    def gap_constraints(self, u: np.ndarray, reach: float) -> tuple[GapConstraints, csr_matrix]:
        """Weighted gaps of the nodes near a partner, and their derivative by the degrees of freedom, (rows, size). See
        ``Contact.gap_constraints``."""
        coords = self.coords(u)
        found = self.contact.gap_constraints(coords, reach)
        rows = csr_matrix((found.data, found.indices, found.indptr), shape=(len(found), coords.size)).tocoo()
        held = self._frame * self.contact.dim
        free = rows.col >= held
        entries = (rows.data[free], (rows.row[free], self._dofs.ravel()[rows.col[free] - held]))
        return found, csr_matrix(entries, (len(found), self.size))

    def begin_step(self, u: np.ndarray) -> None:
        """Begins a step with friction at ``u``. See ``FrictionSteps.begin_step``."""
        self.contact.friction.begin_step(self.coords(u))

    def commit_step(self, u: np.ndarray) -> None:
        """Accepts the step with friction that ends at ``u``, and begins the next. See ``FrictionSteps.commit_step``."""
        self.contact.friction.commit_step(self.coords(u))

    def freeze_friction(self, u: np.ndarray) -> None:
        """Freezes friction as it is at ``u``. See ``FrictionSteps.freeze``."""
        self.contact.friction.freeze(self.coords(u))

    def keep_patches(self, u: np.ndarray) -> int:
        """Keeps the directions of the law ``"fiber"`` found at ``u``, so that forces are the gradient of one energy:
        for the start of a load step. See ``Patches.keep``."""
        return self.contact.patches.keep(self.coords(u))
