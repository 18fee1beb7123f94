"""Poses of obstacles."""

from __future__ import annotations

from ctypes import byref
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats, shape_error, vector
from ._library import check, library
from ._structs import fmc_pose


class Pose:
    """Position, rotation and scale: a point X of the shape is at ``position + scale * rotation @ X``.

    ``Obstacles.set_pose`` keeps the obstacle's rotation or scale if it is not given.

    Parameters
    ----------
    position : array_like, (dim,)
        Position (length).
    rotation : array_like, (dim, dim), optional
        Orthonormal, with determinant +1. Default: the identity for a new obstacle, and the rotation it has for one that is moved.
    scale : float, optional
        Positive factor. Default: 1 for a new obstacle, and the scale it has for one that is moved.

    Raises
    ------
    ValueError
        For another shape. Where the pose is used, the library raises ``BadPoseError`` if the values are not as they should be.

    Examples
    --------
    >>> Pose((0, 0.1), scale=2.0)
    Pose([0.0, 0.1], None, 2.0)
    """

    def __init__(self, position: ArrayLike, rotation: Optional[ArrayLike] = None, scale: Optional[float] = None) -> None:
        self.position = floats(position, "position").copy()
        if self.position.shape not in ((2,), (3,)):
            raise shape_error("position", self.position.shape, "(2,) or (3,)")
        dim = len(self.position)
        self._rotation = None if rotation is None else floats(rotation, "rotation", (dim, dim)).copy()
        self._scale = None if scale is None else float(scale)

    @property
    def rotation(self) -> np.ndarray:
        """Rotation, (dim, dim). If none was given: the identity, which cannot be written to."""
        if self._rotation is not None:
            return self._rotation
        identity = np.eye(len(self.position))
        identity.flags.writeable = False
        return identity

    @rotation.setter
    def rotation(self, rotation: Optional[ArrayLike]) -> None:
        dim = len(self.position)
        self._rotation = None if rotation is None else floats(rotation, "rotation", (dim, dim)).copy()

    @property
    def scale(self) -> float:
        """Scale. If none was given: 1."""
        return 1.0 if self._scale is None else self._scale

    @scale.setter
    def scale(self, scale: Optional[float]) -> None:
        self._scale = None if scale is None else float(scale)

    def _moved_from(self, old: Pose) -> Pose:
        """The pose, with the rotation and the scale of another one where none was given."""
        rotation = old.rotation if self._rotation is None else self._rotation
        return Pose(self.position, rotation, old.scale if self._scale is None else self._scale)

    @classmethod
    def along(cls, position: ArrayLike, axis: ArrayLike, scale: Optional[float] = None) -> Pose:
        """The pose that takes the shape's last axis (y in 2D, z in 3D) to a direction.

        The last axis is the axis of cylinder, cone and capsule, and the outward normal of a half-space.

        Parameters
        ----------
        position : array_like, (dim,)
            Position (length).
        axis : array_like, (dim,)
            Direction, of any length.
        scale : float, optional
            Positive factor. Default: as for ``Pose``.

        Returns
        -------
        Pose
            The pose, with the least rotation.

        Raises
        ------
        BadPoseError
            If the axis has no direction.

        Examples
        --------
        >>> Pose.along((0, 0), (2, 0)).rotation @ [0, 1]
        array([1., 0.])
        """
        at = vector(position, np.size(position), "position")
        dim, found = len(at), fmc_pose()
        check(library.fmc_pose_along(dim, at, vector(axis, dim, "axis"), byref(found)))
        return cls(at, np.array(found.rotation[:]).reshape(3, 3)[:dim, :dim], scale)

    def __repr__(self) -> str:
        rotation = None if self._rotation is None else self._rotation.tolist()
        return f"Pose({self.position.tolist()}, {rotation}" + (")" if self._scale is None else f", {self._scale})")


Placement = Union[Pose, ArrayLike, None]
"""A pose; a position alone, (dim,); or ``None`` for the origin."""


def placed(struct: fmc_pose, dim: int) -> Pose:
    """The pose of a contact in ``dim`` dimensions."""
    return Pose(struct.position[:dim], np.array(struct.rotation[:]).reshape(3, 3)[:dim, :dim], struct.scale)


def pose_struct(placement: Placement, dim: int) -> fmc_pose:
    """The pose for a contact in ``dim`` dimensions."""
    struct = fmc_pose()
    check(library.fmc_pose_init(byref(struct)))
    if placement is None:
        return struct
    pose = placement if isinstance(placement, Pose) else Pose(placement)
    if len(pose.position) != dim:
        raise ValueError(f"the pose has {len(pose.position)} axes, the contact {dim}")
    struct.position[:dim] = pose.position.tolist()
    rotation = np.eye(3)
    rotation[:dim, :dim] = pose.rotation
    struct.rotation[:] = rotation.ravel().tolist()
    struct.scale = pose.scale
    return struct
