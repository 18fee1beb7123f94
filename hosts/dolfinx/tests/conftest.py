"""Runs programs on several ranks; the tests themselves are serial."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).parent


@pytest.fixture(scope="session")
def ranks():
    """``ranks(n, program, *arguments, limit=seconds)``: the finished process of ``parallel.py`` on n ranks."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    # Ranks are more than cores: one that waits lets the others go on.
    environment["OMPI_MCA_mpi_yield_when_idle"] = "1"

    def run(count, *arguments, limit=120):
        command = ["timeout", str(limit), "mpirun", "--oversubscribe", "-n", str(count), sys.executable]
        command += [str(FOLDER / "parallel.py"), *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, env=environment)

    return run
