"""What the programs found, side by side."""

from __future__ import annotations

from statistics import median
from typing import Any

import numpy as np
from fmc_agreement.indentation import Surface, is_compared
from fmc_agreement.problem import Problem

from .measure import Run


def has_profile(problem: Problem) -> bool:
    """Whether a body is pressed on a rigid shape, so that its pressure is a curve over the place."""
    return problem.raw["figures"]["kind"] in ("wedge", "cone", "balls")


def rows(problem: Problem, runs: list[list[Run]]) -> list[dict[str, Any]]:
    """A row for every program: its repetitions in a list, ours first."""
    about = problem.about
    first = Surface(problem, about, runs[0][0].force)
    found = []
    for repeated in runs:
        run = repeated[0]
        row: dict[str, Any] = {
            "case": problem.name,
            "program": run.program,
            "cells": sum(len(body.conn) for body in problem.bodies),
            "repetitions": len(repeated),
            "cpu_seconds": median(one.total for one in repeated),
            "cpu_seconds_each": [one.seconds for one in repeated],
            "iterations": run.iterations,
            "force": force(problem, run, about),
            "friction": problem.raw["contact"].get("friction_coefficient", 0.0),
        }
        if has_profile(problem):
            own = Surface(problem, about, run.force)
            row["half_width"] = own.reach()
            row["profile_difference"] = apart(own, first)
        if problem.raw["figures"]["kind"] == "ironing":
            row["force_along"] = run.figures["force_x_mid"] if run.figures else along_at_half_slide(run.history)
        found.append(row)
    return found


def force(problem: Problem, run: Run, about: int) -> float:
    """On the body that the figures are about, along the last axis, of the whole; over a slide, the mean."""
    if problem.raw["figures"]["kind"] == "ironing":
        return run.figures["force_y_mean"] if run.figures else mean_over_slide(run.history)
    return problem.force_along_last_axis(run.force, about)


def apart(own: Surface, first: Surface) -> float:
    """Root mean square over the area of the difference of two pressures at the same nodes, by the second; without the tip,
    where both are singular."""
    tip = first.place > 0.0
    return own.distance(first.place[tip].min(), np.inf, True, lambda _: first.pressure[tip])


def mean_over_slide(history: np.ndarray) -> float:
    """Rows of stage, part of its load, force along each axis."""
    stage, load, up = history[:, 0], history[:, 1], np.abs(history[:, -1])
    return float(up[(stage == stage.max()) & is_compared(load)].mean())


def along_at_half_slide(history: np.ndarray) -> float:
    """The force along the slide, half way."""
    sliding = history[history[:, 0] == history[:, 0].max()]
    return float(sliding[np.argmin(np.abs(sliding[:, 1] - 0.5)), 2])


def markdown(everything: list[dict[str, Any]]) -> str:
    """For people."""
    heads = ["case", "program", "CPU s", "iterations", "force", "force along", "half width", "profile, L2 from fmc"]
    lines = ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    before = None
    for row in everything:
        case = f"`{row['case']}`, {row['cells']} cells" + (f", μ = {row['friction']:g}" if row.get("friction") else "")
        width, off, along = row.get("half_width"), row.get("profile_difference"), row.get("force_along")
        cells = [
            "" if case == before else case,
            row["program"],
            f"{row['cpu_seconds']:.2f}",
            str(row["iterations"] or ""),
            f"{row['force']:.6g}",
            "" if along is None else f"{along:.4g}",
            "" if width is None else f"{width:.4f}",
            "" if not off else f"{100.0 * off:.2g} %",
        ]
        lines.append("| " + " | ".join(cells) + " |")
        before = case
    return "\n".join(lines) + "\n"
