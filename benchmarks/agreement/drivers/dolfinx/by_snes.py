"""An equilibrium by PETSc's SNES, on any number of ranks: loose bodies that loads press."""

from __future__ import annotations

import time

import numpy as np
from dolfinx import fem
from fmc_agreement.approach import approach, soft_stiffness
from fmc_agreement.problem import Problem
from fmc_agreement.solved import Solved, Step
from fmc_contact_dolfinx import ContactProblem, by_input_number, set_by_input_number
from model import Model
from timed import Timed

FAR = 0.1
"""Part of the load that a residual may be on the way."""

MOST_TURNS = 4
"""Times that the lines are turned into the contact normal of an equilibrium, and it is sought anew."""


def solved(problem: Problem, model: Model, contact: Timed) -> Solved:
    """First on a soft contact, on which loose bodies settle, then on the real one."""
    found, clock = Solved(), time.process_time()
    residual = model.internal if model.load is None else model.internal - model.load
    solver = ContactProblem(residual, model.u, model.bcs, contact)
    pull = fem.Function(model.space)
    if model.load is not None:
        pull.x.array[: model.displacement.owned * model.dim] = model.assembled(fem.form(model.load))
        pull.x.scatter_forward()
    load = by_input_number(pull)
    hard = contact.contact.options["stiffness"]
    soft = min(hard, soft_stiffness(problem))
    contact.contact.set_options(stiffness=soft)
    at = lambda u: contact.contact.evaluate(problem.coords + u).forces
    set_by_input_number(model.u, approach(problem, np.where(problem.held, problem.prescribed, 0.0), load, at))
    tolerance, size = problem.raw["load_steps"]["tolerance"], np.linalg.norm(load)
    stages = [(soft, FAR), ((soft * hard) ** 0.5, FAR)] if soft < hard else []
    for stiffness, accuracy in [*stages, *[(hard, tolerance)] * (1 + MOST_TURNS)]:
        contact.contact.set_options(stiffness=stiffness)
        contact.keep_patches(model.u)
        snes = solver.solver()
        snes.setTolerances(atol=accuracy * size, rtol=0.0, stol=0.0, max_it=100)
        snes.setConvergenceHistory()
        found.iterations += solver.solve(snes)
        found.residuals += (snes.getConvergenceHistory()[0] / size).tolist()
    found.seconds, found.contact_seconds = time.process_time() - clock, contact.seconds
    result = contact.evaluate(model.u)
    found.steps.append(Step(0, 1.0, by_input_number(model.u), result.forces, result.penetration))
    return found
