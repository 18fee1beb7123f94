"""A case in scikit-fem: ``python run_case.py CASE [--variant NAME] [--override KEY=VALUE ...] --out FOLDER``."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from fmc_agreement import bits, leapfrog, outcome, parts
from fmc_agreement.equilibrium import Equilibrium
from fmc_agreement.leapfrog import Motion, Touch
from fmc_agreement.path import Path as LoadPath
from fmc_agreement.problem import Problem, load
from in_case import Touching
from model import Model


def at_rest(problem: Problem, out: Path) -> None:
    """Solves a case of statics."""
    problems = parts.split(problem)
    models = [Model(one) for one in problems]
    elastic, touching = parts.Elastic(models, problems), Touching(problem, models)
    pull = np.concatenate([model.load()[model.dofs] for model in models])
    solved = LoadPath(Equilibrium(problem, elastic, touching, pull)).follow()
    found: dict[str, float] = {}
    if problem.raw["figures"]["kind"] == "patch":
        pressure = problem.raw["loads"][0]["pressure"]
        stresses = [
            model.stresses_along(model.on_dofs(u), problem.dim - 1)
            for model, u in elastic.each(solved.steps[-1].displacement)
        ]
        found = {"stress_error_max": float(np.abs(np.concatenate(stresses) + pressure).max() / pressure)}
    bits.begun_anew(problem, touching)
    outcome.of_equilibrium(out, "skfem", problem, solved, found, bits.compared(out, problem, touching.force))


class Forces:
    """Internal and contact forces, for the time steps."""

    def __init__(self, model: Model, touching: Touching) -> None:
        self.adapter = touching.adapter
        self.internal = model.internal

    def contact(self, u: np.ndarray) -> tuple[np.ndarray, Touch]:
        result = self.adapter.evaluate(u)
        sums = np.array([one.force for one in (*result.bodies, *result.obstacles)])
        return self.adapter.on_dofs(result.forces), Touch(result.energy, sums)


def in_motion(problem: Problem, out: Path) -> None:
    """Follows a case of dynamics."""
    model = Model(problem)
    touching = Touching(problem, [model])
    mass, velocity = model.mass(), np.zeros(problem.coords.shape)
    for body in problem.bodies:
        velocity[body.nodes] = body.velocity
    at_nodes = mass[model.dofs]

    def momentum(v: np.ndarray) -> np.ndarray:
        moving = at_nodes * v[model.dofs]
        return np.array([moving[body.nodes].sum(axis=0) for body in problem.bodies])

    motion = Motion(mass, model.on_dofs(problem.held), model.on_dofs(velocity), momentum=momentum)
    steps = problem.raw["time"]
    u, history = leapfrog.run(Forces(model, touching), motion, steps["step"], steps["end"], steps["contact_substeps"])
    masses = np.array([at_nodes[body.nodes, 0].sum() for body in problem.bodies])
    displacement = u[model.dofs]
    force = touching.force(displacement)
    arrays = bits.compared(out, problem, touching.force)
    outcome.of_motion(out, "skfem", problem, history, masses, displacement, force, arrays)


def main() -> None:
    parser = argparse.ArgumentParser(description="A case in scikit-fem")
    parser.add_argument("case")
    parser.add_argument("--variant")
    parser.add_argument("--override", action="append", default=[])
    parser.add_argument("--out", type=Path, required=True)
    given = parser.parse_args()
    problem = load(given.case, given.variant, tuple(given.override))
    (at_rest if problem.is_static else in_motion)(problem, given.out)


if __name__ == "__main__":
    main()
