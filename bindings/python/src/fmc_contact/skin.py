"""Several traces in one numbering: from the nodes of a host to the points of a contact, and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from .trace import Trace


class Triplets(NamedTuple):
    """Entries of a matrix; duplicates are summed."""

    rows: np.ndarray
    cols: np.ndarray
    values: np.ndarray


class Skin:
    """Traces one after another: nodes and points of the first, then of the second, ..."""

    facets: np.ndarray
    """Points of all flat facets, (count, dim)."""
    first_node: np.ndarray
    """First node of every trace, and the number of nodes, (traces + 1,)."""
    prolongation: Any
    """``scipy.sparse.csr_matrix`` (points, nodes); ``None`` where points are nodes."""

    def __init__(self, traces: Sequence[Trace]) -> None:
        self._node_counts = [trace.node_count for trace in traces]
        self.first_node = np.cumsum([0] + self._node_counts)
        self._first_point = np.cumsum([0] + [trace.point_count for trace in traces])
        self.facets = np.concatenate([trace.facets + first for trace, first in zip(traces, self._first_point)])
        self.prolongation = None
        if any(trace.prolongation is not None for trace in traces):
            from scipy.sparse import block_diag, identity

            parts = [identity(t.node_count) if t.prolongation is None else t.prolongation for t in traces]
            self.prolongation = block_diag(parts, format="csr")
            self._parts = [_Part(trace) for trace in traces]

    def points(self, at_nodes: np.ndarray) -> np.ndarray:
        """Values of the nodes, (nodes, dim), at the points."""
        if self.prolongation is None:
            return at_nodes
        return np.concatenate([part.points(at) for part, at in zip(self._parts, _cut(at_nodes, self.first_node))])

    def to_nodes(self, forces: np.ndarray) -> np.ndarray:
        """Forces on the points, (points, dim), transferred to the nodes."""
        if self.prolongation is None:
            return forces
        return np.concatenate([part.to_nodes(at) for part, at in zip(self._parts, _cut(forces, self._first_point))])

    def at_nodes(self, values: np.ndarray) -> np.ndarray:
        """Values of the points, (points, ...), at the nodes, which are points."""
        if self.prolongation is None:
            return values
        return np.concatenate([at[:count] for at, count in zip(_cut(values, self._first_point), self._node_counts)])

    def tangent_to_nodes(self, tangent: Triplets, dim: int) -> Triplets:
        """A matrix of points, row and column ``point * dim + axis``, as one of nodes."""
        if self.prolongation is None:
            return tangent
        from scipy.sparse import csr_matrix

        size = self.prolongation.shape[0] * dim
        matrix = csr_matrix((tangent.values, (tangent.rows, tangent.cols)), shape=(size, size))
        moved = (self._all_axes(dim).T @ matrix @ self._all_axes(dim)).tocoo()
        return Triplets(moved.row, moved.col, moved.data)

    def _all_axes(self, dim: int) -> Any:
        from scipy.sparse import identity, kron

        return kron(self.prolongation, identity(dim), format="csr")


class _Part:
    """One trace, whose first points are its nodes: only the other points are multiplied."""

    def __init__(self, trace: Trace) -> None:
        self._count = trace.node_count
        self._down = None if trace.prolongation is None else trace.prolongation[trace.node_count :]
        # By rows as well: the product with a matrix by columns takes several times as long.
        self._up = None if self._down is None else self._down.T.tocsr()

    def points(self, at_nodes: np.ndarray) -> np.ndarray:
        return at_nodes if self._down is None else np.concatenate([at_nodes, self._down @ at_nodes])

    def to_nodes(self, forces: np.ndarray) -> np.ndarray:
        return forces if self._up is None else forces[: self._count] + self._up @ forces[self._count :]


def _cut(rows: np.ndarray, first: np.ndarray) -> list[np.ndarray]:
    return [rows[start:end] for start, end in zip(first[:-1], first[1:])]
