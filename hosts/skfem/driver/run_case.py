"""A case in scikit-fem: ``python run_case.py CASE [--variant NAME] [--override KEY=VALUE ...] --out FOLDER``."""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np
from fmc_agreement import bits, figures, leapfrog, outcome
from fmc_agreement.leapfrog import Motion, Touch
from fmc_agreement.problem import Problem, load
from fmc_contact_skfem import SkfemContact
from model import Model
from newton import Newton


def contact_of(problem: Problem, model: Model) -> SkfemContact:
    """The contact of the case, with its obstacles."""
    contact = SkfemContact(model.basis, bodies=problem.body_of_cell, **problem.contact_options())
    problem.add_obstacles(contact.contact)
    return contact


def same_bits(out: Path, problem: Problem, model: Model, contact: SkfemContact) -> dict[str, np.ndarray]:
    """Forces at the displacement of the reference host, where it has run."""
    if not (out / "reference.npz").exists():
        return {}
    contact.contact.release_patches()
    return bits.compared(out, problem, lambda u: contact.force(model.on_dofs(u))[model.dofs])


def at_rest(problem: Problem, out: Path) -> None:
    """Solves a case of statics."""
    model = Model(problem)
    begin = time.perf_counter()
    newton = Newton(model, contact_of(problem, model), problem.raw["load_steps"]["tolerance"])
    u = newton.equilibrium()
    seconds = time.perf_counter() - begin
    force = newton.contact.force(u)[model.dofs]
    found: dict[str, float] = {}
    curve = np.column_stack([np.arange(len(newton.residuals)), newton.residuals])
    if profile := figures.at_rest(problem, force):
        found, curve = profile
    elif problem.raw["figures"]["kind"] == "patch":
        pressure = problem.raw["loads"][0]["pressure"]
        off = model.stresses_along(u, problem.dim - 1) + pressure
        found = {"stress_error_max": float(np.abs(off).max() / pressure)}
    found["penetration_max"] = newton.touch.penetration
    iterations, seconds_there = newton.iterations, newton.contact_seconds
    outcome.write(
        out, "skfem", problem, found, u[model.dofs], force, curve, iterations, seconds, seconds_there,
        same_bits(out, problem, model, newton.contact),
    )  # fmt: skip


class Forces:
    """Internal and contact forces, for the time steps."""

    def __init__(self, model: Model, contact: SkfemContact) -> None:
        self.model, self.adapter = model, contact
        self.internal = model.internal

    def contact(self, u: np.ndarray) -> tuple[np.ndarray, Touch]:
        result = self.adapter.evaluate(u)
        sums = np.array([one.force for one in (*result.bodies, *result.obstacles)])
        return self.adapter.on_dofs(result.forces), Touch(result.energy, sums)


def in_motion(problem: Problem, out: Path) -> None:
    """Follows a case of dynamics."""
    model = Model(problem)
    forces = Forces(model, contact_of(problem, model))
    mass, velocity = model.mass(), np.zeros(problem.coords.shape)
    for body in problem.bodies:
        velocity[body.nodes] = body.velocity
    at_nodes = mass[model.dofs]

    def momentum(v: np.ndarray) -> np.ndarray:
        moving = at_nodes * v[model.dofs]
        return np.array([moving[body.nodes].sum(axis=0) for body in problem.bodies])

    motion = Motion(mass, model.on_dofs(problem.held), model.on_dofs(velocity), momentum=momentum)
    steps = problem.raw["time"]
    u, history = leapfrog.run(forces, motion, steps["step"], steps["end"], steps["contact_substeps"])
    masses = np.array([at_nodes[body.nodes, 0].sum() for body in problem.bodies])
    found = figures.motion(problem, history, masses)
    force = forces.contact(u)[0][model.dofs]
    about = [body.name for body in problem.bodies].index(problem.raw["figures"]["body"])
    curve = np.column_stack([history.time, np.linalg.norm(np.array(history.bodies)[:, about], axis=1)])
    count = len(history.time) - 1
    outcome.write(
        out, "skfem", problem, found, u[model.dofs], force, curve, count, history.seconds, history.contact_seconds,
        same_bits(out, problem, model, forces.adapter),
    )  # fmt: skip


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
