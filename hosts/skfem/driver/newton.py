"""Newton's method on the total energy, for scikit-fem's vectors."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from fmc_agreement.approach import approach, soft_stiffness
from fmc_contact import FmcError
from fmc_contact_skfem import SkfemContact
from model import Model
from scipy.sparse.linalg import splu

MOST_TURNS = 4
"""Times that the lines are turned into the contact normal of an equilibrium, and it is sought anew."""

FAR = 0.1
"""Residual by the forces above which the contact's matrix is semidefinite."""


class Newton:
    def __init__(self, model: Model, contact: SkfemContact, tolerance: float) -> None:
        self.model, self.contact, self.tolerance = model, contact, tolerance
        self.load = model.load()
        self.free = np.flatnonzero(~model.on_dofs(model.problem.held))
        self.iterations, self.contact_seconds = 0, 0.0
        self.residuals: list[float] = []

    def equilibrium(self) -> np.ndarray:
        """The displacement at full load: first on a soft contact, on which loose bodies settle, then on the real
        one."""
        problem, options = self.model.problem, self.contact.contact.options
        hard = options["stiffness"]
        soft = min(hard, soft_stiffness(problem))
        self.contact.contact.set_options(stiffness=soft)
        load = self.load[self.model.dofs]
        start = approach(problem, load, lambda u: self._force(self.model.on_dofs(u))[self.model.dofs])
        u = self.model.on_dofs(start)
        for stiffness in (soft, (soft * hard) ** 0.5):
            if soft < hard:
                self.contact.contact.set_options(stiffness=stiffness)
                u = self._solve(u, max(FAR, self.tolerance), 0)
        self.contact.contact.set_options(stiffness=hard)
        return self._solve(u, self.tolerance, MOST_TURNS)

    def _force(self, u: np.ndarray) -> np.ndarray:
        return self._timed(self.contact.force, u)

    def _timed(self, function: Any, *arguments: Any) -> Any:
        clock = time.perf_counter()
        found = function(*arguments)
        self.contact_seconds += time.perf_counter() - clock
        return found

    def _state(self, u: np.ndarray) -> tuple[np.ndarray, float, float]:
        """Residual on what is free, its size by the forces, and the energy; infinite where a cell is turned inside
        out."""
        try:
            touch = self._timed(self.contact.evaluate, u)
        except FmcError:
            return np.zeros(len(self.free)), np.inf, np.inf
        inside, strain = self.model.internal(u)
        pushed = self.contact.on_dofs(touch.forces)
        residual = (inside - pushed - self.load)[self.free]
        scale = max(np.linalg.norm(part) for part in (inside, pushed, self.load))
        self.touch = touch
        return residual, float(np.linalg.norm(residual) / scale), float(strain + touch.energy - self.load @ u)

    def _solve(self, u: np.ndarray, tolerance: float, turns: int) -> np.ndarray:
        self._timed(self.contact.keep_patches, u)
        residual, size, energy = self._state(u)
        area, pairs = self.touch.contact_area, len(self.touch.pairs)
        for _ in range(100):
            if size <= tolerance and turns > 0:
                turns -= 1
                self._timed(self.contact.keep_patches, u)
                residual, size, energy = self._state(u)
            # Far from the solution the patches follow the contact when it has begun or spread.
            if size > FAR and (
                len(self.touch.pairs) > pairs or not 0.5 * area <= self.touch.contact_area <= 2.0 * area
            ):
                self._timed(self.contact.keep_patches, u)
                residual, size, energy = self._state(u)
                area, pairs = self.touch.contact_area, len(self.touch.pairs)
            self.residuals.append(size)
            if size <= tolerance:
                return u
            matrix = self.model.tangent(u) + self._timed(self.contact.tangent, u, size > FAR)
            step = np.zeros_like(u)
            step[self.free] = splu(matrix[self.free][:, self.free].tocsc()).solve(-residual)
            self.iterations += 1
            length, slope = 1.0, float(residual @ step[self.free])
            for _ in range(30):
                tried = u + length * step
                found = self._state(tried)
                if found[2] <= energy + 1e-4 * length * slope + 1e-13 * (abs(energy) + abs(self.load @ u)):
                    break
                length *= 0.5
            u, (residual, size, energy) = tried, found
        raise RuntimeError(f"no equilibrium: residual {size:.1e} of the forces")
