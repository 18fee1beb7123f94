"""Hertz and a flat punch in GetFEM: by fmc_contact beside the reference host, and by GetFEM's own contact on the same mesh in the
same run. ``python compare.py FOLDER``; the status is 1 where fmc_contact is apart from the reference host.

With the path of the command in FMC, and benchmarks/agreement/src, benchmarks/agreement/drivers/getfem and benchmarks/peers on
PYTHONPATH."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
import own_contact
from fmc_agreement import outcome, reference
from fmc_agreement.approach import approach
from fmc_agreement.problem import Problem
from fmc_contact_getfem import GetfemContact, find_equilibrium
from model import Model

CASES = (("hertz", None, 1), ("punch", "depth", 4), ("punch", None, 4))
"""Case, variant, load steps."""

LARGEST = 1e-8
"""Largest difference of any node, by the largest value."""

MOST_TURNS = 6
"""Times that patches are found anew at an equilibrium, and it is sought with them."""


def solve(problem: Problem, steps: int) -> tuple[np.ndarray, np.ndarray, int]:
    """Displacement and contact force (nodes, dim) at the end, and the linear solves it took."""
    bodies = Model(problem)
    bodies.add_loads()
    contact = GetfemContact(bodies.model, bodies.variables, bodies=problem.body_of_cell, **problem.contact_options())
    problem.add_obstacles(contact.contact)
    # Bodies that nothing else holds begin where contact carries their load.
    load = bodies.load()
    start = approach(problem, np.zeros_like(load), load, lambda u: contact.force(bodies.state(u))[bodies.dofs])
    bodies.model.to_variables(bodies.state(start))
    options = {
        "held": bodies.dofs[problem.held],
        # That of the reference host.
        "tolerance": problem.raw["load_steps"]["tolerance"],
    }
    solves = 0
    for step in range(1, steps + 1):
        contact.keep_patches()
        found = find_equilibrium(contact, prescribed=bodies.state(problem.prescribed * step / steps), **options)
        solves += found.iterations
    # Found anew where bodies are now, patches of the law fiber are no longer those of the way.
    for _ in range(MOST_TURNS):
        contact.keep_patches()
        found = find_equilibrium(contact, **options)
        solves += found.iterations
        if found.iterations == 0:
            break
    return bodies.displacement(), contact.force()[bodies.dofs], solves


def distance(found: np.ndarray, expected: np.ndarray) -> float:
    """Of any node, by the largest value."""
    return float(np.abs(found - expected).max() / np.abs(expected).max())


def main(folder: str) -> int:
    apart = 0
    for case, variant, steps in CASES:
        place = Path(folder) / "-".join(filter(None, (case, variant)))
        problem = reference.run(place, case, variant)
        _, arrays = outcome.read(place, "reference")
        clock = time.process_time()
        displacement, force, solves = solve(problem, steps)
        seconds = time.process_time() - clock
        title = f"{case}, law {problem.raw['contact']['law']}"
        for name, found in (("displacement", displacement), ("force", force)):
            far = distance(found, arrays[name].reshape(found.shape))
            apart += not far <= LARGEST
            print(f"{title}: {name} {far:.1e} from the reference host, {solves} linear solves, {seconds:.2f} s")
        for name, own in own_contact.FORMULATIONS[problem.raw["figures"]["kind"]].items():
            clock = time.process_time()
            beside = own_contact.beside(problem, displacement, force, own(problem))
            print(f"{title}: GetFEM's own contact {name}: {beside}, {time.process_time() - clock:.2f} s", flush=True)
    return int(apart > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
