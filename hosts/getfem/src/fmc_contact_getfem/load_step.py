"""One load step of a model by the library's search, fed with GetFEM's matrix and residual."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Any

import fmc_contact
import numpy as np
from fmc_contact import Equilibrium
from numpy.typing import ArrayLike
from scipy.sparse import csr_matrix

from .adapter import GetfemContact
from .bricks import Bricks
from .system import is_linear, residual_and_tangent


def find_equilibrium(
    contact: GetfemContact,
    *,
    held: ArrayLike | None = None,
    prescribed: ArrayLike | None = None,
    bricks: Bricks | None = None,
    **options: Any,
) -> Equilibrium:
    """Equilibrium with contact at the end of a load step, by ``fmc_contact.find_equilibrium``.

    The state of the model is where the step begins, and the solution at the end. Data of the model hold the changes of the step: the value of a
    Dirichlet condition, a load.

    Parameters
    ----------
    contact : GetfemContact
        The contact. It may be made without a stiffness.
    held : array_like of int, optional
        Unknowns of the state that are not solved for, instead of a Dirichlet condition with multipliers.
    prescribed : array_like, (size,), optional
        Values of the held unknowns at the end of the step.
    bricks : Bricks, optional
        Bricks of this contact, if the model has them. They are left out on the way, and are up to date at the end.
    **options
        As for ``fmc_contact.find_equilibrium``: ``tolerance``, ``penetration``, ``lagged``, ...

    Returns
    -------
    Equilibrium
        As from ``fmc_contact.find_equilibrium``; ``x`` is the state.

    Raises
    ------
    NoSupportError
        As ``fmc_contact.find_equilibrium`` raises. The state of the start is then restored.
    NotConvergedError
        The same.

    Examples
    --------
    >>> find_equilibrium(contact).iterations
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

            found = fmc_contact.find_equilibrium(host, contact, start, free, prescribed, **options)
    except BaseException:
        model.to_variables(start)
        raise
    model.to_variables(found.x)
    if bricks:
        bricks.update()
    return found
