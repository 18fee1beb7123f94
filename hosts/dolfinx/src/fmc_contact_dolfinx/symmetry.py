"""Faces in planes of symmetry, by the tags of facets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from dolfinx import mesh as dmesh
from fmc_contact._cells import face_corners
from fmc_contact.second_order import MIDDLES
from fmc_contact.symmetry import Plane, check_nodes, cut_by_nodes, divided, lie_in, planes_through

from .cells import CELL_TYPES
from .replica import gather_rows
from .space import Displacement
from .together import together
from .versions import is_on


def tagged_faces(comm: Any, fields: Sequence[Displacement], tags: Sequence[Any], values: Sequence[int]) -> list[np.ndarray]:
    """For every space the faces with one of the values: number of their cell in the input, and of the face in it as ``BoundaryFacets`` counts
    them, (faces, 2), the same on every rank. Collective.

    Errors: ``ValueError`` for tags of something else, and for a value that no facet has."""
    for field in fields:
        _connect(field)
    mine = together(comm, lambda: [_known(number, field, of) for number, (field, of) in enumerate(zip(fields, tags))])
    known = np.unique(np.concatenate(comm.allgather(np.concatenate([of_values for _, of_values in mine]))))
    for value in values:
        if value not in known:
            raise ValueError(f"no facet has the tag {value!r}; there are {known.tolist()}")
    found = []
    for field, (facets, of_values) in zip(fields, mine):
        named = gather_rows(comm, _faces(field, facets[np.isin(of_values, np.asarray(values, np.int64))]))
        found.append(np.unique(named, axis=0))
    return found


def _known(number: int, field: Displacement, tags: Any) -> tuple[np.ndarray, np.ndarray]:
    """Facets of this rank with a tag, and their tags."""
    if tags is None:
        return np.empty(0, np.int32), np.empty(0, np.int64)
    if not all(hasattr(tags, name) for name in ("dim", "indices", "values")):
        raise TypeError(f"tags[{number}] is a {type(tags).__name__}, expected MeshTags of facets, or None")
    if tags.dim != field.facet_dim:
        raise ValueError(f"tags[{number}] has entities of dimension {tags.dim}, expected facets, of dimension {field.facet_dim}")
    if not is_on(tags, field.mesh):
        raise ValueError(f"tags[{number}] is of another mesh than spaces[{number}]")
    return np.asarray(tags.indices), np.asarray(tags.values).astype(np.int64)


def _connect(field: Displacement) -> None:
    topology = field.mesh.topology
    topology.create_entities(field.facet_dim)
    topology.create_connectivity(field.facet_dim, field.dim)
    topology.create_connectivity(field.dim, field.facet_dim)


def _cells(field: Displacement, facets: np.ndarray) -> np.ndarray:
    to_cells = field.mesh.topology.connectivity(field.facet_dim, field.dim)
    return to_cells.array[to_cells.offsets[facets]]


def _faces(field: Displacement, facets: np.ndarray) -> np.ndarray:
    topology, cells = field.mesh.topology, _cells(field, facets)
    to_facets = topology.connectivity(field.dim, field.facet_dim).array.reshape(-1, len(field.faces))
    place = np.argmax(to_facets[cells] == facets[:, None], axis=1)
    number = np.asarray(topology.original_cell_index, np.int64)[cells]
    return np.column_stack([number, field.faces[place]])


# Parts of faces of second order: corners, middles of the edges from the first corner on, and the middle of a quadrilateral.
_PARTS = {
    2: [[0, 2], [2, 1]],
    3: [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]],
    4: [[0, 4, 8, 7], [4, 1, 5, 8], [8, 5, 2, 6], [7, 8, 6, 3]],
}


def _divided_faces(field: Displacement) -> list[list[list[int]]]:
    """For every face of a cell its parts, by the places of their nodes in the cell."""
    faces = face_corners(CELL_TYPES[field.kind])
    if field.order == 1:
        return [[corners] for corners in faces]
    place = {frozenset(ends): len(field.topology[0]) + number for number, ends in enumerate(MIDDLES[field.cell_type])}
    found = []
    for corners in faces:
        edges = [place[frozenset(ends)] for ends in zip(corners, corners[1:] + corners[:1])]
        nodes = corners + edges[: 1 if len(corners) == 2 else None] + ([place[frozenset(corners)]] if len(corners) == 4 else [])
        found.append([[nodes[k] for k in part] for part in _PARTS[len(corners)]])
    return found


class OwnFacets(NamedTuple):
    """Boundary facets of this rank, as the library divides faces."""

    corners: np.ndarray
    """(facets, dim, dim)."""
    nodes: np.ndarray
    """Blocks over all ranks at the corners of their faces, or of the parts of these in second order, (facets, 4); -1 where there are fewer."""
    is_named: np.ndarray
    exterior: np.ndarray
    """Numbers of the named faces among the facets of the mesh."""

    @staticmethod
    def of(field: Displacement, named: np.ndarray) -> OwnFacets:
        """Those of a space, some of which are named as by ``tagged_faces``."""
        exterior = np.asarray(dmesh.exterior_facet_indices(field.mesh.topology))
        exterior = exterior[exterior < field.mesh.topology.index_map(field.facet_dim).size_local]
        faces, cells = _faces(field, exterior), _cells(field, exterior)
        width = len(field.faces)
        is_named = np.isin(faces @ [width, 1], named @ [width, 1])
        blocks = field.node_blocks()
        x, parts = field.node_coords(len(blocks)), []
        for face, of_face in enumerate(_divided_faces(field)):
            (here,) = np.nonzero(faces[:, 1] == face)
            for corners in of_face:
                nodes = np.full((len(here), 4), -1)
                nodes[:, : len(corners)] = field.global_blocks(blocks[cells[here]][:, corners])
                facets = divided(x[cells[here]][:, corners])
                each = 1 if len(corners) == field.dim else len(corners)
                parts.append((facets, np.repeat(nodes, each, axis=0), np.repeat(is_named[here], each)))
        return OwnFacets(*map(np.concatenate, zip(*parts)), exterior[is_named])

    def gathered(self, comm: Any, chosen: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Corners, nodes and marks of the chosen ones of all ranks. Collective."""
        return gather_rows(comm, self.corners[chosen]), gather_rows(comm, self.nodes[chosen]), gather_rows(comm, self.is_named[chosen])


def planes_of(comm: Any, facets: OwnFacets) -> list[Plane] | None:
    """The planes of named facets, as ``fmc_contact.symmetry.symmetry_of`` finds them, the same on every rank; ``None`` if other facets lie in them,
    and nodes tell the named ones. Collective.

    Errors: ``ValueError`` as it raises."""
    corners, nodes, _ = facets.gathered(comm, facets.is_named)
    planes = comm.bcast(together(comm, lambda: planes_through(corners)), 0)
    if not comm.allreduce(bool(lie_in(planes, facets.corners[~facets.is_named]).any())):
        return planes
    may_be = (np.isin(facets.nodes, nodes) | (facets.nodes < 0)).all(axis=1)
    corners, nodes, is_named = facets.gathered(comm, may_be)
    together(comm, lambda: check_nodes(cut_by_nodes(corners, nodes, is_named), is_named))
    return None
