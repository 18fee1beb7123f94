"""A case as its parts: bodies of one type of cells, for programs whose meshes have one; and what the parts give
together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby
from typing import Any, Protocol

import numpy as np
from scipy.sparse import block_diag, csr_matrix

from .problem import Problem


class Part(Protocol):
    """What a host knows of the bodies of one mesh. Forces and displacements are (nodes, dim), matrices have the unknown
    ``node * dim + axis``, in the part's numbering."""

    def elastic(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces and strain energy; infinite or no number where a cell is inverted."""

    def stiffness(self, u: np.ndarray) -> csr_matrix:
        """Derivative of the internal forces."""


def split(problem: Problem) -> list[Problem]:
    """Bodies that follow one another and have cells of one type, as cases of their own. Their nodes follow one
    another too, as those of the bodies do."""
    found, first = [], 0
    for _, group in groupby(enumerate(problem.bodies), lambda pair: pair[1].cell_type):
        numbers, bodies = zip(*group)
        last = 1 + max(int(body.conn.max()) for body in bodies)
        here = slice(first, last)
        loads = [
            {**one, "faces": (np.array(one["faces"], int) - first).tolist()}
            for one in problem.raw["loads"]
            if one["body"] in numbers
        ]
        part = Problem(
            {**problem.raw, "loads": loads},
            problem.coords[here],
            [replace(body, conn=body.conn - first) for body in bodies],
            problem.held[here],
            problem.prescribed[here],
        )
        found.append(part)
        first = last
    return found


class Elastic:
    """All parts together, in the numbering of the whole case."""

    def __init__(self, parts: Sequence[Part], problems: Sequence[Problem]) -> None:
        self.parts = parts
        self._ends = np.cumsum([len(one.coords) for one in problems])[:-1]

    def each(self, u: np.ndarray) -> list[tuple[Any, np.ndarray]]:
        """Every part with its rows of an array of nodes."""
        return list(zip(self.parts, np.split(u, self._ends)))

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces (nodes, dim) and strain energy."""
        found = [part.elastic(at) for part, at in self.each(u)]
        return np.concatenate([force for force, _ in found]), sum(energy for _, energy in found)

    def stiffness(self, u: np.ndarray) -> csr_matrix:
        """Derivative of the internal forces."""
        return block_diag([part.stiffness(at) for part, at in self.each(u)], format="csr")
