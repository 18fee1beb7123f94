"""Programs in processes of their own, one after another, and the CPU seconds of each."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fmc_agreement.problem import Problem, fmc
from fmc_agreement.reference import point_data


@dataclass(frozen=True, eq=False)
class Run:
    """One run of a program. ``seconds`` are CPU seconds, user and system, by what they were spent on."""

    program: str
    seconds: dict[str, float]
    iterations: int
    force: np.ndarray
    """Contact force on every node, (nodes, dim)."""
    figures: dict[str, float]
    history: np.ndarray

    @property
    def total(self) -> float:
        """What is compared. Of fmc the whole process: the case read and meshed, solved, its files written. Of GetFEM the
        mesh and the model made from arrays in memory, and the solution; not Python's start nor the reading of a file."""
        return sum(spent for name, spent in self.seconds.items() if name != "reading")


def ours(folder: Path, problem: Problem, words: list[str]) -> Run:
    """``fmc run`` with the words that name the case and its changes, one thread."""
    command = [fmc(), "run", *words, "--quiet", "--out", str(folder), "--override", "output.frames=0"]
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    # It has been waited for.
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode > 1:
        raise RuntimeError(f"fmc run {words[0]} ended with {process.returncode}")
    summary = json.loads((folder / "summary.json").read_text())
    force = point_data(folder / "equilibrium.vtu", "contact_force")[:, : problem.dim]
    seconds = {"whole process": usage.ru_utime + usage.ru_stime}
    return Run("fmc", seconds, summary["iterations"], force, summary["figures"], np.zeros((0, 0)))


def getfem(folder: Path, problem: Problem, file: Path, formulation: str) -> Run:
    """GetFEM in one of its formulations."""
    out = folder / f"getfem-{formulation.replace(',', '').replace(' ', '-')}"
    subprocess.run([sys.executable, "-m", "fmc_peers.solve", str(file), formulation, str(out)], check=True)
    found, arrays = json.loads(out.with_suffix(".json").read_text()), np.load(out.with_suffix(".npz"))
    name = f"GetFEM, {formulation}"
    # What is held stands against what holds it.
    force = np.where(problem.held, 0.0, arrays["inner_force"])
    return Run(name, found["seconds"], found["iterations"], force, {}, arrays["history"])
