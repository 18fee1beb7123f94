"""Mesh that the ranks pass to the contact: all cells, or the boundary alone. Both are numbered by input numbers, so they do not depend on the
ranks."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from dolfinx import mesh as dmesh
from fmc_contact.other_basis import nodes_from_unknowns
from fmc_contact.second_order import MIDDLES
from fmc_contact.trace import Trace

from .replica import Replica, gather_rows
from .space import Displacement, LayoutError
from .versions import cell_dofs


class Shown(NamedTuple):
    """One space's nodes on every rank."""

    displacement: Displacement
    replica: Replica
    undeformed: np.ndarray
    """Coordinates of the nodes, (nodes, dim)."""
    cells: np.ndarray
    """Nodes of the cells in VTK's order; empty where the boundary is shown."""
    input_count: int
    """Nodes with an input number; they come first, in its order. 0 where the boundary is shown."""
    trace: Trace | None
    body: np.ndarray | None
    """Number of every cell or flat facet."""
    matrix: Any = None
    """From unknowns, the rows of the replica, to nodes, where unknowns are not the nodes."""


def _replica(displacement: Displacement, blocks: np.ndarray) -> Replica:
    index_map = displacement.space.dofmap.index_map
    return Replica(displacement.mesh.comm, blocks, index_map.local_range[0], displacement.owned)


def _inputs(displacement: Displacement) -> np.ndarray:
    """Input number of every geometry node here."""
    return np.asarray(displacement.mesh.geometry.input_global_indices, np.int64)


def whole(displacement: Displacement, bodies: np.ndarray | None) -> Shown:
    """All cells, in the order in which the mesh was made from them."""
    mesh, comm = displacement.mesh, displacement.mesh.comm
    count = mesh.topology.index_map(mesh.topology.dim).size_local
    number = np.asarray(mesh.topology.original_cell_index, np.int64)[:count]
    order = np.argsort(gather_rows(comm, number), kind="stable")
    inputs = _inputs(displacement)[displacement.given_geometry(count)]
    inputs = gather_rows(comm, inputs)[order]
    if displacement.reading is None:
        blocks = gather_rows(comm, displacement.global_blocks(displacement.node_blocks()[:count]))[order]
    else:
        blocks = _middles(inputs, MIDDLES[displacement.cell_type])
    x = gather_rows(comm, np.ascontiguousarray(displacement.node_coords(count)))[order]
    nodes, first = _numbered(inputs, blocks)
    body = None if bodies is None else gather_rows(comm, bodies[:count])[order]
    undeformed = x.reshape(-1, displacement.dim)[first]
    if displacement.reading is None:
        replica = _replica(displacement, blocks.ravel()[first])
        return Shown(displacement, replica, undeformed, nodes, len(np.unique(inputs)), None, body)
    of_cells = gather_rows(comm, displacement.global_blocks(cell_dofs(displacement.space)[:count]))[order]
    unknowns, seen, number = np.unique(of_cells, return_index=True, return_inverse=True)
    by_cells = np.argsort(seen)
    place = np.empty(len(unknowns), np.int64)
    place[by_cells] = np.arange(len(unknowns))
    reading = np.broadcast_to(displacement.reading.T[:, None], (of_cells.shape[1], *nodes.shape))
    matrix = nodes_from_unknowns(reading, place[number.reshape(of_cells.shape)].T, nodes, len(unknowns))
    if matrix is None:
        raise LayoutError("the cells of the space do not agree where they meet: expected continuous elements")
    replica = _replica(displacement, unknowns[by_cells])
    return Shown(displacement, replica, undeformed, nodes, len(np.unique(inputs)), None, body, matrix)


def _middles(inputs: np.ndarray, middles: list[tuple[int, ...]]) -> np.ndarray:
    """A number for every node of cells by their corners' input numbers, (cells, nodes): the same for the same corners."""
    most = max(len(around) for around in middles)
    keys = np.full((len(inputs), len(middles), most), -1)
    for k, around in enumerate(middles):
        keys[:, k, : len(around)] = np.sort(inputs[:, list(around)], axis=1)
    _, number = np.unique(keys.reshape(-1, most), axis=0, return_inverse=True)
    return np.concatenate([np.zeros_like(inputs), number.reshape(len(inputs), -1)], axis=1)


def _numbered(inputs: np.ndarray, blocks: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Nodes of the cells, (cells, nodes), and the first place of each of them. Nodes with an input number are sorted by it, all other nodes follow in
    the order of the cells; neither depends on the ranks."""
    width = inputs.shape[1]
    _, first, given = np.unique(inputs, return_index=True, return_inverse=True)
    row, place = np.divmod(first, width)
    first = row * blocks.shape[1] + place
    given = given.reshape(inputs.shape)
    if blocks.shape[1] == width:
        return given, first
    others = blocks[:, width:]
    _, seen, inverse = np.unique(others, return_index=True, return_inverse=True)
    by_cells = np.argsort(seen)
    number = np.empty(len(seen), np.int64)
    number[by_cells] = len(first) + np.arange(len(seen))
    row, place = np.divmod(seen[by_cells], others.shape[1])
    nodes = np.concatenate([given, number[inverse].reshape(others.shape)], axis=1)
    return nodes, np.concatenate([first, row * blocks.shape[1] + width + place])


def boundary(displacement: Displacement, bodies: np.ndarray | None) -> Shown:
    """The boundary of a displacement of first order, face after face in the order of their cells."""
    comm = displacement.mesh.comm
    _, cells, corners, nodes = owned_faces(displacement)
    x = np.ascontiguousarray(displacement.mesh.geometry.x[corners][:, :, : displacement.dim])
    number = np.asarray(displacement.mesh.topology.original_cell_index, np.int64)[cells]
    inputs = _inputs(displacement)[corners]
    key = gather_rows(comm, np.column_stack([number, np.sort(inputs, axis=1)]))
    order = np.lexsort(key.T[::-1])
    inputs = gather_rows(comm, inputs)[order]
    blocks = gather_rows(comm, displacement.global_blocks(nodes))[order]
    x = gather_rows(comm, x)[order]
    trace = Trace(inputs)
    of_nodes = np.empty(trace.node_count, np.int64)
    of_nodes[trace.nodes.ravel()] = blocks.ravel()
    coords = np.empty((trace.node_count, displacement.dim))
    coords[trace.nodes.ravel()] = x.reshape(-1, displacement.dim)
    body = None
    if bodies is not None:
        body = gather_rows(comm, bodies[cells])[order][trace.face_of_facet]
    replica = _replica(displacement, of_nodes)
    return Shown(displacement, replica, coords, np.empty((0, 0), int), 0, trace, body)


class Faces(NamedTuple):
    """Boundary faces that this rank owns."""

    facets: np.ndarray
    cells: np.ndarray
    corners: np.ndarray
    """Geometry nodes of the corners, (faces, corners), seen from outside."""
    nodes: np.ndarray
    """Blocks of the corners, (faces, corners)."""


def owned_faces(displacement: Displacement) -> Faces:
    """The boundary faces that this rank owns."""
    mesh, facet_dim = displacement.mesh, displacement.facet_dim
    topology, dim = mesh.topology, displacement.dim
    topology.create_entities(facet_dim)
    topology.create_connectivity(facet_dim, dim)
    topology.create_connectivity(dim, facet_dim)
    facets = np.asarray(dmesh.exterior_facet_indices(topology))
    facets = facets[facets < topology.index_map(facet_dim).size_local]
    to_cells, to_facets = topology.connectivity(facet_dim, dim), topology.connectivity(dim, facet_dim)
    cells = to_cells.array[to_cells.offsets[facets]]
    variants = displacement.facet_nodes()
    facet_count = len(variants) // 2
    place = np.argmax(to_facets.array.reshape(-1, facet_count)[cells] == facets[:, None], axis=1)
    corner_table = np.array([corners for corners, _ in variants])
    node_table = np.array([nodes for _, nodes in variants])
    geometry, x = displacement.corner_geometry()[cells], mesh.geometry.x[:, :dim]

    def pick(table: np.ndarray, of_cells: np.ndarray, variant: np.ndarray) -> np.ndarray:
        return np.take_along_axis(of_cells, table[variant], axis=1)

    corners = pick(corner_table, geometry, 2 * place)
    inward = _inward(x[corners], x[geometry].mean(axis=1))
    variant = 2 * place + inward
    corners = pick(corner_table, geometry, variant)
    nodes = pick(node_table, cell_dofs(displacement.space)[cells], variant)
    return Faces(facets, cells, corners, nodes)


def _inward(at: np.ndarray, middles: np.ndarray) -> Any:
    """Whether faces with these corners, (faces, corners, dim), look into cells with these middles."""
    if at.shape[2] == 2:
        along = at[:, 1] - at[:, 0]
        normal = np.column_stack([along[:, 1], -along[:, 0]])
    else:
        normal = np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0])
    return np.einsum("ij,ij->i", normal, at.mean(axis=1) - middles) < 0
