"""The reference host, ``fmc run``, and what it leaves in files."""

from __future__ import annotations

import base64
import csv
import json
import resource
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from . import outcome
from .problem import Problem, fmc, load
from .solved import Step

MIDDLE = 0.4
"""Part of a motion after which forces are compared bit for bit: in all cases bodies touch then."""


def run(folder: Path, case: str, variant: str | None = None, overrides: tuple[str, ...] = ()) -> Problem:
    """Runs the case in the reference host and writes its outcome; returns the case."""
    problem = load(case, variant, overrides)
    own = folder / "reference"
    summary, fields = _run(own, problem, case, variant, overrides)
    if problem.is_static:
        arrays = {"at_displacement": fields["displacement"], **outcome.way(_steps(own, problem, fields))}
    else:
        end = MIDDLE * problem.raw["time"]["end"]
        _, middle = _run(folder / "reference-middle", problem, case, variant, (*overrides, f"time.end={end!r}"))
        arrays = {"at_displacement": middle["displacement"], "at_force": middle["contact_force"]}
    outcome.write(
        folder, "reference", problem, summary["figures"], fields["displacement"], fields["contact_force"],
        _curve(own, problem, summary), summary["iterations"], summary["seconds"], summary["contact_seconds"], arrays,
        **{key: summary.get(key) for key in ("contact_iterations", "factorisations", "updates", "nodal_penetration")},
    )  # fmt: skip
    return problem


def _run(own: Path, problem: Problem, case: str, variant: str | None, changes: tuple[str, ...]) -> tuple[dict, dict]:
    """Summary and fields at the end."""
    command = [fmc(), "run", case, "--out", str(own), "--quiet"]
    command += [] if variant is None else ["--variant", variant]
    # Nothing to look at; of a motion two frames, the start and the end.
    less = ("output.fibers=0",) if problem.is_static else ("output.frames=1", "output.animation=false")
    for change in (*changes, *less):
        command += ["--override", change]
    clock = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode > 1:
        raise RuntimeError(done.stderr)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - clock
    file = own / "equilibrium.vtu" if problem.is_static else max((own / "fields").glob("*.vtu"))
    summary = json.loads((own / "summary.json").read_text())
    # It counts the time that passes, here processor time is compared: that of the whole program, in the same parts.
    summary["contact_seconds"] *= seconds / summary["seconds"]
    summary["seconds"] = seconds
    return summary, _fields(file, problem.dim)


def _fields(file: Path, dim: int) -> dict[str, np.ndarray]:
    return {name: point_data(file, name)[:, :dim] for name in ("displacement", "contact_force")}


def point_data(file: Path, name: str) -> np.ndarray:
    """An array of the points of a VTU file of the reference host: inline, base64, not compressed."""
    for array in ElementTree.parse(file).getroot().iter("DataArray"):
        if array.get("Name") == name:
            numbers = np.frombuffer(base64.b64decode(array.text or "")[8:], np.float64)
            return numbers.reshape(-1, int(array.get("NumberOfComponents", "1")))
    raise KeyError(f"{file} has no array '{name}'")


def _steps(own: Path, problem: Problem, last: dict[str, np.ndarray]) -> list[Step]:
    """The equilibria on the way; the last one alone where the case writes no others."""
    rows, files = _rows(own / "load_steps.csv"), sorted((own / "fields").glob("*.vtu"))
    if len(files) != len(rows):
        rows, fields = rows[-1:], [last]
    else:
        fields = [_fields(file, problem.dim) for file in files]
    return [
        Step(int(row["stage"]), float(row["load"]), at["displacement"], at["contact_force"], float(row["penetration"]))
        for row, at in zip(rows, fields)
    ]


def _rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def _curve(own: Path, problem: Problem, summary: dict) -> np.ndarray:
    """What a picture shows: pressure over place, residuals, or the force on the body over its slide or time."""
    kind = problem.raw["figures"]["kind"]
    if kind == "patch":
        return np.column_stack([np.arange(len(summary["residuals"])), summary["residuals"]])
    if kind in ("ironing", "sliding"):
        rows = _rows(own / "load_steps.csv")
        last = [row for row in rows if row["stage"] == rows[-1]["stage"]]
        along = "force_x" if kind == "sliding" else f"force_{'xyz'[problem.dim - 1]}"
        return np.array([[float(row["load"]), abs(float(row[along]))] for row in last])
    if problem.is_static:
        rows = [row for row in _rows(own / "pressure.csv") if row.get("what", "nodal pressure") == "nodal pressure"]
        place = "place" if "place" in rows[0] else "x"
        return np.array([[float(row[place]), float(row["pressure"])] for row in rows])
    name, rows = problem.raw["figures"]["body"], _rows(own / "history.csv")
    columns = [f"force_{name}_{axis}" for axis in "xyz"[: problem.dim]]
    if columns[0] not in rows[0]:
        raise KeyError(f"{own / 'history.csv'} has the columns {', '.join(rows[0])}, {columns[0]} is wanted")
    forces = np.array([[float(row[column]) for column in columns] for row in rows])
    return np.column_stack([[float(row["time"]) for row in rows], np.linalg.norm(forces, axis=1)])
