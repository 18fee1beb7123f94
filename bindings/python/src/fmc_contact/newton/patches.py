"""Patches of the law "fiber" that follow the contact while it is far from its equilibrium, and are those of its end."""

from __future__ import annotations

from .state import Model, State

FAR = 0.1
"""Residual by the forces above which patches follow the contact."""


class Patches:
    """Which patches are kept, from iteration to iteration."""

    def __init__(self, model: Model, tolerance: float) -> None:
        self.model = model
        self.at: State | None = None
        self.turned = self.was_turned = tolerance >= FAR

    def chosen(self, state: State) -> State:
        """Keeps those of here where that is called for; the state with them.

        Lines run along the contact normal of the start. Once the solution is near, they turn into that of now. Far from it they follow
        the contact when it has begun or spread."""
        is_near = state.relative <= FAR
        if self.at is None or (is_near and not self.turned) or (not is_near and state.outgrows(self.at)):
            self.turned |= is_near
            self.model.inner.patches.keep(self.model.coords(state.x))
            state = self.at = self.model.again(state)
        return state

    def moved(self) -> None:
        """What is prescribed has moved: patches begin anew."""
        self.at, self.turned = None, self.was_turned
