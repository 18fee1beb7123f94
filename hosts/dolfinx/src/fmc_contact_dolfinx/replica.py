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
        order = gather_rows(comm, self.rows)
        if len(order) != self.count:
            raise AssertionError(f"{self.count} nodes have {len(order)} owners")
        self._counts = np.array(comm.allgather(len(self.rows)))
        self._place = np.argsort(order)
        """Where a row stands among those of all ranks, one rank after another."""
        self._unknowns = np.empty(0, np.int64)

    def gather(self, owned_values: np.ndarray) -> np.ndarray:
        """Values of all rows, (count, dim), from the values of all blocks that this rank owns, (owned, dim)."""
        # take is several times as fast as an index, for rows as short as these.
        mine = owned_values.take(self.local, axis=0)
        if self.comm.size == 1:
            return mine
        width = mine.shape[1]
        received = np.empty((self.count, width))
        self.comm.Allgatherv(mine.ravel(), [received.reshape(-1), self._counts * width])
        return received.take(self._place, axis=0)

    def add_rows(self, target: np.ndarray, values: np.ndarray) -> None:
        """Adds values of the rows that this rank owns, (rows, dim), to its blocks in ``target``, (owned * dim,)."""
        if len(self._unknowns) != values.size:
            width = values.shape[1]
            self._unknowns = (self.local[:, None] * width + np.arange(width)).ravel()
        sums = target.take(self._unknowns)
        sums += values.ravel()
        target[self._unknowns] = sums
