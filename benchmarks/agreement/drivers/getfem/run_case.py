"""A case in GetFEM: ``python run_case.py CASE [--variant NAME] [--override KEY=VALUE ...] --out FOLDER``."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from fmc_agreement import bits, leapfrog, outcome
from fmc_agreement.equilibrium import Equilibrium
from fmc_agreement.leapfrog import Motion, Touch
from fmc_agreement.path import Path as LoadPath
from fmc_agreement.problem import Problem, load
from in_case import Touching
from model import Model


def at_rest(problem: Problem, out: Path) -> None:
    """Solves a case of statics."""
    bodies = Model(problem)
    touching = Touching(problem, bodies)
    solved = LoadPath(Equilibrium(problem, bodies, touching, bodies.load())).follow()
    found: dict[str, float] = {}
    if problem.raw["figures"]["kind"] == "patch":
        pressure = problem.raw["loads"][0]["pressure"]
        stresses = bodies.stresses_along(solved.steps[-1].displacement, problem.dim - 1)
        found = {"stress_error_max": float(np.abs(stresses + pressure).max() / pressure)}
    bits.begun_anew(problem, touching)
    outcome.of_equilibrium(out, "getfem", problem, solved, found, bits.compared(out, problem, touching.force))


class Forces:
    """Internal and contact forces, for the time steps."""

    def __init__(self, bodies: Model, touching: Touching) -> None:
        self.adapter = touching.adapter
        self.internal = bodies.elastic

    def contact(self, state: np.ndarray) -> tuple[np.ndarray, Touch]:
        result = self.adapter.evaluate(state)
        sums = np.array([one.force for one in (*result.bodies, *result.obstacles)])
        return self.adapter.on_dofs(result.forces), Touch(result.energy, sums)


def in_motion(problem: Problem, out: Path) -> None:
    """Follows a case of dynamics."""
    bodies = Model(problem)
    touching = Touching(problem, bodies)
    mass, velocity = bodies.mass(), np.zeros(problem.coords.shape)
    for body in problem.bodies:
        velocity[body.nodes] = body.velocity
    at_nodes = mass[bodies.dofs]

    def momentum(v: np.ndarray) -> np.ndarray:
        moving = at_nodes * v[bodies.dofs]
        return np.array([moving[body.nodes].sum(axis=0) for body in problem.bodies])

    motion = Motion(mass, bodies.state(problem.held).astype(bool), bodies.state(velocity), momentum=momentum)
    steps = problem.raw["time"]
    state, history = leapfrog.run(Forces(bodies, touching), motion, steps["step"], steps["end"], steps["contact_substeps"])
    masses = np.array([at_nodes[body.nodes, 0].sum() for body in problem.bodies])
    displacement = state[bodies.dofs]
    force = touching.force(displacement)
    arrays = bits.compared(out, problem, touching.force)
    outcome.of_motion(out, "getfem", problem, history, masses, displacement, force, arrays)


def main() -> None:
    parser = argparse.ArgumentParser(description="A case in GetFEM")
    parser.add_argument("case")
    parser.add_argument("--variant")
    parser.add_argument("--override", action="append", default=[])
    parser.add_argument("--out", type=Path, required=True)
    given = parser.parse_args()
    problem = load(given.case, given.variant, tuple(given.override))
    (at_rest if problem.is_static else in_motion)(problem, given.out)


if __name__ == "__main__":
    main()
