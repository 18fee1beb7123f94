"""Pictures of the pages: python -m fmc_pictures write | check [NAME ...]

`write` draws docs/NAME.svg, all or those named. `check` draws them and compares: words and shapes are equal, and no point has moved by more
than a pixel. Needs numpy, scipy, fmc_contact and the library.
"""

import re
import sys
from importlib import import_module
from pathlib import Path

DOCS = Path(__file__).parents[3] / "docs"
IDEAS = ["overlap", "meshes", "stick-slip", "corner", "deep", "second-order", "ranks", "interfaces"]
NUMBER = re.compile(r"(?<![#\w])-?\d+\.?\d*")


def drawn(name):
    return import_module(f"fmc_pictures.{name.replace('-', '_')}").picture().svg()


def differs(stored, new):
    """Whether two pictures differ for a reader."""
    if NUMBER.sub("#", stored) != NUMBER.sub("#", new):
        return True
    return any(abs(float(a) - float(b)) > 1.0 for a, b in zip(NUMBER.findall(stored), NUMBER.findall(new)))


def main(command=None, *names):
    if command not in ("write", "check"):
        sys.exit(__doc__)
    faults = []
    for name in names or IDEAS:
        file, new = DOCS / f"{name}.svg", drawn(name)
        if command == "write":
            file.write_text(new, encoding="utf-8")
        elif not file.exists() or differs(file.read_text(encoding="utf-8"), new):
            faults.append(f"docs/{name}.svg is not what the library gives: make pictures")
    print("\n".join(faults) or f"{len(names or IDEAS)} pictures")
    sys.exit(bool(faults))


main(*sys.argv[1:])
