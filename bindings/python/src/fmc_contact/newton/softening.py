"""A stiffness that cells bear, for the plain method."""

from __future__ import annotations

import numpy as np

from .state import Model, State

# Pressure, by Young's modulus, down to which a deep overlap is softened. Measured on docs/newton.md's problems: with 0.03
# load steps take an iteration more; with 0.2 the first of the punch takes 26 iterations, not 6, with 128 cells; with
# 0.4 cells under its corners are inverted, with 64 cells.
_BEARABLE = 0.1

# Factor by which k is raised from one iteration to the next, at least. With 8 and more, surfaces at the corners of that
# punch part and come back, one iteration after the other, until a cell is inverted.
_RAISE = 4.0

# Pressure in an iteration by that of the equilibrium from which the load step begins, up to which nothing is softened.
_GROWTH = 2.0

# Residual at the nodes in contact, by the contact forces, below which these are taken for those of an equilibrium.
_BALANCED = 0.01


class Softening:
    """k from iteration to iteration."""

    def __init__(self, model: Model, young: float) -> None:
        if not young > 0:
            raise ValueError(f"Young's modulus is {young}, a positive one is wanted")
        self.model, self.allowed, self.has_touched = model, _BEARABLE * young, False
        self.wanted = self.now = self._stiffness()

    def _stiffness(self) -> float:
        return float(self.model.inner.options["stiffness"])

    @property
    def is_soft(self) -> bool:
        return self.now < self.wanted

    def chosen(self, iteration: int, state: State) -> State:
        """Chooses k; the state with it."""
        if not self.is_soft:
            # An update of multipliers may have raised it.
            self.wanted = self.now = self._stiffness()
        depth = state.result.penetration
        if iteration == 0 and self._is_balanced(state):
            # Pressures of an equilibrium are borne, however large: at a corner they are.
            self.allowed = max(self.allowed, _GROWTH * self.now * depth)
        k = min(self.wanted, self.allowed / depth) if depth > 0 else self.wanted
        # The first linear solve moves what is prescribed: what touches after it is touched for the first time.
        if iteration > 1 and self.has_touched:
            k = min(self.wanted, max(k, _RAISE * self.now))
        self.has_touched = depth > 0
        if k == self.now:
            return state
        self.now = k
        self.model.inner.set_options(stiffness=k)
        return self.model.again(state)

    def undone(self) -> None:
        """k is what it was."""
        if self.is_soft:
            self.now = self.wanted
            self.model.inner.set_options(stiffness=self.wanted)

    def _is_balanced(self, state: State) -> bool:
        """Whether the nodes in contact are in equilibrium; a load that grows acts on others."""
        touching = np.intersect1d(np.flatnonzero(state.forces), self.model.free)
        return bool(np.linalg.norm(state.residual[touching]) < _BALANCED * np.linalg.norm(state.forces[touching]))
