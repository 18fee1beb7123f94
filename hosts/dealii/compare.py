"""Problems in deal.II beside the reference host: python compare.py PRESS FOLDER; the status is 1 where they are apart.

Hertz and a flat punch on the same mesh; two blocks under uniform pressure with cells that are refined beside the contact, so that nodes
hang; and a slider that friction holds on a slope. With the path of the command in FMC and benchmarks/agreement/src on PYTHONPATH."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
from fmc_agreement import outcome, reference
from fmc_agreement.faces import loads
from fmc_agreement.problem import Problem

LAWS = {"volume": 0, "fiber": 1, "depth": 2}
@dataclass(frozen=True)
class Case:
    name: str
    variant: str | None = None
    changes: tuple[str, ...] = ()
    is_refined: Callable[[np.ndarray], np.ndarray] | None = None
    """Of the cells' middles, (cells, 2), those where they are to be divided."""
    largest: float = 1e-8
    """Largest difference of any node, by the largest value."""

    @property
    def title(self) -> str:
        return self.name + ("-refined" if self.is_refined else "")


def beside_contact(at: np.ndarray) -> np.ndarray:
    """Of two blocks that meet at y = 0.5, over a part of their width."""
    return (abs(at[:, 1] - 0.5) < 0.13) & (at[:, 0] > 0.2) & (at[:, 0] < 0.75)


CASES = (
    Case("hertz", changes=("bodies.disc.mesh.cell=quad4",)),
    Case("punch", "depth"),
    Case("patch2d", "depth"),
    # The pressure is uniform but for the side walls, which are in line, by 1.5e-5; of that a finer mesh shows its own part.
    Case("patch2d", "depth", is_refined=beside_contact, largest=1e-6),
    Case("cgs4"),
)


def write(problem: Problem, case: Case, displacements: np.ndarray, path: Path) -> None:
    """The table that problem.h reads, with the displacements of the reference host, (steps, nodes, 2). Loaded nodes are moved as it
    found them moved, so that a body which only a first touch holds needs no more than Newton's method."""
    contact = problem.contact_options()
    cells = [[number, *nodes] for number, body in enumerate(problem.bodies) for nodes in body.conn.tolist()]
    is_held = problem.held.copy()
    is_held[np.unique(np.concatenate([faces.ravel() for faces, _ in loads(problem)] or [np.zeros(0, int)]))] = True
    held = [[node, axis, *displacements[:, node, axis].tolist()] for node, axis in np.argwhere(is_held).tolist()]
    nodes_of_cells = np.array(cells)[:, 1:]
    refined = np.zeros(len(cells), bool)
    if case.is_refined:
        # A node in the middle of a held edge would have to be held as well.
        refined = case.is_refined(problem.coords[nodes_of_cells].mean(axis=1)) & ~is_held[nodes_of_cells].any(axis=(1, 2))
    tables = {
        "nodes": problem.coords.tolist(),
        "cells": cells,
        "refined": np.flatnonzero(refined)[:, None].tolist(),
        "steps": [[len(displacements)]],
        "held": held,
        "materials": [
            [int(of.law == "linear-elastic"), of.lame, of.shear, of.bulk] for of in (body.material for body in problem.bodies)
        ],
        "contact": [[LAWS[contact["law"]], contact["stiffness"], contact.get("friction_coefficient", 0.0)]],
        "half_spaces": [
            [*one.get("position", [0.0, 0.0]), *one.get("axis", [0.0, 1.0])] for one in problem.raw["obstacles"]
        ],
    }
    lines = []
    for name, rows in tables.items():
        lines += [f"{name} {len(rows)}", *(" ".join(map(repr, row)) for row in rows)]
    path.write_text("\n".join(lines) + "\n")


def compared(case: Case, press: str, place: Path) -> bool:
    """Whether a case agrees; distances are printed."""
    problem = reference.run(place, case.name, case.variant, case.changes)
    _, arrays = outcome.read(place, "reference")
    on_the_way = problem.has_friction
    displacements = arrays["way_displacement"] if on_the_way else arrays["displacement"].reshape(1, *problem.coords.shape)
    write(problem, case, displacements, place / "problem.txt")
    subprocess.run([press, place / "problem.txt", place / "dealii.txt"], check=True)
    with open(place / "dealii.txt") as file:
        solves = int(file.readline())
        rows = np.loadtxt(file)
    count = len(problem.coords)  # those of refined cells come after them
    print(f"{case.title}: {len(rows) - count} more nodes, {solves} linear solves")
    found = {"displacement": rows[:count, :2], "force": rows[:count, 2:4]}
    if case.is_refined:
        del found["force"]  # it has gone to other nodes
    distances = {
        name: np.abs(one - arrays[name].reshape(one.shape)).max() / np.abs(arrays[name]).max() for name, one in found.items()
    }
    if problem.has_friction:
        distances["push by load"] = abs(pushed(problem, rows[:count, 2:4]) - 1)
    for name, distance in distances.items():
        beside = "its closed form" if name == "push by load" else "the reference host"
        print(f"  {name}: {distance:.1e} from {beside}", flush=True)
    # The contact is as soft as the bodies are: the reference host has the push to 2e-5, too.
    return all(distance <= (1e-4 if name == "push by load" else case.largest) for name, distance in distances.items())


def pushed(problem: Problem, force: np.ndarray) -> float:
    """Forces on a slider that goes up a slope of 1 in 10, across by along its weight, by the closed form."""
    friction = problem.contact_options()["friction_coefficient"]
    across, along = abs(force[problem.bodies[problem.about].nodes].sum(axis=0))
    return float(across / along / ((0.1 + friction) / (1 - 0.1 * friction)))


def main(press: str, folder: str) -> int:
    agree = [compared(case, press, Path(folder) / case.title) for case in CASES]
    return int(not all(agree))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
