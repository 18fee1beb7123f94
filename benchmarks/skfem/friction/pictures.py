"""Pictures of the study: traction over the width of contact, stick and slip coloured; loops of force over displacement."""

import cylinders
import matplotlib
import numpy as np

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.hashsalt": "friction", "svg.fonttype": "none", "font.family": "sans-serif"})
from matplotlib import pyplot as plt  # noqa: E402

STICKS, SLIDES = "#2f6fb0", "#d0602a"


def _save(figure, path):
    figure.savefig(path, metadata={"Date": None} if path.suffix == ".svg" else None)
    plt.close(figure)


def tractions(states, path):
    """``states``: Q by mu P, and the facets (x, q, p, length) of one body, for each load."""
    figure, axes = plt.subplots(figsize=(7.2, 3.8), layout="constrained")
    x = np.linspace(-1.15, 1.15, 801)
    limit = cylinders.MU * cylinders.PEAK
    axes.plot(x, np.sqrt(np.clip(1 - x**2, 0, None)), color="0.6", lw=1, label="μ p")
    for dragged, (at, q, p, _) in states:
        axes.plot(x, cylinders.traction(x * cylinders.WIDTH, dragged) / limit, color="k", lw=0.8)
        slides = q > (1 - 1e-6) * cylinders.MU * p
        for which, colour in ((slides, SLIDES), (~slides, STICKS)):
            axes.plot(at[which] / cylinders.WIDTH, q[which] / limit, "o", ms=3.2, color=colour)
        middle = cylinders.traction(np.zeros(1), dragged)[0] / limit
        axes.annotate(f"Q = {dragged:g} μP", (0, middle), (0, -13), textcoords="offset points", ha="center", fontsize=9)
    axes.plot([], [], color="k", lw=0.8, label="exact")
    axes.plot([], [], "o", ms=3.2, color=STICKS, label="sticks")
    axes.plot([], [], "o", ms=3.2, color=SLIDES, label="slides")
    axes.set(xlabel="x / a", ylabel="q / μp₀", xlim=(-1.15, 1.15), ylim=(0, 1.1))
    axes.legend(frameon=False, loc="upper right", fontsize=8)
    _save(figure, path)


def loop(loads, places, path):
    figure, axes = plt.subplots(figsize=(5, 3.8), layout="constrained")
    axes.axhline(0, color="0.8", lw=0.8)
    axes.plot(np.insert(places - places[0], 0, np.nan), np.insert(loads, 0, np.nan), "-o", ms=2.5, lw=0.8, color=STICKS)
    axes.set(xlabel="displacement", ylabel="Q / μP")
    _save(figure, path)


def curves(lines, labels, path):
    """``lines``: (name, x, y) each."""
    figure, axes = plt.subplots(figsize=(5, 3.8), layout="constrained")
    for name, x, y in lines:
        axes.plot(x, y, "-o", ms=2.5, lw=0.8, label=name)
    axes.set(xlabel=labels[0], ylabel=labels[1])
    axes.legend(frameon=False, fontsize=8)
    _save(figure, path)
