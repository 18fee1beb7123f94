"""Rigid shapes as data, each in its own frame."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import addressof, byref, c_double, pointer
from typing import Any, Callable, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, floats, indices, shape_error, vector
from ._constants import FMC_SHAPE_KIND
from ._library import check, library
from ._structs import fmc_part, fmc_shape, fmc_signed_distance
from .pose import Placement, pose_struct

SHAPES = tuple(FMC_SHAPE_KIND.values())
"""Kinds of shapes."""

SignedDistance = Callable[[np.ndarray], tuple[ArrayLike, ArrayLike]]
"""From points (n, dim) to distances (n,), negative inside, and their gradients (n, dim), of any length."""

Guard = Callable[[Callable[..., None]], Callable[..., int]]
"""Makes of a function one that the library can call."""


class Shape:
    """A rigid shape in its own frame, for ``Obstacles.add`` and for parts of a compound.

    Parameters
    ----------
    kind : str
        Name of the method of ``Obstacles`` for this shape, without ``add_``: ``"half_space"``, ``"ball"``, ``"cuboid"``, ``"cylinder"``, ``"cone"``,
        ``"capsule"``, ``"polytope"``, ``"convex_hull"``, ``"height_field"``, ``"compound"`` or ``"signed_distance"``. See this method for the other
        parameters of the shape.
    radius, half_height : float
        Of a ball, a cylinder, a cone and a capsule.
    half_extents : array_like, (dim,)
        Of a cuboid.
    points : array_like, (n, dim) or (dim, n)
        Of a polytope and a convex hull.
    facets : array_like of int, (m, dim)
        Of a polytope.
    heights, lengths, thickness
        Of a height field.
    parts : sequence of Part
        Of a compound.
    signed_distance : callable
        Of a body given by its signed distance.

    Raises
    ------
    ValueError
        If there is no such shape.

    Examples
    --------
    >>> from fmc_contact import Shape
    >>> Shape("ball", radius=0.1)
    Shape('ball')
    """

    def __init__(
        self,
        kind: str,
        *,
        radius: float = 0.0,
        half_height: float = 0.0,
        half_extents: Optional[ArrayLike] = None,
        points: Optional[ArrayLike] = None,
        facets: Optional[ArrayLike] = None,
        heights: Optional[ArrayLike] = None,
        lengths: Optional[ArrayLike] = None,
        thickness: float = 0.0,
        parts: Sequence[Part] = (),
        signed_distance: Optional[SignedDistance] = None,
    ) -> None:
        if kind not in SHAPES:
            raise ValueError(f"no shape '{kind}'; there are {', '.join(SHAPES)}")
        self.kind = kind
        self.radius, self.half_height, self.thickness = float(radius), float(half_height), float(thickness)
        self.half_extents, self.points, self.facets = half_extents, points, facets
        self.heights, self.lengths = heights, lengths
        self.parts, self.signed_distance = tuple(parts), signed_distance

    def __repr__(self) -> str:
        return f"Shape('{self.kind}')"

    def _struct(self, dim: int, guard: Guard, kept: list[Any]) -> fmc_shape:
        """The shape for the library; ``kept`` receives the objects to which it points."""
        struct = fmc_shape()
        check(library.fmc_shape_init(byref(struct), SHAPES.index(self.kind)))
        struct.radius, struct.half_height, struct.thickness = self.radius, self.half_height, self.thickness
        if self.half_extents is not None:
            struct.half_extents[:dim] = vector(self.half_extents, dim, "half_extents").tolist()
        if self.points is not None:
            corners = coords_view(self.points, dim, "points")
            kept.append(corners)
            struct.points = corners.struct
        if self.facets is not None:
            facets = indices(self.facets, "facets", dim)
            kept.append(facets)
            struct.facets, struct.facet_count, struct.index_size = facets.ctypes.data, len(facets), facets.itemsize
        if self.heights is not None:
            heights = np.ascontiguousarray(floats(self.heights, "heights"))
            if heights.ndim != dim - 1:
                raise shape_error("heights", heights.shape, f"{dim - 1} axes in {dim}D")
            kept.append(heights)
            struct.heights = heights.ctypes.data
            struct.counts[: dim - 1] = heights.shape
            struct.lengths[: dim - 1] = vector(() if self.lengths is None else self.lengths, dim - 1, "lengths").tolist()
        if self.parts:
            parts = (fmc_part * len(self.parts))(*(part._struct(dim, guard, kept) for part in self.parts))
            kept.append(parts)
            struct.parts, struct.part_count = addressof(parts), len(parts)
        if self.signed_distance is not None:
            callback = fmc_signed_distance(guard(_distances(self.signed_distance, dim)))
            kept.append(callback)
            struct.signed_distance = callback
        return struct


class Part(NamedTuple):
    """A part of a compound.

    Attributes
    ----------
    shape : Shape
        Its shape.
    pose : Pose or array_like (dim,), optional
        Pose in the frame of the compound, or position alone. Default: the origin.

    Examples
    --------
    >>> from fmc_contact import Part, Shape
    >>> Part(Shape("ball", radius=0.1), (0.3, 0)).shape
    Shape('ball')
    """

    shape: Shape
    pose: Placement = None

    def _struct(self, dim: int, guard: Guard, kept: list[Any]) -> fmc_part:
        shape = self.shape._struct(dim, guard, kept)
        kept.append(shape)
        return fmc_part(pointer(shape), pose_struct(self.pose, dim))


def _memory(first: Any, *shape: int) -> np.ndarray:
    """The library's own doubles behind a pointer, valid during the callback only."""
    memory = (c_double * int(np.prod(shape))).from_address(addressof(first.contents))
    return np.frombuffer(memoryview(memory)).reshape(shape)


def _distances(function: SignedDistance, dim: int) -> Callable[..., None]:
    """The function as the library calls it."""

    def distances(_user: object, count: int, x: Any, phi: Any, grad: Any) -> None:
        distance, gradient = function(_memory(x, count, dim).copy())
        for name, target, values in (
            ("phi", _memory(phi, count), distance),
            ("grad", _memory(grad, count, dim), gradient),
        ):
            target[...] = floats(values, f"{name}, returned by the signed distance,", target.shape)

    return distances
