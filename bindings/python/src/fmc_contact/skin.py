"""Several traces in one numbering: all that a host shows to a contact, and the way back."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np

from .trace import Trace


class Triplets(NamedTuple):
    """Entries of a matrix; values of one place add up."""

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
        first_point = np.cumsum([0] + [trace.point_count for trace in traces])
        self.facets = np.concatenate([trace.facets + first for trace, first in zip(traces, first_point)])
        self.prolongation = None
        if any(trace.prolongation is not None for trace in traces):
            from scipy.sparse import block_diag, identity

            parts = [identity(t.node_count) if t.prolongation is None else t.prolongation for t in traces]
            self.prolongation = block_diag(parts, format="csr")

    def points(self, at_nodes: np.ndarray) -> np.ndarray:
        """What the nodes have, (nodes, dim), at the points."""
        return at_nodes if self.prolongation is None else self.prolongation @ at_nodes

    def to_nodes(self, forces: np.ndarray) -> np.ndarray:
        """Forces on the points, (points, dim), brought to the nodes."""
        return forces if self.prolongation is None else self.prolongation.T @ forces

    def tangent_to_nodes(self, tangent: Triplets, dim: int) -> Triplets:
        """A matrix of points, row and column ``point * dim + axis``, as one of nodes."""
        if self.prolongation is None:
            return tangent
        from scipy.sparse import csr_matrix, identity, kron

        points, nodes = self.prolongation.shape
        matrix = csr_matrix((tangent.values, (tangent.rows, tangent.cols)), shape=2 * (points * dim,))
        all_axes = kron(self.prolongation, identity(dim), format="csr")
        moved = (all_axes.T @ matrix @ all_axes).tocoo()
        return Triplets(moved.row, moved.col, moved.data)
