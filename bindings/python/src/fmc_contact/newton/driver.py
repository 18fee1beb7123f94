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

from typing import Any, Callable

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
    prescribed: ArrayLike | None = None,
    *,
    young: float,
    tolerance: float = 1e-9,
    max_iterations: int = 30,
    lagged: bool = False,
    solve: Callable[[Any, np.ndarray], np.ndarray] | None = None,
    two_level: bool | None = None,
    penetration: float | None = None,
    reach: float = 0.0,
    max_updates: int = 20,
    find_patches: bool = False,
) -> Equilibrium:
    """Equilibrium of bodies in contact at the end of a load step, by Newton's method.

    ``residual_and_tangent(x)``: internal less external forces of the host, without contact, in the shape of ``x``, and
    their derivative, (size, size), a matrix of scipy or an array, and as a third, where the host has it, strain energy less the work of
    loads; degree of freedom ``node * dim + axis`` for coordinates. ``contact``: a ``Contact``, for which ``x`` are coordinates, (n, dim); or an adapter with ``contact``,
    ``evaluate``, ``on_dofs`` and ``tangent``, such as ``SkfemContact``, for which ``x`` is a displacement, (size,).
    ``x``: where the load step begins, best the last equilibrium; it is not changed. ``free``: numbers of the unknowns
    that are solved for. ``prescribed``: in the shape of ``x``, what the others are at the end of the step, entries at
    free ones are not read; default: what they are in ``x``. ``young``: Young's modulus of the softest body, which says
    what pressure cells bear. Converged: the residual at free unknowns is at most ``tolerance`` times the forces, in
    Euclid's norm, of the bodies or of contact, whichever is larger, or rounding. ``solve(matrix, right)``: a linear
    solver; default: the library's Cholesky factors, where the matrix is not symmetric and positive definite MUMPS' (where petsc4py with
    it was imported) or scipy's ``splu``, numpy's for an array. Lengths and pressures are in the units of the contact.

    For laws of which the pressure is ``stiffness`` times the penetration: ``"depth"``, and ``"fiber"`` with kept
    patches. The stiffness of the contact is changed during the call; afterwards, and after an error, it is what it was, if
    no ``penetration`` raises it.

    With friction, after ``friction.begin_step``; a step that is accepted is committed by the caller. ``lagged`` freezes friction where
    the bodies are, solves, and freezes it anew at what was found, until nothing changes: friction has an energy then, and the
    method goes on where that of the current pressure does not converge, but takes more solves. Near the end the plain method with the
    current pressure takes over, where it gets there; not with a ``solve`` of your own, which gets symmetric matrices alone. The
    equilibrium is the same. Friction is released afterwards.

    ``penetration``: the largest mean penetration of a node, over its part of the surface, that is wanted, a length, however soft the
    contact is; ``None``: what the law leaves. Surfaces are moved out by what they penetrate near an equilibrium
    (``Multipliers.augment``, with gaps measured as far as ``reach``), and again, at most ``max_updates`` times; they stay so for the next
    load step. Where an update leaves more than a quarter, the contact's stiffness is raised fourfold (``Contact.stiffen``), sixteenfold at
    most, and stays raised. Not with friction and self-contact.

    ``find_patches``, with the law ``"fiber"``: patches are kept at the start, follow the contact while it is far from its equilibrium,
    and are found anew once near it; else they are the caller's affair.

    ``two_level``, where ``None``, the default, means wherever it can be (not with a ``solve`` of your own), and ``False``
    never: the bodies are factorised down to the unknowns that feel contact, and the contact is iterated as it is
    (``Contact.contact_step`` with ``soft_start``), without soft iterations of this method; where that leads nowhere, or more than 5 000 unknowns feel contact, the rest is plain, and
    ``Equilibrium.plain_because`` says why. It takes fewer linear
    solves where contact opens and closes, also out of a first overlap of half a cell. It goes where the energy is least: where the
    plain method stays on an equilibrium that is not stable, as of two columns pressed straight together that hardly anything holds
    sideways, it finds the stable one, in which they have slipped off.

    Errors: ``NotConvergedError``, also where a cell is inverted, the matrix singular or the residual not finite. A
    smaller load step helps; if the matrix is singular, a body must be held. ``ValueError`` for shapes.
    """
    x, free = start(x, free)
    model = Model(residual_and_tangent, contact, x.shape, free)
    softening = Softening(model, young)
    search = Search(model, x, moved(x, free, prescribed), softening, solve or solved)
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
            model.inner.friction.freeze(model.coords(x))
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
