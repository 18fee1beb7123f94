#!/usr/bin/env python3
"""The page "Try the law depth" has the numbers of the library: python tools/site/compare.py SITE

Random shapes, places and angles go through the page's own scripts in chromium, and through the library. Needs numpy, the package
fmc_contact and the library. Both compute closed forms; the bound is some thousand roundings, for quotients of thin overlaps.
"""

import html
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from fmc_contact import Contact

COUNT, STIFFNESS, BOUND = 40, 7.0, 1e-12

PAGE = """<!doctype html><meta charset="utf-8"><script>LAW</script><script>SHAPES_OF_THE_PAGE</script><pre id="said"></pre><script>
const cases = CASES;
const now = ([name, at, angle]) => placed(body(SHAPES[name]), at, angle);
const results = cases.map(([a, b]) => contact(STIFFNESS, now(a), now(b)));
document.getElementById("said").textContent = JSON.stringify({ shapes: SHAPES, results });
</script>"""


def in_the_browser(site, cases):
    """Outlines of the shapes, and the page's result for each case."""
    text = PAGE.replace("CASES", json.dumps(cases)).replace("STIFFNESS", str(STIFFNESS))
    for mark, name in (("LAW", "law.js"), ("SHAPES_OF_THE_PAGE", "shapes.js")):
        text = text.replace(mark, (site / "assets" / name).read_text(encoding="utf-8"))
    folder = Path(tempfile.mkdtemp())
    (folder / "page.html").write_text(text, encoding="utf-8")
    words = [shutil.which("chromium"), "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile", "--dump-dom"]
    run = subprocess.run([*words, f"file://{folder}/page.html"], capture_output=True, text=True, timeout=60, check=True)
    shutil.rmtree(folder, ignore_errors=True)
    said = json.loads(html.unescape(re.search(r'<pre id="said">(.*?)</pre>', run.stdout, re.S)[1]))
    return said["shapes"], said["results"]


def by_the_library(shapes, sides):
    """The library's result for two bodies, cut into triangles about their centres."""
    rest, now, cells = [], [], []
    for k, (name, at, angle) in enumerate(sides):
        nodes = np.array([*shapes[name], [0.0, 0.0]])
        last, first = len(nodes) - 1, sum(map(len, rest))
        cells += [[first + i, first + (i + 1) % last, first + last] for i in range(last)]
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        rest.append(nodes + [10.0 * k, 0.0])  # apart, as the depth is measured at rest
        now.append(nodes @ turn.T + at)
    return Contact(np.vstack(rest), np.array(cells), "triangle", stiffness=STIFFNESS).evaluate(np.vstack(now))


def largest_difference(ours, theirs):
    """The largest relative difference of any number of two results."""
    pair = theirs.pairs[0]
    expected = (theirs.energy, theirs.volume, pair.contact_area, pair.penetration, pair.pressure)
    got = [ours[name] for name in ("energy", "area", "length", "penetration", "pressure")]
    forces = np.abs(np.vstack(ours["forces"]) - theirs.forces).max() / np.abs(theirs.forces).max()
    return max(forces, *(abs(a - b) / abs(b) for a, b in zip(got, expected)))


def main():
    rng = np.random.default_rng(20)
    names = ["block", "star", "triangle", "hexagon", "disc"]
    place = lambda: (str(rng.choice(names)), rng.uniform(-0.9, 0.9, 2).tolist(), rng.uniform(-np.pi, np.pi))
    cases = [[place(), place()] for _ in range(COUNT)]
    shapes, results = in_the_browser(Path(sys.argv[1]), cases)
    assert sorted(shapes) == sorted(names)
    differences = []
    for case, ours in zip(cases, results):
        theirs = by_the_library(shapes, case)
        assert bool(theirs.pairs) == (ours["area"] > 0), case
        if theirs.pairs:
            differences.append(largest_difference(ours, theirs))
    assert len(differences) >= 20, f"only {len(differences)} of {COUNT} positions overlap"
    print(f"{len(differences)} positions: the page differs from the library by at most {max(differences):.1e}, relative")
    sys.exit(bool(max(differences) > BOUND))


main()
