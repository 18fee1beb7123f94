"""What a host found, in files that can be compared: ``HOST.json`` and ``HOST.npz``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from .figures import judged
from .problem import Problem


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


def read(folder: Path, host: str) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Summary and arrays."""
    return json.loads((folder / f"{host}.json").read_text()), dict(np.load(folder / f"{host}.npz"))
