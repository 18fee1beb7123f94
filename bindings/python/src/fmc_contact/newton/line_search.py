"""How far along a step."""

from __future__ import annotations

import numpy as np

from ..errors import InvertedCellError
from .state import Model, State

# Part of what the slope promises that a step must gain (Armijo).
_GAIN = 1e-4

# Trials: 2^-30 of a step is nothing.
_MOST_TRIALS = 30

# Times that a step without an energy is halved, at most.
_HALVINGS = 8


def least_energy(model: Model, state: State, step: np.ndarray) -> State | None:
    """The state after a part of a step that lowers the energy; after all of it if that does; ``None`` where no part does.

    Where the energy has grown, its slope has changed sign: the next trial is where the slope would vanish if it were linear, kept
    away from the ends. A cell that is turned inside out halves the step. Errors: ``InvertedCellError`` where it is at every length."""
    slope, length, inverted = float(state.residual @ step), 1.0, None
    if not slope < 0.0:
        return None
    for _ in range(_MOST_TRIALS):
        try:
            reached = model.at(state.x + (length * step).reshape(state.x.shape))
        except InvertedCellError as error:
            inverted, length = error, 0.5 * length
            continue
        if not np.isfinite(reached.norm) or (reached.energy is not None and not np.isfinite(reached.energy)):
            length *= 0.5
            continue
        gained, rounding, flat = state.gained(reached, length * step)
        # Near the end the energy is flat within rounding, or what the step promises is; then the forces tell.
        is_less = min(abs(gained), -slope) <= flat and reached.norm <= 0.5 * state.norm
        if gained <= _GAIN * length * slope + rounding or is_less:
            return reached
        there = float(reached.residual @ step)
        length *= min(max(slope / (slope - there) if there > slope else 0.5, 0.1), 0.7)
        inverted = None
    if inverted is not None:
        raise inverted
    return None


def least_residual(model: Model, state: State, step: np.ndarray) -> State:
    """The state after a part of a step that lowers the residual; where none does, after all of it."""
    whole = reached = model.at(state.x + step.reshape(state.x.shape))
    for halving in range(1, _HALVINGS + 1):
        if reached.relative < state.relative:
            return reached
        reached = model.at(state.x + (0.5**halving * step).reshape(state.x.shape))
    return reached if reached.relative < state.relative else whole
