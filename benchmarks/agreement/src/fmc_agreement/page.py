"""The HTML page of ``make agree``: nothing but this file is needed to read it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from . import outcome
from .picture import overlay
from .problem import Problem
from .runs import Case, label
from .table import is_met


def write(path: Path, done: list[tuple[Case, Problem, Path, list[dict[str, Any]]]], notes: str) -> None:
    """``done``: every case with its folder and its rows."""
    environment = Environment(
        loader=PackageLoader("fmc_agreement", "."), autoescape=True, undefined=StrictUndefined, trim_blocks=True
    )
    environment.filters["figure"] = _figure
    cases = [_case(*one) for one in done]
    path.write_text(environment.get_template("page.html").render(cases=cases, notes=notes))


def _case(case: Case, problem: Problem, folder: Path, rows: list[dict[str, Any]]) -> dict[str, Any]:
    names = ["reference", *(label(host, ranks) for host, ranks in case.hosts)]
    curves = {name: outcome.read(folder, name)[1]["curve"] for name in names}
    return {
        "title": case.title,
        "about": problem.raw["title"],
        "rows": [{"same_bits": None, **row, "is_met": is_met(row)} for row in rows],
        "expected": {
            one["figure"]: f"{one['value']:.6g} ± {one['tolerance']:.1g}"
            for one in reversed(problem.raw["expected"])
            if one["tolerance"] is not None
        },
        "picture": _inline(overlay(problem.raw["figures"]["kind"], curves)),
    }


def _inline(svg: str) -> str:
    """A picture as part of a page: without what stands before its root."""
    return svg[svg.index("<svg") :]


def _figure(value: float | None, digits: int = 1) -> str:
    return "" if value is None else f"{value:.{digits}g}"
