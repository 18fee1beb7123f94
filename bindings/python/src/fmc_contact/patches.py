"""Patches of the law ``"fiber"``."""

from __future__ import annotations

from ctypes import byref, c_size_t
from typing import Optional

from numpy.typing import ArrayLike

from ._arrays import View, coords_view
from ._core import Core
from ._library import library


class Patches:
    """Patches of the law ``"fiber"``: which facets touch together, and the direction and spacing of their lines.

    Without kept patches every evaluation finds its own, and the energy jumps where they change. The other laws have none.

    Examples
    --------
    >>> contact.set_options(law="fiber")
    >>> contact.patches.keep(coords)
    1
    >>> contact.patches.release()
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def keep(self, coords: ArrayLike) -> int:
        """Finds the patches and keeps them, so that forces are the gradient of one energy.

        Call it at the start of a load step. Patches of pairs that do not overlap are not kept.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Returns
        -------
        int
            Number of directions that are kept; 0 with other laws.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.

        Examples
        --------
        >>> contact.patches.keep(coords)
        0
        """
        return self._set(coords_view(coords, self._core.dim))

    def release(self) -> None:
        """Releases kept patches: every evaluation finds its own again.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.patches.release()
        """
        self._set(None)

    def _set(self, view: Optional[View]) -> int:
        count = c_size_t()
        with self._core.handle:
            coords = None if view is None else byref(view.struct)
            self._core.handle.call(library.fmc_context_keep_patches, coords, byref(count))
        return count.value
