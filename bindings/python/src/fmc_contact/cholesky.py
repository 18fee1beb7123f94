"""The Schur complement by the library's sparse Cholesky factors."""

from __future__ import annotations

from typing import Any

import numpy as np

from .condensation import Condensation
from .errors import NotPositiveDefiniteError, UnsymmetricError
from .schur import Condense, Solve


class Cholesky:
    """``condense`` (``fmc_contact.schur``) for symmetric matrices that are positive definite on the rest; ``other`` gets those that
    are not, and dense ones. The order of elimination is kept for the next matrix of the same pattern, and a solver serves
    until then."""

    def __init__(self, other: Condense) -> None:
        self.other, self._condensation, self._count = other, Condensation(), 0

    def __call__(self, matrix: Any, rest: np.ndarray, kept: np.ndarray) -> tuple[Solve, np.ndarray]:
        if isinstance(matrix, np.ndarray) or not len(rest):
            return self.other(matrix, rest, kept)
        order = np.concatenate([rest, kept])
        self._count += 1
        try:
            self._condensation.factorise(matrix[order][:, order], np.arange(len(rest), len(order)))
        except (NotPositiveDefiniteError, UnsymmetricError):
            return self.other(matrix, rest, kept)
        return _Factors(self, len(rest), len(kept)), self._condensation.complement

    def solved(self, number: int, right: np.ndarray, kept: np.ndarray) -> np.ndarray:
        """Solution with the factors of this number."""
        if number != self._count:
            raise RuntimeError("these factors were replaced by the factors of another matrix")
        return self._condensation.expand(right, kept)


class _Factors:
    """A solver for the rest, with the retained unknowns fixed."""

    def __init__(self, owner: Cholesky, rest: int, kept: int) -> None:
        self._owner, self._number, self._rest = owner, owner._count, rest
        self._held, self._none = np.zeros(kept), np.zeros(rest + kept)

    def __call__(self, right: np.ndarray) -> np.ndarray:
        if right.ndim > 1:
            return np.stack([self(column) for column in right.T], axis=1)
        return self._owner.solved(self._number, np.concatenate([right, self._held]), self._held)[: self._rest]

    def follow(self, kept: np.ndarray) -> np.ndarray:
        """Values of the rest for given retained unknowns, without a load, in half the time."""
        return self._owner.solved(self._number, self._none, kept)[: self._rest]
