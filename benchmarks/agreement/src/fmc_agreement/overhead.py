"""What an adapter adds to an evaluation: gather, copy and scatter, at about 50 000 nodes on the surface."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from typing import Any, Callable

import numpy as np

from .runs import drivers, mpirun


def plates(divisions: int = 110) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Two plates of hexahedra that overlap in the middle: nodes, cells, and displacements that bulge the upper one."""
    from .plates import plate

    lower, cells = plate(divisions, 0.0)
    upper, more = plate(divisions - 1, 0.099)
    bulge = np.zeros_like(upper)
    bulge[:, 2] = 0.1 * ((upper[:, :2] - 0.5) ** 2).sum(axis=1)
    coords = np.concatenate([lower, upper])
    return coords, np.concatenate([cells, more + len(lower)]), np.concatenate([np.zeros_like(lower), bulge])


def share(contact: Any, adapted: Callable[[], Any], repeats: int = 9) -> tuple[float, float]:
    """Seconds of an evaluation with its adapter and of the evaluation within it: of the repeat in which the rest was
    least. ``contact`` is what the adapter evaluates."""
    plain, times = contact.evaluate, []

    def evaluate(*arguments: Any) -> Any:
        nonlocal inner
        begin = time.perf_counter()
        found = plain(*arguments)
        inner = time.perf_counter() - begin
        return found

    contact.evaluate = evaluate
    for _ in range(repeats):
        inner, begin = 0.0, time.perf_counter()
        adapted()
        times.append((time.perf_counter() - begin, inner))
    contact.evaluate = plain
    return min(times, key=lambda pair: pair[0] - pair[1])


def measured() -> str:
    """A line for every adapter."""
    lines = []
    for host, ranks in (("skfem", 1), ("getfem", 1), ("dolfinx", 1), ("dolfinx", 2)):
        command = [sys.executable, str(drivers() / host / "overhead.py")]
        if host == "dolfinx":
            command = [*mpirun(ranks), *command]
        more = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **more})
        lines.append(done.stdout.strip() if done.returncode == 0 else f"{host} failed: {done.stderr.strip()[-300:]}")
    return "\n".join(lines)
