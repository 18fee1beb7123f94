"""The examples run, check themselves, and stay short."""

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parent.parent / "examples").glob("*.py"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs_and_has_at_most_forty_lines(path):
    assert len(path.read_text().splitlines()) <= 40
    run = subprocess.run([sys.executable, path], capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stdout + run.stderr


def test_there_are_examples():
    assert len(EXAMPLES) >= 2


def test_the_first_force_of_the_pages_runs_in_ten_lines():
    root = Path(__file__).parents[3]
    texts = [path.read_text() for path in (root / "docs" / "first-contact.md", root / "hosts" / "skfem" / "README.md")]
    programs = [[one.split("```")[0] for one in text.split("```python\n")[1:]] for text in texts]
    (code,) = [one for one in programs[0] if "fmc_contact_skfem" in one]
    assert code == programs[1][0]
    # With the line that installs.
    assert len([line for line in code.splitlines() if line.strip()]) + 1 <= 10
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    # A strip 0.7 wide and 0.01 deep: pressure k times depth makes 350, less at the rims, and pushes the upper block up.
    force = float(run.stdout.replace("[", " ").replace("]", " ").split()[1])
    assert force == pytest.approx(350.0, rel=0.02)


def test_the_load_steps_of_the_readme_take_at_most_eight_iterations():
    text = (Path(__file__).parents[1] / "README.md").read_text()
    code = text.split("```python\n")[2].split("```")[0]
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    steps = [[float(number) for number in line.split()] for line in run.stdout.splitlines()]
    assert len(steps) == 3 and all(iterations <= 8 for iterations, *_ in steps)
    # What the top is pressed with, the bottom carries.
    assert all(pressed == pytest.approx(-carried, rel=1e-6) and carried > 1e3 for _, pressed, carried in steps)
