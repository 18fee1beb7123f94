"""The programs run and check themselves; a notebook prints and draws what is stored in it."""

import json
import subprocess
import sys
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import pytest

HERE = Path(__file__).parent
PROGRAMS = sorted(HERE.glob("*_blocks.py"))
sys.dont_write_bytecode = True
loader = SourceFileLoader("made", str(HERE.parents[1] / ".ci/notebooks"))
made = module_from_spec(spec_from_loader("made", loader))
loader.exec_module(made)


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


@pytest.mark.parametrize(("name", "page"), made.pages().items(), ids=lambda one: one if isinstance(one, str) else "")
def test_a_notebook_prints_and_draws_as_is_stored(name, page):
    results = made.run(made.cells(name, page.read_text(encoding="utf-8")))
    stored = json.loads((made.FOLDER / f"{name}.ipynb").read_text(encoding="utf-8"))["cells"]
    stored = [made.read(cell["outputs"]) for cell in stored if cell["cell_type"] == "code"]
    assert [len(pictures) for _, pictures in results] == [len(pictures) for _, pictures in stored]
    for (text, _), (kept, _) in zip(results, stored):
        assert not made.differs(kept, text) if kept else not text


def test_every_tutorial_in_python_has_a_notebook():
    tutorials = {page.stem for page in made.DOCS.glob("tutorial-*.md") if "```python\n" in page.read_text(encoding="utf-8")}
    assert tutorials | {"first-contact", "starts"} == set(made.pages())


def test_a_page_becomes_cells():
    page = (
        "# Title\n\nA [notebook](../examples/notebooks/x.ipynb).\n\n```math\na\n```\n\n```python\nimport matplotlib\n```\n\n```output\n1\n```\n\n"
        f"![Drawn](x.svg)\n\nSee [there](y.md#z).\n\n## C\n\n{made.LEFT_OUT}\n\n```c\nint x;\n```\n\n## End\n\n![Kept](k.svg)\n"
    )
    title, program, text = made.cells("x", page)
    assert "docs/x.md" in title[1] and "pip install matplotlib" in title[1] and "$$\na\n$$" in title[1]
    assert program == ["code", "import matplotlib", "1\n", "x.svg"]
    assert text[1] == "See [there](../../docs/y.md#z).\n\n## End\n\n![Kept](../../docs/k.svg)"
