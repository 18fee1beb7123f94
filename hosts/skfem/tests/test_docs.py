"""What docs/second-order.md shows of scikit-fem runs after the lines that a reader has to have already; other pages as they stand."""

import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[3] / "bindings/python/tests"))
from printed import differs, programs

PAGE = Path(__file__).parents[3] / "docs" / "second-order.md"

BEFORE = """
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementTriP3, ElementVector, MeshTri
import numpy as np
mesh = MeshTri().refined(1)
u = np.zeros(Basis(mesh, ElementVector(ElementTriP3())).N)
"""

AFTER = """
size = Basis(mesh, ElementVector(ElementTriP3())).N
assert contact.force(np.zeros(size)).shape == (size,) and contact.tangent(np.zeros(size)).shape == (size, size)
assert contact.nodes(np.zeros(size)).shape[1] == 2
"""


def test_elements_of_third_order():
    pieces = re.findall(r"```python\n(.*?)```", PAGE.read_text(), flags=re.S)
    (piece,) = [one for one in pieces if "SkfemContact" in one]
    run = subprocess.run([sys.executable, "-c", BEFORE + piece + AFTER], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr


def test_problems_that_start_by_themselves():
    pieces, shown = zip(*programs(PAGE.with_name("starts.md")))
    run = subprocess.run([sys.executable, "-c", "\n".join(pieces)], capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stderr
    assert not differs("".join(shown), run.stdout)
    touching, stack, stands, falls, removed, pressure = run.stdout.splitlines()
    # In the stack one solve finds where blocks with friction first touch.
    for told, most in ((touching, 6), (stack, 7)):
        solves, force = told.split()
        assert int(solves) <= most and abs(float(force) - 1) < 1e-9
    assert "stands" in stands and "stands" not in falls
    # Facets of a circle of 96: the overlap of their middles is by 5e-4 smaller or larger than 0.002.
    assert abs(float(removed) - 0.002) < 1e-4
    assert abs(float(pressure) / 515 - 1) < 0.03


def test_heat():
    ((program, shown),) = programs(PAGE.with_name("heat.md"))
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    assert shown and not differs(shown, run.stdout)
    heat, jump = (float(number) for number in re.findall(r"\d+\.\d+", run.stdout))
    # Blocks of length 1 between walls: pressure from the mean temperature, conductance from the pressure, heat from all in series.
    flux = 50.0
    for _ in range(50):
        warm = flux / (2 * 2) + 100 - flux / 2
        conductance = 1 + 2 * 1e3 * (1e-3 + 1e-4 * warm) / 2
        flux = 100 / (1 / 2 + 1 / conductance + 1)
    # The figures of the page, and the penetration that is left: 1e-3 of the pressure.
    assert abs(heat / flux - 1) < 1e-4 and abs(jump * conductance / flux - 1) < 1e-3
    assert abs(flux - 62.663) < 1e-3 and abs(flux / conductance - 6.006) < 1e-3


def test_wear():
    ((program, shown),) = programs(PAGE.with_name("wear.md"))
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    assert shown and not differs(shown, run.stdout)
    mean, least, most, volume = (float(number) for number in re.findall(r"\d+\.\d+", run.stdout))
    # K p s of 1000 cycles of 2 mm; the pressure of an elastic pin is even to 2 permille.
    assert abs(mean / (1e-8 * 100 * 2000) - 1) < 1e-3 and most - least < 4e-3 * mean and abs(volume - 1) < 1e-3


def test_hertz():
    # The last piece draws: it runs in the notebook.
    *pieces, (drawing, _) = programs(PAGE.with_name("tutorial-hertz.md"))
    program, shown = ("\n".join(texts) for texts in zip(*pieces))
    assert "matplotlib" in drawing and "matplotlib" not in program
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    assert shown and not differs(shown, run.stdout)
    solves, force, half_width, largest, difference = (float(number) for number in re.findall(r"\d+\.?\d*(?:e-?\d+)?", run.stdout.replace("p0", "")))
    # The figures of the table.
    assert solves == 2 and abs(force - 0.004282) < 1e-6 and abs(half_width / 0.005 - 14.1) < 0.05
    assert abs(largest - 1.010) < 1e-3 and abs(difference - 0.010) < 1e-3
