"""What all runners share: the model as arrays, and the answer as a file. Needs numpy alone."""

from __future__ import annotations

import json
import resource
import sys
import time
from pathlib import Path
from typing import Callable

import numpy as np


class NotSupported(Exception):
    """The code has no way to pose the problem; the text says why."""


class Failed(Exception):
    """The code returned no equilibrium; the text is what it said."""


class Model:
    """A problem as arrays; unknowns are ``point * dim + axis``."""

    def __init__(self, arrays: dict[str, np.ndarray]) -> None:
        self.points, self.firsts, self.fixed = arrays["points"], arrays["firsts"], arrays["fixed"]
        self.prescribed, self.loads = arrays["prescribed"], arrays["loads"]
        self.symmetry, self.materials = arrays["symmetry"], arrays["materials"]
        self.friction, self.tied, self.overlaps = float(arrays["friction"]), bool(arrays["tied"]), bool(arrays["overlaps"])
        self.dim = self.points.shape[1]
        self.warnings: list[str] = []
        """What a code warned of, for the readers of the table."""
        self.cells = [arrays[f"cells_{number}"] for number in range(len(self.materials))]
        count = sum(name.startswith("slave_") for name in arrays)
        self.pairs = [(arrays[f"slave_{number}"], arrays[f"master_{number}"]) for number in range(count)]

    @property
    def steps(self) -> int:
        return len(self.loads)

    def body_of(self, facets: np.ndarray) -> int:
        return int(np.searchsorted(self.firsts, facets.flat[0], side="right") - 1)

    def facet_size(self) -> float:
        """Mean length of an edge of the facets that may touch."""
        edges = [np.linalg.norm(self.points[one[:, 1]] - self.points[one[:, 0]], axis=1) for pair in self.pairs for one in pair]
        return float(np.mean(np.concatenate(edges)))


Solve = Callable[[Model, str], "tuple[np.ndarray, int]"]
"""Takes the model and the name of a variant; returns displacements, (steps, n, dim), and the number of iterations, -1 if not told."""


def _seconds() -> float:
    """Of the processor, in this process and in those that it has waited for."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def main(solve: Solve) -> None:
    """Runs a solver for the words of the command line."""
    path, variant, out = sys.argv[1:]
    with np.load(path) as arrays:
        model = Model(dict(arrays))
    found: dict[str, object] = {"status": "ok", "message": ""}
    begun = _seconds()
    try:
        displacements, iterations = solve(model, variant)
        if not np.isfinite(displacements).all():
            raise Failed("displacements that are not finite")
        np.save(out + ".npy", displacements)
        found.update(iterations=iterations, message="; ".join(model.warnings))
    except NotSupported as error:
        found.update(status="not supported", message=str(error))
    except Exception as error:
        found.update(status="failed", message=f"{error}"[:400] or type(error).__name__)
    found["seconds"] = _seconds() - begun
    Path(out + ".json").write_text(json.dumps(found) + "\n")
