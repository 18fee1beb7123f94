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

    Parameters
    ----------
    position : array_like, (dim,)
        Position (length).
    rotation : array_like, (dim, dim), optional
        Orthonormal, with determinant +1. Default: the identity.
    scale : float
        Positive factor.

    Raises
    ------
    ValueError
        For another shape. Where the pose is used, the library raises ``BadPoseError`` if the values are not as they should be.

    Examples
    --------
    >>> Pose((0, 0.1), scale=2.0)
    Pose([0.0, 0.1], [[1.0, 0.0], [0.0, 1.0]], 2.0)
    """

    def __init__(self, position: ArrayLike, rotation: Optional[ArrayLike] = None, scale: float = 1.0) -> None:
        self.position = floats(position, "position").copy()
        if self.position.shape not in ((2,), (3,)):
            raise shape_error("position", self.position.shape, "(2,) or (3,)")
        dim = len(self.position)
        self.rotation = np.eye(dim) if rotation is None else floats(rotation, "rotation", (dim, dim)).copy()
        self.scale = float(scale)

    @classmethod
    def along(cls, position: ArrayLike, axis: ArrayLike, scale: float = 1.0) -> Pose:
        """The pose that takes the shape's last axis (y in 2D, z in 3D) to a direction.

        The last axis is the axis of cylinder, cone and capsule, and the outward normal of a half-space.

        Parameters
        ----------
        position : array_like, (dim,)
            Position (length).
        axis : array_like, (dim,)
            Direction, of any length.
        scale : float
            Positive factor.

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
        return f"Pose({self.position.tolist()}, {self.rotation.tolist()}, {self.scale})"


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
