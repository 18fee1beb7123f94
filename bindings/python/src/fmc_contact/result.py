"""Results of an evaluation. Units follow from the coordinates and the stiffness: with m and Pa, volumes are m^3 (2D:
m^2), areas m^2 (m), energies J (J/m) and forces N (N/m)."""

from __future__ import annotations

from ctypes import byref, c_char_p, c_int32
from dataclasses import dataclass

import numpy as np

from ._constants import FMC_PARTNER, FMC_WARNING
from ._handle import Handle
from ._library import library
from ._structs import fmc_pair, fmc_result, fmc_resultant


@dataclass(frozen=True, eq=False)
class Resultant:
    """Contact force and moment on one body or obstacle."""

    id: int
    """Id of the body as given, or its number among the connected components; index of the obstacle."""
    force: np.ndarray
    """Sum of the forces, (dim,)."""
    moment: np.ndarray
    """Moment of the forces about the origin of space, (3,); in 2D only the last entry differs from 0."""
    node_count: int
    """Nodes on the body's surface; 0 for an obstacle."""
    friction: np.ndarray
    """The part of ``force`` that is friction, (dim,)."""


@dataclass(frozen=True)
class Friction:
    """What friction does in sum; all zero without."""

    energy: float
    """Energy stored in the stick."""
    dissipation: float
    """Energy dissipated since the step began, never negative."""
    stick_area: float
    """Area (2D: length) that sticks."""
    slip_area: float
    """Area (2D: length) that slides."""
    largest_slip: float
    """Largest slip since the step began that was not elastic."""


@dataclass(frozen=True, eq=False)
class Pair:
    """One overlapping pair; no side is master or slave.

    ``a`` and ``b`` are ``("body", index)`` or ``("obstacle", index)``, for ``Result.bodies`` and ``Result.obstacles``;
    both are the same for a body that overlaps itself.
    """

    a: tuple[str, int]
    b: tuple[str, int]
    volume: float
    """Volume (2D: area) of what is inside both sides, each place once, with every law and estimator."""
    volume_standard_error: float
    """Standard error of the volume; 0 for ``exact``."""
    energy: float
    pressure: float
    """Mean of the contact pressure over the contact: with the law ``"volume"`` dw/dV, which is one for the whole
    pair; with ``"fiber"`` ``psi'(L)``, the mean over its lines; with ``"depth"`` k times the depth of either
    surface below the other, the mean over both."""
    contact_area: float
    """Area of contact (2D: length): half of the boundary of what is inside both sides, the strips of sunken side
    walls with it. The law ``"fiber"`` does not see strips along its lines; with ``"depth"`` and an obstacle it is
    the surface of the body that is inside. Facets that do not match gape between their nodes in hard contact; what
    gapes is not counted."""
    penetration: float
    """How deep the sides reach into one another: with the law ``"fiber"`` the longest of its lines, with
    ``"depth"`` the largest depth of either surface below the other, with ``"volume"``, which knows no depth of a
    place, the extent of the overlap along its mean normal. The same where faces overlap flat. With ``"fiber"`` and
    ``"depth"`` k times it is the largest pressure."""
    spacing: float
    """Spacing of the fibers; 0 for ``exact``. As the option ``spacing`` it gives the same pattern again."""
    friction: Friction
    """Friction of the pair; its ``largest_slip`` is that of all pairs."""


@dataclass(frozen=True)
class ContactWarning:
    """A caution about a result, which is valid all the same.

    ``kind`` is ``"coarse_fibers"``, ``"unresolved_overlap"``, ``"swallowed_body"``, ``"patch_left_out"``,
    ``"unbalanced"`` or ``"flush_faces"``; ``text`` a sentence.
    """

    kind: str
    text: str


@dataclass(frozen=True, eq=False)
class Result:
    """Contact forces, totals, resultants and pairs."""

    forces: np.ndarray
    """Force on every node, (n, dim), in the order of the nodes; (dim, n) for coordinates in columns. They push bodies
    apart; nodes that are not in contact have 0. The caller's own array where one was given."""
    volume: float
    """Volume (2D: area) of what is inside both sides, summed over the pairs."""
    volume_standard_error: float
    """Standard error of the volume; 0 for ``exact``."""
    energy: float
    """Contact energy, summed over the pairs."""
    contact_area: float
    """Area of contact (2D: length), summed over the pairs; see ``Pair``."""
    penetration: float
    """Largest penetration of any pair; see ``Pair``."""
    fiber_count: int
    """Fibers laid."""
    crossing_count: int
    """Crossings that bound an overlap."""
    facet_count: int
    """Facets that bound an overlap."""
    friction: Friction
    """Friction, summed over the pairs."""
    bodies: tuple[Resultant, ...]
    """Force and moment on every body, ordered by id."""
    obstacles: tuple[Resultant, ...]
    """Force and moment on every obstacle."""
    pairs: tuple[Pair, ...]
    """Pairs that overlap."""
    warnings: tuple[ContactWarning, ...]
    """Cautions about this result."""


def _resultant(handle: Handle, getter, index: int, dim: int) -> Resultant:
    found = fmc_resultant()
    handle.call(getter, index, byref(found))
    force, friction = np.array(found.force[:dim]), np.array(found.friction[:dim])
    return Resultant(found.id, force, np.array(found.moment[:]), found.node_count, friction)


def _friction(found: fmc_result | fmc_pair, largest_slip: float) -> Friction:
    areas = found.stick_area, found.slip_area
    return Friction(found.friction_energy, found.friction_dissipation, *areas, largest_slip)


def _pair(handle: Handle, index: int, largest_slip: float) -> Pair:
    found = fmc_pair()
    handle.call(library.fmc_context_pair, index, byref(found))
    return Pair(
        (FMC_PARTNER[found.a_kind], found.a),
        (FMC_PARTNER[found.b_kind], found.b),
        found.volume,
        found.volume_standard_error,
        found.energy,
        found.pressure,
        found.contact_area,
        found.penetration,
        found.spacing,
        _friction(found, largest_slip),
    )


def _warning(handle: Handle, index: int) -> ContactWarning:
    kind, text = c_int32(), c_char_p()
    handle.call(library.fmc_context_warning, index, byref(kind), byref(text))
    return ContactWarning(FMC_WARNING.get(kind.value, str(kind.value)), (text.value or b"").decode())


def gather(handle: Handle, forces: np.ndarray, found: fmc_result, dim: int) -> Result:
    """The result of the evaluation that has just succeeded, copied from what the library keeps until the next one."""
    body, obstacle = library.fmc_context_body, library.fmc_context_obstacle
    return Result(
        forces,
        found.volume,
        found.volume_standard_error,
        found.energy,
        found.contact_area,
        found.penetration,
        found.fiber_count,
        found.crossing_count,
        found.facet_count,
        _friction(found, found.largest_slip),
        tuple(_resultant(handle, body, index, dim) for index in range(found.body_count)),
        tuple(_resultant(handle, obstacle, index, dim) for index in range(found.obstacle_count)),
        tuple(_pair(handle, index, found.largest_slip) for index in range(found.pair_count)),
        tuple(_warning(handle, index) for index in range(found.warning_count)),
    )
