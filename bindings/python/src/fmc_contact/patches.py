"""Patches of the law ``"fiber"``."""

from __future__ import annotations

from ctypes import byref, c_size_t

from numpy.typing import ArrayLike

from ._arrays import View, coords_view
from ._core import Core
from ._library import library


class Patches:
    """The patches of the law ``"fiber"``: which facets touch together, and the direction and spacing of their lines."""

    def __init__(self, core: Core) -> None:
        self._core = core

    def keep(self, coords: ArrayLike) -> int:
        """Finds the patches at ``coords`` and keeps direction and spacing of their lines, so
        that a solver's forces are the gradient of one energy; call it at the start of a load step. Patches of pairs
        that do not overlap there are not kept. Returns the number of directions kept, 0 with other laws. Errors: those
        of ``Contact.evaluate``."""
        return self._set(coords_view(coords, self._core.dim))

    def release(self) -> None:
        """Releases kept patches: they are found at every evaluation again."""
        self._set(None)

    def _set(self, view: View | None) -> int:
        count = c_size_t()
        with self._core.handle:
            coords = None if view is None else byref(view.struct)
            self._core.handle.call(library.fmc_context_keep_patches, coords, byref(count))
        return count.value
