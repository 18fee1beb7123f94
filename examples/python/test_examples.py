"""The programs run and check themselves; the notebook prints what is stored in it.

With UPDATE_NOTEBOOK=1 what it prints and draws is stored instead.
"""

import os
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

HERE = Path(__file__).parent
PROGRAMS = sorted(HERE.glob("*_blocks.py"))
NOTEBOOK = HERE.parent / "first_contact.ipynb"


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_a_program_runs_stays_short_and_agrees_with_its_closed_form(path):
    code = [line for line in path.read_text().splitlines() if line.strip() and not line.lstrip().startswith("#")]
    assert len(code) <= 41
    run = subprocess.run([sys.executable, path], capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stdout + run.stderr
    carried, expected = (float(run.stdout.split(name)[1].split(",")[0]) for name in ("carried", "closed form"))
    # Up to penetration by cell size, and strain: see the programs.
    assert carried == pytest.approx(expected, rel=1e-3) and expected > 0.1


def test_there_are_programs():
    assert len(PROGRAMS) == 2


def printed(notebook):
    """Text that the cells print, and the number of pictures that each draws."""
    cells = [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]
    texts = ["".join(one.get("text", "") for one in outputs) for outputs in cells]
    pictures = [sum("image/png" in one.get("data", {}) for one in outputs) for outputs in cells]
    return texts, pictures


def without_times(notebook):
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
    notebook.metadata = {"kernelspec": notebook.metadata["kernelspec"], "language_info": {"name": "python"}}
    return notebook


def test_the_notebook_prints_what_is_stored_in_it():
    stored = nbformat.read(NOTEBOOK, 4)
    run = nbformat.read(NOTEBOOK, 4)
    NotebookClient(run, timeout=300, kernel_name="python3").execute(cwd=HERE.parent)
    if os.environ.get("UPDATE_NOTEBOOK"):
        nbformat.write(without_times(run), NOTEBOOK)
        stored = run
    assert printed(run) == printed(stored)
    assert sum(printed(stored)[1]) == 3
