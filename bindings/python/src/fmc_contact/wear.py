"""Wear: loss of surfaces by sliding."""

from __future__ import annotations

from ctypes import byref, c_size_t
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats, shape_error
from ._core import Core
from ._library import library
from .errors import LengthError

# Numbers in a row of the worn facets.
WIDTH = 4


class Wear:
    """Wear of the bodies, by Archard's law; ``pairs.set_wear`` switches it on.

    Surfaces wear in ``friction.commit_step`` alone. A side that has slid by s under the pressure p then loses K p s of its depth: contact sees its
    surface recessed by this depth. Coordinates and strains of your mesh stay.

    Examples
    --------
    >>> contact.pairs.set_wear(0, 1, 1e-3)
    >>> contact.friction.begin_step(coords)
    >>> contact.friction.commit_step(coords)
    >>> contact.wear.volumes
    array([0., 0.])
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def _list(self, function: Any) -> np.ndarray:
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(function, None, 0, byref(count))
            found = np.empty(count.value)
            self._core.handle.call(function, found, found.size, byref(count))
        return found

    @property
    def depth(self) -> np.ndarray:
        """Worn depth of the surface at every node (length), (nodes,).

        Raises
        ------
        NoStepError
            If worn facets were set, and no step has begun since.
        UnsupportedError
            For a mesh in parts.

        Examples
        --------
        >>> contact.wear.depth.any()
        np.False_
        """
        return self._list(library.fmc_context_worn_depth)

    @property
    def volumes(self) -> np.ndarray:
        """Volume that every body has lost, in 2D per unit thickness, (bodies,).

        Raises
        ------
        NoStepError
            If worn facets were set, and no step has begun since.
        UnsupportedError
            For a mesh in parts.

        Examples
        --------
        >>> contact.wear.volumes.sum()
        np.float64(0.0)
        """
        return self._list(library.fmc_context_worn_volumes)

    @property
    def facets(self) -> np.ndarray:
        """State of wear, by facet: a row for each worn facet and each node that moves it, (rows, 4).

        Columns: the facet, by its place in ``contact.mesh.boundary_facets()``; the node from 0, with cells of second order the point; the
        depth (length) against the normal of the facet; and the volume. For a restart set the rows, call ``friction.begin_step``, then
        set ``friction.slip``. If you have moved your nodes to the worn surface, set ``np.zeros((0, 4))``.

        Raises
        ------
        LengthError
            If the shape is not (rows, 4).
        IndexOutOfRangeError
            If a row names a facet that does not exist, a node that does not move it, or both twice, or is invalid.
        NotPositiveError
            If a depth or volume is negative or not finite. The old state is then kept.
        UnsupportedError
            For a mesh in parts.

        Examples
        --------
        >>> contact.wear.facets.shape
        (0, 4)
        >>> contact.wear.facets = np.zeros((0, 4))
        """
        return self._list(library.fmc_context_worn_facets).reshape(-1, WIDTH)

    @facets.setter
    def facets(self, facets: ArrayLike) -> None:
        values = np.ascontiguousarray(floats(facets, "facets"))
        if values.ndim != 2 or values.shape[1] != WIDTH:
            raise LengthError(str(shape_error("facets", values.shape, f"(rows, {WIDTH})")))
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_worn_facets, values, values.size)

    def set_cycles(self, cycles: float) -> None:
        """Sets how many cycles each later step represents, 1 at first: the wear of a step is multiplied by this number.

        Parameters
        ----------
        cycles : float
            Their number. Surfaces do not change within a step: an evaluation warns if a step, with all of its cycles, wears off more than the
            sides penetrate.

        Raises
        ------
        NotPositiveError
            Unless it is positive and finite.

        Examples
        --------
        >>> contact.wear.set_cycles(100)
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_wear_cycles, float(cycles))
