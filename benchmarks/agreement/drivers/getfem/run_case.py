"""A case of statics in GetFEM: ``python run_case.py CASE [--variant NAME] [--override KEY=VALUE ...] --out FOLDER``."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from fmc_agreement import bits, outcome
from fmc_agreement.direct import solve
from fmc_agreement.equilibrium import Equilibrium
from fmc_agreement.path import Path as LoadPath
from fmc_agreement.problem import Problem, load
from in_case import Touching
from model import Model


def at_rest(problem: Problem, out: Path) -> None:
    """Solves a case of statics."""
    bodies = Model(problem)
    touching = Touching(problem, bodies)
    solved = LoadPath(Equilibrium(problem, bodies, touching, bodies.load(), solve)).follow()
    found: dict[str, float] = {}
    if problem.raw["figures"]["kind"] == "patch":
        pressure = problem.raw["loads"][0]["pressure"]
        stresses = bodies.stresses_along(solved.steps[-1].displacement, problem.dim - 1)
        found = {"stress_error_max": float(np.abs(stresses + pressure).max() / pressure)}
    bits.begun_anew(problem, touching)
    outcome.of_equilibrium(out, "getfem", problem, solved, found, bits.compared(out, problem, touching.force))


def main() -> None:
    parser = argparse.ArgumentParser(description="A case in GetFEM")
    parser.add_argument("case")
    parser.add_argument("--variant")
    parser.add_argument("--override", action="append", default=[])
    parser.add_argument("--out", type=Path, required=True)
    given = parser.parse_args()
    problem = load(given.case, given.variant, tuple(given.override))
    if not problem.is_static:
        parser.error(f"'{problem.name}' is a motion, which is not done in GetFEM")
    at_rest(problem, given.out)


if __name__ == "__main__":
    main()
