"""Data that a contact shares with its parts: the context of the library, its options, and properties fixed by its mesh."""

from __future__ import annotations

from ctypes import byref, c_size_t

from ._handle import Handle
from ._library import library
from ._structs import fmc_options


class Core:
    """A context with its options and counts. A contact and all its parts share one."""

    def __init__(self, handle: Handle, options: fmc_options, dim: int, is_columns: bool) -> None:
        self.handle, self.options, self.dim, self.is_columns = handle, options, dim, is_columns
        self.obstacle_count = 0
        self.count()

    def renew_options(self) -> None:
        """Asks for the options, which the library may have changed: a search makes the law stiffer."""
        self.handle.call(library.fmc_context_options, byref(self.options))

    def count(self) -> None:
        """Asks for the counts of the mesh."""
        counts = [c_size_t() for _ in range(3)]
        self.handle.call(library.fmc_context_counts, *map(byref, counts))
        self.node_count, self.facet_count, self.body_count = (count.value for count in counts)
        self.unknown_count = self.node_count
