"""As little penetration as is wanted, whatever iterates the bodies: surfaces that are moved out until they press without."""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view
from ._core import Core
from ._library import library
from ._structs import fmc_augmentation, fmc_multiplier

MULTIPLIER = np.dtype(fmc_multiplier)
"""Type of an entry of ``Multipliers.values``: ``node`` with its ``body``, ``partner_kind`` (1 for an obstacle) and ``partner``,
``shift``, a length, and the unit vector ``towards`` the partner, (3,)."""


@dataclass(frozen=True)
class Augmentation:
    """What ``Multipliers.augment`` says of the coordinates that it was called with."""

    penetration: float
    """Largest mean penetration of a node over its part of the surface, of the side of each pair that has the multipliers."""
    change: float
    """Largest change of a multiplier, by the law's stiffness: how far a node that is pressed is from the partner, inside or outside."""
    is_enough: bool
    """Whether both are no more than what was enough: the multipliers have then stayed."""
    multiplier_count: int
    """Number of multipliers."""


class Multipliers:
    """How far surfaces are moved out, until they press without penetration."""

    def __init__(self, core: Core) -> None:
        self._core = core

    def augment(self, coords: ArrayLike, penetration: float, reach: float = 0.0) -> Augmentation:
        """Moves surfaces out so that at the next equilibrium they press with less penetration: at every node by its mean gap
        (``Contact.gap_constraints``) at ``coords``, up to four times as far where the last update of a series has closed less than it moved
        out, and back where it has opened. It is the method of multipliers: by the law's stiffness a shift is a pressure without
        penetration.

        Call it where the bodies are in equilibrium, or nearly, solve again, and so on until ``is_enough``; ``newton`` does so with
        ``penetration``. The law's stiffness may be any, but a low one takes more updates. All that is asked of the contact
        afterwards, forces, tangents, steps, is that of the surfaces moved out, whose penetration is pressure by stiffness;
        ``gap_constraints`` are those of the true ones. What is moved out stays for the next load step; ``release`` moves
        it back. Of two bodies the one with more nodes near the other has the multipliers, of equals the first.

        ``penetration``: what is left alone, of penetration and change, a length. ``reach``: how far from a partner gaps are measured;
        0: a twentieth of the bodies' extent. Errors: ``NotPositiveError`` for a length that is negative or no number;
        ``UnsupportedError`` with friction, self-contact and the law ``"volume"``; else those of ``Contact.evaluate``."""
        view, found = coords_view(coords, self._core.dim), fmc_augmentation()
        with self._core.handle:
            arguments = byref(view.struct), c_double(reach), c_double(penetration), byref(found)
            self._core.handle.call(library.fmc_context_augment, *arguments)
        return Augmentation(found.penetration, found.change, bool(found.is_enough), found.multiplier_count)

    @property
    def values(self) -> np.ndarray:
        """How far surfaces are moved out, ascending by node and partner, a structured array of type ``MULTIPLIER``: with the
        coordinates all that a restart needs, or a load step that is tried again."""
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_multipliers, None, 0, byref(count))
            found = (fmc_multiplier * count.value)()
            self._core.handle.call(library.fmc_context_multipliers, found, count.value, byref(count))
        return np.frombuffer(found, MULTIPLIER).copy() if count.value else np.empty(0, MULTIPLIER)

    @values.setter
    def values(self, values: np.ndarray) -> None:
        rows = np.ascontiguousarray(values, MULTIPLIER)
        given = (fmc_multiplier * len(rows)).from_buffer_copy(rows.tobytes()) if len(rows) else None
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_multipliers, given, len(rows))

    def release(self) -> None:
        """Moves surfaces back to where they are."""
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_multipliers, None, 0)
