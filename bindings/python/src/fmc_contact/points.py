"""The points of which a contact tells, as combinations of nodes."""

from __future__ import annotations

from ctypes import byref, c_size_t
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._handle import Handle
from ._library import library


@dataclass(frozen=True, eq=False)
class PointWeights:
    """The matrix P of m points over n nodes, X = P x, in compressed rows:
    ``scipy.sparse.csr_array((w.data, w.indices, w.indptr), shape=(len(w), node_count))``.

    Cells of second order are divided into straight ones, whose points are fixed linear combinations of the nodes.
    ``BoundaryFacets.nodes``, ``ContactPoints.nodes`` and ``GapConstraints.node`` then name points: rows of P, counted from the
    option ``index_base`` as nodes are. Rows and columns of the matrix itself count from 0, as scipy has them. A point that is a
    node, or stands for one in the middle of an edge, face or cell, has the node's number; middles of faces without a node
    come after the nodes. Without cells of second order P is the identity.
    """

    indptr: np.ndarray
    """Entries of point p are those from ``indptr[p]`` to ``indptr[p + 1]``, (m + 1,)."""
    indices: np.ndarray
    """Node of every entry, counted from 0; each node once in a row."""
    data: np.ndarray
    """Its weight. The weights of a row add up to 1 (with a basis to what its rows do); some are negative."""
    node_count: int
    """Number of nodes n."""

    def __len__(self) -> int:
        return len(self.indptr) - 1

    def to_points(self, values: ArrayLike) -> np.ndarray:
        """P times values at nodes, (n,) or (n, k), such as coordinates or displacements: those at points."""
        at_nodes = np.asarray(values, float)
        terms = self._weights_as(at_nodes, self.node_count) * at_nodes[self.indices]
        sums = np.zeros((len(self), *at_nodes.shape[1:]))
        np.add.at(sums, np.repeat(np.arange(len(self)), np.diff(self.indptr)), terms)
        return sums

    def to_nodes(self, values: ArrayLike) -> np.ndarray:
        """The transpose of P times values at points, (m,) or (m, k), such as forces: those at nodes that do the same work."""
        at_points = np.asarray(values, float)
        terms = self._weights_as(at_points, len(self)) * np.repeat(at_points, np.diff(self.indptr), axis=0)
        sums = np.zeros((self.node_count, *at_points.shape[1:]))
        np.add.at(sums, self.indices, terms)
        return sums

    def _weights_as(self, values: np.ndarray, count: int) -> np.ndarray:
        """The weights, to be multiplied with rows of ``values``, of which there are ``count``."""
        if values.ndim == 0 or len(values) != count:
            raise ValueError(f"values have shape {values.shape}, {count} rows are wanted")
        return self.data.reshape(-1, *[1] * (values.ndim - 1))


def point_weights(handle: Handle, node_count: int, index_base: int) -> PointWeights:
    """Asks for them, where the library counts nodes from ``index_base``."""
    points, entries = c_size_t(), c_size_t()
    handle.call(library.fmc_context_point_weights_size, byref(points), byref(entries))
    indptr, indices = np.zeros(points.value + 1, np.int64), np.empty(entries.value, np.int64)
    data = np.empty(entries.value)
    handle.call(library.fmc_context_point_weights, indptr, points.value, indices, data, entries.value)
    return PointWeights(indptr, indices - index_base, data, node_count)
