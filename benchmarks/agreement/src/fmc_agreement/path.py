"""Load steps: prescribed displacements and forces grow together, stage after stage, as in the reference host."""

from __future__ import annotations

import time

import numpy as np
from fmc_contact import Equilibrium, FmcError

from .equilibrium import Equilibrium as Solver
from .solved import Solved, Step

MOST_HALVINGS = 8
"""Times that a step which fails is halved."""

MOST_TURNS = 6
"""Times that the lines are turned into the contact normal of an equilibrium, and it is sought anew."""

EASY = 12
"""A step that needs no more iterations than these lets the next one be twice as long, up to the first ones' length."""


class Path:
    """The way through all stages of a case."""

    def __init__(self, equilibrium: Solver) -> None:
        self.equilibrium, self.problem = equilibrium, equilibrium.problem
        self.contact = equilibrium.touching.contact
        plan = self.problem.raw["load_steps"]
        self.tolerance, self.penetration = plan["tolerance"], plan.get("penetration")
        self.u = np.zeros(self.problem.coords.shape)
        self.load = 0.0
        self.found = Solved()
        self.slides = self.problem.has_friction

    def follow(self) -> Solved:
        """Goes through all stages. Errors: those of ``fmc_contact.find_equilibrium``."""
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
        self.start, self.values, self.load = self.u, values, 0.0
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
            self.u, self.load = found.x, load
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
        prescribed = self.start + load * (self.values - self.start)
        return solver.find(self.u, prescribed, self.tolerance, penetration=self.penetration)

    def _on_its_own_patches(self, found: Equilibrium) -> Equilibrium:
        """The equilibrium on the patches that are found where it is, and not on the way there."""
        for _ in range(MOST_TURNS):
            try:
                turned = self.equilibrium.find(found.x, found.x, self.tolerance, penetration=self.penetration)
            except FmcError:  # what was found remains one, on patches of its way
                break
            found = turned
            if found.iterations == 0:
                break
        return found
