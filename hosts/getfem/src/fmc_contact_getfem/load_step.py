"""One load step of a model by the Newton's method of ``fmc_contact``, fed with GetFEM's matrix and residual."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Any

import fmc_contact
import numpy as np
from fmc_contact.newton import Equilibrium
from numpy.typing import ArrayLike
from scipy.sparse import csr_matrix

from .adapter import GetfemContact
from .bricks import Bricks
from .system import is_linear, residual_and_tangent


def newton(
    contact: GetfemContact,
    *,
    young: float,
    held: ArrayLike | None = None,
    prescribed: ArrayLike | None = None,
    bricks: Bricks | None = None,
    **options: Any,
) -> Equilibrium:
    """Brings the model to the equilibrium with contact at the end of a load step; its state is where the step begins.

    What the step prescribes is in the model's data, which any brick may read: a Dirichlet condition's value, a load.
    ``young`` and ``options`` are those of ``fmc_contact.newton``. ``held``: unknowns of the state that are not solved for, and
    ``prescribed``, (size,), what they are at the end of the step, instead of a Dirichlet condition with multipliers: without
    multipliers the method may be the one in two levels. ``bricks``: those of contact, if the model has them; they are left out
    on the way and are up to date at the end.

    Errors: those of ``fmc_contact.newton``; the state is then that of the start.
    """
    model = contact.model
    start = model.from_variables()
    free = np.ones(len(start), bool)
    if held is not None:
        free[held] = False
    try:
        with bricks.left_out() if bricks else nullcontext():
            linear = is_linear(model)

            def host(state: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
                model.to_variables(state)
                return residual_and_tangent(model, linear)

            found = fmc_contact.newton(host, contact, start, free, prescribed, young=young, **options)
    except BaseException:
        model.to_variables(start)
        raise
    model.to_variables(found.x)
    if bricks:
        bricks.update()
    return found
