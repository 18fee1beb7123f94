"""The programs that measure ties, on small meshes: what the page promises of larger ones."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

TABLES = Path(__file__).resolve().parents[2] / "tables"
sys.path.insert(0, str(TABLES))
import tie_cost  # noqa: E402
import tie_frequencies as beams  # noqa: E402


def test_frequencies_of_a_tied_beam_converge():
    """By the square of the size of cells: from 8 to 16 edges the error falls by 3.9, where linear convergence would have 2."""
    answer = beams.one(16, beams.ElementQuad2)
    for solved in (beams.Beam.by_penalty, beams.Beam.by_equations):
        errors = [beams.worst(solved(beams.tied(across)), answer) for across in (8, 16)]
        assert errors[0] / errors[1] > 3.5 and errors[1] < 5e-3, errors
    # A tie of the same meshes on both sides is one body: the equations say that the nodes go together.
    same = beams.Beam([beams.part(8, beams.LINES[:2]), beams.part(8, beams.LINES[1:])])
    assert beams.worst(same.by_equations(), beams.one(8)) < 1e-8


def test_a_tie_is_cheaper_than_contact():
    """An evaluation takes 0.03 of one of contact or less; the bound is ten times that, as small times are noisy."""
    contact, tie = (tie_cost.measured(40, is_tied) for is_tied in (False, True))
    assert tie[1] < 0.3 * contact[1] and tie[2] < 0.3 * contact[2], (contact, tie)


def test_a_soft_tie_costs_few_iterations():
    """Of multigrid, by those of one block: 1.12 with E / h and with equations, and more with a stiffer penalty, unless the tie is solved
    directly."""
    pytest.importorskip("dolfinx")
    run = subprocess.run([sys.executable, str(TABLES / "tie_krylov.py"), "8"], capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stderr
    found = {name: [float(one) for one in numbers.split(", ")] for name, numbers in re.findall(r"^(.*): ([\d., ]+)$", run.stdout, re.M)}
    for name in ("penalty 1 E/h", "equations"):
        assert found[name][1] <= 1.3 and found[name][3] <= 1.3, run.stdout
    stiff = found["penalty 165 E/h"]
    # 54 and 13 iterations, where one block has 8.
    assert stiff[1] > 2 and stiff[4] <= 2 * found["one block"][0], run.stdout
