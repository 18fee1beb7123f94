"""scikit-fem against the reference host, node for node. ``FMC`` names its command; ``make hosts`` sets it."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

if "FMC" not in os.environ:
    pytest.skip("the environment variable FMC does not name the command fmc", allow_module_level=True)

from fmc_agreement import outcome, reference

DRIVER = Path(__file__).parents[1] / "drivers" / "skfem" / "run_case.py"
TIGHT = "load_steps.tolerance=1e-12"
NARROW = "bodies.upper.mesh.max=[0.9, 1.0]"
"""Walls that are not flush, see ``test_hosts``."""


@pytest.mark.parametrize(
    "case, variant, changes",
    [
        ("hertz", None, (TIGHT, "bodies.disc.mesh.finest=0.1134")),
        ("patch2d", None, (NARROW,)),
        ("patch3d", None, ()),
        ("patch3d", "tet4", ()),
        ("bar", None, ()),
        ("bar3d", None, ("time.end=0.2",)),
        ("star", "smooth", ("contact.stiffness=1e9", "time.end=1e-3")),
    ],
)
def test_displacement_and_force_are_those_of_the_reference_host(tmp_path, case, variant, changes):
    problem = reference.run(tmp_path, case, variant, changes)
    command = [sys.executable, str(DRIVER), case, "--out", str(tmp_path)]
    command += ["--variant", variant] if variant else []
    for change in changes:
        command += ["--override", change]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    (_, ours), (_, theirs) = outcome.read(tmp_path, "skfem"), outcome.read(tmp_path, "reference")
    assert np.abs(theirs["displacement"]).max() > 0.0
    # Newton stops below 1e-10 of the forces, as a rule far below; motions add up rounding over their steps.
    for key in ("displacement", "force"):
        scale = np.abs(theirs[key]).max()
        assert np.abs(ours[key] - theirs[key]).max() <= 1e-8 * scale
    assert problem.coords.shape == ours["displacement"].shape


def test_stresses_are_uniform_where_walls_are_flush(tmp_path):
    reference.run(tmp_path, "patch2d")
    subprocess.run([sys.executable, str(DRIVER), "patch2d", "--out", str(tmp_path)], check=True, capture_output=True)
    theirs, ours = (outcome.read(tmp_path, host)[0]["figures"] for host in ("reference", "skfem"))
    # Lines that take a wall of the overlap in turn by the penetration over the width, 1: so much shear is left.
    assert theirs["stress_error_max"] < 1e-9
    assert ours["stress_error_max"] < 2.0 * ours["penetration_max"]
