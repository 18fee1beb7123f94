"""Which cases run in which hosts."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from . import bits, figures, outcome, plain, quadrilaterals
from .problem import Problem
from .solved import Solved, Step

DRIVERS = Path(__file__).parents[2] / "drivers"
"""The folder of the drivers in the checkout; ``FMC_DRIVERS`` where this package is installed elsewhere."""

SHARED = (("skfem", 1), ("dolfinx", 1), ("getfem", 1))
"""Hosts that run every case: name and number of ranks."""


@dataclass(frozen=True)
class Case:
    """A case, what is changed in it, and the hosts beside the reference that run it: name and number of ranks."""

    name: str
    variant: str | None = None
    changes: tuple[str, ...] = ()
    tolerance: float = 1e-8
    """How far displacements may be apart, by the largest."""
    hosts: tuple[tuple[str, int], ...] = SHARED
    on_ranks: bool = False
    """Whether dolfinx solves it on any number of ranks, as its adapter offers, instead of by the path that the hosts share."""

    @property
    def title(self) -> str:
        words = [self.name, *([self.variant] if self.variant else []), *self.changes]
        return ", ".join(words)

    @property
    def folder(self) -> str:
        """Name of the folder for its outcomes."""
        words = [self.name, *([self.variant] if self.variant else []), *self.changes]
        return "-".join(re.sub(r"[^\w.-]+", "-", word) for word in words)

    def only(self, *names: str) -> Case:
        """The same with some of its hosts."""
        return replace(self, hosts=tuple(host for host in self.hosts if host[0] in names))


# With the stiffness of the case file the star's impact multiplies what differs by 1e11: a change of Young's modulus
# in its thirteenth digit moves nodes of one and the same host by 1.5 %. Softer contact does not, and needs longer to
# let go.
CASES = (
    Case(
        "hertz",
        hosts=(("skfem", 1), ("getfem", 1), *[("dolfinx", n) for n in (1, 2, 3, 4)], *[("petsc", n) for n in (1, 2, 4)]),
        on_ranks=True,
    ),
    Case("hertz3d"),
    Case("patch3d"),
    Case("patch3d", "tet4"),
    Case("wedge"),
    # Its contact normal is the mean over sampled lines, whose iteration has several fixed points: hosts that come another way may end
    # on another one, 1e-4 away. These go the same way.
    Case("cone"),
    Case("punch"),
    # What deal.II's program reads: quadrilaterals.
    Case("hertz", None, ("bodies.disc.mesh.cell=quad4",), hosts=(*SHARED, ("dealii", 1))),
    Case("punch", "depth", hosts=(*SHARED, ("dealii", 1))),
    Case("ironing"),
    Case("cgs4", hosts=(*SHARED, ("dealii", 1))),
    Case("hertz", "depth"),
    Case("hertz", "tri6"),
    Case("bar", tolerance=1e-6),
    Case("star", "smooth", ("contact.stiffness=1e9", "time.end=9e-3"), tolerance=1e-6),
)


def label(host: str, ranks: int) -> str:
    """Name of a host's files."""
    return host if ranks == 1 else f"{host}-np{ranks}"


def run(host: str, ranks: int, case: Case, problem: Problem, folder: Path) -> float:
    """Runs a case in a host, which writes its outcome; returns the seconds of the whole program."""
    begin = time.perf_counter()
    if host == "petsc":
        _petsc(ranks, problem, folder)
        return time.perf_counter() - begin
    if host == "dealii":
        _dealii(problem, folder)
        return time.perf_counter() - begin
    command = [sys.executable, str(drivers() / host / "run_case.py"), case.name, "--out", str(folder)]
    command += ["--variant", case.variant] if case.variant else []
    for change in case.changes:
        command += ["--override", change]
    if host == "dolfinx":
        command = [*mpirun(ranks), *command, "--host", label(host, ranks), *(["--on-ranks"] if case.on_ranks else [])]
    _call(command)
    return time.perf_counter() - begin


def mpirun(ranks: int) -> list[str]:
    """A program on several ranks; it ends after ten minutes, whatever its ranks wait for."""
    return ["timeout", "600", "mpirun", "--oversubscribe", "-n", str(ranks)]


def drivers() -> Path:
    """Where the drivers are, a folder for each host."""
    return Path(os.environ.get("FMC_DRIVERS", DRIVERS))


def _petsc(ranks: int, problem: Problem, folder: Path) -> None:
    table, solution = folder / "problem.txt", folder / f"petsc-np{ranks}.txt"
    plain.write(problem, table)
    program = os.environ.get("FMC_PETSC", "equilibrium")
    _call([*mpirun(ranks), program, str(table), str(solution)])
    with open(solution) as file:
        iterations, seconds, contact_seconds = map(float, file.readline().split())
        rows = np.loadtxt(file)
    displacement, force = rows[:, :2], rows[:, 2:]
    found, curve = figures.hertz(problem, force)
    found["penetration_max"] = -float(np.minimum((problem.coords + displacement)[:, 1], 0.0).min())
    outcome.write(
        folder, label("petsc", ranks), problem, found, displacement, force, curve, int(iterations), seconds,
        contact_seconds, ranks=ranks,
    )  # fmt: skip


def _dealii(problem: Problem, folder: Path) -> None:
    solved = in_dealii(problem, folder)
    outcome.of_equilibrium(folder, "dealii", problem, solved, {}, {})


def in_dealii(problem: Problem, folder: Path, is_refined: quadrilaterals.Where | None = None) -> Solved:
    """What deal.II's program finds where the reference host has been, at the nodes of the case. With friction the way counts, and
    the load steps are those of the reference host."""
    table, solution = folder / "problem-dealii.txt", folder / "dealii.txt"
    _, theirs = outcome.read(folder, "reference")
    displacements = theirs["way_displacement"] if problem.has_friction else theirs["displacement"][np.newaxis]
    quadrilaterals.write(problem, displacements, table, is_refined)
    _call([os.environ["FMC_DEALII"], str(table), str(solution)])
    with open(solution) as file:
        solves, seconds, contact_seconds = map(float, file.readline().split())
        rows = np.loadtxt(file)[: len(problem.coords)]  # those of divided cells come after them
    displacement, force = rows[:, :2], rows[:, 2:]
    penetration = bits.package(problem, displacement).penetration
    return Solved(
        [Step(0, 1.0, displacement, force, penetration)],
        iterations=int(solves), seconds=seconds, contact_seconds=contact_seconds,
    )  # fmt: skip


def _call(command: list[str]) -> None:
    more = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **more})
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}\n{done.stdout}\n{done.stderr}")
