"""The page docs/gallery.md: cases with their pictures, their files, and computed figures next to their references."""

from pathlib import Path

import tomllib

CASES = Path(__file__).parents[1] / "cases"
SHOWN = [
    ("star", "depth", "star.gif", "Explicit dynamics: fall, impact and rebound, with one contact evaluation per time step."),
    ("bar", "", "", "An impact with a closed form: a wave runs up the bar and back."),
    ("hertz", "", "hertz.png", "A curved body on a flat one. The pressure is known in closed form."),
    ("hertz3d", "", "", "Two elastic balls. The reference accounts for their finite size."),
    ("patch2d", "", "", "Non-matching meshes transmit a uniform pressure exactly."),
    ("wedge", "", "wedge.png", "Contact at a sharp tip."),
    ("cone", "", "cone.png", "The same problem in 3D."),
    ("punch", "", "", "Flat on flat. In theory the pressure is infinite at the corners."),
    ("ironing", "", "ironing-fibers.png", "A die is pressed in and slides. The contact moves over one element after another."),
    ("corner", "", "", "A cube is pressed corner-first into a block, deeper than one element."),
    ("snap", "", "snap.svg", "A hook snaps in and is pulled out again. The contact returns its energy."),
    ("cattaneo", "coarse", "cattaneo.svg", "Half-discs stick in the inner zone and slip in the outer one. Picture: [friction](friction.md)."),
    ("cgs4", "", "", "The NAFEMS benchmark for friction: finite sliding over non-matching meshes."),
    ("stop", "", "", "Friction stops a sliding block."),
]


def run_name(name, variant):
    return f"{name} --variant {variant}" if variant else name


def runs():
    return {run_name(name, variant) for name, variant, *_ in SHOWN}


def chapter(results, name, variant, picture, about):
    case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
    lines = [f"## {case['title']}", "", about]
    lines += [f"Source: {case['source']}."] if case.get("source") else []
    run = run_name(name, variant)
    lines += [f"[{name}.toml](../benchmarks/cases/{name}.toml) · `fmc run {run}`", ""]
    if picture:
        lines += [f"![{case['title']}]({picture})", ""]
    lines += ["| figure | computed | reference | source of the reference |", "| --- | --- | --- | --- |"]
    for check in results.run(run)["checks"]:
        missed = "" if check["ok"] else " (missed)"
        label = check["name"].replace("_", " ")
        lines.append(f"| {label} | {check['value']:.4g}{missed} | {check['reference']:.4g} | {check['source']} |")
    return lines + [""]


def page(results):
    """The text of the page."""
    lines = ["# Gallery", "", "Every case is a file; `fmc run` computes its figures, in the units of the file. `make figures` writes this page.", ""]
    lines += ["Wang, Xu and Xue: *Solving contact problems using Fiber Monte Carlo*.", ""]
    for shown in SHOWN:
        lines += chapter(results, *shown)
    return "\n".join(lines).rstrip() + "\n"
