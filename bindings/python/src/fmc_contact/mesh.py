"""The mesh of a contact."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import POINTER, byref, c_double, c_size_t
from dataclasses import dataclass
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import basis
from ._arrays import View, coords_view, finite, floats, numbers, shape_error
from ._core import Core
from ._library import library
from ._structs import fmc_adjustment
from .boundary import BoundaryFacets, boundary_facets, corners_of, nodes_of, rows_of_facets
from .points import PointWeights, point_weights
from .symmetry import symmetry_of


@dataclass(frozen=True)
class Adjustment:
    """Result of ``Mesh.adjust``.

    Attributes
    ----------
    closed : float
        Largest mean gap of a surface point that was closed (length).
    removed : float
        Largest mean overlap of a surface point that was removed (length).
    left : float
        Largest mean gap or overlap that these points have now (length).
    count : int
        Number of points that were moved.

    Examples
    --------
    >>> contact.mesh.adjust(coords).count
    0
    """

    closed: float
    removed: float
    left: float
    count: int


class Mesh:
    """The mesh of a contact: its boundary, its undeformed coordinates, its planes of symmetry, and the unknowns that move its nodes.

    Examples
    --------
    >>> contact.mesh.boundary_facets().nodes[0]
    array([0, 1])
    """

    def __init__(self, core: Core) -> None:
        self._core = core
        self._named: Optional[tuple[np.ndarray, np.ndarray]] = None
        """Which facets ``set_symmetry_facets`` named, and the undeformed coordinates there."""

    @property
    def welded_node_count(self) -> int:
        """Number of nodes that the option ``weld`` has taken as one with others, as many as merging would leave out.

        Examples
        --------
        >>> contact.mesh.welded_node_count
        0
        """
        count = c_size_t()
        self._core.handle.call(library.fmc_context_welded_node_count, byref(count))
        return count.value

    def boundary_facets(self) -> BoundaryFacets:
        """The boundary facets that were found; ``contact.friction.slip`` names them by their place.

        Returns
        -------
        BoundaryFacets
            Cell, face of the cell, nodes and body of every facet.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> facets = contact.mesh.boundary_facets()
        >>> len(facets), facets.body
        (8, array([0, 0, 0, 0, 1, 1, 1, 1]))
        """
        core = self._core
        with core.handle:
            return boundary_facets(core.handle, core.dim)

    def point_weights(self) -> PointWeights:
        """The points that other results name, as combinations of nodes.

        With cells of second order there are more points than nodes. Otherwise points are the nodes, and the matrix is the identity.

        Returns
        -------
        PointWeights
            The matrix from nodes to points, in compressed rows.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> len(contact.mesh.point_weights())
        8
        """
        core = self._core
        with core.handle:
            return point_weights(core.handle, core.unknown_count, core.options.index_base)

    def adjust(self, coords: ArrayLike, close: float = 0.0, remove: float = 0.0) -> Adjustment:
        """Closes gaps and removes overlaps without strain.

        Where the mean gap of a surface point is at most ``close``, or its overlap at most ``remove``, the surface is offset from its nodes from then
        on, with two bodies each by half of the distance. Nodes and their strains stay. It works with any law and with friction. For an interference
        fit, adjust, then set a smaller part of ``offsets`` before each load step.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes, best those without deformation.
        close : float
            Gaps up to this are closed (length).
        remove : float
            Overlaps up to this are removed (length).

        Returns
        -------
        Adjustment
            Closed gaps, removed overlaps, and the rest.

        Raises
        ------
        NotPositiveError
            If a length is negative or not a number.
        UnsupportedError
            For a mesh in parts.

        Examples
        --------
        >>> round(contact.mesh.adjust(coords, remove=0.2).removed, 3)
        0.1
        >>> contact.mesh.offsets = None
        """
        view, found = coords_view(coords, self._core.dim), fmc_adjustment()
        with self._core.handle:
            arguments = byref(view.struct), c_double(close), c_double(remove), byref(found)
            self._core.handle.call(library.fmc_context_adjust, *arguments)
        return Adjustment(found.closed, found.removed, found.left, found.count)

    @property
    def offsets(self) -> np.ndarray:
        """Offset of the surface from its nodes (length), (nodes, dim); with cells of second order (points, dim).

        ``None`` sets it to nowhere. Offsets do not turn with bodies.

        Raises
        ------
        LengthError
            If an array that is set has another number of rows.
        ValueError
            If it has another number of columns, or a number in it is not finite.

        Examples
        --------
        >>> contact.mesh.offsets.any()
        np.False_
        """
        core, count = self._core, c_size_t()
        with core.handle:
            core.handle.call(library.fmc_context_offsets, None, 0, byref(count))
            found = np.empty(count.value)
            core.handle.call(library.fmc_context_offsets, found, found.size, byref(count))
        return found.reshape(-1, core.dim)

    @offsets.setter
    def offsets(self, values: Optional[ArrayLike]) -> None:
        rows: np.ndarray = np.empty(0) if values is None else np.ascontiguousarray(finite(values, "offsets"))
        if rows.ndim > 2 or (rows.ndim == 2 and rows.size and rows.shape[1] != self._core.dim):
            raise shape_error("offsets", rows.shape, f"(nodes, {self._core.dim})", "transpose it" if rows.shape[0] == self._core.dim else "")
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_offsets, rows, rows.size)

    def set_basis(self, matrix: Optional[Any]) -> None:
        """Lets your own unknowns move the nodes: nodes = ``matrix`` @ unknowns.

        Unknowns may be control points of splines, or coefficients of hierarchical shape functions. From then on coordinates, forces, tangents, masses
        and columns of gap constraints refer to the unknowns, (unknowns, dim). The undeformed mesh stays, and so do the nodes of ``nodal_contact`` and
        ``set_symmetry_nodes``.

        Parameters
        ----------
        matrix : scipy.sparse matrix or array_like, (nodes, unknowns), or None
            Weights of the unknowns at every node. ``None``: the unknowns are again the positions of the nodes.

        Raises
        ------
        ValueError
            If the number of rows is not the number of nodes.
        RangeError
            If an entry is not finite. The mesh is then unchanged.

        Examples
        --------
        >>> contact.mesh.set_basis(np.eye(8))
        >>> contact.mesh.set_basis(None)
        """
        core = self._core
        unknown_count, weights, _arrays = basis.compressed(matrix, core.node_count)
        with core.handle:
            core.handle.call(library.fmc_context_set_basis, weights, unknown_count)
            core.unknown_count = core.node_count if matrix is None else unknown_count

    def set_reference(self, coords: ArrayLike) -> None:
        """Sets the undeformed coordinates, from which the law ``"depth"`` measures its depths.

        The default is the coordinates with which the contact was made. Planes of symmetry stay where ``set_symmetry_planes`` has set them; those of
        ``set_symmetry_facets`` and ``set_symmetry_nodes`` are found again.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Undeformed coordinates of all nodes.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.
        ValueError
            As ``set_symmetry_facets`` raises, for the facets that it named.

        Examples
        --------
        >>> contact.mesh.set_reference(coords)
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_reference, byref(view.struct))
            if self._named is None:
                return
            is_named, before = self._named
            try:
                self._name(is_named, _rows(view, self._core.dim))
            except Exception:
                self._core.handle.call(library.fmc_context_set_reference, byref(coords_view(before, self._core.dim).struct))
                raise

    def set_symmetry_planes(self, planes: Iterable[tuple[ArrayLike, ArrayLike]]) -> None:
        """Sets planes of symmetry, and replaces earlier ones.

        For the law ``"depth"`` a face without deformation in one of them is no surface, since the body continues behind it. The host holds the
        nodes of such faces in their plane.

        Parameters
        ----------
        planes : iterable of (point, normal)
            For each plane a point in it, (dim,), and a vector across it, (dim,), of any length. None at all: all of the surface is
            surface, and flush faces are not warned of.

        Raises
        ------
        LengthError
            If a point or a vector has another number of coordinates.
        NotPositiveError
            If a vector has no length.
        UnsupportedError
            If a body would have no surface left.

        Examples
        --------
        >>> contact.mesh.set_symmetry_planes([((0.0, 0.0), (1.0, 0.0))])
        """
        given = list(planes)
        rows = [floats(part, "planes", (self._core.dim,)) for plane in given for part in plane]
        points, normals = np.concatenate([np.empty(0), *rows[::2]]), np.concatenate([np.empty(0), *rows[1::2]])
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_symmetry_planes, points, normals, len(given))
            self._named = None

    def set_surface_smoothing(self, feature_angle: float) -> None:
        """Measures straight faces as the round surfaces that they represent.

        Where these meet at less than the angle, the surface between them is smooth. Its normal at a node follows from the faces around the node.
        It is for the law ``"depth"`` between two bodies. Curved faces of second order are measured as curved in any case, and straight ones of
        second order in the same body as flat.

        Parameters
        ----------
        feature_angle : float
            In degrees, at least 0 and below 90. At a larger angle faces meet at an edge of the body: 30 is usual. A round body
            needs some 40 facets around it. 0 takes faces for flat, which is the default.

        Raises
        ------
        NotPositiveError
            If the angle is negative, NaN, or at least 90.
        UnsupportedError
            If the surface has no cells, or the mesh is in parts.

        Examples
        --------
        >>> contact.mesh.set_surface_smoothing(30.0)
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_surface_smoothing, feature_angle)

    def add_surface(self, facets: ArrayLike) -> int:
        """Names a part of the surface, so that ``contact.pairs.set`` can hold it together with another part.

        Parameters
        ----------
        facets : array_like of int or bool, (m,)
            Rows of ``boundary_facets``, always counted from 0, or one bool for each row. They may belong to several bodies. Name all four facets
            of a quadrilateral face, and all parts of a face of second order.

        Returns
        -------
        int
            Number of the part: 1, 2, ... It does not depend on the reference coordinates.

        Raises
        ------
        TypeError
            If the numbers are no integers.
        ValueError
            If there is not one mark for every facet.
        BadValueError
            If there is no such facet.
        UnsupportedError
            Without facets, and for a mesh in parts.

        Examples
        --------
        >>> contact.mesh.add_surface([1, 2])
        1
        """
        core = self._core
        with core.handle:
            places = rows_of_facets(facets, core.facet_count)
            named, surface = places.astype(np.uintp), np.zeros(1, np.int32)
            pointer = named.ctypes.data_as(POINTER(c_size_t))
            core.handle.call(library.fmc_context_add_surface, pointer, len(named), surface)
        return int(surface[0])

    def set_symmetry_nodes(self, nodes: ArrayLike) -> None:
        """Names the nodes that lie in planes of symmetry, and replaces earlier ones.

        The planes are those in which the faces lie all of whose nodes are named, the fewest that hold all these nodes: see
        ``set_symmetry_planes``. A face of the contact surface in a corner between two planes does not count. With cells of second order the
        nodes in the middle of edges and faces are named too. In a slice one cell thick all nodes lie in the planes of the slice: if it has further
        planes, use ``set_symmetry_planes``.

        Parameters
        ----------
        nodes : array_like of int, (m,)
            Numbers of the nodes, counted from ``index_base``. An empty list names none, and switches off the warning of flush faces.

        Raises
        ------
        TypeError
            If the numbers are no integers.
        NodeOutOfRangeError
            If there is no such node.

        Examples
        --------
        >>> contact.mesh.set_symmetry_nodes([0, 3])
        """
        named = numbers(nodes, "nodes", None, self._core.handle.index)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_symmetry_nodes, named, len(named))
            self._named = None

    def set_symmetry_facets(self, facets: ArrayLike, coords: ArrayLike) -> None:
        """Names the boundary facets that lie in planes of symmetry, and replaces earlier planes.

        The planes in which these facets lie are set, as by ``set_symmetry_planes``. If other facets lie in them too, as at a crack beside a ligament,
        the nodes of the named facets are set, as by ``set_symmetry_nodes``. ``set_reference`` finds the planes again. Unlike nodes, facets are
        enough in a slice one cell thick, all of whose nodes lie in the two planes of the slice.

        Parameters
        ----------
        facets : array_like of int or bool, (m,)
            Rows of ``boundary_facets``, always counted from 0, or one bool for each row. Name all four facets of a quadrilateral face, and all
            parts of a face of second order.
        coords : array_like, (n, dim) or (dim, n)
            Undeformed coordinates of all nodes: those with which the contact was made, or those of the last ``set_reference``.

        Raises
        ------
        TypeError
            If the numbers are no integers.
        ValueError
            If there is not one mark for every facet, for facets of a curved surface, and if other facets lie in these planes and nodes cannot tell
            which are named.
        BadValueError
            If there is no such facet.
        UnsupportedError
            If a body would have no surface left, and for a mesh in parts.

        Examples
        --------
        >>> contact.mesh.set_symmetry_facets([3], coords)
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            is_named = np.zeros(self._core.facet_count, bool)
            is_named[rows_of_facets(facets, len(is_named))] = True
            self._name(is_named, _rows(view, self._core.dim))

    def _name(self, is_named: np.ndarray, coords: np.ndarray) -> None:
        """Sets the planes of named facets, or their nodes."""
        core, base = self._core, self._core.options.index_base
        if len(coords) != core.unknown_count:
            raise shape_error("coords", coords.shape, f"({core.unknown_count}, {core.dim})")
        points = point_weights(core.handle, core.unknown_count, base).to_points(coords)
        facets = boundary_facets(core.handle, core.dim)
        planes, nodes = symmetry_of(corners_of(facets, points, base), nodes_of(facets, core.node_count, base), is_named)
        if nodes is None:
            at = [np.concatenate([np.empty(0), *parts]) for parts in zip(*planes)] or [np.empty(0)] * 2
            core.handle.call(library.fmc_context_set_symmetry_planes, *at, len(planes))
        else:
            named = (nodes + base).astype(core.handle.index)
            core.handle.call(library.fmc_context_set_symmetry_nodes, named, len(named))
        self._named = is_named, coords


def _rows(view: View, dim: int) -> np.ndarray:
    """A copy of coordinates, (nodes, dim)."""
    return np.array(view.array.T if view.is_columns else view.array[:, :dim])
