"""Gaps as constraints on the nodes, for augmented Lagrangians, interior points and preconditioners."""

from __future__ import annotations

from ctypes import byref, c_double
from dataclasses import dataclass

import numpy as np

from ._arrays import View, written
from ._handle import Handle
from ._library import library
from ._rows import compressed_rows
from ._structs import fmc_gap_constraint


@dataclass(frozen=True, eq=False)
class GapConstraints:
    """Weighted gaps of m nodes over the surface of a partner of their body: contact is ``gap >= 0``.

    ``data``, ``indices``, ``indptr`` are the derivative of the gaps with respect to all coordinates in compressed rows:
    ``scipy.sparse.csr_array((g.data, g.indices, g.indptr), shape=(len(g), node_count * dim))``. Pressures p on the rows act
    with the nodal forces ``matrix.T @ p``. Both bodies of a pair have rows; for one side only take the rows of one body.

    With cells of second order a row belongs to a point of their division (see ``PointWeights``), whose shape function N is
    linear and nowhere negative; columns are degrees of freedom of nodes.

    Attributes
    ----------
    node : ndarray of int, (m,)
        Node of every row; with cells of second order the point.
    body : ndarray of int, (m,)
        Its body.
    is_obstacle : ndarray of bool, (m,)
        Whether the partner is an obstacle.
    partner : ndarray of int, (m,)
        Index of the partner in ``Result.bodies`` or ``Result.obstacles``.
    gap : ndarray, (m,)
        int N phi dA over the part of the node's facets that is nearer than the reach and faces the partner, within 60 degrees of the
        way to its nearest point. N is the shape function, phi the distance from the partner's surface, negative inside.
    area : ndarray, (m,)
        int N dA over the same part: ``gap / area`` is the mean gap at the node (length).
    data : ndarray
        Entries of the derivative.
    indices : ndarray of int
        Degree of freedom of every entry, ``node * dim + axis``, ascending within a row.
    indptr : ndarray of int, (m + 1,)
        Entries of row r are those from ``indptr[r]`` to ``indptr[r + 1]``.

    Examples
    --------
    >>> gaps = contact.gap_constraints(coords, 0.2)
    >>> gaps.node
    array([1, 2, 4, 7])
    """

    node: np.ndarray
    body: np.ndarray
    is_obstacle: np.ndarray
    partner: np.ndarray
    gap: np.ndarray
    area: np.ndarray
    data: np.ndarray
    indices: np.ndarray
    indptr: np.ndarray

    def __len__(self) -> int:
        return len(self.gap)

    @property
    def degrees_of_freedom(self) -> np.ndarray:
        """The degrees of freedom that feel the contact, ascending.

        Examples
        --------
        >>> len(contact.gap_constraints(coords, 0.2).degrees_of_freedom)
        8
        """
        return np.unique(self.indices)


def gap_constraints(handle: Handle, coords: View, reach: float, index_base: int) -> GapConstraints:
    """Finds the gaps at ``coords``."""
    arguments = byref(coords.struct), c_double(reach)
    found = handle.rows(fmc_gap_constraint, library.fmc_context_gap_constraints, *arguments)
    indptr, indices, data = compressed_rows(handle, library.fmc_context_gap_gradient, index_base=index_base)
    row = written(found, fmc_gap_constraint)
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
