"""Solves the decks with the patched ccx, with `fmc solve` and with ccx's own contact, and prints a table.

`CCX_FMC`, `CCX` and `FMC` name the programs; `python compare.py FOLDER` keeps their files."""

import base64
import os
import re
import subprocess
import sys
from pathlib import Path

import decks
import numpy as np

# ccx's own tolerance is half a per cent of the mean force.
TIGHT = "*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-6\n"


class Solution:
    """Displacements by label, and the reaction of the set that the deck prints."""

    def __init__(self, labels: np.ndarray, displacements: np.ndarray, reaction: np.ndarray, log: str) -> None:
        order = np.argsort(labels)
        self.labels, self.displacements = labels[order], displacements[order]
        self.reaction, self.log = reaction, log


def run(arguments: list[str], folder: Path, contact: str = "fmc") -> str:
    """Runs a program and returns what it prints."""
    environment = {**os.environ, "FMC_CONTACT": contact, "OMP_NUM_THREADS": "1"}
    done = subprocess.run(arguments, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(arguments)}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout + done.stderr


def reaction(folder: Path, name: str) -> np.ndarray:
    """The last total force of a .dat file."""
    lines = (folder / f"{name}.dat").read_text().split("\n")
    at = max(i for i, line in enumerate(lines) if "total force" in line)
    return np.array([float(x) for x in lines[at + 2].split()])


def by_ccx(name: str, deck: str, folder: Path) -> Solution:
    """By ccx with contact of the library."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.inp").write_text(deck.replace("*STATIC\n", TIGHT + "*STATIC\n"))
    log = run([os.environ.get("CCX_FMC", "ccx_fmc"), name], folder)
    (folder / f"{name}.log").write_text(log)
    table = np.loadtxt(folder / f"{name}.fmc.csv", delimiter=",", skiprows=1)
    return Solution(table[:, 2].astype(int), table[:, 3:6], reaction(folder, name), log)


def by_own_contact(name: str, deck: str, folder: Path) -> np.ndarray | None:
    """The reaction by ccx as it is; None where it finds none."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.inp").write_text(deck)
    try:
        run([os.environ.get("CCX", "ccx"), name], folder, "own")
        return reaction(folder, name)
    except (RuntimeError, ValueError, OSError, subprocess.TimeoutExpired):
        return None


def by_solve(name: str, deck: str, folder: Path) -> Solution:
    """By `fmc solve`."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.inp").write_text(deck)
    log = run([os.environ.get("FMC", "fmc"), "solve", f"{name}.inp", "--out", "."], folder)
    text = (folder / "step-1.vtu").read_text()
    points = text[text.index("<PointData>") : text.index("</PointData>")]

    def array(key: str, kind: str) -> np.ndarray:
        found = re.search(rf'Name="{key}"[^>]*>([^<]*)<', points)
        if found is None:
            raise ValueError(f"no {key} in the results of {name}")
        return np.frombuffer(base64.b64decode(found[1].strip())[8:], kind)

    kind = re.search(r'type="(\w+)" Name="label"', points)
    labels = array("label", kind[1].lower() if kind else "int64")
    line = next(line for line in log.split("\n") if "reactions of this set" in line)
    force = np.array([float(x) for x in line.split()[1:4]])
    return Solution(labels.astype(int), array("displacement", "float64").reshape(-1, 3), force, log)


def same_places(name: str, ours: Solution, theirs: Solution) -> float:
    """Largest difference of the displacements at a node, by the largest displacement."""
    is_both = np.isin(ours.labels, theirs.labels)
    if name != "tie" and not is_both.all():
        raise ValueError(f"{name}: nodes differ")
    mine = ours.displacements[is_both]
    other = theirs.displacements[np.isin(theirs.labels, ours.labels)]
    return float(np.abs(mine - other).max() / np.abs(other).max())


def corrections(log: str) -> list[float]:
    """Largest corrections of the displacements in the last increment, iteration after iteration."""
    last = log[log.rindex("increment size=") :] if "increment size=" in log else log
    return [float(x) for x in re.findall(r"largest correction to disp= *([-+.0-9eE]+)", last)]


def compare(name: str, folder: Path) -> tuple[float, np.ndarray, np.ndarray, np.ndarray | None, list[float]]:
    """Difference of displacements, reactions of the three programs, and ccx's corrections."""
    deck = decks.DECKS[name]()
    ours = by_ccx(name, deck, folder / "ccx_fmc")
    theirs = by_solve(name, decks.tie(is_merged=True) if name == "tie" else deck, folder / "fmc")
    own = by_own_contact(name, deck, folder / "ccx")
    return same_places(name, ours, theirs), ours.reaction, theirs.reaction, own, corrections(ours.log)


def main() -> None:
    """Prints the table."""
    folder = Path(sys.argv[1])
    print("| deck | displacement, ccx with fmc-contact and `fmc solve` | reaction | `fmc solve` | ccx's own |")
    print("| --- | --- | --- | --- | --- |")
    for name in decks.DECKS:
        difference, ours, theirs, own, steps = compare(name, folder)
        texts = [f"{np.linalg.norm(force):.6g}" if force is not None else "none" for force in (ours, theirs, own)]
        print(f"| `{name}` | {difference:.0e} | " + " | ".join(texts) + " |", flush=True)
        print("   ", steps, file=sys.stderr)


if __name__ == "__main__":
    main()
