"""The equilibrium at the end of a load step."""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import finite, floats
from .bodies import Bodies, CondensedSteps, Residual, Solve, bodies_of, condensed_of
from .closed import End, slip_of
from .host import Host
from .likely import refuse_start, unconnected
from .outcome import Equilibrium, NoSupportError, NotConvergedError
from .requests import Search
from .start import count, start
from .unknowns import Moved


def find_equilibrium(
    residual_and_tangent: Union[Residual, Host],
    contact: Any,
    x: ArrayLike,
    free: ArrayLike,
    prescribed: Optional[ArrayLike] = None,
    *,
    tolerance: float = 1e-9,
    max_iterations: int = 100,
    lagged: bool = False,
    solve: Optional[Solve] = None,
    two_level: Optional[bool] = None,
    penetration: Optional[float] = None,
    reach: float = 0.0,
    max_updates: int = 20,
    find_patches: bool = False,
    straight_slip: bool = False,
) -> Equilibrium:
    """Equilibrium of bodies in contact at the end of a load step, by the library's search.

    The defaults suffice. A contact without a stiffness gets one from the bodies' matrix. Unsupported bodies move rigidly until contact balances their
    loads. Steps are kept so short that no body passes through another. The search then tries several ways from the same start. The first takes steps
    to the equilibrium of the contact with linear bodies (``"condensed"``). Newton's method with full steps finds the equilibrium next to the start,
    stable or not (``"nearest"``). The last is descent of the energy (``"downhill"``). A load step that fails is repeated in parts.

    With friction, wear or damage call ``contact.friction.commit_step`` after each load step: slip counts from there.

    Parameters
    ----------
    residual_and_tangent : callable
        Takes ``x`` and returns the residual of the bodies without contact, internal minus external forces in the shape of ``x``; its
        derivative, (size, size), a matrix of scipy or an array, with the rows of unknowns that are not free; and optionally
        strain energy minus the work of loads. For coordinates the degree of freedom is ``node * dim + axis``. It raises
        ``fmc_contact.search.Refused`` for a state that its bodies cannot have, or returns numbers that are not finite: a shorter step
        is then made. Any other exception, except an ``FmcError``, ends the search and is raised. Or a ``Host`` of ``fmc_contact.search``, which
        answers requests.
    contact : Contact or adapter
        A ``Contact``, for which ``x`` are coordinates, (n, dim). Or an adapter such as ``OnUnknowns``, for which ``x`` is a
        displacement, (size,): an object with ``contact``, ``coords``, ``evaluate``, ``on_dofs`` and ``tangent``, which takes ``semidefinite``
        and ``symmetric``. Every coordinate of the contact is moved by one unknown.
    x : array_like
        Where the load step begins, best the last equilibrium. It is not changed.
    free : array_like of int or bool
        Numbers of the unknowns that are solved for, or a mark for every unknown.
    prescribed : array_like, optional
        Values of the other unknowns at the end of the step, in the shape of ``x``. Entries at free unknowns are not read. Default: ``x``.
    tolerance : float
        The residual at free unknowns divided by the forces, in the Euclidean norm. The reference is the forces of the bodies or of the contact,
        whichever are larger. Rounding errors of the forces do not count.
    max_iterations : int
        Number of linear solves, at most, over all ways and parts of the load step.
    lagged : bool
        Whether friction is frozen, solved for, and frozen again until nothing changes.
    solve : callable, optional
        Linear solver, ``solve(matrix, right)``. Default: the library's Cholesky factors. If the matrix is not symmetric and positive
        definite, MUMPS if petsc4py was imported and has it, else scipy's ``splu``; for arrays numpy.
    two_level : bool, optional
        Whether bodies are condensed on the unknowns that feel contact. Default: without your own ``solve``, where more than weak springs support
        them. True: also for bodies on very soft springs, and with your own ``solve`` for the other ways; the equilibrium is then stable, and may be
        far from the start. Bodies that cannot be condensed raise ``ValueError`` or ``ImportError``.
    penetration : float, optional
        Penetration tolerance: largest mean penetration of a node over its part of the surface (length). Multipliers shift surfaces at an equilibrium
        (``Multipliers.augment``), and stay for the next load step. If an update does not reduce the penetration to a quarter, the stiffness is raised
        fourfold, sixteenfold at most, and stays raised. Not with self-contact. Default, if the stiffness comes from the bodies' matrix: the work of
        the remaining penetration is a thousandth of the work of the bodies' forces. This takes at most four updates, and more as long as each changes
        the forces by a thousandth. Else there is no tolerance.
    reach : float
        As for ``Multipliers.augment``.
    max_updates : int
        Number of updates, at most.
    find_patches : bool
        With the law ``"fiber"``: whether patches are kept at the start, follow the contact far from its equilibrium, and are recomputed near it.
        Otherwise you keep them.
    straight_slip : bool
        With friction: whether all slip counts straight from the start of the step, also of pairs that touch later. Derivatives are then complete.
        Default: from where a gap closes.

    Returns
    -------
    Equilibrium
        Solution, contact and counts.

    Raises
    ------
    NoSupportError
        If neither supports nor contact stop a body. It names the body and its direction.
    NotConvergedError
        If no equilibrium was found. Friction and multipliers of the contact are then restored. The message points out if the function seems to take
        displacements where ``x`` are coordinates, or the other way round.
    ValueError
        For shapes, for arguments that exclude one another, for coordinates in place of displacements, and for a matrix in the order of components,
        which no ``Contact`` has.

    Examples
    --------
    Two squares on springs, which push each other apart:

    >>> from fmc_contact import find_equilibrium
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> found = find_equilibrium(bodies, contact, coords, range(16))
    >>> found.residuals[-1] < 1e-9
    True
    """
    begin, solved_for = start(x, free)
    refuse_start(contact, begin)
    bodies = bodies_of(residual_and_tangent, contact, begin.shape, solved_for, solve)
    unknowns = Moved(contact, begin.size)
    end = None if prescribed is None else _prescribed(prescribed, begin, solved_for)
    if penetration is not None and not penetration > 0:
        raise ValueError(f"the penetration is {penetration}, expected a positive one")
    steps = _condensed(bodies, two_level)
    options = {
        "tolerance": tolerance,
        "max_solves": count("max_iterations", max_iterations, 1),
        "lagged": int(lagged),
        "penetration": penetration or 0.0,
        "reach": reach,
        "max_updates": count("max_updates", max_updates, 0),
        "find_patches": int(find_patches),
        "straight_slip": int(straight_slip),
    }
    search = Search(bodies, unknowns, begin, solved_for, end, options, steps)
    search.run()
    unknowns.inner._core.renew_options()
    return _ended(search, contact, begin, end, (residual_and_tangent, solve), reach)


def _prescribed(values: ArrayLike, begin: np.ndarray, solved_for: np.ndarray) -> np.ndarray:
    """Of all unknowns; entries at free ones are not read."""
    found = floats(values, "prescribed", begin.shape).astype(np.float64)
    found.ravel()[solved_for] = begin.ravel()[solved_for]
    return finite(found, "prescribed").ravel()


def _condensed(bodies: Host, wanted: Optional[bool]) -> Optional[CondensedSteps]:
    """Condensed bodies if requested, or if possible."""
    if not isinstance(bodies, Bodies):
        if wanted:
            raise ValueError("bodies with their own solver are not condensed")
        return None
    # A solver of an adapter is no wish of the user's.
    has_own = bodies.solve_with is not None and not getattr(bodies.solve_with, "is_of_adapter", False)
    if wanted is False or (wanted is None and has_own):
        return None
    try:
        return CondensedSteps(bodies, condensed_of(bodies), bool(wanted))
    except (ValueError, ImportError):
        if wanted:
            raise
        return None


def _ended(search: Search, contact: Any, begin: np.ndarray, end: Optional[np.ndarray], asked: tuple[Any, Any], reach: float) -> Equilibrium:
    result, way, texts = search.ended()
    bodies, steps = search.bodies, search.steps
    residuals = search.array_of(result.residuals, result.residual_count).tolist()
    hints = bodies.hints if isinstance(bodies, Bodies) else []
    if way == "none":
        text = f"no equilibrium after {result.solve_count} linear solves: {texts[0]}"
        if not result.unheld:
            if search.refusal and search.refusal not in text:
                text += f"; the host refused a state: {search.refusal}"
            text = "; ".join([text, *hints, *_wrong(search, begin)])
            raise NotConvergedError(text, residuals or [float("nan")], result.solve_count)
        error = NoSupportError(text, residuals or [float("nan")], result.solve_count)
        error.body, error.is_rotation = result.unheld_body, not any(result.unheld_direction)
        inner = getattr(contact, "contact", contact)
        error.direction = np.array(result.unheld_direction[: inner.dim])
        raise error
    shape = begin.shape
    x = search.array_of(result.x, search.size).reshape(shape)
    if isinstance(bodies, Bodies) and end is not None and bodies.matrix is not None:
        moved = end - begin.ravel()
        moved[search.solved_for] = 0.0
        texts = texts + unconnected(bodies.matrix, moved)
    texts = texts + hints
    found = Equilibrium(
        x,
        result.solve_count,
        residuals,
        contact.evaluate(x),
        search.array_of(result.reactions, search.size).reshape(shape),
        way,
        result.rigid_step_count,
        result.part_count,
        steps.iterations if steps else 0,
        bodies.factorisations + (steps.factorisations if steps else 0),
        result.update_count,
        result.penetration if result.penetration >= 0 else None,
        texts,
        result.first_touch_count,
    )
    # No field: it is no result, and the adjoint alone reads it.
    found.__dict__["_end"] = End(*asked, contact, search.unknowns, search.solved_for, x, found.result.forces, reach, slip_of(search.unknowns.inner))
    return found


def _wrong(search: Search, begin: np.ndarray) -> list[str]:
    """What ``check_host`` finds to be wrong where the load step begins."""
    if not isinstance(search.bodies, Bodies):
        return []
    check = Search(search.bodies, search.unknowns, begin, search.solved_for, None, {"check": 1}, None)
    try:
        check.run()
    except Exception:
        # A host that fails at the states of the check: that there is no equilibrium is what its user has to know.
        return []
    # A check that is refused is one sentence of all that was found until then.
    return [text for one in check.ended()[2] for text in one.split("; ") if "WRONG" in text]
