"""The page docs/gallery.md: cases with their pictures, their files, and what came out beside the references."""

from pathlib import Path

import tomllib

CASES = Path(__file__).parents[1] / "cases"
SHOWN = [
    ("star", "", "star.gif", "Explicit dynamics: fall, impact and rebound."),
    ("bar", "", "", "An impact with a closed form: the wave runs up the bar and back."),
    ("hertz", "", "hertz.png", "A curved body on a flat one, with a pressure that is known in closed form."),
    ("hertz3d", "", "", "Two elastic balls; the reference takes into account that they are of finite size."),
    ("patch2d", "", "", "Meshes that do not match pass a pressure on exactly."),
    ("wedge", "", "wedge.png", "A sharp tip: master and slave nodes fail here."),
    ("cone", "", "cone.png", "The same in space."),
    ("punch", "", "", "Flat on flat, with pressure that is infinite at the corners in theory."),
    ("ironing", "", "ironing-fibers.png", "A die is pressed in and slides: contact moves over element after element."),
    ("corner", "", "", "A cube is pressed corner-first into a block, more than a cell deep."),
    ("snap", "", "snap.svg", "A hook snaps in and is pulled out again: the energy of the contact comes back."),
    ("cattaneo", "coarse", "cattaneo.svg", "Half-discs stick inside and slip outside."),
    ("cgs4", "", "", "The NAFEMS benchmark of friction, finite sliding over meshes that do not match."),
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
    lines += ["| figure | found | reference | from |", "| --- | --- | --- | --- |"]
    for check in results.run(run)["checks"]:
        missed = "" if check["ok"] else " (missed)"
        label = check["name"].replace("_", " ")
        lines.append(f"| {label} | {check['value']:.4g}{missed} | {check['reference']:.4g} | {check['source']} |")
    return lines + [""]


def page(results):
    """The text of the page."""
    lines = ["# Gallery", "", "Part of the documentation of [fmc-contact](../README.md). Written by `make figures`.", ""]
    lines += ["Every case is a file; the figures are those of the reference host, in the units of the file.", ""]
    for shown in SHOWN:
        lines += chapter(results, *shown)
    return "\n".join(lines).rstrip() + "\n"
