"""``python -m fmc_agreement.penetration FOLDER [CASE ...]``: the cases with a penetration that is wanted, a millionth of the radius, in
every host, beside the law alone. Writes ``penetration.md`` and ``penetration.json``. The exit status is 1 if it is not reached, or takes
more than twice the iterations."""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from fmc_contact import Contact

from . import outcome, reference, runs
from .arguments import with_cases
from .problem import Problem
from .runs import SHARED, Case


@dataclass(frozen=True)
class Wanted:
    """A case and its penetration, m."""

    case: Case
    penetration: float

    def asked(self) -> Case:
        return replace(self.case, changes=(*self.case.changes, f"load_steps.penetration={self.penetration!r}"))


# Radii of 8, of the block on the cone's tip 2.5 as its side, 1.5.
CASES = (
    Wanted(Case("hertz", hosts=SHARED), 8e-6),
    Wanted(Case("hertz", "depth", hosts=SHARED), 8e-6),
    Wanted(Case("cone", hosts=SHARED), 2.5e-6),
    Wanted(Case("ironing", hosts=SHARED), 1.5e-6),
    Wanted(Case("ironing", "depth", hosts=SHARED), 1.5e-6),
)

FORCES = ("force", "force_y_mean")


def largest(problem: Problem, displacements: np.ndarray) -> float:
    """Largest mean penetration of a node at any of some displacements, as the package finds it anew."""
    options = {**problem.contact_options(), "law": "depth", "estimator": "auto"}
    options = {key: value for key, value in options.items() if key in ("stiffness", "law", "estimator", "check_cells")}
    contact = Contact(problem.coords, [(body.cell_type, body.conn) for body in problem.bodies], bodies=problem.body_of_cell, **options)
    problem.add_obstacles(contact)
    found = 0.0
    for u in displacements:
        contact.multipliers.release()
        found = max(found, contact.multipliers.augment(problem.coords + u, penetration=1e300).penetration)
    return found


def row(host: str, wanted: Wanted, problem: Problem, by_law: Path, asked: Path) -> dict[str, Any]:
    """What a host has found with the law alone, and with the penetration asked for."""
    both = [outcome.read(folder, host) for folder in (by_law, asked)]
    found: dict[str, Any] = {"case": wanted.case.title, "host": host, "wanted": wanted.penetration}
    for key in ("iterations", "contact_iterations", "factorisations", "updates", "seconds"):
        found[key] = [summary.get(key) for summary, _ in both]
    found["penetration"] = [largest(problem, arrays["way_displacement"]) for _, arrays in both]
    found["force"] = [next(summary["figures"][key] for key in FORCES if key in summary["figures"]) for summary, _ in both]
    return found


def is_met(row: dict[str, Any]) -> bool:
    """Reached, up to a bit of the coordinates, in no more than twice the iterations."""
    reached = row["penetration"][1] <= row["wanted"] * (1.0 + 1e-9) + 1e-15
    return reached and row["iterations"][1] <= 2 * row["iterations"][0]


def markdown(rows: list[dict[str, Any]]) -> str:
    lines = [
        "| case | host | tolerance | penetration: without, reached | iterations | contact iterations | factorisations | updates | force |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    shown = None
    for one in rows:
        pair = {key: " · ".join(str(value) for value in one[key]) for key in ("iterations", "contact_iterations", "factorisations")}
        cells = [
            one["case"] if one["case"] != shown else "", one["host"], f"{one['wanted']:.1e}",
            " · ".join(f"{value:.1e}" for value in one["penetration"]), pair["iterations"], pair["contact_iterations"],
            pair["factorisations"], str(one["updates"][1]), " · ".join(f"{value:.5g}" for value in one["force"]),
        ]  # fmt: skip
        shown = one["case"]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def measured(folder: Path, wanted: Wanted) -> list[dict[str, Any]]:
    """Runs a case both ways in all its hosts."""
    places = []
    for case in (wanted.case, wanted.asked()):
        place = folder / case.folder
        problem = reference.run(place, case.name, case.variant, case.changes)
        for host, ranks in case.hosts:
            runs.run(host, ranks, case, problem, place)
        places.append(place)
    hosts = ["reference", *(runs.label(*host) for host in wanted.case.hosts)]
    return [row(host, wanted, problem, *places) for host in hosts]


def main() -> int:
    parser = argparse.ArgumentParser(prog="fmc_agreement.penetration", description="As little penetration as is wanted, in every host.")
    parser.add_argument("folder", type=Path, help="where penetration.md and penetration.json are written")
    given = with_cases(parser, sorted({one.case.name for one in CASES}))
    given.folder.mkdir(parents=True, exist_ok=True)
    rows: list[dict[str, Any]] = []
    for wanted in CASES:
        if not given.case or wanted.case.name in given.case:
            print(wanted.case.title, flush=True)
            rows += measured(given.folder, wanted)
    text = markdown(rows)
    (given.folder / "penetration.md").write_text(text)
    (given.folder / "penetration.json").write_text(json.dumps(rows, indent=2) + "\n")
    print(text)
    missed = [one for one in rows if not is_met(one)]
    for one in missed:
        print(f"not met: {one['case']} in {one['host']}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
