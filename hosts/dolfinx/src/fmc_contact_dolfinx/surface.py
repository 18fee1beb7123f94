"""What the ranks show to the contact: all cells, or the boundary alone. Both are numbered by input numbers, so they
do not depend on the ranks."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from dolfinx import mesh as dmesh
from fmc_contact.trace import Trace

from .replica import Replica, gather_rows
from .space import Displacement
from .versions import CELL_TYPES, TENSOR_ORDER, cell_dofs, cell_geometry


class Shown(NamedTuple):
    """One space's nodes on every rank."""

    displacement: Displacement
    replica: Replica
    undeformed: np.ndarray
    """Coordinates of the nodes, (nodes, dim)."""
    cells: np.ndarray
    """Corners of the cells in VTK's order; empty where the boundary is shown."""
    trace: Trace | None
    body: np.ndarray | None
    """Number of every cell or flat facet."""


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
    around = TENSOR_ORDER[CELL_TYPES[displacement.kind]]
    corners = cell_geometry(mesh)[:count][:, around]
    blocks = displacement.global_blocks(displacement.corner_blocks()[:count][:, around])
    number = np.asarray(mesh.topology.original_cell_index, np.int64)[:count]
    order = np.argsort(gather_rows(comm, number), kind="stable")
    inputs = gather_rows(comm, _inputs(displacement)[corners])[order]
    blocks = gather_rows(comm, blocks)[order]
    x = gather_rows(comm, np.ascontiguousarray(mesh.geometry.x[corners][:, :, : displacement.dim]))[order]
    ids, first, conn = np.unique(inputs, return_index=True, return_inverse=True)
    body = None if bodies is None else gather_rows(comm, bodies[:count])[order]
    replica = _replica(displacement, blocks.ravel()[first])
    undeformed = x.reshape(-1, displacement.dim)[first]
    return Shown(displacement, replica, undeformed, conn.reshape(inputs.shape), None, body)


def boundary(displacement: Displacement, divisions: int | None, bodies: np.ndarray | None) -> Shown:
    """The boundary, face after face in the order of their cells."""
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
    trace = Trace(inputs, displacement.order, divisions)
    of_nodes = np.empty(trace.node_count, np.int64)
    of_nodes[trace.nodes.ravel()] = blocks.ravel()
    corner_coords = np.empty((len(trace.corner_ids), displacement.dim))
    corner_coords[trace.nodes[:, : inputs.shape[1]].ravel()] = x.reshape(-1, displacement.dim)
    body = None
    if bodies is not None:
        body = gather_rows(comm, bodies[cells])[order][trace.face_of_facet]
    replica = _replica(displacement, of_nodes)
    return Shown(displacement, replica, trace.straight(corner_coords), np.empty((0, 0), int), trace, body)


class Faces(NamedTuple):
    """Boundary faces that this rank owns."""

    facets: np.ndarray
    cells: np.ndarray
    corners: np.ndarray
    """Geometry nodes of the corners, (faces, corners), seen from outside."""
    nodes: np.ndarray
    """Blocks of the nodes, (faces, nodes), as ``fmc_contact.trace`` draws them."""


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
    geometry, x = cell_geometry(mesh)[cells], mesh.geometry.x[:, :dim]

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
