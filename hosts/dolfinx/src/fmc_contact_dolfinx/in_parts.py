"""Each rank has its own cells, and the cells of other ranks that may be in contact."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from dolfinx import fem
from fmc_contact import PartitionedContact
from fmc_contact.partition import PartitionedMesh
from fmc_contact.skin import Triplets

from .components import components
from .own_part import own_part
from .points import Points, at_points
from .replica import Replica, gather_rows
from .space import Displacement
from .symmetry import OwnFacets, planes_of
from .together import together

LARGEST_BODY = 2**31
"""Numbers of bodies in parts have 32 bits."""


def whole_because(
    fields: Sequence[Displacement], bodies: Sequence[Any], whole_mesh: bool | None, share_work: bool
) -> str:
    """Why every rank has to have the whole mesh; empty where it has not. Collective."""
    if whole_mesh is not None:
        return f"whole_mesh={whole_mesh} was asked for"
    if not share_work:
        return "share_work=False: every rank does all by itself"
    if any(field.reading is not None for field in fields):
        return "the unknowns of a space are no nodes"
    largest = max([0, *(int(np.abs(one).max()) for one in bodies if one is not None and len(one))])
    if fields[0].mesh.comm.allreduce(largest >= LARGEST_BODY):
        return "a body has a number of more than 32 bits"
    return ""


class _Mesh(PartitionedMesh):
    """Numbers of nodes and facets change when other cells are gathered, so neither are named by numbers."""

    def set_symmetry_nodes(self, nodes: Any) -> None:
        """Raises ``TypeError``: see ``DolfinxContact.set_symmetry_blocks``."""
        raise TypeError("the mesh is in parts: name nodes in planes of symmetry by DolfinxContact.set_symmetry_blocks")

    def set_symmetry_facets(self, facets: Any, coords: Any) -> None:
        """Raises ``TypeError``: see ``DolfinxContact.set_symmetry_boundaries``."""
        raise TypeError("the mesh is in parts: name facets in planes of symmetry by DolfinxContact.set_symmetry_boundaries")


class InParts:
    """Mesh of the contact if no rank has all of it."""

    frame = 0
    contact: PartitionedContact

    def __init__(self, comm: Any, fields: Sequence[Displacement], bodies: Sequence[Any], options: dict) -> None:
        self._comm, self._fields = comm, fields
        self._parts = parts = [own_part(field) for field in fields]
        self._displacements = [fem.Function(field.space) for field in fields]
        self._first_number = np.cumsum([0] + [part.number_count for part in parts])
        first_cell = np.cumsum([0] + [part.cell_count for part in parts])
        first_node = np.cumsum([0] + [len(part.numbers) for part in parts])
        self._undeformed = np.concatenate([part.undeformed for part in parts])
        self._blocks = np.concatenate([field.global_blocks(part.blocks) for field, part in zip(fields, parts)])
        self._cell_numbers = np.concatenate([part.cell_numbers + first for part, first in zip(parts, first_cell)])
        numbers = np.concatenate([part.numbers + first for part, first in zip(parts, self._first_number)])
        cells = [(field.cell_type, part.cells + first) for field, part, first in zip(fields, parts, first_node)]
        ids = self._body_ids(bodies)
        # Its messages are kept apart from the host's.
        apart = comm.Dup()
        self.contact = together(
            comm,
            lambda: PartitionedContact(
                apart, self._undeformed, cells, node_numbers=numbers, cell_numbers=self._cell_numbers, bodies=ids, **options
            ),
        )
        self._mesh = self.contact.mesh
        self.contact.mesh = _Mesh(self.contact._core)
        self._number()

    def _body_ids(self, bodies: Sequence[Any]) -> np.ndarray:
        given = [one is not None for one in bodies]
        if all(given):
            return np.concatenate([one[: len(part.cells)] for one, part in zip(bodies, self._parts)])
        if any(given):
            raise ValueError("bodies are given for some spaces and not for others")
        found, first = [], 0
        for field in self._fields:
            of_cells = components(field.mesh)
            found.append(first + of_cells)
            first += 1 + int(self._comm.allreduce(int(of_cells.max(initial=-1)), _max()))
        return np.concatenate(found)

    def _number(self) -> None:
        """Finds the blocks of the nodes that were gathered."""
        numbers, own = self.contact.nodes, self.contact.own_nodes
        blocks = np.full(len(numbers), -1, np.int64)
        blocks[own >= 0] = self._blocks[own[own >= 0]]
        self._comm.Allreduce(blocks.copy(), blocks, _max())
        cuts = np.searchsorted(numbers, self._first_number)
        self.points = Points(
            [
                Replica(self._comm, blocks[start:end], field.space.dofmap.index_map.local_range[0], field.owned)
                for field, start, end in zip(self._fields, cuts[:-1], cuts[1:])
            ]
        )

    @property
    def received_cell_count(self) -> int:
        """Cells of other ranks that this one has."""
        return int(np.setdiff1d(self.contact.gathered_cells(), self._cell_numbers).size)

    def _at_own_nodes(self, owned: Sequence[np.ndarray]) -> np.ndarray:
        """Values of this rank's unknowns at the nodes of its cells, some of which other ranks own. Collective."""
        found = []
        for field, part, function, values in zip(self._fields, self._parts, self._displacements, owned):
            function.x.array[: values.size] = values.ravel()
            function.x.scatter_forward()
            found.append(function.x.array.reshape(-1, field.dim).take(part.blocks, axis=0))
        return found[0] if len(found) == 1 else np.concatenate(found)

    def coords(self, owned: Sequence[np.ndarray]) -> np.ndarray:
        """Coordinates of the gathered nodes, from the displacements that this rank owns. Collective."""
        here = self._undeformed + self._at_own_nodes(owned)
        if together(self._comm, lambda: self.contact.set_coords(here)):
            self._number()
        return self.contact.coords

    def name(self, owned: Sequence[np.ndarray]) -> None:
        """Names nodes in planes of symmetry, from marks of this rank's unknowns. Collective."""
        (nodes,) = np.nonzero(self._at_own_nodes(owned)[:, 0])
        together(self._comm, lambda: self._mesh.set_symmetry_nodes(nodes))

    def name_faces(self, faces: Sequence[np.ndarray]) -> None:
        """Names faces in planes of symmetry, as ``tagged_faces`` returns them. Collective."""
        comm, of_fields = self._comm, [OwnFacets.of(field, named) for field, named in zip(self._fields, faces)]
        for facets, first in zip(of_fields, np.cumsum([0] + [field.space.dofmap.index_map.size_global for field in self._fields])):
            facets.nodes[facets.nodes >= 0] += first
        planes = planes_of(comm, OwnFacets(*map(np.concatenate, zip(*of_fields))))
        if planes is not None:
            together(comm, lambda: self._mesh.set_symmetry_planes(planes))
            return
        marks = []
        for field, facets in zip(self._fields, of_fields):
            blocks = fem.locate_dofs_topological(field.space, field.facet_dim, facets.exterior)
            named, own = gather_rows(comm, field.global_blocks(blocks)), field.global_blocks(np.arange(field.owned))
            marks.append(np.repeat(np.isin(own, named)[:, None], field.dim, axis=1).astype(float))
        self.name(marks)

    def on_points(self, forces: np.ndarray) -> np.ndarray:
        """Forces of the contact, on the nodes gathered."""
        return forces

    def at_nodes(self, values: np.ndarray) -> np.ndarray:
        """Results at the gathered nodes."""
        return values

    def between_points(self, tangent: Triplets) -> Triplets:
        """The same of a tangent, whose rows know the nodes."""
        return Triplets(at_points(tangent.rows, self.points), tangent.cols, tangent.values)


def _max() -> Any:
    from mpi4py import MPI

    return MPI.MAX
