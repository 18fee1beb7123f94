"""Bodies that are not condensed, on the five problems of docs/newton.md, at the coarser of their meshes."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "newton"))

import problems
import study

CASES = [(name, count) for name in ("punch", "half-disc", "press fit", "disc") for count in (16, 32)]


@pytest.mark.parametrize(("name", "count"), [*CASES, ("punch Hex8", 8)])
def test_every_load_step_takes_at_most_eight_iterations(name, count):
    problem = problems.ALL[name](count)
    counts, pressed = study.load_steps(problem, problem.contact(10, **study.LAWS["depth"]), "whole")
    # But the first one of a punch of 32 cells, which presses sharp corners in from a touch.
    most = [10 if (name, count) == ("punch", 32) else 8] + [8] * (len(problem.pushes) - 1)
    assert all(iterations <= bound for iterations, bound in zip(counts, most, strict=True)), counts
    assert (pressed < 0.0) == (name != "press fit")


def test_the_bodies_of_the_problems_have_the_derivative_of_their_forces():
    import numpy as np

    for name, count in (("punch", 8), ("punch Hex8", 8)):
        solid = problems.ALL[name](count).solid
        size = solid.offsets[-1]
        random = np.random.default_rng(1)
        u, way = 2e-3 * random.standard_normal(size), random.standard_normal(size)
        difference = (solid.forces(u + 1e-7 * way) - solid.forces(u - 1e-7 * way)) / 2e-7
        assert np.abs(solid.stiffness(u) @ way - difference).max() < 1e-7 * np.abs(difference).max()
