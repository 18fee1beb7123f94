"""CalculiX (``ccx``): surface-to-surface contact. Ties are contact that is ``TIED``, as ``*TIE`` ties no plane elements. The
answer is read from its result file."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np

from . import common

# Face of an element of CalculiX by the local corners of its facet.
_FACES = {
    2: ({0, 1}, {1, 2}, {2, 3}, {3, 0}),
    3: ({0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}),
}


def _surface(model: common.Model, name: str, facets: np.ndarray, first: int) -> list[str]:
    """Faces of elements; ``first`` is the number of the body's first element."""
    cells = model.cells[model.body_of(facets)]
    lines = [f"*SURFACE, NAME={name}, TYPE=ELEMENT"]
    for facet in facets:
        (cell,) = np.flatnonzero(np.isin(cells, facet).sum(axis=1) == len(facet))
        corners = {int(np.flatnonzero(cells[cell] == node)[0]) for node in facet}
        lines.append(f"{first + cell}, S{_FACES[model.dim].index(corners) + 1}")
    return lines


def _deck(model: common.Model, variant: str) -> list[str]:
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1}, {', '.join(f'{x:.12g}' for x in point)}" for i, point in enumerate(model.points.tolist())]
    firsts = np.cumsum([1, *(len(cells) for cells in model.cells)])
    for number, cells in enumerate(model.cells):
        lines.append(f"*ELEMENT, TYPE={'CPE4' if model.dim == 2 else 'C3D8'}, ELSET=B{number}")
        lines += [f"{firsts[number] + e}, {', '.join(str(n + 1) for n in cell)}" for e, cell in enumerate(cells)]
        young, poisson = model.materials[number]
        lines += [f"*MATERIAL, NAME=M{number}", "*ELASTIC", f"{young:.12g}, {poisson:.12g}"]
        lines += [f"*SOLID SECTION, ELSET=B{number}, MATERIAL=M{number}", *(["1."] if model.dim == 2 else [])]
    for number, (slave, master) in enumerate(model.pairs):
        lines += _surface(model, f"S{number}", slave, firsts[model.body_of(slave)])
        lines += _surface(model, f"T{number}", master, firsts[model.body_of(master)])
    return lines + _interaction(model, variant)


def _interaction(model: common.Model, variant: str) -> list[str]:
    stiffness = (1000 if variant == "stiff" else 50) * float(model.materials[:, 0].min())
    law = ["TIED", f"{stiffness:g}"] if model.tied else ["LINEAR", f"{stiffness:g}"] if variant == "stiff" else ["HARD"]
    lines = ["*SURFACE INTERACTION, NAME=I", f"*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={law[0]}", *law[1:]]
    if model.tied:
        lines += ["*FRICTION", f"1., {stiffness:g}"]
    if model.friction:
        lines += ["*FRICTION", f"{model.friction:g}, {stiffness / 10:g}"]
    for number in range(len(model.pairs)):
        lines += ["*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE", f"S{number}, T{number}"]
    return lines


def _step(model: common.Model, step: int) -> list[str]:
    held = [f"{p + 1}, {a + 1}, {a + 1}, {model.prescribed[step, p, a]:.12g}" for p, a in np.argwhere(model.fixed)]
    loads = [f"{p + 1}, {a + 1}, {model.loads[step, p, a]:.12g}" for p, a in np.argwhere(model.loads[step])]
    lines = [f"*STEP, INC=200{', NLGEOM' if model.friction else ''}", "*STATIC", "0.5, 1., 1e-6, 1." if step == 0 else "1., 1., 1e-6, 1."]
    lines += ["*BOUNDARY", *held, *(["*CLOAD, OP=NEW", *loads] if loads else [])]
    return [*lines, f"*NODE FILE{', OUTPUT=2D' if model.dim == 2 else ''}, FREQUENCY=1000", "U", "*END STEP"]


def _displacements(path: Path, shape: tuple[int, ...]) -> list[np.ndarray]:
    """Those at the ends of all steps that have them."""
    found: list[np.ndarray] = []
    reads = False
    for line in path.read_text(errors="replace").splitlines():
        if line.startswith(" -4"):
            reads = line[5:13].strip() == "DISP"
            if reads:
                found.append(np.full(shape, np.nan))
        elif line.startswith(" -1") and reads:
            found[-1][int(line[3:13]) - 1] = [float(line[13 + 12 * axis : 25 + 12 * axis]) for axis in range(shape[1])]
        elif line.startswith(" -3"):
            reads = False
    return found


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    if shutil.which("ccx") is None:
        raise common.Failed("ccx is not on the path")
    deck = _deck(model, variant)
    for step in range(model.steps):
        deck += _step(model, step)
    Path("job.inp").write_text("\n".join(deck) + "\n")
    done = subprocess.run(["ccx", "job"], capture_output=True, text=True)
    iterations = len(re.findall(r"^\s*iteration\s+\d+\s*$", done.stdout, re.MULTILINE))
    errors = " ".join(line.strip() for line in (done.stdout + done.stderr).splitlines() if "*ERROR" in line)
    found = _displacements(Path("job.frd"), model.points.shape) if Path("job.frd").exists() else []
    if done.returncode or "*ERROR" in errors or len(found) != model.steps:
        raise common.Failed(f"ended with {done.returncode} after {iterations} iterations, {len(found)} of {model.steps} steps: {errors[:200]}")
    return np.array(found), iterations


if __name__ == "__main__":
    common.main(solve)
