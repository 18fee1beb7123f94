"""Friction that is frozen, and frozen anew, until nothing changes."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from ..errors import FmcError
from .linear import summed
from .patches import FAR
from .state import Model, State

# Part of the residual at which friction was frozen that a solve may leave: the next one starts from it.
_LEFT_OVER = 1e-3


class Frozen:
    """Which friction is frozen, from iteration to iteration.

    Frozen friction has an energy and a symmetric tangent, and leads there from afar; each time some tenth of the error stays. Near the
    end the plain method takes over, with the friction of the pressure of now, where it gets there and may: its matrix is
    unsymmetric."""

    def __init__(self, model: Model, tolerance: float, solve: Callable[[Any, np.ndarray], np.ndarray] | None) -> None:
        self.model, self.tolerance, self.solve = model, tolerance, solve
        self.goal, self.solves = float("inf"), 0

    def chosen(self, state: State) -> State:
        """Freezes friction anew where the bodies are in equilibrium with what is frozen; the state with it."""
        if state.relative > max(self.goal, self.tolerance):
            return state
        return self._frozen(state)

    def _frozen(self, state: State) -> State:
        self.model.inner.friction.freeze(self.model.coords(state.x))
        state = self.model.again(state)
        self.goal = _LEFT_OVER * state.relative
        if self.solve is None or not self.tolerance < state.relative <= FAR:
            return state
        found = self._with_current_pressure(state)
        if found is not None:
            return found
        self.model.inner.friction.freeze(self.model.coords(state.x))
        return state

    def _with_current_pressure(self, state: State) -> State | None:
        """By whole steps while the residual falls; ``None`` where it does not."""
        assert self.solve is not None
        model, free = self.model, self.model.free
        model.inner.friction.release()
        try:
            state = model.again(state)
            while state.relative > self.tolerance:
                matrix = summed(state.matrix, model.contact.tangent(state.x, semidefinite=False))
                step = np.zeros(model.size)
                step[free] = self.solve(matrix[free][:, free], -state.residual[free])
                self.solves += 1
                reached = model.at(state.x + step.reshape(state.x.shape))
                if not reached.norm < state.norm:
                    return None
                state = reached
        except (FmcError, RuntimeError, np.linalg.LinAlgError):  # a cell was inverted, or the matrix is singular
            return None
        return state
