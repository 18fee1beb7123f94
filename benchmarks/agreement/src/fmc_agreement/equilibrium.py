"""Bodies at rest: Newton's method on the total energy, for hosts that bring internal
forces, their derivative, contact and a direct solver.

    Π(u) = strain + contact − f·u        r = ∂Π/∂u        K = ∂²Π/∂u²

Everything is in the numbering of the case: displacements and forces (nodes, dim), unknowns ``node * dim + axis``.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any, Callable, Protocol

import numpy as np
from fmc_contact import Contact, Result
from fmc_contact.errors import InvertedCellError
from scipy.sparse import csr_matrix

from .contact_steps import ContactSteps
from .problem import Problem

FAR = 0.1
"""Residual by the forces above which the contact's matrix is semidefinite and its patches follow the contact."""

GAIN = 1e-4
"""Part of what the slope promises that a step must gain."""

MOST_FREEZES = 40
"""Times that friction is frozen in a load step."""

LEFT_OVER = 1e-3
"""Part of the residual at which friction was frozen that a solve may leave: the next one starts from it."""

LEFT_OVER_BY_BODIES = 1e-2
"""Part of the residual that a step may leave where bodies are not linear: to them it is no equilibrium anyway."""

FLAT = 1e-12
"""Part of the energies that a change must exceed to be distinguished from rounding."""


class NoEquilibrium(RuntimeError):
    """None was found; a smaller load step may help."""


class Elastic(Protocol):
    """Internal forces and their derivative."""

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]: ...

    def stiffness(self, u: np.ndarray) -> csr_matrix: ...


class Touching(Protocol):
    """A host's contact."""

    contact: Contact

    def evaluate(self, u: np.ndarray) -> Result: ...

    def coords(self, u: np.ndarray) -> np.ndarray: ...

    def in_case(self, forces: np.ndarray) -> np.ndarray: ...

    def tangent(self, u: np.ndarray, semidefinite: bool) -> csr_matrix: ...

    def keep_patches(self, u: np.ndarray) -> Any: ...

    def begin_step(self, u: np.ndarray) -> None: ...

    def freeze_friction(self, u: np.ndarray) -> None: ...

    def commit_step(self, u: np.ndarray) -> None: ...


Solve = Callable[[csr_matrix, np.ndarray, bool], "np.ndarray | None"]
"""Solution of a system, symmetric or not; ``None`` where a symmetric matrix is not positive definite."""


@dataclass
class Balance:
    """Forces and energy of a displacement."""

    residual: np.ndarray
    """Internal less contact and external force, (nodes, dim)."""
    norm: float
    """Norm of the residual on what is not held."""
    relative: float
    """The same by the largest of the forces' norms."""
    energy: float
    magnitude: float
    """Sum of the energies' magnitudes."""
    touch: Result

    def outgrows(self, other: Balance) -> bool:
        """Whether there is a new pair, or the contact's area has changed by more than half."""
        before, now = ({(pair.a, pair.b) for pair in one.touch.pairs} for one in (other, self))
        area = other.touch.contact_area
        return not now <= before or not 0.5 * area <= self.touch.contact_area <= 2.0 * area


class Equilibrium:
    """A problem, and Newton's method for it."""

    def __init__(
        self, problem: Problem, elastic: Elastic, touching: Touching, load: np.ndarray, solve: Solve
    ) -> None:
        self.problem, self.elastic, self.touching, self.solve = problem, elastic, touching, solve
        self.full_load, self.load = load, load
        self.free = np.flatnonzero(~problem.held)
        self.size = float(np.ptp(problem.coords, axis=0).max())
        self.most_iterations = problem.raw["load_steps"]["most_iterations"]
        self.iterations, self.contact_seconds = 0, 0.0
        self.is_linear = {body.material.law for body in problem.bodies} == {"linear-elastic"}
        self.contact_steps = ContactSteps(touching, problem.coords.shape, self.free)
        self.residuals: list[float] = []

    def timed(self, function: Callable, *arguments: Any) -> Any:
        """What a function of the contact returns; its processor time is added up. Errors: ``NoEquilibrium`` where a cell
        is turned inside out."""
        clock = time.process_time()
        try:
            return function(*arguments)
        except InvertedCellError as error:
            raise NoEquilibrium(str(error)) from None
        finally:
            self.contact_seconds += time.process_time() - clock

    def balance(self, u: np.ndarray) -> Balance:
        """Forces and energy. Errors: ``NoEquilibrium`` where a cell is inverted."""
        touch = self.timed(self.touching.evaluate, u)
        inside, strain = self.elastic.internal(u)
        work = float((self.load * u).sum())
        residual = inside - touch.forces - self.load
        norm = float(np.linalg.norm(residual.ravel()[self.free]))
        scale = max(float(np.linalg.norm(force)) for force in (inside, touch.forces, self.load))
        if not np.isfinite(strain) or not np.isfinite(norm):
            raise NoEquilibrium("a cell is inverted")
        # What frozen friction stores and takes out is its potential.
        contact = touch.energy + touch.friction.energy + touch.friction.dissipation
        magnitude = strain + abs(contact) + abs(work)
        return Balance(residual, norm, norm / (scale or 1.0), strain + contact - work, magnitude, touch)

    def newton(self, u: np.ndarray, tolerance: float, good: float | None = None) -> tuple[np.ndarray, Balance]:
        """Newton's method from a displacement, until the residual is at most ``tolerance``, or a thousand times ``good``
        where the energy cannot be lowered any more; default: the same. Errors: ``NoEquilibrium``."""
        good = tolerance if good is None else good
        now = kept = self.with_patches(u)
        full_failed, turned = False, tolerance >= FAR
        for iteration in range(self.most_iterations + 1):
            residual = now.relative
            # The lines run along the contact normal of the start. Once the solution is near, they turn into that of now.
            if residual <= FAR and not turned:
                now = kept = self.with_patches(u)
                residual, turned = now.relative, True
            # Far from the solution the patches follow the contact when it has begun or spread.
            if residual > FAR and now.outgrows(kept):
                now = kept = self.with_patches(u)
            self.residuals.append(residual)
            if residual <= tolerance:
                return u, now
            if iteration == self.most_iterations:
                break
            step, semidefinite = self._contact_step(u, now, tolerance), True
            if step is None:
                step, semidefinite = self._direction(u, now, residual > FAR or full_failed)
            found = self._search(u, now, step)
            if found is None:
                if residual <= 1e3 * good:
                    return u, now
                raise NoEquilibrium(f"the energy cannot be lowered any more, with a residual of {residual:.1e}")
            full_failed = not semidefinite and found[1].norm > 0.5 * now.norm
            u, now = found
        raise NoEquilibrium(f"no equilibrium: residual {residual:.1e} of the forces")

    def with_friction(self, u: np.ndarray, tolerance: float) -> tuple[np.ndarray, Balance]:
        """Newton's method with friction frozen where the bodies are, and frozen anew where it comes to rest, until that
        is what was frozen, or until the plain method gets there. Frozen friction has an energy and a symmetric tangent.
        Errors: ``NoEquilibrium``."""
        for _ in range(MOST_FREEZES):
            self.timed(self.touching.keep_patches, u)
            self.timed(self.touching.freeze_friction, u)
            now = self.balance(u)
            if now.relative <= tolerance:
                return u, now
            near = self._with_current_pressure(u, tolerance) if now.relative <= FAR else None
            if near is not None:
                return near
            found, now = self.newton(u, max(tolerance, LEFT_OVER * now.relative), tolerance)
            # What cannot be brought nearer is as near as rounding lets it.
            if (found == u).all():
                return u, now
            u = found
        raise NoEquilibrium(f"friction frozen {MOST_FREEZES} times leaves a residual of {now.relative:.1e} of the forces")

    def _with_current_pressure(self, u: np.ndarray, tolerance: float) -> tuple[np.ndarray, Balance] | None:
        """The plain Newton's method with friction that follows the pressure, whose tangent is unsymmetric; ``None`` where
        the residual does not fall, with friction frozen as it was."""
        start = u
        self.touching.contact.release_friction()
        try:
            now = self.balance(u)
            while now.relative > tolerance:
                self.residuals.append(now.relative)
                step = self.linear(u, -now.residual, False, symmetric=False)
                reached = None if step is None else self.balance(u + step)
                if reached is None or reached.norm >= now.norm:
                    break
                u, now = u + step, reached
            else:
                return u, now
        except NoEquilibrium:  # a cell was inverted
            pass
        self.timed(self.touching.freeze_friction, start)
        return None

    def with_patches(self, u: np.ndarray) -> Balance:
        """Forces and energy, and the patches are those of here from now on."""
        self.timed(self.touching.keep_patches, u)
        return self.balance(u)

    def linear(self, u: np.ndarray, right: np.ndarray, semidefinite: bool, symmetric: bool = True) -> np.ndarray | None:
        """Change of the displacement, (nodes, dim), that the tangent at ``u`` gives for forces; ``None`` where it is not
        positive definite, or singular: such may slip through a factorisation, but its solutions do not."""
        matrix = self.elastic.stiffness(u) + self.timed(self.touching.tangent, u, semidefinite)
        found = self.solve(matrix[self.free][:, self.free], right.ravel()[self.free], symmetric)
        if found is None:
            return None
        self.iterations += 1
        step = np.zeros(u.size)
        step[self.free] = found
        longest = float(np.abs(step).max())
        return step.reshape(u.shape) if np.isfinite(longest) and longest < 1e3 * self.size else None

    def _contact_step(self, u: np.ndarray, now: Balance, tolerance: float) -> np.ndarray | None:
        """Change to the equilibrium of the contact with the bodies linearised here; ``None`` where there is none."""
        inside = now.residual + now.touch.forces
        goal = 0.0 if self.is_linear else min(LEFT_OVER_BY_BODIES, now.relative) * now.norm
        step = self.contact_steps.step(u, inside, self.elastic.stiffness(u), 0.1 * tolerance, goal)
        if step is None or not (now.residual * step).sum() < 0.0:
            return None
        self.iterations += 1
        return step

    def _direction(self, u: np.ndarray, now: Balance, semidefinite: bool) -> tuple[np.ndarray, bool]:
        for is_semidefinite in dict.fromkeys((semidefinite, True)):
            step = self.linear(u, -now.residual, is_semidefinite)
            if step is not None and (now.residual * step).sum() < 0.0:
                return step, is_semidefinite
        raise NoEquilibrium("the bodies are not stable, or not supported")

    def _search(self, u: np.ndarray, now: Balance, step: np.ndarray) -> tuple[np.ndarray, Balance] | None:
        """State after a part of the step that lowers the energy; the whole step if it does."""
        slope, length, inverted = float((now.residual * step).sum()), 1.0, None
        for _ in range(30):
            tried = u + length * step
            try:
                reached = self.balance(tried)
            except NoEquilibrium as error:
                inverted = error
                length *= 0.5
                continue
            rounding = 64.0 * np.finfo(float).eps * now.magnitude
            is_flat = abs(reached.energy - now.energy) <= FLAT * now.magnitude
            gained = reached.energy <= now.energy + GAIN * length * slope + rounding
            # Near the end the energy is flat within rounding; then the forces tell.
            if gained or (is_flat and reached.norm <= 0.5 * now.norm):
                return tried, reached
            # The next trial is where the slope would vanish if it were linear, kept away from the ends.
            there = float((reached.residual * step).sum())
            length *= min(max(slope / (slope - there) if there > slope else 0.5, 0.1), 0.7)
            inverted = None
        if inverted is not None:
            raise inverted
        return None
