"""``python -m fmc_suite run | cell PROBLEM CODE [VARIANT] | table | page | list``."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from . import cell, problem
from .codes import CODES


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m fmc_suite", description="Contact problems with known answers, solved by several codes.")
    parser.add_argument("--out", type=Path, default=Path("out/suite"), help="folder of the results (default: out/suite)")
    does = parser.add_subparsers(dest="does", required=True)
    run = does.add_parser("run", help="all cells that have no result yet")
    run.add_argument("--problem", action="append", choices=problem.names())
    run.add_argument("--code", action="append", choices=list(CODES))
    run.add_argument("--again", action="store_true", help="also those that have a result")
    run.add_argument("--seconds", type=float, default=cell.SECONDS, help="limit for each cell")
    one = does.add_parser("cell", help="one cell, printed")
    one.add_argument("problem", choices=problem.names())
    one.add_argument("code", choices=list(CODES))
    one.add_argument("variant", nargs="?", default="default")
    does.add_parser("table", help="table.md of all results")
    does.add_parser("page", help="index.html of all results, with a picture of every problem")
    does.add_parser("list", help="the problems with their references")
    words = parser.parse_args()
    DOES[words.does](words)


def _run(words: argparse.Namespace) -> None:
    for name in words.problem or problem.names():
        for code in words.code or CODES:
            for variant in CODES[code].variants:
                if words.again or not cell.path(words.out, code, variant, name).exists():
                    _say(cell.run(words.out, code, variant, name, words.seconds))
    _table(words)


def _say(found: dict[str, object]) -> None:
    text = f"{found['error']:+.2e}, {found['iterations']} iterations" if found["status"] == "ok" else found["message"]
    print(f"{found['problem']:18} {found['code']:10} {found['variant']:12} {found['status']}: {text}", flush=True)


def _cell(words: argparse.Namespace) -> None:
    print(json.dumps(cell.run(words.out, words.code, words.variant, words.problem), indent=1))


def _list(words: argparse.Namespace) -> None:
    for name in problem.names():
        one = problem.Problem.load(name)
        raw = one.raw
        print(f"{name}: {raw['title']}\n    {raw['figure']['name']} {one.reference:.6g}: {raw['reference']['source']}")


def _table(words: argparse.Namespace) -> None:
    from . import table

    words.out.mkdir(parents=True, exist_ok=True)
    found = table.results(words.out)
    (words.out / "table.md").write_text(table.text(found))
    (words.out / "results.md").write_text(table.page(found))


def _page(words: argparse.Namespace) -> None:
    from . import page

    page.write(words.out)


DOES = {"run": _run, "cell": _cell, "list": _list, "table": _table, "page": _page}

if __name__ == "__main__":
    main()
