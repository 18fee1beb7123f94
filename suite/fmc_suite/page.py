"""The results as one page of HTML without scripts: the summary, and every problem with its picture and all its cells."""

from __future__ import annotations

from html import escape
from pathlib import Path

from . import table
from .codes import CODES
from .picture import svg
from .problem import Problem, names

STYLE = """body{font:15px/1.45 sans-serif;max-width:72em;margin:2em auto;padding:0 1em}
table{border-collapse:collapse;margin:.6em 0}td,th{border:1px solid #bbb;padding:.2em .5em;text-align:left;font-size:13px}
.good{background:#c9e7c6}.fair{background:#e9f2c0}.poor{background:#fbe3b4}.bad{background:#f6c4b4}.failed{background:#e6a7a0}
.unsupported{background:#e4e4e4}.least{font-weight:bold}section{display:flex;gap:2em;flex-wrap:wrap;border-top:1px solid #ccc;padding:1em 0}
code{font-size:12px}"""

LEAD = """<p>Every code gets the same meshes of linear quadrilaterals or hexahedra, nodal loads and held nodes, and returns displacements, which are
measured in one way. The defaults of each code come first, then the options that its own pages advise. CPU and memory are those of
the whole process. An error includes that of the mesh, which all codes share. What is below the bound of the reference counts as equal;
the least error is bold.</p><p><span class="good">&nbsp;to 0.1 %&nbsp;</span> <span class="fair">&nbsp;to 1 %&nbsp;</span>
<span class="poor">&nbsp;to 5 %&nbsp;</span> <span class="bad">&nbsp;beyond&nbsp;</span> <span class="failed">&nbsp;failed&nbsp;</span>
<span class="unsupported">&nbsp;not supported&nbsp;</span></p>"""


def write(folder: Path) -> Path:
    """Writes ``index.html`` for the results of a folder."""
    found = table.results(folder)
    shown = [name for name in names() if any(key[0] == name for key in found)]
    parts = ["<!doctype html><html lang=en><meta charset=utf-8><title>Contact problems with known answers</title>", f"<style>{STYLE}</style>"]
    parts += ["<h1>Contact problems with known answers</h1>", LEAD, _overview(found, shown), _markdown(table.summary(found))]
    parts += [_problem(found, name) for name in shown]
    path = folder / "index.html"
    path.write_text("\n".join(parts) + "\n")
    return path


def _overview(found: table.Results, shown: list[str]) -> str:
    """Errors alone: a row for every problem, a column for every variant."""
    columns = [(code, variant) for code, one in CODES.items() for variant in one.variants if any(key[1:] == (code, variant) for key in found)]
    head = "".join(f"<th>{escape(CODES[code].title)}<br>{escape(variant)}" for code, variant in columns)
    rows = []
    for name in shown:
        least = table.best(found, name)
        cells = [_mark(found.get((name, *column)), (name, *column) in least) for column in columns]
        rows.append(f'<tr><td><a href="#{name}">{name}</a>' + "".join(cells))
    return f"<table><tr><th>problem{head}{''.join(rows)}</table>"


def _mark(cell: table.Cell | None, is_least: bool) -> str:
    if cell is None:
        return "<td>–"
    words = escape(table.percent(cell)) if cell["status"] == "ok" else cell["status"]
    return f'<td class="{table.grade(cell)}{" least" if is_least else ""}" title="{escape(cell.get("message", ""))}">{words}'


def _problem(found: table.Results, name: str) -> str:
    """One problem: picture, reference, and a row for every variant of every code."""
    problem = Problem.load(name)
    raw, reference = problem.raw, problem.raw["reference"]
    least, rows = table.best(found, name), []
    for code, one in CODES.items():
        for variant, advice in one.variants.items():
            cell = found.get((name, code, variant))
            if cell:
                rows.append(_row(cell, one.title, advice, (name, code, variant) in least))
    size = f"{len(problem.points)} points, {sum(len(body.cells) for body in problem.bodies)} cells"
    told = f"<p>{escape(raw['figure']['name'])}: <b>{problem.reference:.6g}</b>, bound {reference['bound']:g}. "
    told += f"{escape(reference['source'])}. {size}.</p>"
    head = "<tr><th>code<th>variant<th>error<th>iterations<th>CPU s<th>MB<th>again"
    return f'<h2 id="{name}">{escape(raw["title"])}</h2><section>{svg(problem)}<div>{told}<table>{head}{"".join(rows)}</table></div></section>'


def _row(cell: table.Cell, title: str, advice: str, is_least: bool) -> str:
    again = f"python -m fmc_suite cell {cell['problem']} {cell['code']} '{cell['variant']}'"
    if cell["status"] == "ok":
        numbers = f"<td>{cell['iterations']}<td>{cell['cpu']:.1f}<td>{cell['memory']:.0f}"
    else:
        numbers = f"<td colspan=3>{escape(cell.get('message', '')[:120])}"
    return f'<tr><td>{escape(title)}<td title="{escape(advice)}">{escape(cell["variant"])}{_mark(cell, is_least)}{numbers}<td><code>{again}</code>'


def _markdown(text: str) -> str:
    """A table of Markdown as one of HTML."""
    rows = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("|") and "---" not in line]
    head, *body = ["".join(f"<td>{escape(one)}" for one in row) for row in rows]
    return f"<table><tr>{head.replace('<td>', '<th>')}{''.join(f'<tr>{row}' for row in body)}</table>"
