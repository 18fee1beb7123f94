"""Penetration tolerance for any iteration: the augmented Lagrangian, as surfaces shifted until they press without penetration."""

from __future__ import annotations

from ctypes import byref, c_double
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, structured, written
from ._core import Core
from ._library import library
from ._structs import fmc_augmentation, fmc_multiplier

MULTIPLIER = np.dtype(fmc_multiplier)
"""Type of an entry of ``Multipliers.values``: ``node`` with its ``body``, ``partner_kind`` (1 for an obstacle) and ``partner``,
``shift``, a length, and the unit vector ``towards`` the partner, (3,)."""


@dataclass(frozen=True)
class Augmentation:
    """Result of ``Multipliers.augment`` at the coordinates of the call.

    Attributes
    ----------
    penetration : float
        Largest mean penetration of a node over its part of the surface (length), on the side of each pair that has multipliers.
    change : float
        Largest change of a multiplier divided by the law's stiffness (length): the distance of a pressed node from its partner.
    is_converged : bool
        Whether both are within the tolerance. The multipliers have not changed then.
    multiplier_count : int
        Number of multipliers.

    Examples
    --------
    >>> contact.multipliers.augment(coords, 1e-6).is_converged
    False
    """

    penetration: float
    change: float
    is_converged: bool
    multiplier_count: int


class Multipliers:
    """Multipliers of the augmented Lagrangian: shifts of surfaces, so that they press without penetration.

    All other results of the contact, such as forces and tangents, refer to the shifted surfaces. ``gap_constraints`` refers to the true surfaces.
    Multipliers stay for the next load step until ``release`` is called.

    Examples
    --------
    >>> found = contact.multipliers.augment(coords, 1e-6)
    >>> len(contact.multipliers.values) == found.multiplier_count
    True
    >>> contact.multipliers.release()
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def augment(self, coords: ArrayLike, penetration: float, reach: float = 0.0) -> Augmentation:
        """Moves surfaces out by their mean gap, so that the next equilibrium has less penetration.

        Call it at an equilibrium, or near one, solve again, and repeat until ``is_converged``. ``find_equilibrium`` does so with its argument
        ``penetration``. The stiffness may be any, but a low one takes more updates. A node moves up to four times as far where the
        last update closed less than it moved, and back where the surfaces have parted. Of two bodies the one with more nodes near
        the other has the multipliers; of equals the first.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.
        penetration : float
            Tolerance for penetration and change (length).
        reach : float
            Distance up to which gaps are measured (length). 0: a twentieth of the extent of the bodies.

        Returns
        -------
        Augmentation
            Penetration and change before the update.

        Raises
        ------
        NotPositiveError
            If a length is negative or not a number.
        UnsupportedError
            With self-contact, and with the law ``"volume"``.
        FmcError
            As ``Contact.evaluate`` raises.

        Examples
        --------
        >>> round(contact.multipliers.augment(coords, 1e-6).penetration, 3)
        0.1
        """
        view, found = coords_view(coords, self._core.dim), fmc_augmentation()
        with self._core.handle:
            arguments = byref(view.struct), c_double(reach), c_double(penetration), byref(found)
            self._core.handle.call(library.fmc_context_augment, *arguments)
        return Augmentation(found.penetration, found.change, bool(found.is_converged), found.multiplier_count)

    @property
    def values(self) -> np.ndarray:
        """The multipliers, ascending by node and partner, a structured array of type ``MULTIPLIER``, (m,).

        For a restart, or a load step that is tried again, you need the coordinates and these values.

        Raises
        ------
        TypeError
            If an array that is set has another type.

        Examples
        --------
        >>> kept = contact.multipliers.values
        >>> contact.multipliers.values = kept
        """
        with self._core.handle:
            found = self._core.handle.rows(fmc_multiplier, library.fmc_context_multipliers)
        return written(found, fmc_multiplier)

    @values.setter
    def values(self, values: np.ndarray) -> None:
        rows = structured(values, MULTIPLIER, "multipliers")
        own = (fmc_multiplier * len(rows)).from_buffer_copy(rows.tobytes()) if len(rows) else None
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_multipliers, own, len(rows))

    def release(self) -> None:
        """Moves surfaces back to where they are.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.multipliers.release()
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_multipliers, None, 0)
