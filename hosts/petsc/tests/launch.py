"""Programs on ranks."""

import os
import subprocess

LIMIT = 300
"""Seconds, of which these runs take a few; more where other programs run beside them."""


def printed(ranks, *command):
    """What a program prints on so many ranks; it must end well."""
    environment = dict(
        os.environ,
        OMP_NUM_THREADS="1",
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_mpi_yield_when_idle="1",
    )
    launched = ["timeout", str(LIMIT), "mpirun", "--oversubscribe", "-n", str(ranks), *command]
    found = subprocess.run(launched, capture_output=True, text=True, env=environment)
    assert found.returncode == 0, found.stdout + found.stderr
    return found.stdout
