"""Ties in addition to the options of pairs: with a period between their faces, or with a jump."""

from __future__ import annotations

from ctypes import byref
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, floats
from ._core import Core
from ._index import integer
from ._library import library
from ._structs import fmc_tie
from .ties import Tie


def _number(what: str, given: object) -> int:
    """The number of a tie or of a surface; one that cannot be is 0, which the library refuses."""
    found = integer(given)
    if found is None:
        raise TypeError(f"{what} {given!r} is no integer")
    return found if 0 < found < 1 << 31 else 0


class Ties:
    """Ties between named parts of surfaces, of two bodies or of one, with a period and a jump.

    The tie holds x_A - x_B = ``period + jump`` for points that face each other without deformation, after a shift of part B by ``period``. Ties by
    ``pairs.set(..., interface="tied")`` are not listed here.

    Examples
    --------
    The left square repeats along x, twice as long.

    >>> facets = contact.mesh.boundary_facets()
    >>> right = contact.mesh.add_surface([1])
    >>> left = contact.mesh.add_surface([3])
    >>> tie = contact.ties.add((right, left), period=(1, 0))
    >>> contact.ties.set_jump(tie, (1, 0))
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def add(self, surfaces: tuple[int, int], period: Optional[ArrayLike] = None, reach: float = 0.0) -> int:
        """Ties two parts of the surface. The jump is 0 at first.

        The tie has the stiffness of the pair's law, and ``find_equilibrium`` finds multipliers. The tie changes no contact.

        Parameters
        ----------
        surfaces : tuple of int
            Numbers of ``contact.mesh.add_surface``: parts A and B, each of one body, without a facet in common.
        period : array_like, (dim,), optional
            Shift from part B to part A (length). Default: zeros. With a period, only facets of both parts can hide each other.
        reach : float
            Largest gap or overlap up to which faces belong together (length). Default: as of a tied pair.

        Returns
        -------
        int
            Number of the tie: 1, 2, ...

        Raises
        ------
        BadValueError
            If there is no such surface.
        UntiedError
            If no faces lie opposite each other within reach.
        NotPositiveError, NonFiniteStiffnessError
            If the reach is negative, or the period not finite.
        UnsupportedError
            For parts of several bodies or with a facet in common; without a period for bodies in contact; for the law ``"volume"``; for a
            period along the radius.

        Examples
        --------
        >>> contact.ties.add((contact.mesh.add_surface([1]), contact.mesh.add_surface([3])), period=(1, 0))
        1
        """
        a, b = surfaces
        vector, number = self._vector("period", np.zeros(self._core.dim) if period is None else period), np.zeros(1, np.int32)
        numbers = _number("surface", a), _number("surface", b)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_add_tie, *numbers, vector, reach, number)
        return int(number[0])

    def remove(self, tie: int) -> None:
        """Removes a tie. Numbers of other ties stay.

        Parameters
        ----------
        tie : int
            Its number.

        Raises
        ------
        BadValueError
            If there is no such tie.

        Examples
        --------
        >>> tie = contact.ties.add((contact.mesh.add_surface([1]), contact.mesh.add_surface([3])), period=(1, 0))
        >>> contact.ties.remove(tie)
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_remove_tie, _number("tie", tie))

    def set_jump(self, tie: int, jump: ArrayLike) -> None:
        """Sets the jump of part A relative to part B, in addition to the period. Faces are not searched again, and multipliers stay.

        With ``jump = H @ period`` a periodic cell has the macroscopic displacement gradient H.

        Parameters
        ----------
        tie : int
            Its number.
        jump : array_like, (dim,)
            The jump (length).

        Raises
        ------
        BadValueError
            If there is no such tie.
        NonFiniteStiffnessError, UnsupportedError
            If the jump is not finite, or along the radius.

        Examples
        --------
        >>> tie = contact.ties.add((contact.mesh.add_surface([1]), contact.mesh.add_surface([3])), period=(1, 0))
        >>> contact.ties.set_jump(tie, (0.1, 0))
        """
        vector = self._vector("jump", jump)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_tie_jump, _number("tie", tie), vector)

    def found(self, tie: int) -> Tie:
        """Data of a tie, as found without deformation.

        Parameters
        ----------
        tie : int
            Its number.

        Returns
        -------
        Tie
            Area, gap and reach.

        Raises
        ------
        BadValueError
            If there is no such tie.
        UntiedError
            If other reference coordinates leave no face of the tie.

        Examples
        --------
        >>> tie = contact.ties.add((contact.mesh.add_surface([1]), contact.mesh.add_surface([3])), period=(1, 0))
        >>> contact.ties.found(tie).area
        1.0
        """
        found = fmc_tie()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_added_tie, _number("tie", tie), byref(found))
        return Tie(found.area, found.largest_gap, found.node_count, found.reach)

    def force(self, tie: int, coords: ArrayLike) -> np.ndarray:
        """Force of a tie on part A, which is the derivative of the contact energy by the jump. Part B has the opposite force.

        The stress of a periodic cell is the sum of ``np.outer(force, period)`` over its ties, divided by its volume.

        Parameters
        ----------
        tie : int
            Its number.
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Returns
        -------
        ndarray, (dim,)
            The force.

        Raises
        ------
        BadValueError
            If there is no such tie.
        LengthError, NonFiniteCoordinateError, NoStiffnessError, UntiedError
            As ``contact.tie_nodes``.

        Examples
        --------
        >>> tie = contact.ties.add((contact.mesh.add_surface([1]), contact.mesh.add_surface([3])), period=(1, 0))
        >>> contact.ties.force(tie, coords).shape
        (2,)
        """
        view, force = coords_view(coords, self._core.dim), np.zeros(self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_tie_force, byref(view.struct), _number("tie", tie), force, len(force), None)
        return force

    def _vector(self, name: str, given: ArrayLike) -> np.ndarray:
        return np.ascontiguousarray(floats(given, name, (self._core.dim,)))
