"""Newton's method for bodies in contact, one load step a call: in two levels where it can, else plain.

Three things make the plain method converge, and none needs anything of the host but its residual and tangent:

1. Prescribed displacements enter with the first linear solve, from the tangent of the last equilibrium, contact
   included. Bodies in contact are carried along; moved by hand, they would overlap by the whole step.
2. A first overlap that is deep is met softly: k is lowered until k times the penetration is a pressure that the cells
   bear, and is then raised at every iteration until it is the one asked for. The semidefinite tangent goes with it.
   Undiminished, such a pressure inverts cells.
3. With the full stiffness, the full tangent.

After eight iterations, which a load step takes at most as a rule, a step is halved where the residual has not fallen.

An equilibrium is one for the stiffness asked for, never for a lower one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike

from .condensed import Condensed
from .contact import Contact
from .errors import FmcError, IndefiniteStiffnessError, InvertedCellError, SingularStiffnessError
from .result import Result
from .schur import SYMMETRIC

# Pressure, by Young's modulus, down to which a deep overlap is softened. Measured on docs/newton.md's problems: with 0.03
# load steps take an iteration more; with 0.2 the first of the punch takes 26 iterations, not 6, with 128 cells; with
# 0.4 cells under its corners are inverted, with 64 cells.
_BEARABLE = 0.1

# Factor by which k is raised from one iteration to the next, at least. With 8 and more, surfaces at the corners of that
# punch part and come back, one iteration after the other, until a cell is inverted.
_RAISE = 4.0

# Pressure in an iteration by that of the equilibrium from which the load step begins, up to which nothing is softened.
_GROWTH = 2.0

# Residual at the nodes in contact, by the contact forces, below which these are taken for those of an equilibrium.
_BALANCED = 0.01


# Residual by |K| |x| that is made of rounding: some bits of the sums that a host takes over elements.
_ROUNDING = 8 * np.finfo(np.float64).eps

# Iterations that are plain. With friction, where much begins to slide in one load step, they may go to and fro between two
# states of a few facets for ever; without, a load step that converges takes no more than these.
_PLAIN = 8

# Residual of a contact step by that of the equilibrium: what it leaves is not to be seen.
_FINER = 0.1

# Times that a later step is halved, at most.
_HALVINGS = 8


class NotConvergedError(FmcError, RuntimeError):
    """Newton's method did not find an equilibrium; ``residuals`` are those of all iterations, relative."""

    def __init__(self, message: str, residuals: list[float]) -> None:
        super().__init__(message)
        self.residuals = residuals


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """What ``newton`` found."""

    x: np.ndarray
    """The solution, in the shape of the start."""
    iterations: int
    """Number of linear solves."""
    soft_iterations: int
    """Those of them with a stiffness lower than the one asked for."""
    residuals: list[float]
    """Relative residual before each solve and at the end; not a number before prescribed displacements are reached."""
    result: Result
    """Contact at the solution."""
    reactions: np.ndarray
    """Residual at the solution, in the shape of ``x``: the forces that hold the unknowns that are not free."""
    plain_because: str = ""
    """Why the method was plain, from some iteration on; empty where it was in two levels to the end."""


def newton(
    residual_and_tangent: Callable[[np.ndarray], tuple[np.ndarray, Any]],
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
) -> Equilibrium:
    """Equilibrium of bodies in contact at the end of a load step, by Newton's method.

    ``residual_and_tangent(x)``: internal less external forces of the host, without contact, in the shape of ``x``, and
    their derivative, (size, size), a matrix of scipy or an array; degree of freedom ``node * dim + axis`` for
    coordinates. ``contact``: a ``Contact``, for which ``x`` are coordinates, (n, dim); or an adapter with ``contact``,
    ``evaluate``, ``on_dofs`` and ``tangent``, such as ``SkfemContact``, for which ``x`` is a displacement, (size,).
    ``x``: where the load step begins, best the last equilibrium; it is not changed. ``free``: numbers of the unknowns
    that are solved for. ``prescribed``: in the shape of ``x``, what the others are at the end of the step, entries at
    free ones are not read; default: what they are in ``x``. ``young``: Young's modulus of the softest body, which says
    what pressure cells bear. Converged: the residual at free unknowns is at most ``tolerance`` times the forces, in
    Euclid's norm, of the bodies or of contact, whichever is larger, or rounding. ``solve(matrix, right)``: a linear
    solver; default: scipy's ``splu``, numpy's for an array. Lengths and pressures are in the units of the contact.

    For laws of which the pressure is ``stiffness`` times the penetration: ``"depth"``, and ``"fiber"`` with kept
    patches. The stiffness of the contact is changed during the call; afterwards, and after an error, it is what it was.

    With friction, after ``begin_step``; a step that is accepted is committed by the caller. ``lagged`` freezes friction where
    the bodies are, solves, and freezes it anew at what was found, until nothing changes: the matrix is then symmetric, for
    a ``solve`` that asks for it, and the method goes on where that of the current pressure does not converge, but takes
    more solves. The equilibrium is the same. Friction is released afterwards.

    ``two_level``, where ``None``, the default, means wherever it can be (not with a ``solve`` of your own, nor ``lagged``), and ``False``
    never: the bodies are factorised down to the unknowns that feel contact, and the contact is iterated as it is
    (``Contact.contact_step`` with ``soft_start``), without soft iterations of this method; where that leads nowhere, or more than 5 000 unknowns feel contact, the rest is plain, and
    ``Equilibrium.plain_because`` says why. It takes fewer linear
    solves where contact opens and closes, also out of a first overlap of half a cell. It goes where the energy is least: where the
    plain method stays on an equilibrium that is not stable, as of two columns pressed straight together that hardly anything holds
    sideways, it finds the stable one, in which they have slipped off.

    Errors: ``NotConvergedError``, also where a cell is inverted, the matrix singular or the residual not finite. A
    smaller load step helps; if the matrix is singular, a body must be held. ``ValueError`` for shapes.
    """
    search = _Search(residual_and_tangent, contact, np.array(x, np.float64), free, prescribed, young, solve or _solved)
    # That of an adapter is no wish of the user's.
    search.begin_levels(two_level, solve is not None and not getattr(solve, "is_of_adapter", False), lagged)
    try:
        if lagged:
            contact.freeze_friction(search.x)
        return search.run(tolerance, max_iterations, lagged)
    finally:
        search.inner.set_options(stiffness=search.stiffness)
        if lagged:
            search.inner.release_friction()


class _Search:
    """One load step under way."""

    def __init__(
        self, host: Any, contact: Any, x: np.ndarray, free: Any, prescribed: Any, young: float, solve: Any
    ) -> None:
        self.host, self.contact, self.x, self.solve = host, contact, x, solve
        self.inner: Contact = contact if isinstance(contact, Contact) else contact.contact
        self.stiffness = self.k = float(self.inner.options["stiffness"])  # type: ignore[arg-type]
        self.free = np.asarray(free)
        if self.free.dtype == bool:
            self.free = np.flatnonzero(self.free)
        if not young > 0:
            raise ValueError(f"Young's modulus is {young}, a positive one is wanted")
        self.allowed = _BEARABLE * young
        self.step = np.zeros(x.size)
        if prescribed is not None:
            prescribed = np.asarray(prescribed, np.float64)
            if prescribed.shape != x.shape:
                raise ValueError(f"prescribed values have shape {prescribed.shape}, that of x is {x.shape}")
            self.step = (prescribed - x).ravel()
            self.step[self.free] = 0.0
        self.residuals: list[float] = []
        self.has_touched = False
        self.condensed: Condensed | None = None
        self.plain_because = "it was asked for"

    def begin_levels(self, wanted: bool | None, has_solve: bool, lagged: bool) -> None:
        """Chooses the method: two levels where they are wanted, or where nothing stands in their way."""
        if wanted is False:
            return
        if wanted is None and (has_solve or lagged):
            self.plain_because = "the linear solver was given" if has_solve else "friction is frozen and frozen anew"
            return
        try:
            self.condensed = Condensed(self.contact, self.x.size, self.free)
        except (ValueError, ImportError) as error:
            if wanted:
                raise
            self.plain_because = str(error)
            return
        self.plain_because = ""

    def forces(self) -> np.ndarray:
        """Contact forces on all unknowns, (size,)."""
        self.result = self.contact.evaluate(self.x)
        is_plain = self.contact is self.inner
        return np.ravel(self.result.forces if is_plain else self.contact.on_dofs(self.result.forces))

    def bodies(self) -> tuple[np.ndarray, Any]:
        inside, matrix = self.host(self.x.copy())
        inside = np.ravel(inside)
        if inside.shape != (self.x.size,):
            raise ValueError(f"the residual has {inside.size} entries, x has {self.x.size}")
        return inside, matrix

    def is_balanced(self, inside: np.ndarray, forces: np.ndarray) -> bool:
        """Whether the nodes in contact are in equilibrium; a load that grows acts on others."""
        touching = np.intersect1d(np.flatnonzero(forces), self.free)
        return bool(np.linalg.norm((inside - forces)[touching]) < _BALANCED * np.linalg.norm(forces[touching]))

    def soften(self, iteration: int, inside: np.ndarray) -> np.ndarray:
        """Chooses k, and returns the contact forces with it."""
        forces = self.forces()
        if self.condensed is not None:
            return forces
        depth = self.result.penetration
        if iteration == 0 and self.is_balanced(inside, forces):
            # Pressures of an equilibrium are borne, however large: at a corner they are.
            self.allowed = max(self.allowed, _GROWTH * self.k * depth)
        wanted = min(self.stiffness, self.allowed / depth) if depth > 0 else self.stiffness
        # The first linear solve moves what is prescribed: what touches after it is touched for the first time.
        if iteration > 1 and self.has_touched:
            wanted = min(self.stiffness, max(wanted, _RAISE * self.k))
        self.has_touched = depth > 0
        if wanted == self.k:
            return forces
        self.k = wanted
        self.inner.set_options(stiffness=wanted)
        return self.forces()

    def run(self, tolerance: float, max_iterations: int, lagged: bool) -> Equilibrium:
        """``lagged``: friction is frozen, and is frozen anew wherever the bodies are in equilibrium with it."""
        soft_count = 0
        for iteration in range(max_iterations + 1):
            inside, matrix = self.bodies()
            try:
                contact = self.soften(iteration, inside)
            except FmcError as error:
                raise self.failed(iteration, str(error)) from error
            residual, relative = self.balance(inside, contact, matrix)
            if iteration > _PLAIN and relative >= self.residuals[-1]:
                residual, relative, matrix = self.shorten(residual, relative, matrix)
            is_soft, is_moving = self.k < self.stiffness, bool(self.step.any())
            if lagged and relative <= tolerance and not is_soft and not is_moving:
                self.contact.freeze_friction(self.x)
                residual, relative = self.balance(inside, self.forces(), matrix)
            if not np.isfinite(relative):
                raise self.failed(iteration, "the residual is not finite")
            self.residuals.append(float("nan") if is_moving else relative)
            if relative <= tolerance and not is_soft and not is_moving:
                reactions = residual.reshape(self.x.shape)
                return Equilibrium(
                    self.x, iteration, soft_count, self.residuals, self.result, reactions, self.plain_because
                )
            if iteration == max_iterations:
                break
            soft_count += is_soft
            if self.condensed is not None and self.advance_by_contact(inside, matrix, tolerance, relative):
                continue
            self.advance(iteration, residual, _sum(matrix, self.contact.tangent(self.x, semidefinite=is_soft)))
        raise self.failed(max_iterations, f"the residual is {relative:.1e}, {tolerance:.1e} is wanted")

    def shorten(self, residual: np.ndarray, relative: float, matrix: Any) -> tuple[np.ndarray, float, Any]:
        """Halves the last step until the residual has fallen by it; where it never does, all of it is taken."""
        whole = residual, relative, matrix, self.x
        for _ in range(_HALVINGS):
            self.taken /= 2
            self.x = self.x - self.taken
            inside, matrix = self.bodies()
            residual, relative = self.balance(inside, self.forces(), matrix)
            if relative < self.residuals[-1]:
                return residual, relative, matrix
        residual, relative, matrix, self.x = whole
        self.forces()
        return residual, relative, matrix

    def balance(self, inside: np.ndarray, contact: np.ndarray, matrix: Any) -> tuple[np.ndarray, float]:
        """The residual, and how large it is at free unknowns, by the forces."""
        residual = inside - contact
        size = max(np.linalg.norm(inside), np.linalg.norm(contact))
        left = np.linalg.norm(residual[self.free])
        # Bodies that moved as one have forces of rounding alone, of which no part is small.
        rounding = _ROUNDING * np.linalg.norm(abs(matrix) @ abs(self.x.ravel()))
        return residual, float(left / size if left > rounding or not np.isfinite(left) else 0.0)

    def advance_by_contact(self, inside: np.ndarray, matrix: Any, tolerance: float, relative: float) -> bool:
        """Moves to the equilibrium of the contact with the bodies linearised here; where there is none, ``False``, and the
        rest of the load step is plain."""
        condensed = self.condensed
        assert condensed is not None
        found, why = None, ""
        try:
            step, found = condensed.step(self.x.ravel(), self.step, inside, matrix, _FINER * tolerance)
        except (RuntimeError, np.linalg.LinAlgError, SingularStiffnessError, IndefiniteStiffnessError, InvertedCellError) as error:
            why = str(error)
        if found is None or found.state == "not_converged" and found.residual >= found.residual_at_start:
            self.plain_because = why or "the iterations of the contact led nowhere"
            self.condensed = None
            return False
        self.taken = step.reshape(self.x.shape)
        self.step = np.zeros(self.x.size)
        self.x = self.x + self.taken
        return True

    def advance(self, iteration: int, residual: np.ndarray, matrix: Any) -> None:
        right = -(residual + matrix @ self.step)[self.free]
        try:
            step = self.solve(matrix[self.free][:, self.free], right)
        except (RuntimeError, np.linalg.LinAlgError) as error:
            raise self.failed(iteration, f"the linear solver failed ({error}): is every body held?") from error
        self.step[self.free] = step
        self.taken = self.step.reshape(self.x.shape)
        self.x = self.x + self.taken
        self.step = np.zeros(self.x.size)

    def failed(self, iteration: int, why: str) -> NotConvergedError:
        return NotConvergedError(f"no equilibrium after {iteration} iterations: {why}", self.residuals)


def _sum(bodies: Any, contact: Any) -> Any:
    """Both tangents; an array if that of the bodies is one. Without scipy, that of contact comes as triplets."""
    if isinstance(contact, tuple):
        rows, cols, values = contact
        total = np.array(bodies, np.float64)
        np.add.at(total, (rows, cols), values)
        return total
    return bodies + contact.toarray() if isinstance(bodies, np.ndarray) else (bodies + contact).tocsr()


def _solved(matrix: Any, right: np.ndarray) -> np.ndarray:
    if isinstance(matrix, np.ndarray):
        return np.linalg.solve(matrix, right)
    from scipy.sparse.linalg import splu

    return splu(matrix.tocsc(), **SYMMETRIC).solve(right)
