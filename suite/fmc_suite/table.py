"""The results as tables of Markdown: a row for every problem, a column for every code. One rule of marks for all codes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from . import problem
from .codes import CODES

Cell = dict[str, Any]
Results = dict[tuple[str, str, str], Cell]
"""Cells by problem, code and variant."""

GRADES = ((1e-3, "good"), (1e-2, "fair"), (5e-2, "poor"))
"""Largest errors of the colours; beyond the last it is ``bad``."""


def results(folder: Path) -> Results:
    """All cells of a folder."""
    found: Results = {}
    for path in sorted(folder.glob("*--*--*.json")):
        cell = json.loads(path.read_text())
        found[cell["problem"], cell["code"], cell["variant"]] = cell
    return found


def grade(cell: Cell) -> str:
    """The colour of a cell."""
    if cell["status"] != "ok":
        return str(cell["status"]).replace("not supported", "unsupported")
    return next((name for most, name in GRADES if abs(cell["error"]) <= most), "bad")


def size(cell: Cell, bound: float) -> float:
    """Error for comparisons: what is below the bound of the reference, or below 1e-4, counts as equal."""
    return max(abs(cell["error"]), bound, 1e-4) if cell["status"] == "ok" else float("inf")


def best(found: Results, name: str) -> set[tuple[str, str, str]]:
    """The cells of a problem with the least error."""
    bound = problem.Problem.load(name).raw["reference"]["bound"]
    sizes = {key: size(cell, bound) for key, cell in found.items() if key[0] == name}
    least = min(sizes.values(), default=float("inf"))
    return {key for key, one in sizes.items() if one == least < float("inf")}


def percent(cell: Cell) -> str:
    """The error of a cell in percent with two digits, marked if the code warned."""
    error, mark = 100 * cell["error"], " (warns)" if cell["message"] else ""
    if abs(error) < 1e-4:
        return f"<0.0001 %{mark}"
    return f"{error:.0f} %{mark}" if abs(error) >= 10 else f"{error:.2g} %{mark}"


def brief(cell: Cell) -> str:
    """A cell in words."""
    if cell["status"] != "ok":
        return str(cell["status"])
    return f"{percent(cell)}, {cell['iterations']} it., {cell['cpu']:.1f} s, {cell['memory']:.0f} MB"


def text(found: Results) -> str:
    """Errors, iterations, CPU seconds and memory of whole processes; the least error of a row is bold."""
    codes = [code for code in CODES if any(key[1] == code for key in found)]
    rows = ["| problem | " + " | ".join(CODES[code].title for code in codes) + " |", "| --- " * (len(codes) + 1) + "|"]
    for name in [name for name in problem.names() if any(key[0] == name for key in found)]:
        least, row = best(found, name), [name]
        for code in codes:
            lines = []
            for variant in CODES[code].variants:
                key = name, code, variant
                if key in found:
                    words = f"{variant}: {brief(found[key])}"
                    lines.append(f"**{words}**" if key in least else words)
            row.append("<br>".join(lines) or "–")
        rows.append("| " + " | ".join(row) + " |")
    return "\n".join(rows) + "\n\n" + summary(found)


def errors(found: Results) -> str:
    """The short table: the errors of defaults, and after a stroke the least of all variants where it is another one."""
    codes = [code for code in CODES if any(key[1] == code for key in found)]
    rows = ["| problem | " + " | ".join(CODES[code].title for code in codes) + " |", "| --- " * (len(codes) + 1) + "|"]
    for name in [name for name in problem.names() if any(key[0] == name for key in found)]:
        rows.append(f"| {name} | " + " | ".join(_short(found, name, code) for code in codes) + " |")
    return "\n".join(rows) + "\n"


def _short(found: Results, name: str, code: str) -> str:
    cells = [found[name, code, variant] for variant in CODES[code].variants if (name, code, variant) in found]
    if not cells:
        return "–"
    first, least = cells[0], min(cells, key=lambda cell: size(cell, 0.0))
    words = percent(first) if first["status"] == "ok" else first["status"]
    return f"{words} / {percent(least)}" if size(least, 0.0) < size(first, 0.0) else words


def summary(found: Results) -> str:
    """How often each variant is good, fails, has the least error, and its CPU seconds in all."""
    rows = ["| code | variant | within 0.1 % | within 1 % | beyond | failed | not supported | least error | CPU s |", "| --- " * 9 + "|"]
    least = set().union(*(best(found, name) for name in problem.names()))
    for code, one in CODES.items():
        for variant in one.variants:
            cells = [cell for key, cell in found.items() if key[1:] == (code, variant)]
            if cells:
                grades = [grade(cell) for cell in cells]
                counts = [grades.count("good"), grades.count("good") + grades.count("fair"), grades.count("poor") + grades.count("bad")]
                counts += [grades.count("failed"), grades.count("unsupported"), sum(key[1:] == (code, variant) for key in least)]
                seconds = sum(cell.get("cpu", 0.0) for cell in cells)
                rows.append(f"| {one.title} | {variant} | " + " | ".join(map(str, counts)) + f" | {seconds:.0f} |")
    return "\n".join(rows) + "\n"


LEAD = """# Results

Errors by the answer; after a stroke that of the best other variant, where it is better. [README](README.md) says what is compared, and how. The
command writes this page, and a table with iterations, CPU and memory beside it.
"""


def page(found: Results) -> str:
    """The short table and the summary, as a page."""
    return "\n".join([LEAD, errors(found), summary(found)])
