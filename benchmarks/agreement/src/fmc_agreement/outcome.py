"""What a host found, in files that can be compared: ``HOST.json`` and ``HOST.npz``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from .figures import at_rest, judged, motion
from .leapfrog import History
from .problem import Problem
from .solved import Solved, Step


def write(
    folder: Path,
    host: str,
    problem: Problem,
    figures: dict[str, float],
    displacement: np.ndarray,
    force: np.ndarray,
    curve: np.ndarray,
    iterations: int,
    seconds: float,
    contact_seconds: float,
    arrays: dict[str, np.ndarray] | None = None,
    **more: Any,
) -> None:
    """``displacement`` and ``force`` (nodes, dim) of the contact, in the case's numbering, at the end; ``curve``
    (points, 2) is what a picture shows. ``arrays`` go beside them, ``more`` into the summary."""
    folder.mkdir(parents=True, exist_ok=True)
    summary = {
        "case": problem.name,
        "variant": problem.raw["variant"],
        "host": host,
        "figures": figures,
        "expected": judged(problem, figures),
        "iterations": iterations,
        "seconds": seconds,
        "contact_seconds": contact_seconds,
        **more,
    }
    (folder / f"{host}.json").write_text(json.dumps(summary, indent=2) + "\n")
    np.savez(folder / f"{host}.npz", displacement=displacement, force=force, curve=curve, **(arrays or {}))


def of_equilibrium(
    folder: Path,
    host: str,
    problem: Problem,
    solved: Solved,
    figures: dict[str, float],
    arrays: dict[str, np.ndarray],
    **more: Any,
) -> None:
    """Writes what a solver found; ``figures`` are those that only the host can take."""
    found, curve = at_rest(problem, solved)
    last = solved.steps[-1]
    write(
        folder, host, problem, {**figures, **found}, last.displacement, last.force, curve, solved.iterations,
        solved.seconds, solved.contact_seconds, {**way(solved.steps), **arrays},
        contact_iterations=solved.contact_iterations, factorisations=solved.factorisations, updates=solved.updates, **more,
    )  # fmt: skip


def of_motion(
    folder: Path,
    host: str,
    problem: Problem,
    history: History,
    masses: np.ndarray,
    displacement: np.ndarray,
    force: np.ndarray,
    arrays: dict[str, np.ndarray],
    **more: Any,
) -> None:
    """Writes what time steps came to; ``masses`` of the bodies."""
    about = problem.about
    curve = np.column_stack([history.time, np.linalg.norm(np.array(history.bodies)[:, about], axis=1)])
    write(
        folder, host, problem, motion(problem, history, masses), displacement, force, curve, len(history.time) - 1,
        history.seconds, history.contact_seconds, arrays, **more,
    )  # fmt: skip


def way(steps: list[Step]) -> dict[str, np.ndarray]:
    """All equilibria as arrays of an outcome: stage and load (steps, 2), displacements and forces (steps, nodes, dim),
    penetrations (steps,)."""
    return {
        "way": np.array([[step.stage, step.load] for step in steps]),
        "way_displacement": np.array([step.displacement for step in steps]),
        "way_force": np.array([step.force for step in steps]),
        "way_penetration": np.array([step.penetration for step in steps]),
    }


def read(folder: Path, host: str) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Summary and arrays."""
    return json.loads((folder / f"{host}.json").read_text()), dict(np.load(folder / f"{host}.npz"))
