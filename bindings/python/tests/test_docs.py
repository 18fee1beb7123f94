"""What the pages show in Python runs: every piece of code in docs, by itself or after the lines that a reader has to have already."""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from fmc_contact import Contact, PartitionedContact
from printed import differs, programs

DOCS = Path(__file__).parents[3] / "docs"

TWO_BLOCKS = """
import numpy as np
from fmc_contact import Contact, find_equilibrium

# Two squares, one on the other, each of 1e4 between its bottom and its top.
x = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.2, 1], [0.8, 1], [0.8, 2], [0.2, 2]], float)
conn = np.array([[0, 1, 2, 3], [4, 5, 6, 7]])
k, E = 1e5, 1e4
K = np.zeros((16, 16))
for square in conn:
    for axis in range(2):
        for low, high in ((square[0], square[3]), (square[1], square[2])):
            at = 2 * np.array([low, high]) + axis
            K[np.ix_(at, at)] += E / 2 * np.array([[1, -1], [-1, 1]])
first = x.copy()
host = lambda x: (K @ (x - first).ravel(), K)
free = np.r_[4:12]
loads = []
for push, slide in ((0.01, 0), (0.01, 0.005), (0.01, 0.2)):
    to = first.copy()
    to[6:] += (slide, -push)
    loads.append(to)
"""

ROUGH = """
import numpy as np
from fmc_contact import Contact, find_equilibrium

coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0.98], [1, 0.98], [1, 1.98], [0, 1.98]])
contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=1e6)
host = lambda x: (1000 * (x - coords).ravel(), 1000 * np.eye(16))
free = range(16)
"""

OF_SECOND_ORDER = """
import numpy as np
from fmc_contact import Contact

corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]], float)
rows, middles = list(corners), {}

def middle(a, b):
    key = min(a, b), max(a, b)
    if key not in middles:
        middles[key] = len(rows)
        rows.append((corners[a] + corners[b]) / 2)
    return middles[key]

def facet(*around):
    return [*around, *(middle(a, b) for a, b in zip(around, around[1:] + around[:1]))]

triangles = np.array([facet(0, 2, 1), facet(3, 4, 5)])
quads = np.array([facet(0, 1, 4, 3), facet(1, 2, 5, 4), facet(2, 0, 3, 5)])
x = np.array(rows)
"""

POINTS = """
import numpy as np
from fmc_contact import Contact

grid = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
coords = np.vstack([grid, [(grid[a] + grid[b]) / 2 for a, b in edges]])
contact = Contact(coords, [np.arange(20)], "hexahedron20", stiffness=1e6)
at_points = np.ones_like(contact.mesh.point_weights().to_points(coords))
"""

BASIS = """
import numpy as np
from fmc_contact import Contact

# Two squares that are moved by their corners alone.
q = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.99, 0], [1.99, 0], [1.99, 1], [0.99, 1]], float)
parts = np.vstack([np.eye(4), (np.eye(4) + np.roll(np.eye(4), 1, axis=1)) / 2, np.full((1, 4), 0.25)])
B = np.kron(np.eye(2), parts)
x, cells = B @ q, np.arange(18).reshape(2, 9)
"""

TWO_SQUARES = """
import numpy as np

coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.99, 0.1], [1.99, 0.1], [1.99, 0.9], [0.99, 0.9]])
squares = np.array([[0, 1, 2, 3], [4, 5, 6, 7]])
"""

TWO_HALVES = """
import numpy as np
from fmc_contact import Contact
coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1], [1, 1], [1, 2], [0, 2]], float)
contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", bodies=[0, 1], stiffness=1e3)
contact.pairs.set(0, 1, excluded=True)
cut = contact.ties.add((contact.mesh.add_surface([4]), contact.mesh.add_surface([2])))
"""

# What stands before a piece, what is checked behind it; None: the tests named run it.
PIECES = {
    "first-contact.md": [
        ("", "assert abs(result.bodies[1].force[0] - 794) < 1"),
        # Two springs of 1e4 in a row, shorter by 0.01.
        (TWO_SQUARES, "assert abs(found.result.bodies[1].force[0] - 50) < 0.1 and found.iterations == 3, found"),
        None,  # hosts/skfem/tests/test_examples.py, examples/python
        None,  # hosts/dolfinx/tests/test_examples.py
    ],
    "friction.md": [
        # Pulled by more than μ times what presses, the lower square is bent by that much.
        (
            TWO_BLOCKS,
            "N, T = (contact.evaluate(x).bodies[1].force[axis] for axis in (1, 0))\nassert N > 10 and abs(abs(T) / N - 0.3) < 0.02, (N, T)",
        ),
        # Pushed at 45°, the upper cube is held along (0.09, 0.01)/√0.1.
        (
            "import numpy as np\nfrom fmc_contact import Contact\n"
            "cube = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1.0]])\n"
            "x = np.concatenate([cube, 0.5 * cube + [0.2, 0.2, 0.999]])\n"
            "contact = Contact(x, np.arange(16).reshape(2, 8), 'hexahedron', stiffness=1e3)\n",
            "contact.friction.begin_step(x)\nx[8:, :2] += 0.1\nbody = contact.evaluate(x).bodies[1]\n"
            "held = -np.array(body.friction[:2]) / (body.force[2] - body.friction[2])\n"
            "assert np.allclose(held, np.array([0.09, 0.01]) / 0.1**0.5, atol=0.01), held",
        ),
        ("", "assert np.isclose(sheet.evaluate(square + [1.0, -0.05]).forces[:, 0].sum(), -0.3 * 100 * 0.05)"),
    ],
    "heat.md": [None],  # hosts/skfem/tests/test_docs.py
    "wear.md": [None],  # hosts/skfem/tests/test_docs.py
    "interfaces.md": [
        ("", "assert np.allclose(result.forces[4:7, 1], [-0.5, -1, -0.5])"),
        ("import numpy as np\nfrom fmc_contact import Contact", "assert left == 1 and halves.pairs.tie(0, 1).area == 1.0"),
        (
            "import numpy as np\nfrom fmc_contact import Contact",
            "sheared[2:, 0] -= 0.1\nassert np.allclose(square.ties.force(across, sheared), (100, 0))",
        ),
        # Halves that stay where they are: the force is the stiffness times the jump.
        (TWO_HALVES, "tighten(contact, cut, lambda: coords, 20.0)\nassert np.allclose(contact.ties.force(cut, coords), (0, -20))"),
        (
            "import numpy as np\nfrom fmc_contact import Contact\nconn = np.array([[0, 1, 2, 3], [4, 5, 8, 7], [5, 6, 9, 8]])\n",
            # Along the last line towards the origin from 0.03, where it was 2 · 2 · (0.1 − 0.03)/(0.1 − 0.001).
            "assert np.allclose([pull, told.dissipated], [2.8283 * 2 / 3, 0.0586], atol=1e-4), (pull, told)",
        ),
        (
            "import numpy as np\nfrom fmc_contact import Contact\nconn = np.array([[0, 1, 2, 3], [4, 5, 8, 7], [5, 6, 9, 8]])\n"
            "coords = np.array([[0, 0], [2, 0], [2, 1], [0, 1], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]], float)\n"
            "glued = Contact(coords, conn, 'quad', bodies=[0, 1, 1], stiffness=1e3)\n",
            "assert abs(-shear - 0.3 * pressed) < 1e-9 and abs(told.dissipated - 0.2) < 1e-12, (shear, pressed, told)",
        ),
        (
            "import numpy as np\nfrom fmc_contact import Contact\nconn = np.array([[0, 1, 2, 3], [4, 5, 8, 7], [5, 6, 9, 8]])\n",
            # On a length of 2, k s + c s³.
            "assert np.allclose(pull, 2 * (100 * 0.02 + 4e4 * 0.02**3)), pull",
        ),
    ],
    "gradients.md": [
        ("", "assert shape.shape == (8, 2) and abs(force) > 1"),
        # Springs of 1e3 up the sides and across, and the contact: half a force of the load for each node.
        ("", "assert found.result.forces[:, 1].sum() > 1 and not adjoint.warnings, found.result.forces"),
        ("", "assert abs(by_friction) > 1e-3 and 0.2 < by_rates[-1] < 0.4 and history.kept <= 20"),
    ],
    "large-problems.md": [None],  # hosts/dolfinx/tests
    "newton.md": [
        # The upper square stands on the lower one by its weight, and by nothing else.
        (
            TWO_BLOCKS + "load = np.zeros(16)\nload[9::2] = -1.0\nfree = np.r_[8:16]\n",
            "assert abs(found.result.bodies[1].force[1] - 4) < 1e-8, found.result.bodies",
        ),
        (
            TWO_BLOCKS + "load = np.zeros(16)\nload[9::2] = -1.0\nfree = np.r_[8:16]\n",
            "found = find_equilibrium(host, Contact(x, conn, 'quad'), x, free)\n"
            "assert abs(found.result.bodies[1].force[1] - 4) < 1e-8\n"
            "try:\n    host(np.zeros((8, 2)))\n    raise AssertionError\nexcept Refused as refused:\n"
            "    assert str(refused) == 'element 0 is inverted'",
        ),
        (ROUGH, "assert contact.evaluate(coords).penetration < 1e-9"),
        (ROUGH, "assert abs(contact.evaluate(x).bodies[1].force[1] - 20) < 0.1, contact.evaluate(x).bodies"),
        # A lid is pressed on the upper square, of 1e4 between its bottom and its top; it touches the walls beside, too, by what multipliers move
        # the face out.
        (
            TWO_BLOCKS
            + "contact, free = Contact(x, conn, 'quad'), np.r_[9:16:2]\nhost = lambda x: (K @ (x - first).ravel(), K)\n"
            + "start, way = np.array([0.5, 2]), np.array([0, -0.1])\ntool = contact.obstacles.add_half_space(start, (0, -1))\n",
            "assert abs(contact.evaluate(x).obstacles[tool].force[1] - 1000) < 15, contact.evaluate(x).obstacles",
        ),
    ],
    "second-order.md": [
        (OF_SECOND_ORDER, "assert contact.facet_count == 2 * 4 + 3 * 16, contact.facet_count"),
        (POINTS, "assert np.allclose(forces.sum(0), len(at_points)) and np.allclose(x[: len(coords)], coords)"),
        (BASIS, "assert forces.shape == q.shape and abs(forces[4:, 0].sum() - 1e6 * 0.01) < 300, forces"),
        None,  # hosts/skfem/tests/test_docs.py
    ],
    "starts.md": [None] * 5,  # hosts/skfem/tests/test_docs.py
    "troubleshooting.md": [
        # Contact pushes the first square to the left: in the residual the sign is turned.
        ("", "assert abs(residual[:8:2].sum() - 794) < 1 and matrix.any()"),
    ],
    # What draws runs in the notebook: examples/python/test_examples.py
    "tutorial-blocks.md": [None] * 7,
    "tutorial-friction.md": [
        # The figures of the table.
        ("", "assert np.allclose(pulls, [9.899, 19.797, 29.696, 30, 30], atol=1e-3), pulls"),
        None,
    ],
    "tutorial-hertz.md": [None] * 5,  # hosts/skfem/tests/test_docs.py
    "tutorial-impact.md": [
        (
            "",
            "assert np.allclose([touching[0], touching[-1]], [0.1, 2.123], atol=1e-3)\n"
            "assert abs(forces[(times > 0.5) & (times < 1.5)].mean() - 1.001e-3) < 1e-6 and abs(v[:, 0].mean() + 9.94e-3) < 1e-5\n"
            "assert 1e-4 < np.ptp(energies) / energies[0] < 1.5e-4",
        ),
        None,
    ],
}


def pieces(page):
    return [piece for piece, _ in programs(page)]


def test_every_piece_is_known():
    found = {page.name: len(pieces(page)) for page in DOCS.glob("*.md") if pieces(page)}
    assert found == {name: len(known) for name, known in PIECES.items()}


RUN_HERE = [(page, at) for page, known in PIECES.items() for at, piece in enumerate(known) if piece]


@pytest.mark.parametrize(("page", "at"), RUN_HERE)
def test_piece_runs(page, at):
    before, after = PIECES[page][at]
    piece, shown = programs(DOCS / page)[at]
    program = "\n".join([before, piece, after])
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    if shown:
        assert not differs(shown, run.stdout)


# Those that run here; hosts/skfem/tests/test_docs.py has the others.
@pytest.mark.parametrize("page", ["first-contact.md", "interfaces.md", "tutorial-friction.md", "tutorial-impact.md"])
def test_pages_show_output(page):
    assert programs(DOCS / page)[0][1]


OTHERS = sorted([*DOCS.parent.glob("tools/site/pages/*.md"), *DOCS.parent.glob("paper/paper.md")])


# A package that is tried without the checkout has none of them.
@pytest.mark.parametrize("page", OTHERS, ids=lambda page: page.name)
def test_other_pages(page):
    program, shown = programs(page)[0]
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    assert shown and not differs(shown, run.stdout)


def test_an_output_that_differs_is_seen():
    assert not differs("force [1.00000 2e-16]\n", "force [ 1.000001  0.0]\n")
    assert differs("force 1.0\n", "force 1.001\n") and differs("force 1.0\n", "forces 1.0\n") and differs("a 1\n", "a 1 2\n")


def test_attributes_that_pages_name_are_there():
    """``contact.mesh.adjust`` and the like; of an adapter ``contact.contact`` is the contact."""
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=1.0, friction_coefficient=0.3)
    contact.friction.begin_step(coords)
    of_adapters = {"force", "nodes", "size", "attach", "touched", "on_dofs", "coords", "set_surface_smoothing", "begin_step", "commit_step"}
    of_adapters |= {"set_symmetry_boundaries", "set_symmetry_regions"}
    seen = set()
    # In case files these are keys of a table.
    for page in set(DOCS.glob("*.md")) - {DOCS / "case-files.md"}:
        for name in re.findall(r"`contact((?:\.\w+)+)", page.read_text(encoding="utf-8")):
            parts = [part for part in name.split(".")[1:] if part != "contact"]
            owner, known = contact, True
            for part in parts:
                known = known and (hasattr(owner, part) or hasattr(PartitionedContact, part) or part in of_adapters or part == "add_")
                owner = getattr(owner, part, owner)
            assert known, f"{page.name}: contact{name}"
            seen.add(name)
    assert len(seen) > 20, seen
