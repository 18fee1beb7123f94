"""Tables of the pages have the figures that their programs print."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*(?:e-?\d+)?")
TABLES = [
    ("block_on_block.py", "", "depth.md"),
    ("rings.py", "fit", "depth.md"),
    ("rings.py", "pin", "depth.md"),
    ("rings.py", "coarse", "depth.md"),
    ("viscosity.py", "", "interfaces.md"),
    ("tie_frequencies.py", "", "interfaces.md"),
]


def shown(page, command):
    """Numbers of the table that follows a command on a page, but for the first cell of each row."""
    after = (ROOT / "docs" / page).read_text(encoding="utf-8").split(f"`{command}`", 1)[1]
    rows = re.search(r"(?:^\|.*\n)+", after, flags=re.M)[0].splitlines()[2:]
    text = " ".join(cell for row in rows for cell in row.split("|")[2:]).replace("−", "-").replace("+ ", "").replace("\u00a0", "")
    return NUMBER.findall(text)


@pytest.mark.parametrize(("program", "part", "page"), TABLES)
def test_a_page_shows_what_its_program_prints(program, part, page):
    words = [f"benchmarks/tables/{program}", *([part] if part else [])]
    run = subprocess.run([sys.executable, *words], capture_output=True, text=True, timeout=300, cwd=ROOT)
    assert run.returncode == 0, run.stderr
    printed = iter([float(one) for one in NUMBER.findall(run.stdout)])
    numbers = shown(page, " ".join(["python", *words]))
    assert len(numbers) > 5
    for one in numbers:
        # In the order of the program. One unit of the last digit that is shown; processors may round differently.
        digits = len(one.split("e")[0].split(".")[1]) if "." in one else 0
        unit = 10.0 ** -digits * (10.0 ** int(one.split("e")[1]) if "e" in one else 1.0)
        assert any(abs(float(one) - value) <= max(unit, 0.04 * abs(value) if float(one) > 10 else 0.0) for value in printed), one
