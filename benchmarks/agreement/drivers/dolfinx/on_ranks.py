"""An equilibrium by the search of the adapter, on any number of ranks."""

from __future__ import annotations

import time

import numpy as np
from fmc_agreement.problem import Problem
from fmc_agreement.solved import Solved, Step
from fmc_contact_dolfinx import ContactProblem, by_input_number, find_equilibrium
from model import Model
from timed import Timed

MOST_TURNS = 4
"""Times that the lines are turned into the contact normal of an equilibrium, and it is sought anew."""


def solved(problem: Problem, model: Model, contact: Timed) -> Solved:
    """In one load step, from rest."""
    found, clock = Solved(), time.process_time()
    residual = model.internal if model.load is None else model.internal - model.load
    bodies = ContactProblem(residual, model.u, model.bcs, contact)
    for _ in range(1 + MOST_TURNS):
        contact.keep_patches(model.u)
        step = find_equilibrium(bodies, tolerance=problem.raw["load_steps"]["tolerance"])
        found.iterations += step.iterations
        found.residuals += step.residuals
    found.seconds, found.contact_seconds = time.process_time() - clock, contact.seconds
    forces = np.asarray(step.result.forces)
    found.steps.append(Step(0, 1.0, by_input_number(model.u), forces, step.result.penetration))
    return found
