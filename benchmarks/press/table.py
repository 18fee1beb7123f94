"""The table of docs/hosts.md: python table.py FOLDER writes table.md there, and prints which hosts are in it."""

import sys
from importlib.metadata import version
from pathlib import Path

from press_programs import FOLDERS, PACKAGES, REFERENCE
from states import code_of, differences, is_installed, states


def row(name):
    displacement, force = (f"{part:.0e}".replace("e-0", "e-") for part in differences(name, REFERENCE))
    apart = ["–", "–"] if name == REFERENCE else [displacement, force]
    solves = " ".join(str(count) for count in states(name)[0]["iterations"])
    cells = [f"[{name}](../hosts/{FOLDERS[name]}/press.py)", version(PACKAGES[name]), len(code_of(name)), *apart, solves]
    return "| " + " | ".join(map(str, cells)) + " |"


def main(folder):
    there = [name for name in PACKAGES if is_installed(name)]
    head = ["| host | version | lines | displacement | force | linear solves |", "| --- | --- | --- | --- | --- | --- |"]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "table.md").write_text("\n".join([*head, *map(row, there)]) + "\n")
    left_out = ", ".join(name for name in PACKAGES if name not in there)
    print(f"{len(there)} hosts" + (f"; not installed: {left_out}" if left_out else ""))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
