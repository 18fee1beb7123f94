"""Steps to the equilibrium of the contact, with bodies that are factorised once."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from ..condensed import Condensed
from ..errors import IndefiniteStiffnessError, InvertedCellError, SingularStiffnessError
from .state import Model, State

# Residual of a contact step by that of the equilibrium: what it leaves is not to be seen.
_FINER = 0.1

# Part of the residual that a contact step may leave where bodies are not linear: to them it is no equilibrium anyway.
_LEFT_OVER = 1e-2

_FAILURES = (RuntimeError, np.linalg.LinAlgError, SingularStiffnessError, IndefiniteStiffnessError, InvertedCellError)

# Attribute of a contact: factors of linear bodies serve later load steps too.
_KEPT = "_condensed_by_newton"


def condensed_of(model: Model) -> Condensed:
    """The bodies of a contact, kept with it. Errors: ``ValueError``, ``ImportError`` where there are no two levels."""
    known: Any = getattr(model.contact, _KEPT, None)
    if known is None or not known.is_of(model.size, model.free):
        known = Condensed(model.contact, model.size, model.free)
        if hasattr(model.contact, "__dict__"):
            setattr(model.contact, _KEPT, known)
    return cast(Condensed, known)


class Levels:
    """Two levels, as long as they lead anywhere."""

    def __init__(self, model: Model, tolerance: float) -> None:
        self.model, self.tolerance, self.because = model, tolerance, ""
        self.contact_iterations, self.last = 0, None
        self.condensed = condensed_of(model)
        self.before = self.condensed.factorisations

    @property
    def factorisations(self) -> int:
        return self.condensed.factorisations - self.before

    def step(self, state: State, moved: np.ndarray) -> np.ndarray | None:
        """Change of all unknowns, (size,), to the equilibrium of the contact with the bodies linearised here and what is prescribed
        moved; ``None`` where there is none, and ``because`` says why."""
        condensed, absolute_tolerance, found, why = self.condensed, 0.0, None, ""
        is_first, self.last = self.last is None, state.matrix
        if not condensed.knows(state.matrix):
            if is_first:
                condensed.forget()
            else:
                absolute_tolerance = min(_LEFT_OVER, state.relative) * state.norm
        try:
            step, found = condensed.step(
                state.x.ravel(), moved, state.inside, state.matrix, _FINER * self.tolerance, absolute_tolerance if not moved.any() else 0.0
            )
        except _FAILURES as error:
            why = str(error)
        if found is None or (found.state == "not_converged" and found.residual >= found.residual_at_start):
            self.because = why or "the iterations of the contact led nowhere"
            return None
        self.contact_iterations += found.iterations
        return step
