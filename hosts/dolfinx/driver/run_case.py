"""A case in dolfinx, on any number of ranks: ``mpirun -n N python run_case.py CASE [--variant NAME] --out FOLDER``."""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import Any

import numpy as np
import ufl
from dolfinx import fem
from fmc_agreement import bits, figures, leapfrog, outcome
from fmc_agreement.approach import approach, soft_stiffness
from fmc_agreement.leapfrog import Motion, Touch
from fmc_agreement.problem import Problem, from_json, load
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, by_input_number, set_by_input_number
from model import Model
from mpi4py import MPI

FAR = 0.1
"""Part of the load that a residual may be on the way."""

MOST_TURNS = 4
"""Times that the lines are turned into the contact normal of an equilibrium, and it is sought anew."""


class Timed:
    """A contact, and the seconds spent in it."""

    def __init__(self, contact: DolfinxContact) -> None:
        self.inner, self.seconds = contact, 0.0

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.inner, name)
        if not callable(found):
            return found

        def call(*arguments: Any, **options: Any) -> Any:
            clock = time.perf_counter()
            try:
                return found(*arguments, **options)
            finally:
                self.seconds += time.perf_counter() - clock

        return call


def contact_of(problem: Problem, model: Model) -> Timed:
    """The contact of the case, with its obstacles."""
    options = problem.contact_options()
    contact = DolfinxContact(model.space, bodies=model.body_of_cell, whole_mesh=True, **options)
    problem.add_obstacles(contact.contact)
    return Timed(contact)


def forces_at(model: Model, contact: Any) -> np.ndarray:
    """Contact forces (nodes, dim) at the model's displacement, in the case's numbering."""
    return contact.evaluate(model.u).forces


def same_bits(out: Path, problem: Problem, model: Model, contact: Any) -> dict[str, np.ndarray]:
    """Forces at the displacement of the reference host, where it has run."""
    if not (out / "reference.npz").exists():
        return {}
    contact.contact.release_patches()
    u, force = fem.Function(model.space), fem.Function(model.space)

    def at(displacement: np.ndarray) -> np.ndarray:
        set_by_input_number(u, displacement)
        owned = contact.force(u)
        force.x.array[: len(owned)] = owned
        return by_input_number(force)

    return bits.compared(out, problem, at)


def at_rest(problem: Problem, out: Path, host: str) -> None:
    """Solves a case of statics."""
    model = Model(problem)
    begin = time.perf_counter()
    contact = contact_of(problem, model)
    residual = model.internal if model.load is None else model.internal - model.load
    solver = ContactProblem(residual, model.u, model.bcs, contact)
    pull = fem.Function(model.space)
    if model.load is not None:
        pull.x.array[: model.displacement.owned * model.dim] = model.assembled(fem.form(model.load))
        pull.x.scatter_forward()
    load_at_nodes = by_input_number(pull)
    hard = contact.contact.options["stiffness"]
    soft = min(hard, soft_stiffness(problem))
    contact.contact.set_options(stiffness=soft)
    at = lambda u: contact.contact.evaluate(problem.coords + u).forces  # noqa: E731
    set_by_input_number(model.u, approach(problem, load_at_nodes, at))
    iterations, residuals = 0, []
    tolerance = problem.raw["load_steps"]["tolerance"]
    stages = [(soft, FAR), ((soft * hard) ** 0.5, FAR)] if soft < hard else []
    for stiffness, accuracy in [*stages, *[(hard, tolerance)] * (1 + MOST_TURNS)]:
        contact.contact.set_options(stiffness=stiffness)
        contact.keep_patches(model.u)
        # What a residual is compared with: the load, or the force of the contact where bodies are moved and not pushed.
        size = np.linalg.norm(load_at_nodes) or np.linalg.norm(contact.evaluate(model.u).forces)
        snes = solver.solver()
        snes.setTolerances(atol=accuracy * size, rtol=0.0, stol=0.0, max_it=100)
        snes.setConvergenceHistory()
        iterations += solver.solve(snes)
        residuals += (snes.getConvergenceHistory()[0] / size).tolist()
    seconds = time.perf_counter() - begin
    result = contact.evaluate(model.u)
    u, force = by_input_number(model.u), result.forces
    found: dict[str, float] = {}
    curve = np.column_stack([np.arange(len(residuals)), residuals])
    if profile := figures.at_rest(problem, force):
        found, curve = profile
    elif problem.raw["figures"]["kind"] == "patch":
        found["stress_error_max"] = largest_stress_error(model, problem.raw["loads"][0]["pressure"])
    found["penetration_max"] = result.penetration
    arrays = same_bits(out, problem, model, contact)
    if model.mesh.comm.rank == 0:
        outcome.write(
            out, host, problem, found, u, force, curve, iterations, seconds, contact.seconds, arrays,
            ranks=model.mesh.comm.size,
        )  # fmt: skip


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
    field, force = by_input_number(model.u), forces_at(model, contact)
    found = figures.motion(problem, history, masses)
    about = [body.name for body in problem.bodies].index(problem.raw["figures"]["body"])
    curve = np.column_stack([history.time, np.linalg.norm(np.array(history.bodies)[:, about], axis=1)])
    arrays = same_bits(out, problem, model, contact)
    if comm.rank == 0:
        outcome.write(
            out, host, problem, found, field, force, curve, len(history.time) - 1, history.seconds,
            history.contact_seconds, arrays, ranks=comm.size,
        )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description="A case in dolfinx")
    parser.add_argument("case")
    parser.add_argument("--variant")
    parser.add_argument("--override", action="append", default=[])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--host", default="dolfinx", help="name of the files")
    given = parser.parse_args()
    comm = MPI.COMM_WORLD
    raw = load(given.case, given.variant, tuple(given.override)).raw if comm.rank == 0 else None
    problem = from_json(comm.bcast(raw))
    (at_rest if problem.is_static else in_motion)(problem, given.out, given.host)


if __name__ == "__main__":
    main()
