"""Problems in deal.II beside the reference host: python compare.py FOLDER; the status is 1 where they are apart.

Hertz, a flat punch, and a slider that friction holds on a slope, each on the same mesh; and two blocks under uniform pressure with
cells that are divided beside the contact, so that nodes hang. With the path of the command in FMC, that of press in FMC_DEALII, and
fmc_agreement of benchmarks/agreement installed."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from fmc_agreement import outcome, reference, runs, table

HANGING = 1e-6
"""The pressure is uniform but for the side walls, which are in line, by 1.5e-5; of that a finer mesh shows its own part."""


def main(folder: Path) -> int:
    cases = [case for case in runs.CASES if ("dealii", 1) in case.hosts]
    return int(not all([*(agrees(case, folder / case.folder) for case in cases), agrees_with_hanging_nodes(folder / "hanging")]))


def agrees(case: runs.Case, place: Path) -> bool:
    """Whether a case on the same mesh agrees; distances are printed."""
    problem = reference.run(place, case.name, case.variant, case.changes)
    runs.run("dealii", 1, case, problem, place)
    (row,) = (row for row in table.rows(case.only("dealii"), place) if row["host"] == "dealii")
    for name in ("displacement", "force"):
        print(f"{case.title}, {name}: {row[name]:.1e} from the reference host, {row['iterations']} linear solves", flush=True)
    return table.is_met(row)


def agrees_with_hanging_nodes(place: Path) -> bool:
    """The same of displacements alone: forces have gone to other nodes."""
    problem = reference.run(place, "patch2d", "depth", ())
    _, theirs = outcome.read(place, "reference")
    (step,) = runs.in_dealii(problem, place, beside_contact).steps
    distance = np.abs(step.displacement - theirs["displacement"]).max() / np.abs(theirs["displacement"]).max()
    print(f"patch2d, depth, with hanging nodes, displacement: {distance:.1e} from the reference host without", flush=True)
    return bool(distance <= HANGING)


def beside_contact(at: np.ndarray) -> np.ndarray:
    """Of two blocks that meet at y = 0.5, over a part of their width."""
    return (abs(at[:, 1] - 0.5) < 0.13) & (at[:, 0] > 0.2) & (at[:, 0] < 0.75)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
