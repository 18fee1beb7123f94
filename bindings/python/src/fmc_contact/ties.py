"""Tied bodies: their tied area, its tractions and jumps, and the tie as equations."""

from __future__ import annotations

from ctypes import byref
from dataclasses import dataclass

import numpy as np

from ._arrays import View, written
from ._handle import Handle
from ._library import library
from ._rows import compressed_rows
from ._structs import fmc_tie_node


@dataclass(frozen=True)
class Tie:
    """The tie of two bodies.

    Attributes
    ----------
    area : float
        Area that is tied (2D: length; with axisymmetry the area of whole rings). 0: the bodies are not tied.
    largest_gap : float
        Largest gap or overlap that the tie keeps between the surfaces (length).
    node_count : int
        Number of means of the jump that are held: of nodes of the side that holds, mostly that with the larger facets.

    reach : float
        Largest gap or overlap up to which faces belong together (length): as given, or its default.

    Examples
    --------
    >>> contact.pairs.tie(0, 1).node_count
    0
    """

    area: float
    largest_gap: float
    node_count: int
    reach: float


@dataclass(frozen=True, eq=False)
class TieNodes:
    """The nodes of all ties, m rows, on the side that holds, mostly that with the larger facets.

    Attributes
    ----------
    node : ndarray of int, (m,)
        The node; with cells of second order the point (see ``PointWeights``).
    body : ndarray of int, (m,)
        Its body in ``Result.bodies``.
    partner : ndarray of int, (m,)
        The body that it is tied to.
    area : ndarray, (m,)
        Tributary area of the node.
    traction : ndarray, (m, dim)
        Traction on its body (force per area).
    jump : ndarray, (m, dim)
        Mean separation of its body from the other one (length).

    Examples
    --------
    >>> contact.tie_nodes(coords).traction.shape
    (0, 2)
    """

    node: np.ndarray
    body: np.ndarray
    partner: np.ndarray
    area: np.ndarray
    traction: np.ndarray
    jump: np.ndarray

    def __len__(self) -> int:
        return len(self.node)


@dataclass(frozen=True, eq=False)
class TieConstraints:
    """Ties as equations: ``matrix @ coords.ravel() = 0`` with compressed rows.

    ``scipy.sparse.csr_array((t.data, t.indices, t.indptr), shape=(len(t), node_count * dim))``. The weights of a row add up to 1 on
    the side of its node, and to -1 on the other side. Displacements fulfil the same equations.

    Attributes
    ----------
    data : ndarray
        Weights.
    indices : ndarray of int
        Degree of freedom of every entry, ``node * dim + axis``, ascending within a row.
    indptr : ndarray of int, (rows + 1,)
        Entries of row r are those from ``indptr[r]`` to ``indptr[r + 1]``.

    Examples
    --------
    >>> contact.tie_constraints().indptr
    array([0])
    """

    data: np.ndarray
    indices: np.ndarray
    indptr: np.ndarray

    def __len__(self) -> int:
        return len(self.indptr) - 1


def tie_nodes(handle: Handle, coords: View, dim: int) -> TieNodes:
    """Finds them at ``coords``."""
    found = handle.rows(fmc_tie_node, library.fmc_context_tie_nodes, byref(coords.struct))
    row = written(found, fmc_tie_node)
    vectors = (row[name][:, :dim].copy() for name in ("traction", "jump"))
    return TieNodes(row["node"].copy(), row["body"].copy(), row["partner"].copy(), row["area"].copy(), *vectors)


def tie_constraints(handle: Handle, index_base: int) -> TieConstraints:
    """The ties as equations."""
    indptr, indices, data = compressed_rows(handle, library.fmc_context_tie_constraints, index_base=index_base)
    return TieConstraints(data, indices, indptr)
