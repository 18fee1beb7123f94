"""Rigid obstacles: in contact with the bodies of the mesh, not with one another; moved by their pose only."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import byref, c_size_t
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import vector
from ._core import Core
from ._index import index_of
from ._library import library
from ._structs import fmc_pose, fmc_signed_distance
from .pose import Placement, Pose, placed, pose_struct
from .shape import SHAPES, Part, Shape, SignedDistance


class Obstacle(NamedTuple):
    """An obstacle as it was added.

    Attributes
    ----------
    shape : str
        Name of the method that added it, without ``add_``: ``"half_space"``, ``"ball"``, ...
    pose : Pose
        Its pose. A flat obstacle made by a point and a normal is a ``"half_space"`` with a pose.

    Examples
    --------
    >>> contact.obstacles.add_ball(0.1, (0.5, 1.05))
    0
    >>> contact.obstacles.get(0).shape
    'ball'
    """

    shape: str
    pose: Pose


class Obstacles:
    """The rigid obstacles of a contact. Every ``add_`` returns the obstacle's index: 0, 1, 2, ...

    Sizes are lengths in the units of the coordinates.

    Examples
    --------
    >>> floor = contact.obstacles.add_half_space((0, 0.01), (0, 1))
    >>> print(f"{contact.evaluate(coords).obstacles[floor].force[1]:.1f}")
    -220.0
    >>> contact.obstacles.set_pose(floor, (0, -1))
    >>> contact.obstacles.remove(floor)
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    @property
    def count(self) -> int:
        """Number of obstacles, including those that were removed: the index of the next one.

        Examples
        --------
        >>> contact.obstacles.count
        0
        """
        return self._core.obstacle_count

    def add(self, shape: Shape, pose: Placement = None) -> int:
        """Adds an obstacle of any shape. The other methods ``add_`` make the shape and add it.

        Parameters
        ----------
        shape : Shape
            The shape, in its own frame. Arrays are copied.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        FmcError
            As the method for this shape raises.

        Examples
        --------
        >>> from fmc_contact import Shape
        >>> contact.obstacles.add(Shape("ball", radius=0.1), (0.5, 1.05))
        0
        """
        core, obstacle, place = self._core, c_size_t(), pose_struct(pose, self._core.dim)
        kept: list[Any] = []
        struct = shape._struct(core.dim, core.handle.guarded, kept)
        with core.handle:
            core.handle.call(library.fmc_context_add_obstacle, byref(struct), byref(place), byref(obstacle))
            core.obstacle_count = obstacle.value + 1
        core.handle.keep(obstacle.value, [one for one in kept if isinstance(one, fmc_signed_distance)])
        return obstacle.value

    def add_half_space(self, point: ArrayLike, normal: ArrayLike) -> int:
        """Adds the half-space behind a plane (2D: a line).

        Parameters
        ----------
        point : array_like, (dim,)
            A point of the plane.
        normal : array_like, (dim,)
            Normal that points out of the obstacle, of any length.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        BadPoseError
            If the normal has no direction.

        Examples
        --------
        >>> contact.obstacles.add_half_space((0, 0.01), (0, 1))
        0
        """
        at, along = vector(point, self._core.dim, "point"), vector(normal, self._core.dim, "normal")
        return self.add(Shape("half_space"), Pose.along(at, along))

    def add_ball(self, radius: float, pose: Placement = None) -> int:
        """Adds a ball (2D: a disc) about the origin of its frame.

        Parameters
        ----------
        radius : float
            Radius.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        NotPositiveError
            If a size is not positive.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> contact.obstacles.add_ball(0.1, (0.5, 1.05))
        0
        """
        return self.add(Shape("ball", radius=radius), pose)

    def add_cuboid(self, half_extents: ArrayLike, pose: Placement = None) -> int:
        """Adds a box (2D: a rectangle) about the origin of its frame.

        Parameters
        ----------
        half_extents : array_like, (dim,)
            Halves of its sides.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        NotPositiveError
            If a size is not positive.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> contact.obstacles.add_cuboid((1, 0.1), (0.5, 1.05))
        0
        """
        return self.add(Shape("cuboid", half_extents=half_extents), pose)

    def add_cylinder(self, radius: float, half_height: float, pose: Placement = None) -> int:
        """Adds a cylinder (2D: a rectangle) about the last axis of its frame, centred.

        Parameters
        ----------
        radius : float
            Radius.
        half_height : float
            Half of its height.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        NotPositiveError
            If a size is not positive.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> contact.obstacles.add_cylinder(0.1, 0.5, (0.5, 1.45))
        0
        """
        return self.add(Shape("cylinder", radius=radius, half_height=half_height), pose)

    def add_cone(self, radius: float, half_height: float, pose: Placement = None) -> int:
        """Adds a cone (2D: a triangle) about the last axis of its frame: apex at ``half_height``, base at ``-half_height``.

        Parameters
        ----------
        radius : float
            Radius of the base.
        half_height : float
            Half of its height.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        NotPositiveError
            If a size is not positive.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> contact.obstacles.add_cone(0.1, 0.5, (0.5, 1.45))
        0
        """
        return self.add(Shape("cone", radius=radius, half_height=half_height), pose)

    def add_capsule(self, radius: float, half_height: float, pose: Placement = None) -> int:
        """Adds a capsule (2D: a stadium): all points within ``radius`` of a segment of the last axis.

        Parameters
        ----------
        radius : float
            Radius.
        half_height : float
            Half of the length of the segment.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        NotPositiveError
            If a size is not positive.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> contact.obstacles.add_capsule(0.1, 0.5, (0.5, 1.55))
        0
        """
        return self.add(Shape("capsule", radius=radius, half_height=half_height), pose)

    def add_polytope(self, points: ArrayLike, facets: ArrayLike, pose: Placement = None) -> int:
        """Adds a closed polygon (2D) or triangle mesh (3D), which need not be convex. Both arrays are copied.

        Parameters
        ----------
        points : array_like, (n, dim) or (dim, n)
            Corners.
        facets : array_like of int, (m, dim)
            Corners of every facet, counted from 0. In 2D the body lies on the left of an edge. In 3D the corners of a triangle run
            counter-clockwise, seen from outside.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        OpenSurfaceError, InconsistentOrientationError, InvertedSurfaceError
            If the facets do not bound a body.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> contact.obstacles.add_polytope([[0, -1], [1, -1], [0.5, 0.1]], [[0, 1], [1, 2], [2, 0]])
        0
        """
        return self.add(Shape("polytope", points=points, facets=facets), pose)

    def add_convex_hull(self, points: ArrayLike, pose: Placement = None) -> int:
        """Adds the convex hull of points. Both estimators support it.

        Parameters
        ----------
        points : array_like, (n, dim) or (dim, n)
            The points.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        DegenerateHullError
            If the points lie in one plane (2D: on one line).
        UnsupportedError
            If the library lacks the feature ``"shapes"``.

        Examples
        --------
        >>> contact.obstacles.add_convex_hull([[0, -1], [1, -1], [0.5, 0.1]])
        0
        """
        return self.add(Shape("convex_hull", points=points), pose)

    def add_height_field(self, heights: ArrayLike, lengths: ArrayLike, thickness: float, pose: Placement = None) -> int:
        """Adds the solid below a height field. Both estimators support it.

        The solid has vertical walls and a flat bottom.

        Parameters
        ----------
        heights : array_like, (n,) in 2D, (nx, ny) in 3D
            Heights along the last axis, on a regular grid that is centred on the origin.
        lengths : array_like, (dim - 1,)
            Lengths of the grid.
        thickness : float
            Distance of the bottom from the lowest height.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        TooFewHeightsError
            If an axis has fewer than two heights.
        NonFiniteHeightError
            If a height is not finite.
        NotPositiveError
            If a length or the thickness is not positive.

        Examples
        --------
        >>> contact.obstacles.add_height_field([0.0, 0.05, 0.0], (2,), 1.0, (0.5, 0))
        0
        """
        return self.add(Shape("height_field", heights=heights, lengths=lengths, thickness=thickness), pose)

    def add_compound(self, parts: Sequence[Part], pose: Placement = None) -> int:
        """Adds a union of shapes of any kind, which may overlap. The estimator ``"exact"`` supports it with the law ``"depth"`` only.

        Its signed distance is the least signed distance of its parts.

        Parameters
        ----------
        parts : sequence of Part
            The shapes, each with its pose in the frame of the compound.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        EmptyCompoundError
            If there is no part.
        UnsupportedError
            If the library lacks the feature ``"shapes"``.
        FmcError
            As the method of each shape raises.

        Examples
        --------
        >>> from fmc_contact import Part, Shape
        >>> ball = Shape("ball", radius=0.1)
        >>> contact.obstacles.add_compound([Part(ball), Part(ball, (0.3, 0))])
        0
        """
        return self.add(Shape("compound", parts=parts), pose)

    def add_signed_distance(self, function: SignedDistance, pose: Placement = None) -> int:
        """Adds a body given by its signed distance. The estimator ``"exact"`` supports it with the law ``"depth"`` only.

        Parameters
        ----------
        function : callable
            Takes points (n, dim) in the obstacle's frame, and returns distances (n,) and gradients (n, dim). Distances are negative
            inside, and their slope is at most 1. Where the distance is 0, the gradient gives the outward normal. The function is
            called on the thread that evaluates, and the evaluation raises its exceptions unchanged.
        pose : Pose or array_like (dim,), optional
            Pose, or position alone. Default: the origin.

        Returns
        -------
        int
            Index of the obstacle.

        Raises
        ------
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> plane = lambda points: (points[:, 1], np.tile([0.0, 1.0], (len(points), 1)))
        >>> contact.obstacles.add_signed_distance(plane, (0, 0.01))
        0
        """
        return self.add(Shape("signed_distance", signed_distance=function), pose)

    def set_pose(self, obstacle: int, pose: Placement) -> None:
        """Moves an obstacle. It keeps the rotation and the scale that it has where the pose gives none.

        A half-space that was added as a ceiling is one still after a move by position alone.

        Parameters
        ----------
        obstacle : int
            Its index.
        pose : Pose or array_like (dim,) or None
            Pose, or position alone. ``None``: the position of the origin. ``Pose(position, numpy.eye(dim), 1.0)`` turns it back to the
            frame of its shape: the normal of a half-space is then the last axis.

        Raises
        ------
        ObstacleOutOfRangeError, ObstacleRemovedError
            If there is no such obstacle.
        BadPoseError
            If the rotation is not orthonormal, or the scale not positive.

        Examples
        --------
        >>> floor = contact.obstacles.add_half_space((0, 0.01), (0, 1))
        >>> contact.obstacles.set_pose(floor, (0, -1))
        >>> ceiling = contact.obstacles.add_half_space((0, 3), (0, -1))
        >>> contact.obstacles.set_pose(ceiling, (0, 4))
        >>> contact.obstacles.get(ceiling).pose.rotation @ [0, 1]
        array([ 0., -1.])
        """
        core = self._core
        wanted = Pose(np.zeros(core.dim)) if pose is None else pose if isinstance(pose, Pose) else Pose(pose)
        # Refused before the obstacle is looked for, as any argument.
        pose_struct(wanted, core.dim)
        index = index_of("obstacle", obstacle)
        with core.handle:
            struct = pose_struct(wanted._moved_from(self._placed(index).pose), core.dim)
            core.handle.call(library.fmc_context_set_pose, index, byref(struct))

    def get(self, obstacle: int) -> Obstacle:
        """Shape and pose of an obstacle.

        Parameters
        ----------
        obstacle : int
            Its index.

        Returns
        -------
        Obstacle
            ``(shape, pose)``.

        Raises
        ------
        ObstacleOutOfRangeError, ObstacleRemovedError
            If there is no such obstacle.

        Examples
        --------
        >>> ball = contact.obstacles.add_ball(0.1, (0.5, 1.05))
        >>> shape, pose = contact.obstacles.get(ball)
        >>> shape, pose.position
        ('ball', array([0.5 , 1.05]))
        """
        with self._core.handle:
            return self._placed(index_of("obstacle", obstacle))

    def _placed(self, index: int) -> Obstacle:
        shape, pose = np.zeros(1, np.int32), fmc_pose()
        self._core.handle.call(library.fmc_context_obstacle_shape, index, shape, byref(pose))
        return Obstacle(SHAPES[int(shape[0])], placed(pose, self._core.dim))

    def remove(self, obstacle: int) -> None:
        """Removes an obstacle, and the options of its pairs.

        All other obstacles keep their indices. Its index is not reused, and ``Result.obstacles`` has a resultant of zero there.

        Parameters
        ----------
        obstacle : int
            Its index.

        Raises
        ------
        ObstacleOutOfRangeError, ObstacleRemovedError
            If there is no such obstacle.

        Examples
        --------
        >>> ball = contact.obstacles.add_ball(0.1)
        >>> contact.obstacles.remove(ball)
        >>> contact.obstacles.count
        1
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_remove_obstacle, index_of("obstacle", obstacle))
            self._core.handle.release(obstacle)

    def set_rotations(self, on: bool) -> None:
        """Sets whether tangents with ``obstacles=True`` include the rotations of the obstacles, after their translations.

        At first they do not. With n nodes and m obstacles the rotation of obstacle o is node n + m + o: a rotation vector about the
        position of its pose, which moves along. In 2D its first entry is the angle, and the second has only zeros. The tangent is
        the second derivative of the energy: the moment M about the position changes by -K dtheta + dtheta x M / 2. Friction adds the terms of its
        tangent. With the law ``"fiber"`` such a tangent raises ``UnsupportedError``.

        Parameters
        ----------
        on : bool
            Whether rotations are included, from the next tangent on.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> ball = contact.obstacles.add_half_space((0, 0.01), (0, 1))
        >>> contact.obstacles.set_rotations(True)
        >>> contact.tangent(coords, obstacles=True).shape
        (20, 20)
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_obstacle_rotations, int(bool(on)))
