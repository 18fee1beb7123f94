"""Results of an evaluation. Units follow from the coordinates and the stiffness: with m and Pa, volumes are m^3 (2D:
m^2), areas m^2 (m), energies J (J/m) and forces N (N/m)."""

from __future__ import annotations

from ctypes import byref, c_char_p, c_int32
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np

from ._constants import FMC_PARTNER, FMC_WARNING
from ._handle import Handle
from ._library import library
from ._structs import fmc_pair_result, fmc_result, fmc_resultant


@dataclass(frozen=True, eq=False)
class Resultant:
    """Contact force and moment on one body or obstacle.

    Attributes
    ----------
    id : int
        Number of the body as given in ``bodies``, or among the connected components; index of the obstacle.
    force : ndarray, (dim,)
        Sum of the forces.
    moment : ndarray, (3,)
        Moment of the forces about the origin. In 2D only the last entry differs from 0.
    node_count : int
        Nodes on the body's surface; 0 for an obstacle.
    friction : ndarray, (dim,)
        The part of ``force`` that is friction.

    Examples
    --------
    >>> contact.evaluate(coords).bodies[1].id
    1
    """

    id: int
    force: np.ndarray
    moment: np.ndarray
    node_count: int
    friction: np.ndarray


@dataclass(frozen=True)
class Friction:
    """Sums of friction; all zero without friction.

    Attributes
    ----------
    energy : float
        Energy stored in sticking contact.
    dissipation : float
        Energy dissipated since the step began; never negative.
    stick_area : float
        Area (2D: length) that sticks.
    slip_area : float
        Area (2D: length) that slides.
    largest_slip : float
        Largest slip since the step began that was not elastic (length).

    Examples
    --------
    >>> contact.evaluate(coords).friction.slip_area
    0.0
    """

    energy: float
    dissipation: float
    stick_area: float
    slip_area: float
    largest_slip: float


@dataclass(frozen=True, eq=False)
class Pair:
    """One overlapping pair. No side is master or slave.

    Attributes
    ----------
    a, b : tuple of str and int
        ``("body", index)`` or ``("obstacle", index)``, of ``Result.bodies`` or ``Result.obstacles``. Both are the same for a body
        that overlaps itself.
    volume : float
        Volume (2D: area) inside both sides, each place once.
    volume_standard_error : float
        Standard error of the volume; 0 for the estimator ``"exact"``.
    energy : float
        Energy of the pair.
    pressure : float
        Mean contact pressure. With ``"volume"`` dw/dV, one value for the whole pair. With ``"fiber"`` the mean over the lines. With
        ``"depth"`` k times the mean depth of both surfaces.
    contact_area : float
        Area of contact (2D: length): half of the boundary of the overlap, including strips of side walls. The law ``"fiber"``
        does not see strips along its lines. With ``"depth"`` and an obstacle it is the surface of the body that is inside.
    penetration : float
        Penetration (length): with ``"fiber"`` the longest line, with ``"depth"`` the largest depth of either surface, with
        ``"volume"`` the extent of the overlap along its mean normal. With ``"fiber"`` and ``"depth"`` k times it is the largest
        pressure.
    spacing : float
        Spacing of the fibers; 0 for the estimator ``"exact"``. As the option ``spacing`` it gives the same pattern again.
    friction : Friction
        Friction of the pair. Its ``largest_slip`` is the largest of all pairs.
    force : ndarray, (dim,)
        Force of ``a`` on ``b``, friction included; that of ``b`` on ``a`` is its negative. 0 for a body that overlaps itself; of a tie of
        a body with itself the force on part B.

    Examples
    --------
    >>> pair = contact.evaluate(coords).pairs[0]
    >>> pair.a, pair.b
    (('body', 0), ('body', 1))
    """

    a: tuple[str, int]
    b: tuple[str, int]
    volume: float
    volume_standard_error: float
    energy: float
    pressure: float
    contact_area: float
    penetration: float
    spacing: float
    friction: Friction
    force: np.ndarray


@dataclass(frozen=True)
class ContactWarning:
    """A caution about a result, which is valid all the same.

    Attributes
    ----------
    kind : str
        ``"coarse_fibers"``, ``"unresolved_overlap"``, ``"swallowed_body"``, ``"patch_left_out"``, ``"unbalanced"``,
        ``"flush_faces"``, ``"coinciding_faces"``, ``"gentle_distance"``, ``"curved_faces"``,
        ``"coarse_faces"``, ``"unused_smoothing"``, ``"no_friction_direction"`` or ``"large_wear"``.
    text : str
        A sentence.

    Examples
    --------
    >>> contact.evaluate(coords).warnings
    ()
    """

    kind: str
    text: str


@dataclass(frozen=True, eq=False)
class Result:
    """Contact forces, totals, resultants and pairs.

    Attributes
    ----------
    forces : ndarray, (n, dim), or (dim, n) for coordinates in columns
        Force on every node. Forces push bodies apart; nodes without contact have 0. The array ``out`` if one was given.
    volume : float
        Volume (2D: area) of the overlaps, summed over the pairs.
    volume_standard_error : float
        Standard error of the volume; 0 for the estimator ``"exact"``.
    energy : float
        Contact energy, summed over the pairs.
    contact_area : float
        Area of contact (2D: length), summed over the pairs; see ``Pair``.
    penetration : float
        Largest penetration of any pair (length); see ``Pair``.
    fiber_count : int
        Number of fibers.
    crossing_count : int
        Number of crossings that bound an overlap.
    facet_count : int
        Number of facets that bound an overlap.
    friction : Friction
        Friction, summed over the pairs.
    bodies : tuple of Resultant
        Force and moment on every body, ordered by id.
    obstacles : tuple of Resultant
        Force and moment on every obstacle.
    pairs : tuple of Pair
        Pairs that overlap.
    warnings : tuple of ContactWarning
        Cautions about this result.

    Examples
    --------
    >>> result = contact.evaluate(coords)
    >>> result.forces.shape, len(result.pairs)
    ((8, 2), 1)
    """

    forces: np.ndarray
    volume: float
    volume_standard_error: float
    energy: float
    contact_area: float
    penetration: float
    fiber_count: int
    crossing_count: int
    facet_count: int
    friction: Friction
    bodies: tuple[Resultant, ...]
    obstacles: tuple[Resultant, ...]
    pairs: tuple[Pair, ...]
    warnings: tuple[ContactWarning, ...]


def _resultant(handle: Handle, getter: Callable[..., int], index: int, dim: int) -> Resultant:
    found = fmc_resultant()
    handle.call(getter, index, byref(found))
    force, friction = np.array(found.force[:dim]), np.array(found.friction[:dim])
    return Resultant(found.id, force, np.array(found.moment[:]), found.node_count, friction)


def _friction(found: Any, largest_slip: float) -> Friction:
    areas = found.stick_area, found.slip_area
    return Friction(found.friction_energy, found.friction_dissipation, *areas, largest_slip)


def _pair(handle: Handle, index: int, largest_slip: float, dim: int) -> Pair:
    found = fmc_pair_result()
    handle.call(library.fmc_context_pair_result, index, byref(found))
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
        np.array(found.force[:dim]),
    )


def _warning(handle: Handle, index: int) -> ContactWarning:
    kind, text = c_int32(), c_char_p()
    handle.call(library.fmc_context_warning, index, byref(kind), byref(text))
    return ContactWarning(FMC_WARNING.get(kind.value, str(kind.value)), (text.value or b"").decode())


def gather(handle: Handle, forces: np.ndarray, found: fmc_result, dim: int) -> Result:
    """The result of the last successful evaluation, copied from the library, which keeps it until the next one."""
    body, obstacle = library.fmc_context_body_resultant, library.fmc_context_obstacle_resultant
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
        tuple(_pair(handle, index, found.largest_slip, dim) for index in range(found.pair_count)),
        tuple(_warning(handle, index) for index in range(found.warning_count)),
    )
