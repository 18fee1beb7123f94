"""Bodies of a mesh that ranks have in parts: the components that are connected by faces."""

from __future__ import annotations

from typing import Any

import numpy as np

from .replica import gather_rows


def components(mesh: Any) -> np.ndarray:
    """Component of every cell that this rank owns, counted in the order in which the cells of the input come to them. Ranks exchange the faces
    between them. Collective."""
    from dolfinx import mesh as dmesh
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import connected_components

    comm, topology, dim = mesh.comm, mesh.topology, mesh.topology.dim
    topology.create_entities(dim - 1)
    topology.create_connectivity(dim, dim - 1)
    topology.create_connectivity(dim - 1, dim)
    count = topology.index_map(dim).size_local
    faces = topology.index_map(dim - 1)
    face_count = faces.size_local + faces.num_ghosts
    to_faces = topology.connectivity(dim, dim - 1)
    face = np.asarray(to_faces.array[: to_faces.offsets[count]], np.int64)
    cell = np.repeat(np.arange(count), np.diff(to_faces.offsets[: count + 1]))
    links = csr_matrix((np.ones(len(face), np.int8), (cell, count + face)), shape=(count + face_count,) * 2)
    label = connected_components(links, directed=False)[1][:count]
    kinds, label = np.unique(label, return_inverse=True)
    number = np.asarray(topology.original_cell_index, np.int64)[:count]
    least = np.full(len(kinds), np.iinfo(np.int64).max)
    np.minimum.at(least, label, number)
    firsts = gather_rows(comm, least)
    label = label + int(np.sum(comm.allgather(len(kinds))[: comm.rank], dtype=np.int64))
    # A face with one own cell has the other on another rank, if it is no boundary.
    may_go_on = np.bincount(face, minlength=face_count) == 1
    may_go_on[np.asarray(dmesh.exterior_facet_indices(topology))] = False
    of_face = np.empty(face_count, np.int64)
    of_face[face] = label[cell]
    (here,) = np.nonzero(may_go_on)
    names = np.asarray(faces.local_to_global(here.astype(np.int32)), np.int64)
    between = gather_rows(comm, np.column_stack([names, of_face[here]]))
    between = between[np.argsort(between[:, 0], kind="stable")]
    same = between[:-1, 0] == between[1:, 0]
    pairs = between[:-1][same, 1], between[1:][same, 1]
    joined = csr_matrix((np.ones(same.sum(), np.int8), pairs), shape=(len(firsts),) * 2)
    body_count, body = connected_components(joined, directed=False)
    first = np.full(body_count, np.iinfo(np.int64).max)
    np.minimum.at(first, body, firsts)
    return np.argsort(np.argsort(first))[body[label]]
