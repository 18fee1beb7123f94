"""The points of a contact's results, as combinations of nodes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats, shape_error
from ._handle import Handle
from ._library import library
from ._rows import compressed_rows


@dataclass(frozen=True, eq=False)
class PointWeights:
    """The matrix P of m points over n nodes, X = P x, in compressed rows.

    ``scipy.sparse.csr_array((w.data, w.indices, w.indptr), shape=(len(w), w.node_count))``

    Cells of second order are divided into straight ones, whose points are fixed linear combinations of the nodes.
    ``BoundaryFacets.nodes``, ``ContactPoints.nodes`` and ``GapConstraints.node`` then name points: rows of P, counted from the
    option ``index_base`` as nodes are. Rows and columns of the matrix itself count from 0. A point that is a node, or represents
    one in the middle of an edge, face or cell, has the node's number. Middles of faces without a node come after the nodes. Without
    cells of second order P is the identity.

    Attributes
    ----------
    indptr : ndarray of int, (m + 1,)
        Entries of point p are those from ``indptr[p]`` to ``indptr[p + 1]``.
    indices : ndarray of int
        Node of every entry, counted from 0; each node once in a row.
    data : ndarray
        Its weight. The weights of a row add up to 1 (with a basis to the sum of its rows); some are negative.
    node_count : int
        Number of nodes n.

    Examples
    --------
    >>> weights = contact.mesh.point_weights()
    >>> weights.data
    array([1., 1., 1., 1., 1., 1., 1., 1.])
    """

    indptr: np.ndarray
    indices: np.ndarray
    data: np.ndarray
    node_count: int

    def __len__(self) -> int:
        return len(self.indptr) - 1

    def to_points(self, values: ArrayLike) -> np.ndarray:
        """P times values at nodes, such as coordinates or displacements.

        Parameters
        ----------
        values : array_like, (n,) or (n, k)
            Values at the nodes.

        Returns
        -------
        ndarray, (m,) or (m, k)
            Values at the points.

        Raises
        ------
        ValueError
            If there are not n rows.

        Examples
        --------
        >>> contact.mesh.point_weights().to_points(coords).shape
        (8, 2)
        """
        at_nodes = floats(values, "values")
        terms = self._weights_as(at_nodes, self.node_count) * at_nodes[self.indices]
        sums = np.zeros((len(self), *at_nodes.shape[1:]))
        np.add.at(sums, np.repeat(np.arange(len(self)), np.diff(self.indptr)), terms)
        return sums

    def to_nodes(self, values: ArrayLike) -> np.ndarray:
        """The transpose of P times values at points, such as forces: forces at nodes that do the same work.

        Parameters
        ----------
        values : array_like, (m,) or (m, k)
            Values at the points.

        Returns
        -------
        ndarray, (n,) or (n, k)
            Values at the nodes.

        Raises
        ------
        ValueError
            If there are not m rows.

        Examples
        --------
        >>> contact.mesh.point_weights().to_nodes(np.ones(8))
        array([1., 1., 1., 1., 1., 1., 1., 1.])
        """
        at_points = floats(values, "values")
        terms = self._weights_as(at_points, len(self)) * np.repeat(at_points, np.diff(self.indptr), axis=0)
        sums = np.zeros((self.node_count, *at_points.shape[1:]))
        np.add.at(sums, self.indices, terms)
        return sums

    def _weights_as(self, values: np.ndarray, count: int) -> np.ndarray:
        """The weights, to be multiplied with rows of ``values``, of which there are ``count``."""
        if values.ndim == 0 or len(values) != count:
            raise shape_error("values", values.shape, f"({count},) or ({count}, columns)")
        return self.data.reshape(-1, *[1] * (values.ndim - 1))


def point_weights(handle: Handle, node_count: int, index_base: int) -> PointWeights:
    """Asks for them, where the library counts nodes from ``index_base``."""
    return PointWeights(*compressed_rows(handle, library.fmc_context_point_weights, index_base=index_base), node_count)
