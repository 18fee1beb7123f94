"""Hertz and the flat punch, node for node, against the reference host and beside GetFEM's own contact. ``FMC`` names the command
``fmc``; ``make hosts`` sets it, and the paths of the programs."""

import os

import pytest

if "FMC" not in os.environ:
    pytest.skip("the environment variable FMC does not name the command fmc", allow_module_level=True)

import compare
import numpy as np
import own_contact
from fmc_agreement import figures, outcome, reference


@pytest.mark.parametrize("case, variant, steps", compare.CASES)
def test_displacement_and_force_are_those_of_the_reference_host(tmp_path, case, variant, steps):
    problem = reference.run(tmp_path, case, variant)
    _, theirs = outcome.read(tmp_path, "reference")
    displacement, force, _ = compare.solve(problem, steps)
    assert np.abs(theirs["force"]).max() > 0.0
    # Newton's method stops below 1e-10 of the forces.
    assert compare.distance(displacement, theirs["displacement"]) < 1e-8
    assert compare.distance(force, theirs["force"]) < 1e-8


def test_getfem_s_own_contact_has_the_pressure_of_hertz(tmp_path):
    """Without penetration; ours leaves 1e-5 of the radius, which costs some 1e-3 of the peak."""
    problem = reference.run(tmp_path, "hertz")
    _, force, _ = compare.solve(problem, 1)
    ours = figures.hertz(problem, force)[0]
    for own in own_contact.FORMULATIONS["hertz"].values():
        theirs = figures.hertz(problem, own(problem).force)[0]
        assert theirs["force"] == pytest.approx(ours["force"], rel=1e-9)
        assert theirs["peak_pressure"] == pytest.approx(ours["peak_pressure"], rel=2e-3)
        assert theirs["half_width"] == pytest.approx(ours["half_width"], rel=5e-3)
