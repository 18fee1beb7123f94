"""One load step under way."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from ..errors import FmcError, InvertedCellError
from .equilibrium import Equilibrium, NotConvergedError
from .friction import Frozen
from .levels import Levels
from .line_search import least_energy, least_residual
from .linear import summed
from .patches import Patches
from .penetration import Penetration
from .softening import Softening
from .state import Model, State

# Iterations that are plain. With friction, where much begins to slide in one load step, they may go to and fro between two
# states of a few facets for ever; without, a load step that converges takes no more than these.
_PLAIN = 8

# Times that a step which moves what is prescribed is halved, where it turns a cell inside out.
_MOST_PARTS = 6


class Search:
    """Newton's method from a displacement on."""

    def __init__(self, model: Model, x: np.ndarray, moved: np.ndarray, softening: Softening, solve: Callable[..., Any]) -> None:
        self.model, self.x, self.step, self.solve, self.softening = model, x, moved, solve, softening
        self.levels: Levels | None = None
        self.plain_because = ""
        self.patches: Patches | None = None
        self.frozen: Frozen | None = None
        self.penetration: Penetration | None = None
        self.residuals: list[float] = []
        self.iterations = self.soft_iterations = self.plain_factorisations = 0

    def run(self, tolerance: float, most: int) -> Equilibrium:
        """Errors: ``NotConvergedError``."""
        try:
            state = self.model.at(self.x)
            while True:
                state = self.prepared(state, tolerance)
                if not np.isfinite(state.relative):
                    raise self.failed("the residual is not finite")
                is_moving = bool(self.step.any())
                self.residuals.append(float("nan") if is_moving else state.relative)
                if not is_moving and self.is_found(state, tolerance):
                    return self.found(state)
                if self.iterations >= most:
                    raise self.failed(f"the residual is {state.relative:.1e}, {tolerance:.1e} is wanted")
                self.iterations += 1
                self.soft_iterations += self.softening.is_soft
                state = self.advanced(state)
        except NotConvergedError as error:
            raise error if error.residuals else self.failed(str(error)) from error
        except FmcError as error:
            raise self.failed(str(error)) from error

    def prepared(self, state: State, tolerance: float) -> State:
        """The state with the stiffness, patches, friction and multipliers with which the next iteration is made."""
        if self.levels is None:
            state = self.softening.chosen(self.iterations, state)
        if self.step.any() and self.iterations:
            return state
        if self.patches is not None:
            state = self.patches.chosen(state)
        if self.softening.is_soft or self.step.any():
            return state
        if self.frozen is not None:
            before = self.frozen.solves
            state = self.frozen.chosen(state)
            self.iterations += self.frozen.solves - before
        if self.penetration is not None:
            state = self.penetration.moved_out(state, tolerance)
        return state

    def is_found(self, state: State, tolerance: float) -> bool:
        is_converged = self.penetration is None or self.penetration.is_converged
        return state.relative <= tolerance and not self.softening.is_soft and is_converged

    def found(self, state: State) -> Equilibrium:
        levels, penetration = self.levels, self.penetration
        return Equilibrium(
            state.x,
            self.iterations,
            self.soft_iterations,
            self.residuals,
            state.result,
            state.residual.reshape(state.x.shape),
            self.plain_because,
            levels.contact_iterations if levels else 0,
            (levels.factorisations if levels else 0) + self.plain_factorisations,
            penetration.updates if penetration else 0,
            penetration.found if penetration else None,
        )

    def advanced(self, state: State) -> State:
        """After one linear solve."""
        step = None
        if self.levels is not None:
            step = self.levels.step(state, self.step)
            if step is None:
                self.give_up_levels(self.levels.because)
        if step is None:
            step = self.plain_step(state)
        if self.step.any():
            return self.moved(state, step)
        if self.levels is not None and self.has_energy and self.levels.condensed.is_definite:
            reached = least_energy(self.model, state, step)
            if reached is not None:
                return reached
            self.give_up_levels("no part of the step to the equilibrium of the contact lowers the energy")
            step = self.plain_step(state)
        if self.iterations > _PLAIN:
            return least_residual(self.model, state, step)
        return self.model.at(state.x + step.reshape(state.x.shape))

    @property
    def has_energy(self) -> bool:
        """Whether contact forces are those of one energy: without friction, or where that is frozen."""
        options = self.model.inner.options
        return self.frozen is not None or not (options["friction_coefficient"] or options["cohesion"])

    def give_up_levels(self, why: str) -> None:
        assert self.levels is not None
        self.plain_because = why
        self.plain_factorisations += self.levels.factorisations
        self.levels = None

    def plain_step(self, state: State) -> np.ndarray:
        """Change of all unknowns that the tangent gives, with what is prescribed moved."""
        model, free = self.model, self.model.free
        matrix = summed(state.matrix, model.contact.tangent(state.x, semidefinite=self.softening.is_soft))
        right, step = -(state.residual + matrix @ self.step)[free], self.step.copy()
        self.plain_factorisations += 1
        try:
            step[free] = self.solve(matrix[free][:, free], right)
        except (RuntimeError, np.linalg.LinAlgError) as error:
            raise self.failed(f"the linear solver failed ({error}): is every body held?") from error
        return step

    def moved(self, state: State, step: np.ndarray) -> State:
        """After a step that moves what is prescribed: all of it, or what turns no cell inside out, and the rest later."""
        part = 1.0
        if self.patches is not None:
            self.patches.moved()
        while True:
            try:
                reached = self.model.at(state.x + (part * step).reshape(state.x.shape))
                if np.isfinite(reached.norm) or part <= 0.5**_MOST_PARTS:
                    break
            except InvertedCellError:
                if part <= 0.5**_MOST_PARTS:
                    raise
            part *= 0.5
        self.step = (1.0 - part) * self.step if part < 1.0 else np.zeros(len(self.step))
        return reached

    def failed(self, why: str) -> NotConvergedError:
        text = f"no equilibrium after {self.iterations} iterations: {why}"
        return NotConvergedError(text, self.residuals or [float("nan")], self.iterations)
