"""Rows that the ranks own between them, on every rank."""

from __future__ import annotations

from typing import Any

import numpy as np


def gather_rows(comm: Any, rows: np.ndarray) -> np.ndarray:
    """The rows of all ranks, one rank after another, on every rank; they agree in width and type."""
    if comm.size == 1:
        return rows
    rows = np.ascontiguousarray(rows)
    width = int(np.prod(rows.shape[1:]))
    counts = np.array(comm.allgather(len(rows))) * width
    out = np.empty(counts.sum(), rows.dtype)
    comm.Allgatherv(rows.ravel(), [out, counts])
    return out.reshape((-1, *rows.shape[1:]))


class Replica:
    """Nodes, each owned by one rank. ``blocks``: their numbers over all ranks, the same array on every rank."""

    def __init__(self, comm: Any, blocks: np.ndarray, first: int, owned: int) -> None:
        self.comm, self.count, self.blocks = comm, len(blocks), blocks
        self.rows = np.flatnonzero((blocks >= first) & (blocks < first + owned))
        """Rows that this rank owns."""
        self.local = blocks[self.rows] - first
        """Their blocks here."""
        self._order = gather_rows(comm, self.rows)
        self._counts = np.array(comm.allgather(len(self.rows)))
        if len(self._order) != self.count:
            raise AssertionError(f"{self.count} nodes have {len(self._order)} owners")

    def gather(self, owned_values: np.ndarray) -> np.ndarray:
        """From the values of all blocks that this rank owns, (owned, dim), those of all rows, (count, dim)."""
        mine = owned_values[self.local]
        out = np.empty((self.count, *mine.shape[1:]))
        if self.comm.size == 1:
            out[self.rows] = mine
            return out
        width = int(np.prod(mine.shape[1:]))
        received = np.empty((self.count, *mine.shape[1:]))
        self.comm.Allgatherv(np.ascontiguousarray(mine).ravel(), [received.reshape(-1), self._counts * width])
        out[self._order] = received
        return out
