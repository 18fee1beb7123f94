"""``python -m fmc_agreement.beside FOLDER [CASE ...]``: iterations and processor time of the Python hosts beside the reference host's, best
of three alternating runs. Writes ``beside.md`` and ``beside.json``. The exit status is 1 where more is taken than is promised."""

from __future__ import annotations

import argparse
import json
import resource
import sys
from pathlib import Path
from typing import Any

from . import outcome, reference, runs
from .arguments import with_cases
from .runs import Case

HOSTS = (("skfem", 1), ("dolfinx", 1), ("getfem", 1))

CASES = tuple(Case(name, hosts=HOSTS) for name in ("wedge", "punch", "ironing", "hertz3d", "cone"))

ROUNDS = 3

MOST_ITERATIONS = 1.2
"""By the reference host's."""

MOST_ON_CONE = 12
"""Iterations."""

MOST_TIME_ON_CONE = 2.0
"""By the reference host's."""


def measured(folder: Path, case: Case) -> list[dict[str, Any]]:
    """Rows of a case: the reference first."""
    place, rows = folder / case.folder, {}
    for _ in range(ROUNDS):
        problem = reference.run(place, case.name, case.variant, case.changes)
        _take(rows, place, "reference", None)
        for host, ranks in case.hosts:
            before = _children()
            runs.run(host, ranks, case, problem, place)
            _take(rows, place, runs.label(host, ranks), _children() - before)
    return [{"case": case.title, **row} for row in rows.values()]


def _children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _take(rows: dict[str, dict[str, Any]], place: Path, host: str, program: float | None) -> None:
    """The counts of a run, and its time where none was less."""
    summary, _ = outcome.read(place, host)
    keys = ("iterations", "contact_iterations", "factorisations")
    row = rows.setdefault(host, {"host": host, "seconds": float("inf"), "program": float("inf")})
    row.update({key: summary.get(key) for key in keys})
    row["seconds"] = min(row["seconds"], summary["seconds"])
    row["program"] = min(row["program"], summary["seconds"] if program is None else program)


def is_met(row: dict[str, Any], theirs: dict[str, Any]) -> bool:
    few = row["iterations"] <= MOST_ITERATIONS * theirs["iterations"]
    if row["case"] == "cone":
        return row["iterations"] <= MOST_ON_CONE and row["seconds"] <= MOST_TIME_ON_CONE * theirs["seconds"]
    return few


def markdown(rows: list[dict[str, Any]]) -> str:
    lines = [
        "| case | host | iterations | ratio to reference | contact iterations | factorisations | time | ratio to reference | with imports |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    theirs: dict[str, Any] = {}
    for row in rows:
        is_first = row["host"] == "reference"
        theirs = row if is_first else theirs
        cells = [
            row["case"] if is_first else "", row["host"], str(row["iterations"]),
            "" if is_first else f"{row['iterations'] / theirs['iterations']:.2f}",
            str(row["contact_iterations"]), str(row["factorisations"]), f"{row['seconds']:.2f} s",
            "" if is_first else f"{row['seconds'] / theirs['seconds']:.2f}", f"{row['program']:.2f} s",
        ]  # fmt: skip
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(prog="fmc_agreement.beside", description="Iterations and time compared with the reference host.")
    parser.add_argument("folder", type=Path, help="where beside.md and beside.json are written")
    given = with_cases(parser, sorted({case.name for case in CASES}))
    given.folder.mkdir(parents=True, exist_ok=True)
    rows, missed = [], []
    for case in CASES:
        if given.case and case.name not in given.case:
            continue
        print(case.title, flush=True)
        found = measured(given.folder, case)
        rows += found
        missed += [row for row in found[1:] if not is_met(row, found[0])]
    text = markdown(rows)
    (given.folder / "beside.md").write_text(text)
    (given.folder / "beside.json").write_text(json.dumps(rows, indent=2) + "\n")
    print(text)
    for row in missed:
        print(f"more than is promised: {row['case']} in {row['host']}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
