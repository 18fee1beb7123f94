"""A host's contact in the numbering of the case, and as ``fmc_contact.find_equilibrium`` wants it."""

from __future__ import annotations

import time
from typing import Any, Callable, Protocol

import numpy as np
from fmc_contact import Contact, Result
from scipy.sparse import csr_matrix


class Touching(Protocol):
    """A host's contact; displacements (nodes, dim) of the case."""

    contact: Contact

    def found(self, u: np.ndarray) -> Result:
        """With forces on the nodes of the contact."""

    def in_case(self, forces: np.ndarray) -> np.ndarray:
        """These on ``node * dim + axis`` of the case, (size,)."""

    def coords(self, u: np.ndarray) -> np.ndarray: ...

    def tangent(self, u: np.ndarray, semidefinite: bool, symmetric: bool) -> csr_matrix: ...

    def keep_patches(self, u: np.ndarray) -> Any: ...

    def begin_step(self, u: np.ndarray) -> None: ...

    def commit_step(self, u: np.ndarray) -> None: ...


class InCase:
    """The same, timed, for displacements of any shape."""

    def __init__(self, touching: Touching, shape: tuple[int, int]) -> None:
        self.touching, self.contact, self.shape, self.seconds = touching, touching.contact, shape, 0.0

    def _timed(self, function: Callable, u: np.ndarray, *arguments: Any) -> Any:
        """What a function of the contact returns; its processor time is added up."""
        clock = time.process_time()
        try:
            return function(u.reshape(self.shape), *arguments)
        finally:
            self.seconds += time.process_time() - clock

    def evaluate(self, u: np.ndarray) -> Result:
        return self._timed(self.touching.found, u)

    def forces(self, u: np.ndarray) -> np.ndarray:
        """In the numbering of the case, (nodes, dim)."""
        return self.on_dofs(self.evaluate(u).forces).reshape(self.shape)

    def coords(self, u: np.ndarray) -> np.ndarray:
        return self.touching.coords(u.reshape(self.shape))

    def on_dofs(self, forces: np.ndarray) -> np.ndarray:
        return self.touching.in_case(forces)

    def tangent(self, u: np.ndarray, semidefinite: bool = False, symmetric: bool = False) -> csr_matrix:
        return self._timed(self.touching.tangent, u, semidefinite, symmetric)

    def keep_patches(self, u: np.ndarray) -> Any:
        return self._timed(self.touching.keep_patches, u)

    def begin_step(self, u: np.ndarray) -> None:
        self._timed(self.touching.begin_step, u)

    def commit_step(self, u: np.ndarray) -> None:
        self._timed(self.touching.commit_step, u)
