"""Hertz and a flat punch in deal.II beside the reference host: python compare.py PRESS FOLDER; the status is 1 where they are apart.

With the path of the command in FMC and benchmarks/agreement/src on PYTHONPATH."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
from fmc_agreement import outcome, reference
from fmc_agreement.faces import loads
from fmc_agreement.problem import Problem

CASES = (("hertz", None, ("bodies.disc.mesh.cell=quad4",)), ("punch", "depth", ()))
LAWS = {"volume": 0, "fiber": 1, "depth": 2}
LARGEST = 1e-8
"""Largest difference of any node, by the largest value."""


def write(problem: Problem, displacement: np.ndarray, path: Path) -> None:
    """The table that problem.h reads. Loaded nodes are moved as the reference host found them moved, so that a body which only a
    first touch holds needs no more than Newton's method."""
    contact = problem.contact_options()
    cells = [[number, *nodes] for number, body in enumerate(problem.bodies) for nodes in body.conn.tolist()]
    held = [[node, axis, problem.prescribed[node, axis]] for node, axis in np.argwhere(problem.held).tolist()]
    loaded = np.unique(np.concatenate([faces.ravel() for faces, _ in loads(problem)] or [np.zeros(0, int)]))
    held += [[node, axis, displacement[node, axis]] for node in loaded.tolist() for axis in range(2) if not problem.held[node, axis]]
    tables = {
        "nodes": problem.coords.tolist(),
        "cells": cells,
        "held": held,
        "materials": [
            [int(of.law == "linear-elastic"), of.lame, of.shear, of.bulk] for of in (body.material for body in problem.bodies)
        ],
        "contact": [[LAWS[contact["law"]], contact["stiffness"]]],
        "half_spaces": [
            [*one.get("position", [0.0, 0.0]), *one.get("axis", [0.0, 1.0])] for one in problem.raw["obstacles"]
        ],
    }
    lines = []
    for name, rows in tables.items():
        lines += [f"{name} {len(rows)}", *(" ".join(map(repr, row)) for row in rows)]
    path.write_text("\n".join(lines) + "\n")


def main(press: str, folder: str) -> int:
    apart = 0
    for case, variant, changes in CASES:
        place = Path(folder) / case
        problem = reference.run(place, case, variant, changes)
        _, arrays = outcome.read(place, "reference")
        write(problem, arrays["displacement"].reshape(problem.coords.shape), place / "problem.txt")
        subprocess.run([press, place / "problem.txt", place / "dealii.txt"], check=True)
        with open(place / "dealii.txt") as file:
            solves = int(file.readline())
            rows = np.loadtxt(file)
        for name, found in (("displacement", rows[:, :2]), ("force", rows[:, 2:])):
            expected = arrays[name].reshape(found.shape)
            distance = np.abs(found - expected).max() / np.abs(expected).max()
            apart += not distance <= LARGEST
            print(f"{case}, {name}: {distance:.1e} from the reference host, {solves} linear solves", flush=True)
    return int(apart > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
