#!/usr/bin/env python3
"""Figures of the paper, from recorded results: paper/figures.py write | check. suite.svg counts the errors in suite/results.md."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
KINDS = ["within 0.1 %", "0.1 to 1 %", "beyond 1 %", "failed", "not supported"]
COLOURS = ["#0b6e4f", "#8fcfb0", "#e9b44c", "#b3362c", "#c9ced6"]


def counts():
    """For each code with its defaults, how many problems are of each kind."""
    lines = (HERE.parent / "suite/results.md").read_text(encoding="utf-8").splitlines()
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines if line.startswith("| ")]
    (head,) = [row for row in rows if row[:2] == ["code", "variant"]]
    found = {}
    for row in rows:
        if len(row) == len(head) and row[1] == "default":
            columns = ("within 0.1 %", "within 1 %", "beyond", "failed", "not supported")
            close, near, beyond, failed, refused = (int(row[head.index(name)]) for name in columns)
            found[row[0]] = [close, near - close, beyond, failed, refused]
    assert len({sum(values) for values in found.values()}) == 1, found
    return found


def drawn(found):
    """Bars, one for each code."""
    left, unit, step = 190, 11, 30
    total = sum(next(iter(found.values())))
    width, height = left + total * unit + 20, 40 + step * len(found)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13">']
    at = 0
    for kind, colour in zip(KINDS, COLOURS):
        parts.append(f'<rect x="{at}" y="2" width="12" height="12" fill="{colour}"/><text x="{at + 17}" y="13">{kind}</text>')
        at += 34 + 7 * len(kind)
    for row, (code, values) in enumerate(found.items()):
        y, x = 32 + step * row, left
        parts.append(f'<text x="{left - 8}" y="{y + 15}" text-anchor="end">{code}</text>')
        for value, colour in zip(values, COLOURS):
            parts.append(f'<rect x="{x}" y="{y}" width="{value * unit}" height="21" fill="{colour}"/>')
            if value:
                ink = "#fff" if colour in ("#0b6e4f", "#b3362c") else "#111"
                parts.append(f'<text x="{x + value * unit / 2}" y="{y + 15}" text-anchor="middle" fill="{ink}">{value}</text>')
            x += value * unit
    return "\n".join([*parts, "</svg>"]) + "\n"


def main(command=None):
    file, text = HERE / "suite.svg", drawn(counts())
    if command == "write":
        file.write_text(text, encoding="utf-8")
    elif command != "check":
        sys.exit(__doc__)
    elif file.read_text(encoding="utf-8") != text:
        sys.exit("paper/suite.svg is not drawn from suite/results.md: paper/figures.py write")


main(*sys.argv[1:])
