"""Newton's method in two levels on problems of docs/newton.md: outer solves of every load step, and the equilibrium."""

import sys
from pathlib import Path

import numpy as np
import pytest
from fmc_contact import find_equilibrium

sys.path.insert(0, str(Path(__file__).parents[1] / "newton"))

import problems
import study


def _load_steps(problem, two_level, stiffness=10):
    """Outer solves and displacements of every load step."""
    contact = problem.contact(stiffness, **study.LAWS["depth"])
    found, u = [], np.zeros(contact.size)

    def host(u):
        return problem.solid.forces(u), problem.solid.stiffness(u)

    for push in problem.pushes:
        prescribed = u.copy()
        prescribed[problem.moved] = push
        step = find_equilibrium(host, contact, u, problem.free, prescribed, two_level=two_level)
        u = step.x
        found.append((step.iterations, u))
    return found


@pytest.mark.parametrize("name", ["punch", "half-disc", "disc"])
@pytest.mark.parametrize("count", [16, 32])
def test_three_outer_solves_find_the_equilibrium_of_the_plain_method(name, count):
    problem = problems.ALL[name](count)
    plain, two = _load_steps(problem, False), _load_steps(problem, True)
    # What is left of the contact's nonlinearity is solved inside: the outer solves are those of the bodies alone.
    assert all(solves <= 3 for solves, _ in two), [solves for solves, _ in two]
    for (_, wanted), (_, found) in zip(plain, two):
        # Both stop at a residual of 1e-9 of the forces.
        assert np.abs(found - wanted).max() < 1e-8 * np.abs(wanted).max()


@pytest.mark.parametrize("stiffness", [1, 10, 100, 1000])
@pytest.mark.parametrize("overlap", [0.02, 0.1, 0.5])
def test_a_first_overlap_of_a_part_of_a_cell_ends_where_small_load_steps_do(stiffness, overlap):
    problem = problems.column(2)
    pushes = -overlap * problem.facet * np.arange(1, 11) / 10
    problem.pushes = pushes.tolist()
    *_, (_, wanted) = _load_steps(problem, False, stiffness)
    problem.pushes = pushes[-1:].tolist()
    ((solves, found),) = _load_steps(problem, True, stiffness)
    # Deep in a contact as soft as the bodies the condensed way does not lower the energy, and another one is taken.
    assert solves <= {(1, 0.1): 5, (1, 0.5): 18}.get((stiffness, overlap), 4)
    assert np.abs(found - wanted).max() < 1e-8 * np.abs(wanted).max()
