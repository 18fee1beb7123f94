"""``python -m fmc_peers.solve PROBLEM.json FORMULATION OUT``: a case in GetFEM, in a process of its own, so that its CPU seconds
are its own. Writes ``OUT.npz`` and ``OUT.json``."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import getfem as gf
import numpy as np
from fmc_agreement.problem import from_json

from . import pair, rigid
from .solution import Clock

SOLVERS = {"wedge": rigid.solve, "cone": rigid.solve, "balls": rigid.solve, "punch": pair.solve, "ironing": pair.solve}


def main() -> None:
    path, formulation, out = sys.argv[1:]
    gf.util("trace level", 0)
    gf.util("warning level", 0)
    clock = Clock()
    problem = from_json(json.loads(Path(path).read_text()))
    clock.lap("reading")
    found = SOLVERS[problem.raw["figures"]["kind"]](problem, formulation, clock)
    arrays = {"displacement": found.displacement, "inner_force": found.inner_force, "history": np.array(found.history)}
    np.savez(out + ".npz", **arrays)
    found_json = {"iterations": found.iterations, "seconds": clock.laps}
    Path(out + ".json").write_text(json.dumps(found_json) + "\n")


if __name__ == "__main__":
    main()
