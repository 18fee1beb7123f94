"""Curves of all hosts over one another, as SVG."""

from __future__ import annotations

import io

import matplotlib
import numpy as np
from matplotlib.figure import Figure

# Text stays text, and the same curves give the same bytes.
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "fmc", "font.size": 9})

COLOURS = ["#1e1e1e", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f", "#8c564b"]

AXES = {
    "hertz": ("place across the contact, m", "pressure, Pa"),
    "balls": ("distance from the axis, m", "pressure, Pa"),
    "wedge": ("place across the contact, m", "pressure, Pa"),
    "cone": ("distance from the axis, m", "pressure, Pa"),
    "punch": ("place across the contact, m", "pressure, Pa"),
    "ironing": ("part of the slide", "force across it, N/m"),
    "wall": ("time, s", "force on the body, N/m"),
    "impact": ("time, s", "force on the body, N/m"),
    "patch": ("iteration", "residual by the load"),
}


def overlay(kind: str, curves: dict[str, np.ndarray]) -> str:
    """Lines of different widths and dashes, the first the widest, so that those below are seen."""
    across, up = AXES.get(kind, ("", ""))
    figure = Figure(figsize=(7.9, 3.5), layout="constrained")
    axes = figure.add_subplot(xlabel=across, ylabel=up, yscale="log" if kind == "patch" else "linear")
    axes.grid(color="#e4e4e4")
    axes.spines[["top", "right"]].set_visible(False)
    for number, (name, curve) in enumerate(curves.items()):
        axes.plot(
            *curve.T,
            label=name,
            color=COLOURS[number % len(COLOURS)],
            linewidth=max(5.0 - 1.2 * number, 1.0),
            linestyle="-" if number == 0 else (0, (3 + number, 2 + number)),
            alpha=0.35 if number == 0 else 1.0,
        )
    if kind != "patch":
        axes.set_ylim(bottom=min(axes.get_ylim()[0], 0.0))
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    written = io.StringIO()
    figure.savefig(written, format="svg", metadata={"Date": None})
    return written.getvalue()
