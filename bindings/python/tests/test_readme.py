"""The programs of the README run as they stand there."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

README = (Path(__file__).parents[1] / "README.md").read_text()
SHELL = re.findall(r"```sh\n(.*?)```", README, flags=re.S)
PROGRAMS = re.findall(r"```python\n(.*?)```", README, flags=re.S)


def printed(program):
    return subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True).stdout


def test_first_force_in_ten_lines():
    lines = [line for line in (SHELL[0] + PROGRAMS[0]).splitlines() if line]
    assert lines[0].startswith("pip install") and len(lines) <= 10
    output = printed(PROGRAMS[0])
    numbers = [float(number) for number in re.findall(r"-?\d+\.?\d*(?:e[-+]\d+)?", output)]
    # Eight nodes, the overlap, the force on the second square: k 0.01 over the height 0.8, less at the corners.
    assert len(numbers) == 19
    assert sum(numbers[0:8:2]) == pytest.approx(-80, rel=0.02) and sum(numbers[8:16:2]) == pytest.approx(80, rel=0.02)
    assert numbers[16] == pytest.approx(0.008) and numbers[17] == pytest.approx(80, rel=0.02)


def test_a_step_of_a_solver():
    energy, *_ = printed(PROGRAMS[1]).split()
    # k / 2 L^2 over the length 1, with L = 0.1.
    assert float(energy) == pytest.approx(5.0)


def test_equilibrium_in_load_steps():
    lines = [[float(number) for number in line.split()] for line in printed(PROGRAMS[2]).splitlines()]
    assert len(lines) == 3 and all(iterations <= 8 for iterations, *_ in lines)
    for push, (_, force, penetration) in zip((0.1, 0.12, 0.16), lines):
        # 1e4 between the mean of the free nodes and that of the held ones, then k: springs in series. The walls sunk in
        # are pressed sideways, by a part of the order of the penetration.
        in_series = (push - 0.1) / (1 / 1e4 + 1 / 1e5)
        assert force == pytest.approx(-in_series, rel=0.02, abs=1e-6)
        assert penetration == pytest.approx(in_series / 1e5, rel=0.02, abs=1e-9)
