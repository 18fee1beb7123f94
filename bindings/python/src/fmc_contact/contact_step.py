"""Equilibrium of the contact with bodies that are condensed on the degrees of freedom that feel it."""

from __future__ import annotations

from ctypes import byref
from dataclasses import dataclass
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import View, numbers, rows_of, vector
from ._constants import FMC_CONTACT_STEP_STATE
from ._handle import Handle
from ._library import check, library
from ._structs import fmc_contact_step_options, fmc_contact_step_result, fmc_place

OPTIONS = ("tolerance", "absolute_tolerance", "full_below", "max_iterations", "max_trials", "soft_start")
"""Names of the options of a step."""


@dataclass(frozen=True, eq=False)
class ContactStep:
    """Result of ``Contact.contact_step``.

    Attributes
    ----------
    displacement : ndarray, (m,)
        Displacement of the degrees of freedom on the list.
    state : str
        ``"converged"``. ``"outside"``: contact acts on degrees of freedom that are neither on the list nor held, and a longer list is needed. The
        displacement is the last one. ``"not_converged"``: the iterations have run out, or the residual could not be lowered further.
    iterations : int
        Dense systems solved.
    evaluation_count : int
        Evaluations of the contact, not counting its tangent.
    outside_count : int
        Degrees of freedom outside the list on which contact acts.
    residual_at_start : float
        Norm of the residual at the start (force).
    residual : float
        Norm of the remaining residual (force).
    scale : float
        Reference of the residual: the norm of the given residual or of the contact forces on the list, whichever is larger.

    Examples
    --------
    >>> held = [0, 1, 3, 5, 6, 7, *range(8, 16)]
    >>> step = contact.contact_step(coords, [2, 4], np.diag([1e4, 1e4]), [0.0, 0.0], held)
    >>> step.displacement.shape
    (2,)
    """

    displacement: np.ndarray
    state: str
    iterations: int
    evaluation_count: int
    outside_count: int
    residual_at_start: float
    residual: float
    scale: float


def contact_step(
    handle: Handle,
    view: View,
    dim: int,
    dofs: ArrayLike,
    stiffness: ArrayLike,
    residual: ArrayLike,
    held: ArrayLike,
    place: Optional[Callable[[np.ndarray, np.ndarray], None]],
    options: dict[str, float],
    index_base: int,
) -> ContactStep:
    """Calls the library."""
    kept, others = (numbers(one, name, None, handle.index) + index_base for one, name in ((dofs, "dofs"), (held, "held")))
    count = len(kept)
    matrix = rows_of(stiffness, "stiffness", (count, count))
    right, displacement = vector(residual, count, "residual"), np.empty(count)
    asked, found = fmc_contact_step_options(), fmc_contact_step_result()
    check(library.fmc_contact_step_options_init(byref(asked)))
    for name, value in options.items():
        if name not in OPTIONS:
            raise TypeError(f"there is no option '{name}': {', '.join(OPTIONS)}")
        setattr(asked, name, value)

    def placed(_user: object, n: int, moved: Any, coords: Any) -> None:
        assert place is not None
        rows = np.ctypeslib.as_array(coords, (view.node_count, dim))
        place(np.ctypeslib.as_array(moved, (n,)) if n else np.empty(0), rows)

    callback = fmc_place() if place is None else fmc_place(handle.guarded(placed))
    arrays = kept, count, others, len(others), matrix, right
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
    )
