"""``python -m fmc_peers FOLDER [CASE ...]``: the cases in fmc and in GetFEM, in turn, one thread each. Writes ``table.md``,
``table.json`` and, for each case, the pressures over one another as SVG."""

from __future__ import annotations

import argparse
import json
import subprocess
from pathlib import Path

from fmc_agreement.arguments import with_cases
from fmc_agreement.indentation import Surface
from fmc_agreement.picture import overlay
from fmc_agreement.problem import Problem, fmc, from_json

from . import measure, table

FORMULATIONS = {
    "wedge": ("nodal", "nodal, unsymmetric", "integral"),
    "cone": ("nodal", "integral"),
    "hertz3d": ("nodal", "integral"),
    "punch": ("rays from the last body",),
    "ironing": ("rays from the last body", "rays from the first body"),
    "ironing-friction": ("rays from the last body", "rays from the first body"),
}
"""By the case, and its variant after a hyphen."""

TIED = (20, 40)
"""Cells over the half width of the punch's interface where it is tied."""


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="fmc_peers", description="The cases in fmc and in GetFEM, side by side.")
    parser.add_argument("folder", type=Path, help="where everything is written")
    parser.add_argument("--repetitions", type=int, default=3, help="runs of each program, in turn [3]")
    parser.add_argument("--override", action="append", default=[], metavar="KEY=VALUE", help="as of fmc run")
    return with_cases(parser, FORMULATIONS)


def main() -> None:
    given = arguments()
    changes = [word for change in given.override for word in ("--override", change)]
    everything = []
    for case in given.case or FORMULATIONS:
        print(case, flush=True)
        folder = given.folder / case
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / "problem.json"
        name, _, variant = case.partition("-")
        words = [name, *(["--variant", variant] if variant else []), *changes]
        subprocess.run([fmc(), "mesh", *words, "--out", str(file)], check=True)
        problem = from_json(json.loads(file.read_text()))
        programs = [lambda: measure.ours(folder / "fmc", problem, words)]
        programs += [lambda name=name: measure.getfem(folder, problem, file, name) for name in FORMULATIONS[case]]
        # In turn, so that a machine that is busy for a while is busy for all.
        turns = [[program() for program in programs] for _ in range(given.repetitions)]
        runs = [list(of_one) for of_one in zip(*turns)]
        everything += table.rows(problem, runs)
        if table.has_profile(problem):
            draw(folder / "pressure.svg", problem, runs)
        if case == "punch" and not given.override:
            everything += tied_rows(problem)
    (given.folder / "table.json").write_text(json.dumps(everything, indent=2) + "\n")
    text = table.markdown(everything)
    (given.folder / "table.md").write_text(text)
    print(text)


def draw(path: Path, problem: Problem, runs: list[list[measure.Run]]) -> None:
    """Pressures of all programs over one another."""
    found = {of_one[0].program: Surface(problem, 0, of_one[0].force) for of_one in runs}
    reach = 1.3 * max(one.reach() for one in found.values())
    # The tip is singular and would flatten the rest.
    curves = {name: one.profile(reach)[1:] for name, one in found.items()}
    path.write_text(overlay(problem.raw["figures"]["kind"], curves))


def tied_rows(problem: Problem) -> list[dict]:
    """Force and pressure in the middle of an interface that neither opens nor slides."""
    # The only thing here that loads GetFEM into this process.
    import getfem as gf

    from . import tied
    from .solution import Clock

    gf.util("trace level", 0)

    found = []
    for cells in TIED:
        clock = Clock()
        line = tied.solve(problem, cells)
        clock.lap("solution")
        found.append({
            "case": problem.name, "program": f"GetFEM, tied, {cells} cells over the half width",
            "cells": 6 * cells**2, "repetitions": 1, "cpu_seconds": clock.laps["solution"],
            "cpu_seconds_each": [clock.laps], "iterations": None,
            "force": float(problem.raw["figures"]["copies"] * line.force.sum()),
            "pressure_center": float(line.force[0] / line.length[0]),
        })  # fmt: skip
    return found


if __name__ == "__main__":
    main()
