"""Several traces in one numbering: from the nodes of a host to the points of a contact, and back."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np

from .trace import Trace


class Triplets(NamedTuple):
    """Entries of a matrix; duplicates are summed."""

    rows: np.ndarray
    cols: np.ndarray
    values: np.ndarray


class Skin:
    """Traces one after another: nodes and points of the first, then those of the second, ..."""

    facets: np.ndarray
    """Points of all flat facets, (count, dim)."""
    first_node: np.ndarray
    """First node of every trace, and the number of nodes, (traces + 1,)."""
    prolongation: Any
    """``scipy.sparse.csr_matrix`` (points, nodes); ``None`` where points are nodes."""

    def __init__(self, traces: Sequence[Trace]) -> None:
        self.first_node = np.cumsum([0] + [trace.node_count for trace in traces])
        self._first_point = np.cumsum([0] + [trace.point_count for trace in traces])
        self.facets = np.concatenate([trace.facets + first for trace, first in zip(traces, self._first_point)])
        self.prolongation = None
        if any(trace.prolongation is not None for trace in traces):
            from scipy.sparse import block_diag, identity

            parts = [identity(t.node_count) if t.prolongation is None else t.prolongation for t in traces]
            self.prolongation = block_diag(parts, format="csr")
            self._parts = [_Part(trace) for trace in traces]

    def points(self, at_nodes: np.ndarray) -> np.ndarray:
        """What the nodes have, (nodes, dim), at the points."""
        if self.prolongation is None:
            return at_nodes
        return np.concatenate([part.points(at) for part, at in zip(self._parts, _cut(at_nodes, self.first_node))])

    def to_nodes(self, forces: np.ndarray) -> np.ndarray:
        """Forces on the points, (points, dim), brought to the nodes."""
        if self.prolongation is None:
            return forces
        return np.concatenate([part.to_nodes(at) for part, at in zip(self._parts, _cut(forces, self._first_point))])

    def at_nodes(self, values: np.ndarray) -> np.ndarray:
        """What the points have, (points, ...), at the nodes; every node must be a point."""
        if self.prolongation is None:
            return values
        rows = np.flatnonzero(np.diff(self.prolongation.indptr) == 1)
        nodes = self.prolongation.indices[self.prolongation.indptr[rows]]
        # One entry is a one: shape functions add up to it.
        point_of = np.full(self.prolongation.shape[1], -1)
        point_of[nodes] = rows
        if (point_of < 0).any():
            raise ValueError("some nodes are no points of the contact: make divisions a multiple of the order")
        return values[point_of]

    def tangent_to_nodes(self, tangent: Triplets, dim: int) -> Triplets:
        """A matrix of points, row and column ``point * dim + axis``, as one of nodes."""
        if self.prolongation is None:
            return tangent
        from scipy.sparse import csr_matrix

        size = self.prolongation.shape[0] * dim
        matrix = csr_matrix((tangent.values, (tangent.rows, tangent.cols)), shape=(size, size))
        moved = (self._all_axes(dim).T @ self.rows_to_nodes(matrix, dim)).tocoo()
        return Triplets(moved.row, moved.col, moved.data)

    def rows_to_nodes(self, matrix: Any, dim: int) -> Any:
        """A matrix of scipy whose columns are ``point * dim + axis``, as one with those of the nodes."""
        return matrix if self.prolongation is None else matrix @ self._all_axes(dim)

    def _all_axes(self, dim: int) -> Any:
        from scipy.sparse import identity, kron

        return kron(self.prolongation, identity(dim), format="csr")


class _Part:
    """One trace: where its first points are its nodes, only the other points are multiplied."""

    def __init__(self, trace: Trace) -> None:
        self._same, rest = 0, trace.prolongation
        if rest is None:
            self._same = trace.node_count
        elif (
            trace.point_count >= trace.node_count and (rest[: trace.node_count] != _identity(trace.node_count)).nnz == 0
        ):
            self._same, rest = trace.node_count, rest[trace.node_count :]
        self._down = rest
        # By rows as well: the product with a matrix by columns takes several times as long.
        self._up = None if rest is None else rest.T.tocsr()

    def points(self, at_nodes: np.ndarray) -> np.ndarray:
        if self._down is None:
            return at_nodes
        others = self._down @ at_nodes
        return np.concatenate([at_nodes, others]) if self._same else others

    def to_nodes(self, forces: np.ndarray) -> np.ndarray:
        if self._up is None:
            return forces
        others = self._up @ forces[self._same :]
        return forces[: self._same] + others if self._same else others


def _identity(size: int) -> Any:
    from scipy.sparse import identity

    return identity(size, format="csr")


def _cut(rows: np.ndarray, first: np.ndarray) -> list[np.ndarray]:
    return [rows[start:end] for start, end in zip(first[:-1], first[1:])]
