"""``python -m fmc_agreement FOLDER [CASE ...]``: runs all cases in all hosts and writes ``table.md``, ``table.json``
and ``index.html``. The exit status is 1 if a host does not agree."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

from . import page, reference, runs, table
from .arguments import with_cases
from .overhead import measured
from .problem import fmc


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="fmc_agreement", description="The same cases in every host, compared node by node.")
    parser.add_argument("folder", type=Path, help="where table.md, table.json and index.html are written")
    return with_cases(parser, sorted({case.name for case in runs.CASES}))


def main() -> int:
    given = arguments()
    folder, wanted = given.folder, given.case
    folder.mkdir(parents=True, exist_ok=True)
    known = {one["case"] for one in json.loads(subprocess.check_output([fmc(), "list", "--json"]))}
    done, everything = [], []
    for case in runs.CASES:
        if case.name not in known or (wanted and case.name not in wanted):
            continue
        print(case.title, flush=True)
        if "FMC_DEALII" not in os.environ and ("dealii", 1) in case.hosts:
            print("  dealii: left out, FMC_DEALII names no program")
            case = case.only("skfem", "dolfinx", "getfem")
        place = folder / case.folder
        problem = reference.run(place, case.name, case.variant, case.changes)
        for host, ranks in case.hosts:
            seconds = runs.run(host, ranks, case, problem, place)
            print(f"  {runs.label(host, ranks)}: {seconds:.1f} s", flush=True)
        rows = table.rows(case, place)
        done.append((case, problem, place, rows))
        everything += rows
    notes = measured()
    print(notes)
    text = table.markdown(everything)
    (folder / "table.md").write_text(text)
    (folder / "table.json").write_text(json.dumps(everything, indent=2) + "\n")
    page.write(folder / "index.html", done, notes)
    print(text)
    apart = [row for row in everything if not table.is_met(row)]
    for row in apart:
        print(f"does not agree: {row['case']} in {row['host']}", file=sys.stderr)
    return 1 if apart else 0


if __name__ == "__main__":
    sys.exit(main())
