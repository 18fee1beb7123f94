"""A case in dolfinx: ``python run_case.py CASE [--variant NAME] [--override KEY=VALUE ...] --out FOLDER``. Motions run on
any number of ranks, and so do equilibria with ``--on-ranks``: ``mpirun -n N python run_case.py ...``."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np
import on_ranks
import ufl
from dolfinx import fem
from fmc_agreement import bits, leapfrog, outcome, parts
from fmc_agreement.equilibrium import Equilibrium
from fmc_agreement.leapfrog import Motion, Touch
from fmc_agreement.path import Path as LoadPath
from fmc_agreement.problem import Problem, from_json, load
from fmc_contact_dolfinx import DolfinxContact, by_input_number, set_by_input_number
from in_case import Part, Touching
from model import Model
from mpi4py import MPI
from timed import Timed


def contact_of(problem: Problem, model: Model) -> Timed:
    """The contact of the case, with its obstacles."""
    options = problem.contact_options()
    contact = DolfinxContact(model.space, bodies=model.body_of_cell, whole_mesh=True, **options)
    problem.add_obstacles(contact.contact)
    return Timed(contact)


def same_bits(out: Path, problem: Problem, model: Model, contact: Any) -> dict[str, np.ndarray]:
    """Forces at the displacement of the reference host, where it has run."""
    contact.contact.patches.release()
    u, force = fem.Function(model.space), fem.Function(model.space)

    def at(displacement: np.ndarray) -> np.ndarray:
        set_by_input_number(u, displacement)
        owned = contact.force(u)
        force.x.array[: len(owned)] = owned
        return by_input_number(force)

    return bits.compared(out, problem, at)


def at_rest(problem: Problem, out: Path, host: str, is_on_ranks: bool) -> None:
    """Solves a case of statics."""
    found: dict[str, float] = {}
    if is_on_ranks:
        if problem.has_friction:
            raise ValueError(f"'{problem.name}' has friction, whose steps are not made on ranks")
        model = Model(problem)
        contact = contact_of(problem, model)
        solved = on_ranks.solved(problem, model, contact)
        models, arrays = [model], same_bits(out, problem, model, contact)
    else:
        problems = parts.split(problem)
        bodies = [Part(Model(one)) for one in problems]
        touching, pull = Touching(problem, bodies), np.concatenate([part.load() for part in bodies])
        elastic = parts.Elastic(bodies, problems)
        solved = LoadPath(Equilibrium(problem, elastic, touching, pull)).follow()
        bits.begun_anew(problem, touching)
        models, arrays = [part.model for part in bodies], bits.compared(out, problem, touching.force)
        for part, u in elastic.each(solved.steps[-1].displacement):
            part.take(u)
    if problem.raw["figures"]["kind"] == "patch":
        pressure = problem.raw["loads"][0]["pressure"]
        found = {"stress_error_max": max(largest_stress_error(model, pressure) for model in models)}
    if MPI.COMM_WORLD.rank == 0:
        outcome.of_equilibrium(out, host, problem, solved, found, arrays, ranks=MPI.COMM_WORLD.size)


def largest_stress_error(model: Model, pressure: float) -> float:
    """Largest distance of the mean stress of a cell along the last axis from -pressure, by it."""
    axis = model.dim - 1
    gradient = ufl.grad(model.u)
    stress = model.of_cells("lame") * ufl.tr(gradient) + 2.0 * model.of_cells("shear") * gradient[axis, axis]
    test = ufl.TestFunction(model._constants())
    sums, volumes = (model.assembled(fem.form(one * test * model.dx)) for one in (stress, 1.0))
    largest = np.abs(sums / volumes + pressure).max() / pressure if len(sums) else 0.0
    return float(model.mesh.comm.allreduce(largest, MPI.MAX))


class Forces:
    """Internal and contact forces, for the time steps."""

    def __init__(self, model: Model, contact: Any) -> None:
        self.model, self.adapter = model, contact
        self.forms = fem.form(model.internal), fem.form(model.energy)

    def _take(self, u: np.ndarray) -> None:
        self.model.u.x.array[: len(u)] = u
        self.model.u.x.scatter_forward()

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        self._take(u)
        return self.model.assembled(self.forms[0]), fem.assemble_scalar(self.forms[1])

    def contact(self, u: np.ndarray) -> tuple[np.ndarray, Touch]:
        result = self.adapter.evaluate(u)
        pushed = np.zeros_like(u)
        self.adapter.add_forces(pushed, result)
        sums = np.array([one.force for one in (*result.bodies, *result.obstacles)])
        return pushed, Touch(result.energy, sums)


def in_motion(problem: Problem, out: Path, host: str) -> None:
    """Follows a case of dynamics."""
    model = Model(problem)
    comm, dim = model.mesh.comm, model.dim
    contact = contact_of(problem, model)
    forces = Forces(model, contact)
    owned = model.displacement.owned * dim
    density = model.of_cells("density")
    mass = model.assembled(fem.form(ufl.inner(ufl.as_vector([density] * dim), model.v) * model.dx))
    at_nodes = np.zeros(problem.coords.shape)
    for body in problem.bodies:
        at_nodes[body.nodes] = body.velocity
    start, fixed, body_of = (fem.Function(model.space) for _ in range(3))
    set_by_input_number(start, at_nodes)
    set_by_input_number(fixed, problem.held.astype(float))
    of_nodes = np.zeros(problem.coords.shape)
    for number, body in enumerate(problem.bodies):
        of_nodes[body.nodes] = number
    set_by_input_number(body_of, of_nodes)
    number = body_of.x.array[:owned:dim].round().astype(int)

    def momentum(v: np.ndarray) -> np.ndarray:
        moving = (mass * v).reshape(-1, dim)
        sums = np.array([moving[number == k].sum(axis=0) for k in range(len(problem.bodies))])
        return comm.allreduce(sums)

    motion = Motion(mass, fixed.x.array[:owned] > 0.5, start.x.array[:owned].copy(), comm.allreduce, momentum)
    steps = problem.raw["time"]
    u, history = leapfrog.run(forces, motion, steps["step"], steps["end"], steps["contact_substeps"])
    masses = momentum(np.ones(owned))[:, 0]
    forces._take(u)
    field, force = by_input_number(model.u), contact.evaluate(model.u).forces
    arrays = same_bits(out, problem, model, contact)
    if comm.rank == 0:
        outcome.of_motion(out, host, problem, history, masses, field, force, arrays, ranks=comm.size)


def main() -> None:
    parser = argparse.ArgumentParser(description="A case in dolfinx")
    parser.add_argument("case")
    parser.add_argument("--variant")
    parser.add_argument("--override", action="append", default=[])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--host", default="dolfinx", help="name of the files")
    parser.add_argument("--on-ranks", action="store_true", help="an equilibrium on any number of ranks")
    given = parser.parse_args()
    comm = MPI.COMM_WORLD
    raw = load(given.case, given.variant, tuple(given.override)).raw if comm.rank == 0 else None
    problem = from_json(comm.bcast(raw))
    if problem.is_static:
        at_rest(problem, given.out, given.host, given.on_ranks)
    else:
        in_motion(problem, given.out, given.host)


if __name__ == "__main__":
    main()
