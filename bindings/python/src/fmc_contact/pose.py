"""Poses of obstacles."""

from __future__ import annotations

from ctypes import byref
from typing import Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import vector
from ._library import check, library
from ._structs import fmc_pose


class Pose:
    """Position, rotation and scale: a point X of the shape is at ``position + scale * rotation @ X``.

    ``position`` has (dim,) entries; ``rotation``, (dim, dim), is orthonormal with determinant +1, or ``None`` for
    unturned; ``scale`` is positive. The library raises ``BadPoseError`` where the pose is used if they are not.
    """

    def __init__(self, position: ArrayLike, rotation: ArrayLike | None = None, scale: float = 1.0) -> None:
        self.position = np.array(position, np.float64)
        if self.position.shape not in ((2,), (3,)):
            raise ValueError(f"position has shape {self.position.shape}, (2,) or (3,) is wanted")
        dim = len(self.position)
        self.rotation = np.eye(dim) if rotation is None else np.array(rotation, np.float64)
        if self.rotation.shape != (dim, dim):
            raise ValueError(f"rotation has shape {self.rotation.shape}, ({dim}, {dim}) is wanted")
        self.scale = float(scale)

    @classmethod
    def along(cls, position: ArrayLike, axis: ArrayLike, scale: float = 1.0) -> Pose:
        """The shape's last axis (y in 2D, z in 3D) along ``axis``, which need not have unit length.

        That is the axis of cylinder, cone and capsule, and the outward normal of a half-space.
        """
        position = np.ascontiguousarray(position, np.float64)
        dim = len(position)
        found = fmc_pose()
        check(library.fmc_pose_along(dim, vector(position, dim, "position"), vector(axis, dim, "axis"), byref(found)))
        return cls(position, np.array(found.rotation[:]).reshape(3, 3)[:dim, :dim], scale)

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
