"""A penetration tolerance on a problem of docs/newton.md, over load steps."""

import sys
from pathlib import Path

import numpy as np
from fmc_contact import find_equilibrium

sys.path.insert(0, str(Path(__file__).parents[1] / "newton"))

import problems


def test_a_disc_on_a_block_over_load_steps():
    """Two bodies: one of them is moved out, forces balance, and the next load step begins with what the last one has found."""
    problem = problems.disc(64)
    counts, moved_out, updates = {}, set(), 0
    for penetration in (None, 1e-6):
        contact, u, counts[penetration] = problem.contact(10.0), np.zeros(problem.solid.offsets[-1]), []
        for push in problem.pushes[3:]:
            prescribed = u.copy()
            prescribed[problem.moved] = push
            host = lambda u: (problem.solid.forces(u), problem.solid.stiffness(u))
            found = find_equilibrium(host, contact, u, problem.free, prescribed, penetration=penetration)
            u = found.x
            counts[penetration].append(found.iterations)
            if penetration is None:
                continue
            assert found.penetration <= penetration
            moved_out |= set(contact.contact.multipliers.values["body"].tolist())
            updates += found.updates
    print(counts, updates)
    assert updates > 0 and sum(counts[1e-6]) <= 2 * sum(counts[None]) and len(moved_out) <= 1
    forces = found.reactions.reshape(-1, 2).sum(axis=0)
    assert np.abs(forces).max() < 1e-6 * np.abs(found.reactions).sum()
