"""Part of a space on this rank: its own cells and their nodes, by numbers that do not depend on the ranks."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from .space import Displacement


class OwnPart(NamedTuple):
    """Cells of this rank, without ghosts."""

    cells: np.ndarray
    """Nodes of the cells in VTK's order, (cells, nodes), counted here."""
    cell_numbers: np.ndarray
    """Their numbers in the input."""
    blocks: np.ndarray
    """Blocks of the nodes, as this rank counts them, ghosts after what it owns."""
    numbers: np.ndarray
    """Numbers of the nodes: those of the input, then those in the middle of edges, faces and cells as the cells come to them."""
    undeformed: np.ndarray
    """Coordinates of the nodes, (nodes, dim)."""
    cell_count: int
    """Cells of all ranks."""
    number_count: int
    """Above the numbers of nodes of all ranks."""


def own_part(displacement: Displacement) -> OwnPart:
    """Collective."""
    mesh, comm = displacement.mesh, displacement.mesh.comm
    cells = mesh.topology.index_map(mesh.topology.dim)
    count = cells.size_local
    cell_numbers = np.asarray(mesh.topology.original_cell_index, np.int64)[:count]
    given = np.asarray(mesh.geometry.input_global_indices, np.int64)[displacement.given_geometry(count)]
    blocks, x = displacement.node_blocks()[:count], displacement.node_coords(count)
    given_count = _above(comm, given)
    numbers, width = given, given.shape[1]
    if blocks.shape[1] > width:
        middles = np.arange(blocks.shape[1] - width)
        come = given_count + cell_numbers[:, None] * len(middles) + middles
        come, x[:, width:] = _first_come(displacement, blocks[:, width:], come, x[:, width:])
        numbers = np.concatenate([given, come], axis=1)
    found, first, nodes = np.unique(numbers, return_index=True, return_inverse=True)
    return OwnPart(
        nodes.reshape(numbers.shape),
        cell_numbers,
        blocks.ravel()[first],
        found,
        x.reshape(-1, displacement.dim)[first],
        cells.size_global,
        _above(comm, numbers),
    )


def _above(comm: Any, numbers: np.ndarray) -> int:
    return int(max(comm.allgather(int(numbers.max()) + 1 if numbers.size else 0)))


def _first_come(
    displacement: Displacement, blocks: np.ndarray, come: np.ndarray, x: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The least of the numbers that the cells of all ranks give a block, and the place that goes with it; asked of its owner. Cells round the
    position of a node independently."""
    comm, dim = displacement.mesh.comm, displacement.dim
    ends = np.cumsum(comm.allgather(displacement.owned))
    number, first, inverse = _least(displacement.global_blocks(blocks).ravel(), come.ravel())
    place = x.reshape(-1, dim)[first]
    owner = np.searchsorted(ends, number, side="right")
    to = [np.flatnonzero(owner == rank) for rank in range(comm.size)]
    asked = comm.alltoall([(number[at], come.ravel()[first[at]], place[at]) for at in to])
    numbers, gave, places = (np.concatenate(parts) for parts in zip(*asked))
    _, first, back = _least(numbers, gave)
    answers = np.split(first[back], np.cumsum([len(of_rank[0]) for of_rank in asked])[:-1])
    told = comm.alltoall([(gave[at], places[at]) for at in answers])
    come, place = np.empty(len(number), np.int64), np.empty((len(number), dim))
    for at, (least, where) in zip(to, told):
        come[at], place[at] = least, where
    return come[inverse].reshape(blocks.shape), place[inverse].reshape(x.shape)


def _least(numbers: np.ndarray, come: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Distinct numbers, the place in the list of the least value for each, and the place of every number among them."""
    order = np.lexsort((come, numbers))
    distinct, first, inverse = np.unique(numbers[order], return_index=True, return_inverse=True)
    place = np.empty(len(numbers), np.int64)
    place[order] = inverse
    return distinct, order[first], place
