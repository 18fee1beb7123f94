"""The points that the contact is shown, and which unknowns they are."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from .replica import Replica


class Points:
    """Points of one space after another, the same on every rank; each is a block of unknowns that one rank owns."""

    def __init__(self, replicas: Sequence[Replica]) -> None:
        self.replicas = list(replicas)
        self.first = np.cumsum([0] + [replica.count for replica in self.replicas])
        """First point of every space, and the number of points."""

    @property
    def count(self) -> int:
        return int(self.first[-1])

    def owned(self) -> Iterator[tuple[Replica, np.ndarray]]:
        """By space, those that this rank owns."""
        for replica, first in zip(self.replicas, self.first):
            yield replica, first + replica.rows

    def gather(self, owned_values: Sequence[np.ndarray]) -> np.ndarray:
        """Values of all points, from the values of all blocks of this rank, by space. Collective."""
        moved = [replica.gather(values) for replica, values in zip(self.replicas, owned_values)]
        return moved[0] if len(moved) == 1 else np.concatenate(moved)

    def unknowns(self, dim: int) -> np.ndarray:
        """The unknown, over all ranks, of every ``point * dim + axis``, in its own space."""
        numbers = [replica.blocks[:, None] * dim + np.arange(dim) for replica in self.replicas]
        return np.concatenate([of_space.ravel() for of_space in numbers])

    def spaces(self, dim: int) -> np.ndarray:
        """The space of every ``point * dim + axis``."""
        return np.repeat(np.arange(len(self.replicas)), np.diff(self.first) * dim)

    def is_owned(self) -> np.ndarray:
        """Whether this rank owns a point."""
        mine = np.zeros(self.count, bool)
        for _, rows in self.owned():
            mine[rows] = True
        return mine


class AtPoints(np.ndarray):
    """An array about points that knows which these are: other points may be shown before it is used."""

    points: Points | None = None

    def __array_finalize__(self, of: Any) -> None:
        self.points = getattr(of, "points", None)


def at_points(values: np.ndarray, points: Points) -> np.ndarray:
    """The same array, which knows its points."""
    found = np.asarray(values).view(AtPoints)
    found.points = points
    return found


def points_of(values: np.ndarray, now: Points) -> Points:
    """The points of an array over points; the current ones if it has no record of them.

    Errors: ``ValueError`` where these are not as many."""
    points = getattr(values, "points", None) or now
    if len(values) != points.count:
        raise ValueError(f"{len(values)} values at points, of which {points.count} are shown: were others shown before?")
    return points
