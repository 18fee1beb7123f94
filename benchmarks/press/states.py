"""The states that a host's program finds, by ``record.py`` in a process of its own."""

import functools
import os
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from press_programs import MODULES, PROGRAMS

HERE = Path(__file__).parent


def is_installed(name):
    return find_spec(MODULES[name]) is not None


@functools.cache
def states(name):
    """What ``record.py`` records of a program, and what the program prints."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "states.npz"
        command = [sys.executable, HERE / "record.py", PROGRAMS[name], path]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=900, env={**os.environ, "OMP_NUM_THREADS": "1"})
        # Not the status: some hosts end with one of their own after all is written.
        assert path.exists(), run.stdout + run.stderr
        return dict(np.load(path)), run.stdout


def code_of(name):
    """Lines of a program that are neither empty nor comments."""
    return [line for line in PROGRAMS[name].read_text().splitlines() if line.strip() and not line.lstrip().startswith("#")]


def differences(name, reference):
    """Largest difference of a coordinate and of a contact force from another host's, relative to the largest push and force."""
    (ours, _), (theirs, _) = states(name), states(reference)
    push = np.abs(theirs["x"] - theirs["points"]).max()
    x, forces = (np.abs(ours[key] - theirs[key]).max() for key in ("x", "forces"))
    return x / push, forces / np.abs(theirs["forces"]).max()
