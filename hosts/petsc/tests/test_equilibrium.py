"""A block that nothing but a floor holds, by the library's search in PETSc: no stiffness is given, and ranks do not matter."""

import os

import numpy as np
import pytest
from launch import printed

CELLS = 4
GAP, PULL = 0.1, -1e-3


def table(stiffness):
    """A unit square of triangles above a floor, its top pulled down, one node held sideways."""
    at = np.linspace(0.0, 1.0, CELLS + 1)
    nodes = [(x, y + GAP) for y in at for x in at]
    row = CELLS + 1
    corners = [j * row + i for j in range(CELLS) for i in range(CELLS)]
    triangles = [t for a in corners for t in ((a, a + 1, a + row + 1), (a, a + row + 1, a + row))]
    top = [CELLS * row + i for i in range(CELLS)]
    tables = {
        "nodes": nodes,
        "triangles": triangles,
        "held": [(row * (CELLS // 2) + CELLS // 2, 0, 0.0)],
        "faces": [(n + 1, n, 0.0, PULL) for n in top],
        "materials": [(0.58, 0.38)],
        "contact": [(stiffness, 1e-10)],
        "half_spaces": [(0.0, 0.0, 0.0, 1.0)],
    }
    lines = ["dimension 2"]
    for name, rows in tables.items():
        lines += [f"{name} {len(rows)}", *(" ".join(map(str, row)) for row in rows)]
    return "\n".join(lines) + "\n"


def solve(folder, ranks, stiffness):
    """Linear solves, displacements and contact forces of nodes."""
    problem, solution = folder / "problem.txt", folder / f"solution-{ranks}.txt"
    problem.write_text(table(stiffness))
    said = printed(ranks, os.environ["FMC_PETSC"], problem, solution)
    rows = np.loadtxt(solution, skiprows=1)
    return int(said.split()[0]), rows[:, :2], rows[:, 2:]


@pytest.mark.parametrize("stiffness", [0, 100], ids=["found", "given"])
def test_the_floor_bears_a_block_on_any_number_of_ranks(stiffness, tmp_path):
    solves, alone, force = solve(tmp_path, 1, stiffness)
    assert solves <= 12
    assert force[:, 1].sum() == pytest.approx(-PULL, rel=1e-9)
    assert alone[: CELLS + 1, 1] == pytest.approx(-GAP, abs=1e-4)
    for ranks in (2, 3):
        _, displacement, _ = solve(tmp_path, ranks, stiffness)
        assert np.abs(displacement - alone).max() < 1e-10 * np.abs(alone).max()
