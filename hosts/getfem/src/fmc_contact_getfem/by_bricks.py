"""One load step by GetFEM's own ``solve``, iteration by iteration, by the recipe of ``docs/newton.md``."""

from __future__ import annotations

from typing import Any

import numpy as np
from fmc_contact.errors import FmcError
from fmc_contact.newton import NotConvergedError

from .bricks import Bricks
from .system import is_linear

# Pressure, by Young's modulus, down to which a deep overlap is softened; factor by which stiffness is raised at every iteration
# then; pressure by that of the start, up to which nothing is softened; residual at the nodes in contact, by the contact
# forces, below which the start is an equilibrium. Those of fmc_contact.newton.
_BEARABLE, _RAISE, _GROWTH, _BALANCED = 0.1, 4.0, 2.0, 0.01

_WHOLE_STEPS = ("lsearch", "simplest", "alpha min", 1.0)


def newton_by_bricks(
    bricks: Bricks,
    *,
    young: float,
    tolerance: float = 1e-9,
    max_iterations: int = 30,
    solver: tuple[Any, ...] = _WHOLE_STEPS,
) -> int:
    """Equilibrium with contact at the end of a load step, by GetFEM's own ``solve``, one iteration at a time.

    The state of the model is where the step begins, and the solution at the end. Data of the model prescribe what the step changes, as for
    ``newton``, which takes fewer iterations.

    Parameters
    ----------
    bricks : Bricks
        The contact.
    young : float
        Young's modulus of the softest body (pressure).
    tolerance : float
        The residual divided by the forces.
    max_iterations : int
        Number of iterations, at most.
    solver : tuple
        Arguments of ``model.solve``.

    Returns
    -------
    int
        Number of iterations.

    Raises
    ------
    NotConvergedError
        Also if a cell is inverted. The state is then that of the start. A smaller load step helps.

    Examples
    --------
    >>> newton_by_bricks(Bricks(contact), young=1e9)
    """
    model, inner = bricks.contact.model, bricks.contact.contact
    start, residuals = model.from_variables(), []
    stiffness = k = float(inner.options["stiffness"])
    allowed, has_touched, linear = _BEARABLE * young, False, is_linear(model)

    def failed(why: str) -> NotConvergedError:
        model.to_variables(start)
        return NotConvergedError(f"no equilibrium after {len(residuals)} iterations: {why}", residuals)

    try:
        for iteration in range(max_iterations + 1):
            depth = bricks.update().penetration
            if iteration == 0 and _is_balanced(bricks, linear):
                allowed = max(allowed, _GROWTH * k * depth)
            wanted = min(stiffness, allowed / depth) if depth > 0.0 else stiffness
            if iteration > 1 and has_touched:
                wanted = min(stiffness, max(wanted, _RAISE * k))
            has_touched, is_soft = depth > 0.0, wanted < stiffness
            if wanted != k or is_soft:
                k = wanted
                inner.set_options(stiffness=k)
                bricks.update(semidefinite=is_soft)
            residuals.append(bricks.relative(bricks.residual(linear)))
            if residuals[-1] <= tolerance and not is_soft:
                return iteration
            if iteration < max_iterations:
                model.solve("max_iter", 1, *solver)
    except (FmcError, RuntimeError) as error:  # GetFEM's own are RuntimeError
        raise failed(str(error)) from error
    finally:
        inner.set_options(stiffness=stiffness)
    raise failed(f"the residual is {residuals[-1]:.1e}, {tolerance:.1e} is wanted")


def _is_balanced(bricks: Bricks, linear: bool) -> bool:
    """Whether the nodes in contact are in equilibrium; a load that grows acts on others."""
    (touching,) = np.nonzero(bricks.force)
    left = np.linalg.norm(bricks.residual(linear)[touching])
    return bool(left < _BALANCED * np.linalg.norm(bricks.force[touching]))
