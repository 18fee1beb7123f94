"""All cells, or the whole boundary, on every rank."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from fmc_contact import Contact
from fmc_contact.boundary import facets_on
from fmc_contact.skin import Skin, Triplets

from .points import Points
from .space import Displacement
from .surface import boundary, whole
from .together import together


class Replicated:
    """Mesh of the contact if every rank has all of it."""

    contact: Contact

    def __init__(
        self, comm: Any, fields: Sequence[Displacement], bodies: Sequence[Any], whole_mesh: bool, options: dict
    ) -> None:
        self._comm = comm
        shown_by = whole if whole_mesh else boundary
        self._shown = [shown_by(field, number) for field, number in zip(fields, bodies)]
        self.points = Points([shown.replica for shown in self._shown])
        self._first_nodes = np.cumsum([0] + [len(shown.undeformed) for shown in self._shown])
        self._undeformed = np.concatenate([shown.undeformed for shown in self._shown])
        self._skin: Skin | None = None
        self.contact = together(comm, lambda: self._made(whole_mesh, options))
        own = sum(field.mesh.topology.index_map(field.dim).size_local for field in fields)
        self.received_cell_count = sum(len(shown.cells) for shown in self._shown) - own if whole_mesh else 0
        self.frame = 0
        """Points that stand before those of the spaces."""
        if any(shown.matrix is not None for shown in self._shown):
            together(comm, self._set_basis)

    def _made(self, whole_mesh: bool, options: dict) -> Contact:
        bodies = [shown.body for shown in self._shown]
        ids = None if bodies[0] is None else np.concatenate(bodies)
        if whole_mesh:
            blocks = [
                (shown.displacement.cell_type, shown.cells + first)
                for shown, first in zip(self._shown, self._first_nodes)
            ]
            return Contact(self._undeformed, blocks, bodies=ids, **options)
        self._skin = Skin([shown.trace for shown in self._shown])
        return Contact.from_facets(self._skin.points(self._undeformed), self._skin.facets, bodies=ids, **options)

    def _set_basis(self) -> None:
        """Has the nodes moved by unknowns: x = X + B u. The undeformed X are held by the unit vectors of the axes, the first
        unknowns that the contact is shown."""
        from scipy.sparse import block_diag, csr_matrix, hstack, identity

        self.frame = self.contact.dim
        parts = [identity(len(s.undeformed), format="csr") if s.matrix is None else s.matrix for s in self._shown]
        self._matrix = csr_matrix(block_diag(parts, format="csr"))
        self.contact.mesh.set_basis(csr_matrix(hstack([csr_matrix(self._undeformed), self._matrix], format="csr")))

    def coords(self, owned: Sequence[np.ndarray]) -> np.ndarray:
        """Coordinates for the contact, from the displacements that this rank owns. Collective."""
        moved = self.points.gather(owned)
        if self.frame:
            return np.concatenate([np.eye(self.frame), moved])
        at_nodes = self._undeformed + moved
        return at_nodes if self._skin is None else self._skin.points(at_nodes)

    def name(self, owned: Sequence[np.ndarray]) -> None:
        """Names nodes in planes of symmetry, from marks of this rank's unknowns. Collective."""
        if self.frame:
            raise ValueError("the unknowns of a space are no nodes: name facets in planes of symmetry by set_symmetry_boundaries")
        self._check_cells()
        (nodes,) = np.nonzero(self.points.gather(owned)[:, 0])
        self.contact.mesh.set_symmetry_nodes(nodes)

    def name_faces(self, faces: Sequence[np.ndarray]) -> None:
        """Names faces in planes of symmetry, as ``tagged_faces`` returns them. Collective."""
        self._check_cells()
        first = np.cumsum([0] + [len(shown.cells) for shown in self._shown])
        cells, numbers = np.concatenate([of_space + [start, 0] for of_space, start in zip(faces, first)]).T
        points = np.zeros((self.points.count, self.contact.dim))
        undeformed = np.concatenate([np.eye(self.frame), points]) if self.frame else self._undeformed
        mesh = self.contact.mesh
        together(self._comm, lambda: mesh.set_symmetry_facets(facets_on(mesh.boundary_facets(), cells, numbers), undeformed))

    def _check_cells(self) -> None:
        if self._skin is not None:
            raise ValueError("planes of symmetry are for meshes whose nodes and cells are passed")

    def on_points(self, forces: np.ndarray) -> np.ndarray:
        """Forces of the contact, on the points of the spaces."""
        if self.frame:
            return forces[self.frame :]
        return forces if self._skin is None else self._skin.to_nodes(forces)

    def at_nodes(self, values: np.ndarray) -> np.ndarray:
        """Results at the contact's points, transferred to the points of the spaces."""
        return values if self._skin is None else self._skin.at_nodes(values)

    def between_points(self, tangent: Triplets) -> Triplets:
        """The same of a tangent."""
        dim = self.contact.dim
        if self.frame:
            held, (rows, cols, values) = self.frame * dim, tangent
            free = (rows >= held) & (cols >= held)
            return Triplets(rows[free] - held, cols[free] - held, values[free])
        return tangent if self._skin is None else self._skin.tangent_to_nodes(tangent, dim)
