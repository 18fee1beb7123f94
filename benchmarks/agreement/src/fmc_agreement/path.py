"""Load steps: prescribed displacements and forces grow together, stage after stage, as in the reference host."""

from __future__ import annotations

import math
import time

import numpy as np
from fmc_contact import Equilibrium, FmcError

from .approach import approach, loose_push, soft_stiffness
from .equilibrium import FAR
from .equilibrium import Equilibrium as Solver
from .solved import Solved, Step

MOST_HALVINGS = 8
"""Times that a step which fails is halved."""

MOST_TURNS = 6
"""Times that the lines are turned into the contact normal of an equilibrium, and it is sought anew."""

EASY = 12
"""A step that needs no more iterations than these lets the next one be twice as long, up to the first ones' length."""

STRIDE = 100.0
"""Factor from one rough contact to the next."""


class Path:
    """The way through all stages of a case."""

    def __init__(self, equilibrium: Solver) -> None:
        self.equilibrium, self.problem = equilibrium, equilibrium.problem
        self.contact = equilibrium.touching.contact
        self.hard = self.contact.options["stiffness"]
        self.soft = min(self.hard, soft_stiffness(self.problem))
        plan = self.problem.raw["load_steps"]
        self.tolerance, self.penetration = plan["tolerance"], plan.get("penetration")
        self.u = np.zeros(self.problem.coords.shape)
        self.load = 0.0
        self.found = Solved()
        self.slides = self.problem.has_friction

    def follow(self) -> Solved:
        """Goes through all stages. Errors: those of ``fmc_contact.newton``."""
        clock, found, solver = time.process_time(), self.found, self.equilibrium
        for stage, (count, values) in enumerate(self.problem.stages):
            self._stage(stage, count, values)
        found.seconds = time.process_time() - clock
        found.residuals, found.iterations = solver.residuals, solver.iterations
        found.contact_seconds = solver.touching.seconds
        found.contact_iterations, found.factorisations = solver.contact_iterations, solver.factorisations
        found.updates = solver.updates
        return found

    def _stage(self, stage: int, count: int, values: np.ndarray) -> None:
        self.start, self.values, self.load, self.before = self.u, values, 0.0, None
        # The dead loads have grown in the first stage.
        self.part_before = min(stage, 1)
        longest = step = 1.0 / count
        while self.load < 1.0:
            load = self.load + step if self.load + step <= 1.0 - 1e-9 else 1.0
            iterations = self.equilibrium.iterations
            multipliers = self.contact.multipliers.values
            try:
                found = self._advance(load)
            except FmcError:
                if step <= longest * 0.5**MOST_HALVINGS:
                    raise
                self.contact.multipliers.values = multipliers
                step *= 0.5
                self.found.halvings += 1
                continue
            if self.slides:
                self.equilibrium.touching.commit_step(found.x)
            elif load == 1.0:
                found = self._on_its_own_patches(found)
            self.before, self.u, self.load = (self.u, self.load), found.x, load
            self.found.steps.append(self._step(stage, load, found))
            if self.equilibrium.iterations - iterations <= EASY:
                step = min(longest, 2.0 * step)

    def _step(self, stage: int, load: float, found: Equilibrium) -> Step:
        touch, shape = found.result, self.u.shape
        sliding = (touch.friction.dissipation, touch.friction.stick_area, touch.friction.slip_area)
        forces = self.equilibrium.touching.on_dofs(touch.forces).reshape(shape)
        penetration = touch.penetration if found.penetration is None else found.penetration
        return Step(stage, load, found.x, forces, penetration, sliding)

    def _advance(self, load: float) -> Equilibrium:
        """Equilibrium at a load, from the last one."""
        solver = self.equilibrium
        part = self.part_before + load * (1.0 - self.part_before)
        solver.load = part * solver.full_load
        if self.slides:
            solver.touching.begin_step(self.u)
            # Until friction is sought, it is that of the last equilibrium.
            solver.touching.freeze_friction(self.u)
        if self.slides and self.before is not None:
            # As far beyond the last equilibrium as that is beyond the one before: what slides goes on sliding.
            last, at = self.before
            start = self._prescribed(self.u + (load - self.load) / (self.load - at) * (self.u - last), load)
            return solver.newton(start, self.tolerance)
        if self._is_loose(self.u) or self._meets_by_lines():
            return solver.newton(self._led(load), self.tolerance, penetration=self.penetration)
        prescribed = self._prescribed(self.u, load)
        return solver.newton(self.u, self.tolerance, prescribed=prescribed, penetration=self.penetration)

    def _led(self, load: float) -> np.ndarray:
        """Where Newton's method begins when bodies meet: they are carried along, and where nothing but contact holds one, or they
        overlap by too much, they settle on a soft contact. On hard contact a body that comes to rest would creep."""
        start = self._predicted(load)
        if self.soft < self.hard and (self._is_loose(start) or self._is_too_deep(start)):
            try:
                return self._settled(start)
            finally:
                self.contact.set_options(stiffness=self.hard)
        return start

    def _meets_by_lines(self) -> bool:
        """Whether bodies meet in this step by sampled lines, whose normal is a mean that may have several fixed points: the one that
        is found depends on the way, and this is the reference host's."""
        options = self.contact.options
        if options["law"] != "fiber" or options["estimator"] != "fibers":
            return False
        self.contact.patches.release()
        return not self.equilibrium.touching.evaluate(self.u).pairs

    def _on_its_own_patches(self, found: Equilibrium) -> Equilibrium:
        """The equilibrium on the patches that are found where it is, and not on the way there."""
        for _ in range(MOST_TURNS):
            try:
                turned = self.equilibrium.newton(found.x, self.tolerance, penetration=self.penetration)
            except FmcError:  # what was found remains one, on patches of its way
                break
            found = turned
            if found.iterations == 0:
                break
        return found

    def _settled(self, u: np.ndarray) -> np.ndarray:
        """Rough equilibria on contacts of growing stiffness."""
        solver, growth = self.equilibrium, self.hard / self.soft
        stages = max(math.ceil(math.log(growth) / math.log(STRIDE)), 1)
        for stage in range(stages):
            self.contact.set_options(stiffness=self.soft * growth ** (stage / stages))
            if stage == 0:
                self.contact.patches.release()
                u = approach(self.problem, u, solver.load, solver.touching.forces)
            u = solver.newton(u, max(FAR, self.tolerance)).x
        return u

    def _prescribed(self, u: np.ndarray, load: float) -> np.ndarray:
        return np.where(self.problem.held, self.start + load * (self.values - self.start), u)

    def _predicted(self, load: float) -> np.ndarray:
        """What is prescribed moved on, and the bodies following as their tangent says: else the cells at the supports alone would
        take all of it."""
        moved = self._prescribed(self.u, load)
        if (moved == self.u).all():
            return self.u
        carried = self.equilibrium.predicted(self.u, moved)
        return moved if carried is None else carried

    def _is_too_deep(self, u: np.ndarray) -> bool:
        """Whether the penetration calls for a pressure beyond Young's modulus, which nothing could bear."""
        self.contact.patches.release()
        try:
            penetration = self.equilibrium.touching.evaluate(u).penetration
        except FmcError:  # Newton's method will hear it too
            return False
        return penetration * self.hard > min(body.material.young for body in self.problem.bodies)

    def _is_loose(self, u: np.ndarray) -> bool:
        """Whether a body that nothing but contact holds against its load touches nothing."""
        loose = [
            body for body in self.problem.bodies if loose_push(self.problem, body, self.equilibrium.load).any()
        ]
        if not loose:
            return False
        self.contact.patches.release()
        forces = self.equilibrium.touching.forces(u)
        return not all(forces[body.nodes].any() for body in loose)
