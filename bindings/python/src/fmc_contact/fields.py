"""The contact at nodes and at points, for output, post-processing and other methods of solution."""

from __future__ import annotations

from ctypes import byref
from dataclasses import dataclass

import numpy as np

from ._arrays import View, written
from ._handle import Handle
from ._library import check, library
from ._structs import fmc_contact_point, fmc_nodal_contact


@dataclass(frozen=True, eq=False)
class NodalContact:
    """The contact at every node, n of them in the order of the coordinates; zero without contact.

    The nodal force without its friction is ``-(pressure * area)[:, None] * normal``, to rounding. With cells of second order
    that is the force at the point of their division that represents the node (see ``PointWeights``). Nodes at the edge of the contact may
    have a tiny area, so a mean pressure is weighted with the area: ``numpy.average(pressure, weights=area)``. With the
    law ``"depth"`` the pressure is no more than twice ``local_pressure``, or than the mean of the pair where that is larger, unless the force is
    more than that on all of the node's part of the surface.

    Attributes
    ----------
    pressure : ndarray, (n,)
        Contact pressure: the nodal force by the area on which it acts.
    gap : ndarray, (n,)
        Minus the penetration (length), the mean over the same part. Never positive: parts that do not touch are not measured.
    area : ndarray, (n,)
        Area (2D: length) on which the pressure acts: the integral of the node's shape function over the part of the facets that is
        in contact. Never more than the node's part of the surface.
    normal : ndarray, (n, dim)
        Unit normal, outwards of the node's body.
    touching : ndarray of bool, (n,)
        Whether a facet at the node is in contact.
    friction : ndarray, (n, dim)
        Traction of friction on the node's body: the mean over the part in contact.
    sliding : ndarray, (n,)
        Part of the node's contact area that slides, between 0 and 1.
    sticks : ndarray of bool, (n,)
        Whether friction acts on the node and more of its contact sticks than slides, by area.
    slides : ndarray of bool, (n,)
        Whether at least half of it slides.
    local_pressure : ndarray, (n,)
        The mean of the law's pressure over the part of the facets that is in contact, weighted with the node's shape function. With
        the law ``"volume"`` the pressure of the pair. On curved surfaces it scatters more than ``pressure``.

    Examples
    --------
    >>> nodal = contact.nodal_contact(coords)
    >>> print(nodal.pressure.max().round(1))
    90.9
    """

    pressure: np.ndarray
    gap: np.ndarray
    area: np.ndarray
    normal: np.ndarray
    touching: np.ndarray
    friction: np.ndarray
    sliding: np.ndarray
    sticks: np.ndarray
    slides: np.ndarray
    local_pressure: np.ndarray


@dataclass(frozen=True, eq=False)
class ContactPoints:
    """The m points where a law presses.

    With ``"fiber"`` they are pieces of lines inside both sides of a pair. With ``"depth"`` they are the centres of pressure of the parts of facets
    inside each cell of the other body, or inside an obstacle. Facets of both bodies are pressed, each with half of its area; facets against an
    obstacle with all of it. With ``"volume"`` there are none, unless friction acts. Axis 1 of the arrays of sides is the side, first and second.

    Attributes
    ----------
    position : ndarray, (m, dim)
        Middle of the piece, or centre of pressure.
    normal : ndarray, (m, dim)
        Unit vector along the line, or of the facet, outwards of the first side.
    gap : ndarray, (m,)
        Minus the penetration (length): the length of the piece, or the mean depth of the facet's part.
    pressure : ndarray, (m,)
        Contact pressure.
    area : ndarray, (m,)
        Area (2D: length) that the point represents.
    friction : ndarray, (m, dim)
        Traction of friction on the first side: ``(friction * area[:, None]).sum(axis=0)`` is its resultant.
    slip : ndarray, (m, dim)
        Slip of the first side against the second since the step began, without its elastic part (length).
    sliding : ndarray, (m,)
        Part of the area that slides: 0 where the point sticks, 0.5 where one of its two facets slides, else 1.
    patch : ndarray of int, (m,)
        Number of the patch within the pair. Points of one patch have one normal, up to its sign. 0 with ``"depth"``.
    is_obstacle : ndarray of bool, (m, 2)
        Whether a side is an obstacle.
    partner : ndarray of int, (m, 2)
        Index of each side in ``Result.bodies`` or ``Result.obstacles``.
    cell : ndarray of int, (m, 2)
        Cell of each side, counted over all blocks; -1 for an obstacle and for surfaces without cells.
    ends : ndarray, (m, 2, dim)
        Where the line meets the boundary of each side. With ``"depth"`` the point, twice.
    nodes : ndarray of int, (m, 2, 8)
        Nodes of the boundary face of each side; with ``"depth"`` nodes of the cell on the side without a facet; -1 where there is
        none. With cells of second order they are points: rows of ``contact.mesh.point_weights()``.
    weights : ndarray, (m, 2, 8)
        Values of their shape functions at the end: a force there is distributed to the nodes, or points, with these factors.

    Examples
    --------
    >>> points = contact.contact_points(coords)
    >>> points.weights.shape == (len(points), 2, 8)
    True
    """

    position: np.ndarray
    normal: np.ndarray
    gap: np.ndarray
    pressure: np.ndarray
    area: np.ndarray
    friction: np.ndarray
    slip: np.ndarray
    sliding: np.ndarray
    patch: np.ndarray
    is_obstacle: np.ndarray
    partner: np.ndarray
    cell: np.ndarray
    ends: np.ndarray
    nodes: np.ndarray
    weights: np.ndarray

    def __len__(self) -> int:
        return len(self.gap)


def nodal_contact(handle: Handle, coords: View, node_count: int, dim: int) -> NodalContact:
    """Measures the contact at ``coords``."""
    pressure, gap, area, local_pressure = (np.empty(node_count) for _ in range(4))
    normal, friction = np.empty((node_count, dim)), np.empty((node_count, dim))
    sliding, status = np.empty(node_count), np.empty(node_count, np.int32)
    lists: dict[str, np.ndarray] = {"pressure": pressure, "gap": gap, "area": area, "normal": normal, "friction": friction}
    lists.update(sliding=sliding, status=status, local_pressure=local_pressure)
    nodal = fmc_nodal_contact()
    check(library.fmc_nodal_contact_init(byref(nodal)))
    for name, array in lists.items():
        setattr(nodal, name, array.ctypes.data)
    handle.call(library.fmc_context_nodal_contact, byref(coords.struct), byref(nodal))
    sticks, slides = status == 2, status == 3
    return NodalContact(pressure, gap, area, normal, status != 0, friction, sliding, sticks, slides, local_pressure)


def contact_points(handle: Handle, coords: View, dim: int) -> ContactPoints:
    """Finds the contact points at ``coords``."""
    found = handle.rows(fmc_contact_point, library.fmc_context_contact_points, byref(coords.struct))
    points = written(found, fmc_contact_point)
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
