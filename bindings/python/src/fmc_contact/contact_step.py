"""Equilibrium of the contact with bodies that are condensed on the degrees of freedom that feel it."""

from __future__ import annotations

from ctypes import byref
from dataclasses import dataclass
from typing import Callable

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import View, vector
from ._constants import FMC_CONTACT_STEP_STATE
from ._handle import Handle
from ._library import check, library
from ._structs import fmc_contact_step_options, fmc_contact_step_result, fmc_place


OPTIONS = (
    "tolerance", "goal", "full_below", "most_iterations", "most_trials", "penetration", "reach", "most_updates", "soft_start",
)  # fmt: skip
"""Names of the options of a step."""


@dataclass(frozen=True, eq=False)
class ContactStep:
    """Where ``Contact.contact_step`` has led."""

    displacement: np.ndarray
    """Displacement of the degrees of freedom on the list, (m,)."""
    state: str
    """``"converged"``; ``"outside"``: contact acts on degrees of freedom that are neither on the list nor held, the displacement
    is what was reached when it did, and a longer list is needed; ``"not_converged"``: the iterations have run out, or the
    residual, or the penetration, could not be lowered any more."""
    iterations: int
    """Dense systems solved."""
    evaluation_count: int
    """Evaluations of the contact, without those of its tangent."""
    outside_count: int
    """Degrees of freedom outside the list on which contact acts."""
    residual_at_start: float
    """Norm of the residual at the start."""
    residual: float
    """Norm of the residual that is left."""
    scale: float
    """What it is compared with: the larger of the norms of the residual given and of the contact forces on the list."""
    update_count: int = 0
    """Updates of the pressures of an augmented Lagrangian."""
    penetration: float = 0.0
    """Largest mean penetration of a node at the end, where one was asked for; else 0."""


def contact_step(
    handle: Handle,
    view: View,
    dim: int,
    dofs: ArrayLike,
    stiffness: ArrayLike,
    residual: ArrayLike,
    held: ArrayLike,
    place: Callable[[np.ndarray, np.ndarray], None] | None,
    options: dict[str, float],
) -> ContactStep:
    """Calls the library."""
    numbers, others = (np.ascontiguousarray(np.ravel(one), np.int64) for one in (dofs, held))
    count = len(numbers)
    matrix = np.ascontiguousarray(stiffness, np.float64)
    if matrix.shape != (count, count):
        raise ValueError(f"stiffness has shape {matrix.shape}, ({count}, {count}) is wanted")
    right, displacement = vector(residual, count, "residual"), np.empty(count)
    asked, found = fmc_contact_step_options(), fmc_contact_step_result()
    check(library.fmc_contact_step_options_init(byref(asked)))
    for name, value in options.items():
        if name not in OPTIONS:
            raise TypeError(f"there is no option '{name}': {', '.join(OPTIONS)}")
        setattr(asked, name, value)

    def placed(_user: object, n: int, given: object, coords: object) -> None:
        rows = np.ctypeslib.as_array(coords, (view.node_count, dim))  # type: ignore[arg-type]
        place(np.ctypeslib.as_array(given, (n,)) if n else np.empty(0), rows)  # type: ignore[arg-type, misc]

    callback = fmc_place() if place is None else fmc_place(handle.guarded(placed))
    arrays = numbers, count, others, len(others), matrix, right
    handle.call(
        library.fmc_context_contact_step, byref(view.struct), byref(asked), *arrays, callback, None, displacement, byref(found)
    )
    return ContactStep(
        displacement,
        FMC_CONTACT_STEP_STATE[found.state],
        found.iterations,
        found.evaluation_count,
        found.outside_count,
        found.residual_at_start,
        found.residual,
        found.scale,
        found.update_count,
        found.penetration,
    )
