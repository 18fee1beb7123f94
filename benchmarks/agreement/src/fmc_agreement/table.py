"""Outcomes side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from . import outcome
from .runs import Case, label


def rows(case: Case, folder: Path) -> list[dict[str, Any]]:
    """One row for every host, the reference first."""
    theirs, theirs_arrays = outcome.read(folder, "reference")
    found = [_row(case, theirs, theirs_arrays, theirs_arrays)]
    for host, ranks in case.hosts:
        summary, arrays = outcome.read(folder, label(host, ranks))
        found.append(_row(case, summary, arrays, theirs_arrays))
    return found


def _row(case: Case, summary: dict, arrays: dict, reference: dict) -> dict[str, Any]:
    checks = [one for one in summary["expected"] if one["ok"] is not None]
    row = {
        "case": case.title,
        "host": summary["host"],
        "displacement": _farthest("displacement", arrays, reference),
        "force": _farthest("force", arrays, reference),
        "history": _distance(arrays["curve"], reference["curve"]) if summary["figures"].get("impulse") else None,
        "figures": summary["figures"],
        "checks_met": sum(one["ok"] for one in checks),
        "checks": len(checks),
        "missed": [one["figure"] for one in checks if not one["ok"]],
        "iterations": summary["iterations"],
        "seconds": summary["seconds"],
        "contact_seconds": summary["contact_seconds"],
        "tolerance": case.tolerance,
    }
    if "force_at_reference" in arrays and "one_shot" in arrays:
        row["same_bits"] = bool((arrays["force_at_reference"] == arrays["one_shot"]).all())
    return row


def _farthest(key: str, one: dict, other: dict) -> float | None:
    """Distance at the end; of equilibria in several stages the largest at the ends of all. Those between stand on patches
    found on the way, which may differ."""
    ends = [_ends_of_stages(key, arrays) for arrays in (one, other)]
    if len(ends[0]) == len(ends[1]) > 1:
        return _distance(*ends)
    return _distance(one[key], other[key])


def _ends_of_stages(key: str, arrays: dict) -> np.ndarray:
    return arrays[f"way_{key}"][arrays["way"][:, 1] == 1.0] if "way" in arrays else np.empty(0)


def _distance(one: np.ndarray, other: np.ndarray) -> float | None:
    """Largest difference of any node by the largest value; ``None`` where there is nothing."""
    if one.shape != other.shape:
        return float("inf")
    largest = float(np.abs(other).max())
    return float(np.abs(one - other).max()) / largest if largest > 0.0 else None


def is_met(row: dict[str, Any]) -> bool:
    """Whether the host agrees with the reference, and gives the bits of the package where that was looked at."""
    near = all(row[key] is None or row[key] <= row["tolerance"] for key in ("displacement", "force"))
    return near and row.get("same_bits", True)


def markdown(all_rows: list[dict[str, Any]]) -> str:
    """The table of a run; docs/hosts.md has the same of the recorded one."""
    lines = [
        "| case | host | displacement | force | bit-identical | checks met | iterations | time | in contact |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    shown = None
    for row in all_rows:
        is_reference = row["host"] == "reference"
        bits = {None: "", True: "yes", False: "NO"}[row.get("same_bits")]
        share = row["contact_seconds"] / row["seconds"] if row["seconds"] else 0.0
        cells = [
            row["case"] if row["case"] != shown else "",
            row["host"],
            "–" if is_reference else _short(row["displacement"]),
            "–" if is_reference else _short(row["force"]),
            bits,
            f"{row['checks_met']} of {row['checks']}" if row["checks"] else "",
            str(row["iterations"]),
            f"{row['seconds']:.2f} s",
            f"{100 * share:.0f} %",
        ]
        shown = row["case"]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def _short(number: float | None) -> str:
    return "no force" if number is None else f"{number:.0e}".replace("e-0", "e-")
