"""The programs of the README run, and say what they should."""

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAMS = [one.split("```")[0] for one in (Path(__file__).parents[1] / "README.md").read_text().split("```python\n")[1:]]


def lines(code):
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stdout + run.stderr
    return [[float(number) for number in line.replace("[", " ").replace("]", " ").split()] for line in run.stdout.splitlines()]


def test_the_first_force():
    ((_, up, _),) = lines(PROGRAMS[0])
    # A strip 0.7 wide and 0.01 deep: pressure k times depth makes 350, less at the rims, and pushes the upper block up.
    assert up == pytest.approx(350.0, rel=0.02)


def test_the_search_and_a_loop_of_getfem_s_own_find_the_same_forces():
    again = """
model.to_variables(np.zeros(model.nbdof()))
for push in (0.051, 0.052):
    model.set_variable("move_punch", [0, -push])
    step = find_equilibrium(contact, bricks=bricks)
    print(step.iterations, *(body.force[1] for body in step.result.bodies))
"""
    found = lines(PROGRAMS[1] + PROGRAMS[2] + again)
    assert len(found) == 7
    for number, (solves, *forces) in enumerate(found):
        assert solves <= (8 if 3 <= number < 5 else 3)
        # To and fro, to a residual of 1e-9.
        assert forces[1] == pytest.approx(-forces[0], rel=1e-6) and forces[1] > 1e3
    # The same load steps, the first from rest.
    for (_, *by_getfem), (_, *ours) in zip(found[3:5], found[5:]):
        assert by_getfem == pytest.approx(ours, rel=1e-6)
