#!/usr/bin/env python3
"""References of the paper are those of docs/bibliography.md, each is cited, and each figure is there. The tables are checked by
`make figures-check`, like those of the pages."""

import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = (HERE.parent / "docs/bibliography.md").read_text(encoding="utf-8")


def entries(text):
    """Fields of every entry, by its key."""
    found = {}
    for key, fields in re.findall(r"@\w+\{(\w+),\n(.*?)\n\}", text, re.S):
        found[key] = {name: value.replace("{", "").replace("}", "") for name, value in re.findall(r"^  (\w+) = \{(.*)\},?$", fields, re.M)}
    return found


def main():
    paper = (HERE / "paper.md").read_text(encoding="utf-8")
    known = entries((HERE / "paper.bib").read_text(encoding="utf-8"))
    faults = []
    for key, fields in known.items():
        named = [fields[name] for name in ("title", "year", "eprint") if name in fields and not fields[name].startswith("[")]
        named += [author.split(",")[0] for author in fields.get("author", "").split(" and ") if author]
        # One entry of the page has all of them.
        if not any(all(one in " ".join(line.split()) for one in named) for line in re.split(r"\n(?=- )", PAGE)):
            faults.append(f"docs/bibliography.md has no entry with {named}")
    cited = set(re.findall(r"@(\w+)", paper.split("---", 2)[2]))
    faults += [f"{key} is cited, and not in paper.bib" for key in cited - set(known)] + [f"{key} is not cited" for key in set(known) - cited]
    faults += [f"no file {name}" for name in re.findall(r"!\[.*?\]\((.*?)\)", paper, re.S) if not (HERE / name).is_file()]
    print("\n".join(faults) or f"{len(known)} references of the paper are in docs/bibliography.md")
    sys.exit(bool(faults))


main()
