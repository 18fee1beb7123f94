"""Recorded results: what each run found, by its name."""

import json
from dataclasses import dataclass
from pathlib import Path

FILE = Path(__file__).parents[2] / "docs" / "results.json"


@dataclass(frozen=True)
class Results:
    """Runs by name. A case's is what stands after ``fmc run``; those of other programs begin with that program's name and a slash.

    A run has ``figures``; that of a case also ``checks``, each with name, value, reference, ok and source.
    """

    runs: dict

    @classmethod
    def read(cls):
        return cls(json.loads(FILE.read_text(encoding="utf-8"))["runs"])

    def run(self, name):
        if name not in self.runs:
            raise ValueError(f"no run '{name}' in {FILE.name}: make figures")
        return self.runs[name]

    def figure(self, name, figure):
        figures = self.run(name)["figures"]
        if figures.get(figure) is None:
            raise ValueError(f"'{name}' has no figure '{figure}', it has {', '.join(figures)}")
        return figures[figure]

    def reference(self, name, figure):
        """The one reference with which a figure is checked."""
        found = [check["reference"] for check in self.run(name).get("checks", []) if check["name"] == figure]
        if len(found) != 1:
            raise ValueError(f"'{name}' has {len(found)} references for '{figure}', one is wanted")
        return found[0]
