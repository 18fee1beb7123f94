"""The pattern of the tangent."""

from __future__ import annotations

from ._core import Core
from ._library import library


class Pattern:
    """The places at which the tangent has entries."""

    def __init__(self, core: Core) -> None:
        self._core = core

    def keep(self) -> None:
        """Keeps the pattern of the tangent's entries: from the last tangent on it only grows, and places that have no
        entry any more hold zeros. As long as ``nnz`` of a matrix without terms of rank one stays the same, so does its
        pattern, and with it a symbolic factorisation. For a load step."""
        self._set(1)

    def release(self) -> None:
        """Releases a kept pattern: every tangent has its own."""
        self._set(0)

    def _set(self, on: int) -> None:
        with self._core.handle:
            self._core.handle.call(library.fmc_context_keep_pattern, on)
