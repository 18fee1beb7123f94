"""Parts of a compound: shapes, each with a pose in the frame of the compound."""

from __future__ import annotations

from ctypes import byref, pointer
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, indices, vector
from ._constants import FMC_SHAPE
from ._library import check, library
from ._structs import fmc_part
from .pose import Placement, pose_struct

SHAPES = tuple(FMC_SHAPE.values())
PART_SHAPES = SHAPES[: SHAPES.index("convex_hull") + 1]
"""Shapes that a part of a compound may have."""


class Part:
    """A shape and its pose in a compound.

    Parameters
    ----------
    shape : str
        ``"half_space"``, ``"ball"``, ``"cuboid"``, ``"cylinder"``, ``"cone"``, ``"capsule"``, ``"polytope"`` or ``"convex_hull"``.
    pose : Pose or array_like (dim,), optional
        Pose in the frame of the compound, or position alone. Default: the origin.
    radius, half_height : float
        As in the method of ``Obstacles`` that adds this shape.
    half_extents : array_like, (dim,)
        Of a cuboid.
    points : array_like, (n, dim) or (dim, n)
        Of a polytope and a convex hull.
    facets : array_like of int, (m, dim)
        Of a polytope.

    Raises
    ------
    ValueError
        If there is no such shape.

    Examples
    --------
    >>> from fmc_contact import Part
    >>> Part("ball", (0.3, 0), radius=0.1).shape
    'ball'
    """

    def __init__(
        self,
        shape: str,
        pose: Placement = None,
        *,
        radius: float = 0.0,
        half_height: float = 0.0,
        half_extents: Optional[ArrayLike] = None,
        points: Optional[ArrayLike] = None,
        facets: Optional[ArrayLike] = None,
    ) -> None:
        if shape not in PART_SHAPES:
            raise ValueError(f"no shape '{shape}' of a part; there are {', '.join(PART_SHAPES)}")
        self.shape, self.pose = shape, pose
        self.radius, self.half_height, self.half_extents = float(radius), float(half_height), half_extents
        self.points, self.facets = points, facets

    def _struct(self, dim: int, kept: list[Any]) -> fmc_part:
        """The part for the library; arrays that it points to are put into ``kept``."""
        struct = fmc_part()
        check(library.fmc_part_init(byref(struct)))
        struct.shape = SHAPES.index(self.shape)
        struct.radius, struct.half_height = self.radius, self.half_height
        struct.pose = pose_struct(self.pose, dim)
        if self.half_extents is not None:
            struct.half_extents[:dim] = vector(self.half_extents, dim, "half_extents").tolist()
        if self.points is not None:
            corners = coords_view(self.points, dim, "points")
            kept.append(corners)
            struct.points = pointer(corners.struct)
        if self.facets is not None:
            facets = indices(self.facets, "facets", dim).astype(np.int32)
            kept.append(facets)
            struct.facets, struct.facet_count = facets.ctypes.data, len(facets)
        return struct
