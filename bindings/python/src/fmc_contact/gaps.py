"""Gaps as constraints on the nodes, for augmented Lagrangians, interior points and preconditioners."""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t
from dataclasses import dataclass

import numpy as np

from ._arrays import View
from ._handle import Handle
from ._library import library
from ._structs import fmc_gap_constraint


@dataclass(frozen=True, eq=False)
class GapConstraints:
    """Weighted gaps of m nodes over the surface of a partner of their body: contact is ``gap >= 0``.

    ``data``, ``indices``, ``indptr`` are the derivative of the gaps with respect to all coordinates in compressed rows:
    ``scipy.sparse.csr_array((c.data, c.indices, c.indptr), shape=(len(c), node_count * dim))``. Pressures p on the rows act
    with the nodal forces ``matrix.T @ p``. Both bodies of a pair have rows; for one side only take those of one body.

    With cells of second order a row is that of a point of their division (see ``PointWeights``), whose shape function N is
    straight and nowhere negative; columns are degrees of freedom of nodes.
    """

    node: np.ndarray
    """Node of every row, (m,); with cells of second order the point."""
    body: np.ndarray
    """Its body, (m,)."""
    is_obstacle: np.ndarray
    """Whether the partner is an obstacle, (m,)."""
    partner: np.ndarray
    """Index of the partner in ``Result.bodies`` or ``Result.obstacles``, (m,)."""
    gap: np.ndarray
    """int N phi dA, (m,), over what the facets of the node have nearer than the reach and facing the partner, within 60 degrees
    of the way to its nearest point: N is the shape function, phi the distance from the partner's surface, negative inside."""
    area: np.ndarray
    """int N dA over the same part, (m,): ``gap / area`` is the mean gap at the node."""
    data: np.ndarray
    """Entries of the derivative."""
    indices: np.ndarray
    """Degree of freedom of every entry, node * dim + axis, ascending within a row."""
    indptr: np.ndarray
    """Entries of row r are those from ``indptr[r]`` to ``indptr[r + 1]``, (m + 1,)."""

    def __len__(self) -> int:
        return len(self.gap)

    @property
    def degrees_of_freedom(self) -> np.ndarray:
        """The degrees of freedom that feel the contact, ascending."""
        return np.unique(self.indices)


def gap_constraints(handle: Handle, coords: View, reach: float) -> GapConstraints:
    """Finds the gaps at ``coords``."""
    rows, entries = c_size_t(), c_size_t()
    handle.call(
        library.fmc_context_find_gap_constraints, byref(coords.struct), c_double(reach), byref(rows), byref(entries)
    )
    found = (fmc_gap_constraint * rows.value)()
    handle.call(library.fmc_context_gap_constraints, found, rows.value)
    indptr, indices = np.zeros(rows.value + 1, np.int64), np.empty(entries.value, np.int64)
    data = np.empty(entries.value)
    handle.call(library.fmc_context_gap_gradient, indptr, indices, data, entries.value)
    kind = np.dtype(fmc_gap_constraint)
    row = np.frombuffer(found, kind) if rows.value else np.empty(0, kind)
    return GapConstraints(
        row["node"].copy(),
        row["body"].copy(),
        row["partner_kind"] == 1,
        row["partner"].copy(),
        row["gap"].copy(),
        row["area"].copy(),
        data,
        indices,
        indptr,
    )
