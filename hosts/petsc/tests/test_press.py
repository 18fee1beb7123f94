"""Two blocks by SNES, of which no rank has the whole mesh: the equilibrium is that of a direct solver on any number of ranks, the
preconditioner is symmetric, and takes few iterations whatever the stiffness of contact."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from launch import LIMIT, printed


def run(ranks, *words):
    """Rows that the program prints, and what else it says."""
    said = printed(ranks, os.environ["FMC_PRESS"], *words)
    (row,) = [line for line in said.splitlines() if line.startswith("|")]
    names = ("unknowns", "ranks", "kind", "ratio", "touched", "steps", "krylov", "force", "seconds")
    return dict(zip(names, (word.strip() for word in row.split("|")[1:-1]))), said


@pytest.fixture(scope="module")
def force_alone():
    return float(run(1, *EXACTLY)[0]["force"])


def of_ranks(said):
    """Own cells, those received, facets near the contact, all facets, calls, bytes received, MB of every rank."""
    names = r"rank \d+: (\d+) own cells, (\d+) received, (\d+) of (\d+) facets, (\d+) calls, (\d+) bytes received, (\d+) MB"
    return [[int(word) for word in of_rank] for of_rank in re.findall(names, said)]


EXACTLY = ("-cells", "6", "-ratio", "100", "-check", "-ksp_rtol", "1e-10", "-snes_rtol", "1e-11")


@pytest.mark.parametrize("ranks", [1, 2, 4])
def test_it_is_the_equilibrium_of_a_direct_solver(ranks, force_alone):
    row, said = run(ranks, *EXACTLY)
    # Both end at a residual of 1e-11 of the first; contact is a hundred times as stiff as a cell.
    assert float(re.search(r"apart from the direct solution by (\S+)", said)[1]) < 1e-8
    asymmetry, energy = re.search(r"asymmetry (\S+), least energy (\S+)", said).groups()
    # Of a few hundred sums of products.
    assert float(asymmetry) < 1e-12 and float(energy) > 0
    assert float(row["force"]) == pytest.approx(force_alone, rel=1e-9)
    cells = [of_rank[:2] for of_rank in of_ranks(said)]
    whole = 6 * (6**3 + 4**3)
    assert len(cells) == ranks and sum(own for own, _ in cells) == whole
    assert all(own + received < whole for own, received in cells) or ranks == 1


def test_the_force_is_that_of_another_host():
    """The same blocks in FEniCSx, where contact is told through Python."""
    example = Path(__file__).parents[2] / "dolfinx" / "examples" / "large_blocks.py"
    said = subprocess.run([sys.executable, example, "6"], capture_output=True, text=True, timeout=LIMIT)
    assert said.returncode == 0, said.stdout + said.stderr
    rows = [[word.strip() for word in line.split("|")[1:-1]] for line in said.stdout.splitlines()]
    (force,) = [float(row[7]) for row in rows if row[3] == "100"]
    # There the residual ends at 1e-8 of the first, 1e-6 of the force.
    assert float(run(1, *EXACTLY)[0]["force"]) == pytest.approx(force, rel=1e-5)


def test_few_iterations_whatever_the_stiffness_of_contact():
    counts = {(n, k): int(run(n, "-cells", "8", "-ratio", k)[0]["krylov"]) for n in (1, 4) for k in ("1", "1000")}
    # Measured 9 and 14 on one rank; on four, of two or three layers of nodes each, 12 and 15: sweeps stay on a rank.
    assert counts[1, "1"] <= 12 and counts[1, "1000"] <= 18
    assert all(counts[4, k] <= counts[1, k] + 4 for k in ("1", "1000"))
    # Without the direct solve on the contact some fifty.
    assert int(run(1, "-cells", "8", "-ratio", "1000", "-plain")[0]["krylov"]) > 2 * counts[1, "1000"]


def test_a_rank_has_its_part_and_what_is_near_the_contact():
    """A small block on a large one, 128 817 unknowns; one step of Newton's method, with loose tolerances, takes the memory of all."""
    words = ("-cells", "34", "-width", "0.09", "-upper", "3", "-ratio", "1", "-snes_rtol", "0.9", "-ksp_rtol", "0.5")
    (alone,), four = (of_ranks(run(count, *words)[1]) for count in (1, 4))
    for own, received, near, facets, calls, received_bytes, megabytes in four:
        print(f"{own} + {received} cells, {near} of {facets} facets, {calls} calls, {received_bytes} B, {megabytes} MB")
        assert facets == 12 * (34**2 + 3**2) and 0 < near <= 0.05 * facets
        assert own + received < 0.35 * 6 * (34**3 + 3**3)
        # A rank is told of faces between ranks by its neighbours alone: 0.33 to 0.43 MB, of which one rank alone has 0.23.
        assert calls < 100 and received_bytes < 40 * facets
        # Of the process: some 60 MB before there is a mesh, and PETSc's matrices; tests/memory_in_parts.rs has the library's alone.
        assert megabytes <= 0.5 * alone[-1]
