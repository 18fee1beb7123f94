"""Coarse forms of the cases in both programs; skipped where GetFEM is missing. ``make peers-test`` sets the paths."""

import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COARSE = {
    # Contact at nodes and along facets part by how a facet carries the edge of the contact: some percent of the force where
    # few facets are in contact.
    "wedge": (["bodies.block.mesh.cells=16", "bodies.block.mesh.shells=22"], 0.01),
    "cone": (["bodies.block.mesh.fine=0.32", "bodies.block.mesh.cells=4", "bodies.block.mesh.shells=8"], 0.1),
    "hertz3d": (["bodies.ball.mesh.edges=8", "bodies.ball.mesh.finest=2e-3"], 0.03),
}


@unittest.skipUnless(importlib.util.find_spec("getfem"), "GetFEM is not installed (Debian: python3-getfem)")
@unittest.skipUnless("FMC" in os.environ, "the environment variable FMC does not name the command fmc")
class BothPrograms(unittest.TestCase):
    def test_find_one_force(self):
        for case, (changes, apart) in COARSE.items():
            with self.subTest(case=case), tempfile.TemporaryDirectory() as folder:
                words = [word for change in changes for word in ("--override", change)]
                command = [sys.executable, "-m", "fmc_peers", folder, case, "--repetitions", "1", *words]
                subprocess.run(command, check=True, capture_output=True)
                ours, *theirs = json.loads((Path(folder) / "table.json").read_text())
                self.assertTrue(theirs)
                for row in theirs:
                    self.assertGreater(row["cpu_seconds"], 0.0)
                    self.assertLess(abs(row["force"] / ours["force"] - 1.0), apart, row["program"])
                picture = (Path(folder) / case / "pressure.svg").read_text()
                # A curve of each, of more points than an axis has, and its name.
                curves = [path for path in re.findall(r'<path d="(M[^"]*)"', picture) if path.count("L") > 4]
                self.assertGreaterEqual(len(curves), 1 + len(theirs))
                for row in (ours, *theirs):
                    self.assertIn(f">{row['program']}</text>", picture)


if __name__ == "__main__":
    unittest.main()
