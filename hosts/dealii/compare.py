"""Hertz and a flat punch in deal.II beside the reference host: python compare.py FOLDER; the status is 1 where they are apart.

With the path of the command in FMC, that of press in FMC_DEALII, and fmc_agreement of benchmarks/agreement installed."""

from __future__ import annotations

import sys
from pathlib import Path

from fmc_agreement import reference, runs, table


def main(folder: str) -> int:
    apart = 0
    for case in runs.CASES:
        if ("dealii", 1) not in case.hosts:
            continue
        place = Path(folder) / case.folder
        problem = reference.run(place, case.name, case.variant, case.changes)
        runs.run("dealii", 1, case, problem, place)
        (row,) = (row for row in table.rows(case.only("dealii"), place) if row["host"] == "dealii")
        apart += not table.is_met(row)
        for name in ("displacement", "force"):
            print(f"{case.title}, {name}: {row[name]:.1e} from the reference host, {row['iterations']} linear solves", flush=True)
    return int(apart > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
