"""Multigrid with the contact solved directly: symmetric, positive, few iterations whatever the stiffness, on any number of ranks."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import ufl
from dolfinx import fem
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, FilteredMultigrid, find_equilibrium
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from parallel import elastic, pressed
from petsc4py import PETSc
from scenes import COMM, blocks

HERE = Path(__file__).parent.parent


@pytest.fixture
def problem():
    x, cells = blocks("tetra", 5, 4)
    space = vector_space(mesh_from_cells(COMM, x, cells, "tetra"), 1)
    contact = DolfinxContact(space, stiffness=1e6, law="fiber")
    u = fem.Function(space)
    contact.keep_patches(u)
    return ContactProblem(elastic(u, ufl.TestFunction(space)), u, pressed(space, -0.01), contact)


def test_it_finds_what_a_direct_solver_finds(problem):
    find_equilibrium(problem)
    direct = problem.u.x.array.copy()
    problem.u.x.array[:] = 0.0
    find_equilibrium(problem, problem.iterative_solver(rtol=1e-10))
    # Both stop at a residual of 1e-9 of the forces; contact is some thousand times as stiff as a cell.
    assert np.abs(problem.u.x.array - direct).max() < 1e-8 * np.abs(direct).max()
    assert len(problem.touched) > 10


def test_it_is_symmetric_and_positive(problem):
    matrix, contact, u = problem.bodies(), problem.contact, problem.u
    tangent = contact.tangent(u, semidefinite=True)
    contact.add_tangent(matrix, tangent, problem.bcs)
    pc = PETSc.PC().create(COMM)
    pc.setOperators(matrix)
    touched = contact.touched(tangent, problem.bcs)
    multigrid = FilteredMultigrid(u.function_space, lambda: touched, problem.bodies)
    multigrid.attach(pc)
    pc.setUp()
    assert multigrid.count == len(touched)
    random = np.random.default_rng(5)
    vectors = []
    for _ in range(2):
        v, mv = matrix.createVecs()
        v.setArray(random.standard_normal(v.getLocalSize()))
        pc.apply(v, mv)
        vectors.append((v, mv))
    (v, mv), (w, mw) = vectors
    # The two cycles and the direct solve are each symmetric to rounding.
    assert v.dot(mw) == pytest.approx(w.dot(mv), abs=1e-9 * np.sqrt(v.dot(mv) * w.dot(mw)))
    assert v.dot(mv) > 0 and w.dot(mw) > 0


def test_levels_of_the_bodies_are_those_of_gamg(problem):
    with pytest.raises(ValueError, match="gamg, not from hypre"):
        FilteredMultigrid(problem.u.function_space, lambda: problem.touched, problem.bodies, cycle="hypre")


def counts(ranks, *words):
    """Krylov iterations that ``large_blocks.py`` prints, by k h / E."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
    command = ["timeout", "300", "mpirun", "--oversubscribe", "-n", str(ranks), sys.executable]
    command += [str(HERE / "examples" / "large_blocks.py"), *words]
    run = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert run.returncode == 0, run.stdout + run.stderr
    rows = [[word.strip() for word in line.split("|")[1:-1]] for line in run.stdout.splitlines()]
    return {int(row[3]): int(row[6]) for row in rows}


def test_iterations_do_not_grow_with_the_stiffness_of_contact():
    one, two, plain = counts(1, "8"), counts(2, "8"), counts(1, "8", "--plain")
    # Measured 9 to 16, and 13 to 51 without the direct solve; 21 to 30 with levels of the matrix with contact.
    assert max(one.values()) <= 20 and max(two.values()) <= 1.2 * max(one.values()) + 1
    assert plain[1000] > 2 * one[1000]
