"""Writes docs/gallery.md: cases with their pictures, their files, and what came out beside the references.

    python3 benchmarks/gallery/gallery.py target/release/fmc docs/gallery.md
"""

import json
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

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


def figure(number: float) -> str:
    """Four digits."""
    return f"{number:.4g}"


def chapter(fmc: str, name: str, variant: str, picture: str, about: str) -> list[str]:
    case = tomllib.loads((CASES / f"{name}.toml").read_text())
    with tempfile.TemporaryDirectory() as folder:
        command = [fmc, "run", str(CASES / f"{name}.toml"), "--json", "--out", folder] + (["--variant", variant] if variant else [])
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    found = json.loads(run.stdout)
    lines = [f"## {case['title']}", "", about]
    lines += [f"Source: {case['source']}."] if case.get("source") else []
    command = f"`fmc run {name}{f' --variant {variant}' if variant else ''}`"
    lines += [f"[{name}.toml](../benchmarks/cases/{name}.toml) · {command}", ""]
    if picture:
        lines += [f"![{case['title']}]({picture})", ""]
    lines += ["| figure | found | reference | from |", "| --- | --- | --- | --- |"]
    for check in found["checks"]:
        missed = "" if check["ok"] else " (missed)"
        label = check["name"].replace("_", " ")
        lines.append(f"| {label} | {figure(check['value'])}{missed} | {figure(check['reference'])} | {check['source']} |")
    return lines + [""]


def main(fmc: str, page: str) -> None:
    lines = ["# Gallery", "", "Part of the documentation of [fmc-contact](../README.md). Written by `make gallery`.", ""]
    lines += ["Every case is a file; the figures are those of the reference host, in the units of the file.", ""]
    for number, shown in enumerate(SHOWN):
        print(f"{number + 1} of {len(SHOWN)}: {shown[0]}", file=sys.stderr, flush=True)
        lines += chapter(fmc, *shown)
    Path(page).write_text("\n".join(lines).rstrip() + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
