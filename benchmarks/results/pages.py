"""Marked blocks of the pages: <!-- begin: NAME --> and <!-- end -->, filled from tables/NAME.md, or by a program that stands in BUILT."""

import re
from pathlib import Path

import case_keys
import fields
import penetration

import hosts

ROOT = Path(__file__).parents[2]
TABLES = Path(__file__).parent / "tables"
BUILT = {
    "hosts": hosts.table,
    "penetration": penetration.table,
    "beside": penetration.beside,
    "case-keys": case_keys.keys,
    "case-example": case_keys.example,
}
BLOCK = re.compile(r"(<!-- begin: ([\w-]+) -->\n)(.*?)(<!-- end -->\n)", re.S)


def all_pages():
    """Pages that have a block."""
    found = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), ROOT / "paper" / "paper.md"]
    return [path for path in found if "<!-- begin: " in path.read_text(encoding="utf-8")]


def filled(path, results):
    """The page with its blocks as the results have them."""

    def block(match):
        begin, name, _, end = match.groups()
        try:
            return begin + (BUILT[name](results) if name in BUILT else from_table(name, results)) + end
        except (ValueError, OSError) as error:
            raise ValueError(f"{path.name}, block {name}: {error}") from error

    text = path.read_text(encoding="utf-8")
    new, count = BLOCK.subn(block, text)
    if count != text.count("<!-- begin: ") or count != text.count("<!-- end -->"):
        raise ValueError(f"{path.name}: a block is not closed, or not opened")
    return new


def from_table(name, results):
    return fields.filled((TABLES / f"{name}.md").read_text(encoding="utf-8"), results)


def unused_tables():
    used = {match[2] for path in all_pages() for match in BLOCK.finditer(path.read_text(encoding="utf-8"))}
    return sorted(path.name for path in TABLES.glob("*.md") if path.stem not in used)


def runs():
    """Names of the runs that the tables ask for."""
    return {run for path in TABLES.glob("*.md") for run in fields.runs(path.read_text(encoding="utf-8"))}
