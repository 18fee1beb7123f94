"""The HTML page of ``make agree``: nothing but this file is needed to read it."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from . import outcome
from .picture import overlay
from .problem import Problem
from .runs import Case, label
from .table import is_met

STYLE = """
body { font: 16px/1.45 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; color: #1e1e1e; }
table { border-collapse: collapse; margin: .5rem 0 1rem; } th, td { padding: .2rem .7rem; text-align: right; }
th:first-child, td:first-child { text-align: left; } tr { border-bottom: 1px solid #ddd; } .bad { color: #b00020;
font-weight: 600; } svg { max-width: 100%; } svg text { font-size: 12px; fill: #444; } .grid { stroke: #e4e4e4; }
"""


def write(path: Path, done: list[tuple[Case, Problem, Path, list[dict[str, Any]]]], notes: str) -> None:
    """``done``: every case with its folder and its rows."""
    parts = [
        "<!doctype html><html lang='en'><meta charset='utf-8'><meta name='viewport' content='width=device-width'>",
        f"<title>fmc-contact: the hosts agree</title><style>{STYLE}</style><h1>The same cases in every host</h1>",
        "<p>Differences are the largest of any node from the reference host, by the largest value.</p>",
    ]
    for case, problem, folder, rows in done:
        parts += [
            f"<h2>{escape(case.title)}</h2><p>{escape(problem.raw['title'])}</p>",
            _table(rows),
            _figures(rows, problem),
        ]
        names = ["reference", *(label(host, ranks) for host, ranks in case.hosts)]
        curves = {name: outcome.read(folder, name)[1]["curve"] for name in names}
        parts.append(overlay(problem.raw["figures"]["kind"], curves))
    parts.append(f"<h2>Adapters</h2><pre>{escape(notes)}</pre>")
    path.write_text("\n".join(parts))


def _table(rows: list[dict[str, Any]]) -> str:
    heads = ["host", "displacement", "force", "same bits", "iterations", "time, s", "in contact, s"]
    lines = ["<table><tr>" + "".join(f"<th>{head}</th>" for head in heads) + "</tr>"]
    for row in rows:
        bits = {None: "", True: "yes", False: "no"}[row.get("same_bits")]
        cells = [row["host"], _number(row["displacement"]), _number(row["force"]), bits, str(row["iterations"])]
        cells += [f"{row['seconds']:.2f}", f"{row['contact_seconds']:.2f}"]
        mark = "" if is_met(row) else " class='bad'"
        lines.append(f"<tr{mark}>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>")
    return "\n".join([*lines, "</table>"])


def _figures(rows: list[dict[str, Any]], problem: Problem) -> str:
    keys = list(rows[0]["figures"])
    lines = ["<table><tr><th>figure</th><th>expected</th>"]
    lines.append("".join(f"<th>{escape(row['host'])}</th>" for row in rows) + "</tr>")
    for key in keys:
        expected = [e for e in problem.raw["expected"] if e["figure"] == key and e["tolerance"] is not None]
        wanted = f"{expected[0]['value']:.6g} ± {expected[0]['tolerance']:.1g}" if expected else ""
        cells = "".join(
            f"<td{' class=bad' if key in row['missed'] else ''}>{_number(row['figures'].get(key), 6)}</td>"
            for row in rows
        )
        lines.append(f"<tr><td>{escape(key)}</td><td>{wanted}</td>{cells}</tr>")
    return "\n".join([*lines, "</table>"])


def _number(value: float | None, digits: int = 1) -> str:
    return "" if value is None else f"{value:.{digits}g}"
