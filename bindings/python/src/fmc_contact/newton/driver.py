"""Newton's method for bodies in contact, one load step a call: in two levels where it can, else plain.

Three things make the plain method converge, and none needs anything of the host but its residual and tangent:

1. Prescribed displacements enter with the first linear solve, from the tangent of the last equilibrium, contact
   included. Bodies in contact are carried along; moved by hand, they would overlap by the whole step.
2. A first overlap that is deep is met softly: k is lowered until k times the penetration is a pressure that the cells
   bear, and is then raised at every iteration until it is the one asked for. The semidefinite tangent goes with it.
   Undiminished, such a pressure inverts cells.
3. With the full stiffness, the full tangent.

After eight iterations, which a load step takes at most as a rule, a step is halved where the residual has not fallen.

In two levels a step goes to the equilibrium of the contact as it is with linear bodies, and is shortened where that does not lower the
energy of all. It is not where the bodies' matrix is not positive definite, as with multipliers of the host's own: no energy is least there.

An equilibrium is one for the stiffness asked for, never for a lower one.
"""

from __future__ import annotations

from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from .equilibrium import Equilibrium
from .friction import Frozen
from .levels import Levels
from .linear import solved
from .patches import Patches
from .penetration import Penetration
from .prescribed import moved, start
from .search import Search
from .softening import Softening
from .state import Model


def newton(
    residual_and_tangent: Callable[[np.ndarray], Any],
    contact: Any,
    x: ArrayLike,
    free: ArrayLike,
    prescribed: Optional[ArrayLike] = None,
    *,
    young: float,
    tolerance: float = 1e-9,
    max_iterations: int = 30,
    lagged: bool = False,
    solve: Optional[Callable[[Any, np.ndarray], np.ndarray]] = None,
    two_level: Optional[bool] = None,
    penetration: Optional[float] = None,
    reach: float = 0.0,
    max_updates: int = 20,
    find_patches: bool = False,
) -> Equilibrium:
    """Equilibrium of bodies in contact at the end of a load step, by Newton's method.

    It suits laws whose pressure is ``stiffness`` times the penetration: ``"depth"``, and ``"fiber"`` with kept patches. The stiffness of
    the contact is changed during the call. Afterwards it is as before, also after an error, unless ``penetration`` raises it.

    Parameters
    ----------
    residual_and_tangent : callable
        Takes ``x`` and returns the residual of the bodies without contact, internal minus external forces in the shape of ``x``; its
        derivative, (size, size), a matrix of scipy or an array; and optionally strain energy minus the work of loads. For
        coordinates the degree of freedom is ``node * dim + axis``.
    contact : Contact or adapter
        A ``Contact``, for which ``x`` are coordinates, (n, dim). Or an adapter such as ``SkfemContact``, for which ``x`` is a
        displacement, (size,): an object with ``contact``, ``coords``, ``evaluate``, ``on_dofs`` and ``tangent``.
    x : array_like
        Where the load step begins, best the last equilibrium. It is not changed.
    free : array_like of int or bool
        Numbers of the unknowns that are solved for, or a mark for every unknown.
    prescribed : array_like, optional
        Values of the other unknowns at the end of the step, in the shape of ``x``. Entries at free unknowns are not read. Default: ``x``.
    young : float
        Young's modulus of the softest body (pressure). It limits the pressure of a first, deep overlap.
    tolerance : float
        The residual at free unknowns divided by the forces, in the Euclidean norm. The forces are those of the bodies or of the
        contact, whichever are larger.
    max_iterations : int
        Number of linear solves, at most.
    lagged : bool
        Whether friction is frozen, solved for, and frozen again until nothing changes. This also converges where the current pressure
        does not, but takes more solves. Near the end the current pressure takes over if it converges, but not with a ``solve`` of
        your own. The equilibrium is the same. Friction is released afterwards.
    solve : callable, optional
        Linear solver, ``solve(matrix, right)``. Default: the library's Cholesky factors. If the matrix is not symmetric and positive
        definite, MUMPS if petsc4py was imported and has it, else scipy's ``splu``; for arrays numpy.
    two_level : bool, optional
        Whether the bodies are condensed on the unknowns that feel contact, which is then iterated by ``Contact.contact_step``. It takes
        fewer linear solves, and finds the stable equilibrium. Default: wherever it is possible without a ``solve`` of your own.
        ``Equilibrium.plain_because`` says why it was not, or where it was given up.
    penetration : float, optional
        Penetration tolerance: largest mean penetration of a node over its part of the surface (length). Surfaces are moved out near an
        equilibrium (``Multipliers.augment``), and stay so for the next load step. If an update leaves more than a quarter, the
        stiffness is raised fourfold, sixteenfold at most, and stays raised. Not with friction or self-contact. Default: what the
        law leaves.
    reach : float
        As for ``Multipliers.augment``.
    max_updates : int
        Number of updates, at most.
    find_patches : bool
        With the law ``"fiber"``: whether patches are kept at the start, follow the contact far from its equilibrium, and are found
        again near it. Otherwise they are left to you.

    Returns
    -------
    Equilibrium
        Solution, contact and counts.

    Raises
    ------
    NotConvergedError
        Also if a cell is inverted, the matrix singular or the residual not finite. A smaller load step helps. If the matrix is
        singular, a body must be held.
    ValueError
        For shapes, and for arguments that exclude one another.

    Examples
    --------
    Two squares on springs, which push each other apart:

    >>> from fmc_contact import newton
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> found = newton(bodies, contact, coords, range(16), young=1e4)
    >>> found.residuals[-1] < 1e-9
    True
    """
    begin, solved_for = start(x, free)
    model = Model(residual_and_tangent, contact, begin.shape, solved_for)
    softening = Softening(model, young)
    search = Search(model, begin, moved(begin, solved_for, prescribed), softening, solve or solved)
    if penetration is not None:
        search.penetration = Penetration(model, penetration, reach, max_updates)
    if find_patches and model.inner.options["law"] == "fiber":
        search.patches = Patches(model, tolerance)
    # That of an adapter is no wish of the user's.
    is_own = solve is not None and not getattr(solve, "is_of_adapter", False)
    search.levels, search.plain_because = _levels(model, tolerance, two_level, is_own)
    try:
        if lagged:
            # An own solver may be one for symmetric matrices.
            search.frozen = Frozen(model, tolerance, None if is_own else search.solve)
            model.inner.friction.freeze(model.coords(begin))
        return search.run(tolerance, max_iterations)
    finally:
        softening.undone()
        if lagged:
            model.inner.friction.release()


def _levels(model: Model, tolerance: float, wanted: bool | None, has_solve: bool) -> tuple[Levels | None, str]:
    """Two levels where they are wanted, or where nothing stands in their way; else why not."""
    if wanted is False:
        return None, "it was asked for"
    if wanted is None and has_solve:
        return None, "the linear solver was given"
    try:
        return Levels(model, tolerance), ""
    except (ValueError, ImportError) as error:
        if wanted:
            raise
        return None, str(error)
