"""Bodies held together by interfaces that break: their state at some coordinates, and their damage."""

from __future__ import annotations

from ctypes import byref, c_size_t
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, floats, shape_error, written
from ._core import Core
from ._index import index_of
from ._library import library
from ._structs import fmc_cohesive, fmc_cohesive_point
from .errors import LengthError


@dataclass(frozen=True)
class CohesiveInterface:
    """The cohesive interface of two bodies at some coordinates.

    Attributes
    ----------
    area : float
        Its total area, without deformation (2D: length; with axisymmetry the area of whole rings). 0: there is no interface.
    largest_gap : float
        Largest gap or overlap that it keeps between the surfaces (length).
    point_count : int
        Number of points at which it opens and breaks.
    stored : float
        Energy that unloading would give back.
    dissipated : float
        Energy that damage has dissipated so far.
    rubbed : float
        Energy that friction of the broken part has dissipated, minus the stick energy of newly broken area.
    viscous : float
        Energy that the viscosity has dissipated.
    damaged_area : float
        Area of points that are damaged, broken ones among them.
    broken_area : float
        Area of points that are broken.

    Examples
    --------
    >>> contact.cohesive.interface(0, 1, coords).area
    0.0
    """

    area: float
    largest_gap: float
    point_count: int
    stored: float
    dissipated: float
    damaged_area: float
    broken_area: float
    rubbed: float
    viscous: float


@dataclass(frozen=True, eq=False)
class CohesivePoints:
    """The points of all cohesive interfaces, m rows, by pair of bodies.

    Attributes
    ----------
    bodies : ndarray of int, (m, 2)
        The pair in ``Result.bodies``, the lower one first.
    position : ndarray, (m, dim)
        Where the point is, on the first body.
    area : ndarray, (m,)
        Its tributary area, without deformation.
    opening : ndarray, (m,)
        Opening beyond the initial gap, along the normal of the second body (length). Negative in compression.
    sliding : ndarray, (m, dim)
        Slip of the first body along the surface of the second (length).
    traction : ndarray, (m, dim)
        Traction on the second body (force per area), along its outward normal in tension.
    damage : ndarray, (m,)
        0: whole, 1: broken, as it would be after a step that ends here.
    dissipated, rubbed, viscous : ndarray, (m,)
        Energies per area dissipated so far: by damage, by friction and by viscosity.

    Examples
    --------
    >>> contact.cohesive.points(coords).traction.shape
    (0, 2)
    """

    bodies: np.ndarray
    position: np.ndarray
    area: np.ndarray
    opening: np.ndarray
    sliding: np.ndarray
    traction: np.ndarray
    damage: np.ndarray
    dissipated: np.ndarray
    rubbed: np.ndarray
    viscous: np.ndarray

    def __len__(self) -> int:
        return len(self.area)


class CohesiveInterfaces:
    """Interfaces that break, as ``pairs.set(a, b, interface="cohesive", ...)`` makes them.

    Every evaluation computes damage from the last accepted state, and ``friction.commit_step`` accepts it, after ``friction.begin_step`` at the
    start. You may repeat a step any number of times.

    Examples
    --------
    >>> len(contact.cohesive.points(coords))
    0
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def interface(self, a: int, b: int, coords: ArrayLike) -> CohesiveInterface:
        """The cohesive interface of two bodies at ``coords``.

        Parameters
        ----------
        a, b : int
            The bodies.
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Returns
        -------
        CohesiveInterface
            Its area is 0 where the bodies have none.

        Raises
        ------
        BodyOutOfRangeError
            If there is no such body.
        LengthError, NonFiniteCoordinateError
            If the coordinates do not fit the mesh.
        UntiedError
            If other reference coordinates leave no face of the interface.

        Examples
        --------
        >>> contact.cohesive.interface(0, 1, coords).point_count
        0
        """
        bodies = index_of("body", a), index_of("body", b)
        view, found = coords_view(coords, self._core.dim), fmc_cohesive()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_cohesive, *bodies, byref(view.struct), byref(found))
        energies = (found.stored, found.dissipated, found.damaged_area, found.broken_area, found.rubbed, found.viscous)
        return CohesiveInterface(found.area, found.largest_gap, found.point_count, *energies)

    def points(self, coords: ArrayLike) -> CohesivePoints:
        """All points at which bodies are held together, by pair.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Returns
        -------
        CohesivePoints
            A row for each point, in the order of ``damage``.

        Raises
        ------
        LengthError, NonFiniteCoordinateError
            If the coordinates do not fit the mesh.
        UntiedError
            As ``interface``.

        Examples
        --------
        >>> len(contact.cohesive.points(coords))
        0
        """
        view, dim = coords_view(coords, self._core.dim), self._core.dim
        with self._core.handle:
            found = self._core.handle.rows(fmc_cohesive_point, library.fmc_context_cohesive_points, byref(view.struct))
        row = written(found, fmc_cohesive_point)
        return CohesivePoints(
            bodies=np.column_stack([row["body"], row["partner"]]),
            position=row["position"][:, :dim].copy(),
            area=row["area"].copy(),
            opening=row["opening"].copy(),
            sliding=row["sliding"][:, :dim].copy(),
            traction=row["traction"][:, :dim].copy(),
            damage=row["damage"].copy(),
            dissipated=row["dissipated"].copy(),
            rubbed=row["rubbed"].copy(),
            viscous=row["viscous"].copy(),
        )

    @property
    def damage(self) -> np.ndarray:
        """State of all points after the accepted steps, in the order of ``points``, (m, 2).

        Columns: damage, 0 to 1; energy per area that was dissipated. A restart needs it and the coordinates, with friction or viscosity also
        ``history``. Set it also for an initially damaged interface: a damage of 1 is a crack.

        Raises
        ------
        LengthError
            If the shape is not (m, 2).
        NotPositiveError
            If a damage is outside 0 to 1, or an energy is negative. The damage is then unchanged.
        UntiedError
            As ``interface``.

        Examples
        --------
        >>> contact.cohesive.damage.shape
        (0, 2)
        >>> contact.cohesive.damage = np.zeros((0, 2))
        """
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_damage, None, 0, byref(count))
            found = np.empty((count.value // 2, 2))
            self._core.handle.call(library.fmc_context_damage, found, found.size, None)
        return found

    @damage.setter
    def damage(self, damage: ArrayLike) -> None:
        values = np.ascontiguousarray(floats(damage, "damage"))
        if values.ndim != 2 or values.shape[1] != 2:
            raise LengthError(str(shape_error("damage", values.shape, "(points, 2)")))
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_damage, values, values.size)

    @property
    def history(self) -> np.ndarray:
        """Further state of these points, (m, 5): a restart sets it after ``damage``. All 0 without friction and viscosity.

        Columns: two of the slip of the broken part, in edges of the facet of the second body; energies per area that friction and viscosity have
        dissipated. The last is the loading of the point when the step began, while the viscosity delays damage.

        Raises
        ------
        LengthError
            If the shape is not (m, 5).
        NotPositiveError
            If a value is not finite, or the energy of the viscosity is negative. The history is then unchanged.
        UntiedError
            As ``interface``.

        Examples
        --------
        >>> contact.cohesive.history.shape
        (0, 5)
        >>> contact.cohesive.history = np.zeros((0, 5))
        """
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_cohesive_history, None, 0, byref(count))
            found = np.empty((count.value // 5, 5))
            self._core.handle.call(library.fmc_context_cohesive_history, found, found.size, None)
        return found

    @history.setter
    def history(self, history: ArrayLike) -> None:
        values = np.ascontiguousarray(floats(history, "history"))
        if values.ndim != 2 or values.shape[1] != 5:
            raise LengthError(str(shape_error("history", values.shape, "(points, 5)")))
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_cohesive_history, values, values.size)

    def set_time_step(self, time_step: float) -> None:
        """Sets the duration of the current step and of all later ones, for the ``viscosity`` of a pair.

        Parameters
        ----------
        time_step : float
            A time, positive.

        Raises
        ------
        NotPositiveError
            If it is not positive and finite.

        Examples
        --------
        >>> contact.cohesive.set_time_step(0.1)
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_time_step, float(time_step))
