"""Rigid obstacles: in contact with the bodies of the mesh, not with one another; moved by their pose only."""

from __future__ import annotations

from ctypes import addressof, byref, c_double, c_int32, c_size_t
from typing import Callable, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, indices, vector
from ._constants import FMC_SHAPE
from ._core import Core
from ._library import library
from ._structs import fmc_part, fmc_pose, fmc_signed_distance
from .part import Part
from .pose import Placement, Pose, placed, pose_struct

SignedDistance = Callable[[np.ndarray], Tuple[ArrayLike, ArrayLike]]
"""From points (n, dim) to distances (n,), negative inside, and their gradients (n, dim), of any length."""


def _memory(pointer, *shape: int) -> np.ndarray:
    """The library's own doubles behind a pointer, valid during the callback only."""
    memory = (c_double * int(np.prod(shape))).from_address(addressof(pointer.contents))
    return np.frombuffer(memoryview(memory)).reshape(shape)


def _index(obstacle: int) -> int:
    if obstacle < 0:
        raise IndexError(f"no obstacle {obstacle}")
    return obstacle


class Obstacle(NamedTuple):
    """An obstacle as it was added."""

    shape: str
    pose: Pose


class Obstacles:
    """The rigid obstacles of a contact. Every ``add_`` returns the obstacle's index: 0, 1, 2, ...

    ``pose`` is a ``Pose``, a position alone, or ``None`` for the origin. Errors: ``BadPoseError``,
    ``NotPositiveError`` for a size that is not positive, ``BusyError``.
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    @property
    def count(self) -> int:
        """Number of obstacles, with those that were removed: the next one gets this index."""
        return self._core.obstacle_count

    def _add(self, function, *arguments, pose: Placement) -> int:
        obstacle = c_size_t()
        with self._core.handle:
            self._core.handle.call(function, *arguments, byref(pose_struct(pose, self._core.dim)), byref(obstacle))
            self._core.obstacle_count = obstacle.value + 1
        return obstacle.value

    def add_half_space(self, point: ArrayLike, normal: ArrayLike) -> int:
        """Adds the half-space behind the plane (2D: line) through ``point``; ``normal`` points out of the obstacle."""
        point, normal = vector(point, self._core.dim, "point"), vector(normal, self._core.dim, "normal")
        return self._add(library.fmc_context_add_half_space, pose=Pose.along(point, normal))

    def add_ball(self, radius: float, pose: Placement = None) -> int:
        """Adds a ball (2D: a disc) about the origin of its frame."""
        return self._add(library.fmc_context_add_ball, float(radius), pose=pose)

    def add_cuboid(self, half_extents: ArrayLike, pose: Placement = None) -> int:
        """Adds a box about the origin of its frame; ``half_extents``, (dim,), are halves of its sides."""
        halves = vector(half_extents, self._core.dim, "half_extents")
        return self._add(library.fmc_context_add_cuboid, halves, pose=pose)

    def add_cylinder(self, radius: float, half_height: float, pose: Placement = None) -> int:
        """Adds a cylinder (2D: a rectangle) about the last axis of its frame, centred."""
        return self._add(library.fmc_context_add_cylinder, float(radius), float(half_height), pose=pose)

    def add_cone(self, radius: float, half_height: float, pose: Placement = None) -> int:
        """Adds a cone (2D: a triangle) about the last axis: apex at +half_height, base of ``radius`` below."""
        return self._add(library.fmc_context_add_cone, float(radius), float(half_height), pose=pose)

    def add_capsule(self, radius: float, half_height: float, pose: Placement = None) -> int:
        """Adds a capsule (2D: a stadium): what lies within ``radius`` of the last axis between -+half_height."""
        return self._add(library.fmc_context_add_capsule, float(radius), float(half_height), pose=pose)

    def add_polytope(self, points: ArrayLike, facets: ArrayLike, pose: Placement = None) -> int:
        """Adds a closed polygon (2D) or triangle mesh (3D); both arrays are copied.

        ``points`` are the corners, laid out as coordinates; ``facets``, (m, dim), numbers of corners: in 2D the body
        lies left of an edge, in 3D a triangle runs counter-clockwise seen from outside. Errors: also those of
        ``Contact.from_facets``.
        """
        corners, conn = coords_view(points, self._core.dim, "points"), indices(facets, "facets", self._core.dim)
        wide = conn.dtype == np.int64
        function = library.fmc_context_add_polytope_i64 if wide else library.fmc_context_add_polytope
        return self._add(function, byref(corners.struct), conn, len(conn), pose=pose)

    def add_convex_hull(self, points: ArrayLike, pose: Placement = None) -> int:
        """Adds the convex hull of ``points``, laid out as coordinates; both estimators support it.

        Errors: ``DegenerateHullError`` for points in one plane (2D: on one line); ``UnsupportedError`` if the library
        lacks the feature "shapes".
        """
        corners = coords_view(points, self._core.dim, "points")
        return self._add(library.fmc_context_add_convex_hull, byref(corners.struct), pose=pose)

    def add_height_field(
        self, heights: ArrayLike, lengths: ArrayLike, thickness: float, pose: Placement = None
    ) -> int:
        """Adds the solid below a height field; both estimators support it.

        ``heights``, (n,) in 2D and (nx, ny) in 3D, are measured along the last axis on a grid of ``lengths``,
        (dim - 1,), centred on the origin. The solid has a flat bottom, ``thickness`` below the lowest height, and vertical walls.
        Errors: ``TooFewHeightsError``, ``NonFiniteHeightError``, ``NotPositiveError``.
        """
        heights = np.ascontiguousarray(heights, np.float64)
        if heights.ndim != self._core.dim - 1:
            raise ValueError(f"heights has {heights.ndim} axes, not {self._core.dim - 1}")
        counts = (c_size_t * heights.ndim)(*heights.shape)
        lengths = vector(lengths, self._core.dim - 1, "lengths")
        function = library.fmc_context_add_height_field
        return self._add(function, counts, lengths, heights.ravel(), float(thickness), pose=pose)

    def add_compound(self, parts: Sequence[Part], pose: Placement = None) -> int:
        """Adds a union of shapes, which may overlap; only the estimator ``fibers`` supports it.

        Its signed distance is the least of those of its parts. Errors: those of the shapes; ``EmptyCompoundError``;
        ``UnsupportedError`` if the library lacks the feature "shapes".
        """
        kept: list = []
        structs = (fmc_part * len(parts))(*(part._struct(self._core.dim, kept) for part in parts))
        return self._add(library.fmc_context_add_compound, structs, len(parts), pose=pose)

    def add_signed_distance(self, function: SignedDistance, pose: Placement = None) -> int:
        """Adds a body given by its signed distance; only the estimator ``fibers`` supports it.

        ``function`` takes points (n, dim) in the obstacle's frame and returns ``(phi, grad)``: distances (n,), negative
        inside and of slope at most 1, and gradients (n, dim), which give the outward normal where phi = 0. It is called
        on the thread that evaluates. Its exceptions are raised by the evaluation unchanged; a value that is not finite
        raises ``SignedDistanceError``.
        """
        dim = self._core.dim

        def distances(_user, count, x, phi, grad) -> None:
            distance, gradient = function(_memory(x, count, dim).copy())
            for name, target, found in (
                ("phi", _memory(phi, count), distance),
                ("grad", _memory(grad, count, dim), gradient),
            ):
                found = np.asarray(found, np.float64)
                if found.shape != target.shape:
                    raise ValueError(f"the signed distance returned {name} of shape {found.shape}, not {target.shape}")
                target[...] = found

        callback = fmc_signed_distance(self._core.handle.guarded(distances))
        obstacle = self._add(library.fmc_context_add_signed_distance, callback, None, pose=pose)
        self._core.handle.keep(obstacle, callback)
        return obstacle

    def set_pose(self, obstacle: int, pose: Placement) -> None:
        """Moves an obstacle. Errors: ``ObstacleOutOfRangeError``, ``ObstacleRemovedError``, ``BadPoseError``,
        ``BusyError``."""
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_pose, _index(obstacle), byref(pose_struct(pose, self._core.dim)))

    def get(self, obstacle: int) -> Obstacle:
        """Shape of an obstacle, what stands after ``add_`` in the method that made it, and its pose; a flat obstacle
        made by a point and a normal is a ``"half_space"``. Errors: ``ObstacleOutOfRangeError``,
        ``ObstacleRemovedError``, ``BusyError``."""
        shape, pose = c_int32(), fmc_pose()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_obstacle_shape, _index(obstacle), byref(shape), byref(pose))
        return Obstacle(FMC_SHAPE[shape.value], placed(pose, self._core.dim))

    def remove(self, obstacle: int) -> None:
        """Removes an obstacle, and the options of its pairs. The others keep their indices; its own is never given
        again, and stands in ``Result.obstacles`` with a resultant of zero. Errors: ``ObstacleOutOfRangeError``,
        ``ObstacleRemovedError``, ``BusyError``."""
        with self._core.handle:
            self._core.handle.call(library.fmc_context_remove_obstacle, _index(obstacle))
            self._core.handle.release(obstacle)

    def set_rotations(self, on: bool) -> None:
        """Whether tangents with ``obstacles`` have their rotations, too, after the translations, from the next one on; they
        have not at first. The rotation of obstacle o of m is node n + m + o: a rotation vector about the position of its
        pose, which moves along; in 2D its first entry is the angle, and the second has only zeros. It is the second
        derivative of the energy: the moment M about the position changes by -K dtheta + dtheta x M / 2. Not with friction
        nor with the law ``"fiber"``: the tangent then raises ``UnsupportedError``."""
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_obstacle_rotations, int(bool(on)))
