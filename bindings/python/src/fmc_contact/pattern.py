"""The pattern of the tangent."""

from __future__ import annotations

from ._core import Core
from ._library import library


class Pattern:
    """The places at which the tangent has entries, for solvers that keep a symbolic factorisation.

    Examples
    --------
    >>> contact.pattern.keep()
    >>> count = contact.tangent(coords).nnz
    >>> contact.tangent(coords - [[0.01, 0.0]]).nnz == count
    True
    >>> contact.pattern.release()
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def keep(self) -> None:
        """Keeps the pattern: from the last tangent on it only grows, and places without an entry hold zeros.

        As long as ``nnz`` of a tangent without terms of rank one stays the same, so does its pattern.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.pattern.keep()
        """
        self._set(1)

    def release(self) -> None:
        """Releases a kept pattern: every tangent has its own.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.pattern.release()
        """
        self._set(0)

    def _set(self, on: int) -> None:
        with self._core.handle:
            self._core.handle.call(library.fmc_context_keep_pattern, on)
