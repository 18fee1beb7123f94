"""The contact at nodes and at points, for output, post-processing and other methods of solution."""

from __future__ import annotations

from ctypes import byref, c_size_t
from dataclasses import dataclass

import numpy as np

from ._arrays import View
from ._handle import Handle
from ._library import library
from ._structs import fmc_contact_point


@dataclass(frozen=True, eq=False)
class NodalContact:
    """The contact at every node, n of them in the order of the coordinates; zero where nothing touches.

    The nodal force without its friction is ``-(pressure * area)[:, None] * normal``, to rounding. With cells of second order
    that is the force at the point of their division that stands for the node (see ``PointWeights``), and the shape function
    is that point's: those of second order are negative in places, and have no mean at a corner.
    """

    pressure: np.ndarray
    """Contact pressure, (n,): the mean of that of the law over the part of the facets at the node that is in contact,
    weighted with the node's shape function; with the law ``"volume"`` that of the pair."""
    gap: np.ndarray
    """Minus the penetration, (n,), the mean over the same part. Never positive: distances of what is apart are not
    measured."""
    area: np.ndarray
    """Area (2D: length) on which the pressure acts, (n,)."""
    normal: np.ndarray
    """Unit normal, (n, dim), outwards of the node's body."""
    touching: np.ndarray
    """Whether a facet at the node is in contact, (n,), bool."""
    friction: np.ndarray
    """Traction of friction on the node's body, (n, dim): the mean of that of the facets over the part in contact."""
    sliding: np.ndarray
    """Part of the contact at the node that slides, of its area, (n,): between 0, where all of it sticks, and 1."""
    sticks: np.ndarray
    """Whether friction acts on the node and more of its contact sticks than slides, by area, (n,), bool."""
    slides: np.ndarray
    """Whether at least half of it slides, (n,), bool."""


@dataclass(frozen=True, eq=False)
class ContactPoints:
    """The m points where a law presses. With ``"fiber"``: pieces of lines inside both sides of a pair. With ``"depth"``: the
    centres of the pressure on what facets have inside each cell of the other body, or inside an obstacle; facets of both
    bodies are pressed, each for half of its area, facets against an obstacle for all of it.

    Axis 1 of the arrays of sides is the side, first and second. Empty with the law ``"volume"`` unless friction acts.
    """

    position: np.ndarray
    """Middle of the piece, or centre of pressure, (m, dim)."""
    normal: np.ndarray
    """Unit vector along the line, or that of the facet, outwards of the first side, (m, dim)."""
    gap: np.ndarray
    """Minus the penetration, (m,): the length of the piece; the mean depth of the facet's part below the other surface."""
    pressure: np.ndarray
    """Contact pressure, (m,)."""
    area: np.ndarray
    """Area (2D: length) across the line, or of the facet's part, for which the point stands, (m,)."""
    friction: np.ndarray
    """Traction of friction on the first side, (m, dim): ``(friction * area[:, None]).sum(axis=0)`` is its resultant."""
    slip: np.ndarray
    """Slip of the first side against the second since the step began, without what is elastic, (m, dim)."""
    sliding: np.ndarray
    """Part of the area that slides, (m,): 0 where the point sticks, 0.5 where one of its two facets does, else 1."""
    patch: np.ndarray
    """Number of the patch within the pair, (m,): points of one patch have one normal, up to its sign. 0 with ``"depth"``."""
    is_obstacle: np.ndarray
    """Whether a side is an obstacle, (m, 2)."""
    partner: np.ndarray
    """Index of each side in ``Result.bodies`` or ``Result.obstacles``, (m, 2)."""
    cell: np.ndarray
    """Cell of each side, counted over all blocks, (m, 2); -1 for an obstacle and for surfaces without cells."""
    ends: np.ndarray
    """Where the line meets the boundary of each side, (m, 2, dim); with ``"depth"`` the point, twice."""
    nodes: np.ndarray
    """Nodes of the boundary face of each side, with ``"depth"`` of the cell on the side that has no facet there,
    (m, 2, 8); -1 where there is none. With cells of second order points of their division: rows of
    ``Mesh.point_weights``."""
    weights: np.ndarray
    """Values of their shape functions at the end, (m, 2, 8): a force there goes to the nodes, or points, by these parts."""

    def __len__(self) -> int:
        return len(self.gap)


def nodal_contact(handle: Handle, coords: View, node_count: int, dim: int) -> NodalContact:
    """Measures the contact at ``coords``."""
    pressure, gap, area = (np.empty(node_count) for _ in range(3))
    normal, friction = np.empty((node_count, dim)), np.empty((node_count, dim))
    sliding, status = np.empty(node_count), np.empty(node_count, np.int32)
    lists = pressure, gap, area, normal, friction, sliding, status
    handle.call(library.fmc_context_nodal_contact, byref(coords.struct), *lists, node_count)
    return NodalContact(pressure, gap, area, normal, status != 0, friction, sliding, status == 2, status == 3)


def contact_points(handle: Handle, coords: View, dim: int) -> ContactPoints:
    """Finds the contact points at ``coords``."""
    count = c_size_t()
    handle.call(library.fmc_context_find_contact_points, byref(coords.struct), byref(count))
    found = (fmc_contact_point * count.value)()
    handle.call(library.fmc_context_contact_points, found, count.value)
    kind = np.dtype(fmc_contact_point)
    points = np.frombuffer(found, kind) if count.value else np.empty(0, kind)
    sides = points["sides"]
    unused = np.arange(8) >= sides["node_count"][..., None]
    return ContactPoints(
        points["position"][:, :dim].copy(),
        points["normal"][:, :dim].copy(),
        points["gap"].copy(),
        points["pressure"].copy(),
        points["area"].copy(),
        points["friction"][:, :dim].copy(),
        points["slip"][:, :dim].copy(),
        points["sliding"].copy(),
        points["patch"].copy(),
        sides["kind"] == 1,
        sides["index"].copy(),
        sides["cell"].copy(),
        sides["position"][..., :dim].copy(),
        np.where(unused, -1, sides["nodes"]),
        sides["weights"].copy(),
    )
