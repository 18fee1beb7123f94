"""Contact of CalculiX by this library: agreement with `fmc solve`, balance of forces, convergence, and what is refused."""

import os
import subprocess
from pathlib import Path

import compare
import decks
import numpy as np
import pytest

# Both programs iterate to residuals of 1e-9 of the forces; the bracket bends, so its displacements follow less closely.
SAME = 1e-8
# A .dat file has seven digits, the table of `fmc solve` six.
PRINTED = 1e-5


@pytest.mark.parametrize("name", list(decks.DECKS))
def test_displacements_and_reactions_are_those_of_fmc_solve(name: str, tmp_path: Path) -> None:
    difference, ours, theirs, _, _ = compare.compare(name, tmp_path)
    assert difference < SAME
    assert np.abs(ours - theirs).max() < PRINTED * np.abs(theirs).max()


@pytest.mark.parametrize("kind", ["C3D8", "C3D10", "C3D20"])
def test_elements_of_other_types_agree(kind: str, tmp_path: Path) -> None:
    deck = decks.punch(kind)
    ours, theirs = compare.by_ccx("punch", deck, tmp_path / "a"), compare.by_solve("punch", deck, tmp_path / "b")
    assert compare.same_places("punch", ours, theirs) < SAME


# One point of integration makes cells of first order softer: a tenth was measured with these cells.
@pytest.mark.parametrize(("kind", "apart"), [("C3D8I", 0.05), ("C3D8R", 0.15), ("C3D20R", 0.05)])
def test_variants_and_large_displacements_are_solved(kind: str, apart: float, tmp_path: Path) -> None:
    full = decks.punch(kind[:-1])
    deck = full.replace(f"TYPE={kind[:-1]}", f"TYPE={kind}").replace("*STEP", "*STEP, NLGEOM")
    ours = compare.by_ccx("punch", deck, tmp_path / "a")
    # Strains are below 2 %: the force is near that of full integration and small strains.
    assert abs(ours.reaction[2] / compare.by_ccx("punch", full, tmp_path / "b").reaction[2] - 1) < apart


@pytest.mark.parametrize("name", ["punch", "hertz"])
def test_friction_is_that_of_fmc_solve(name: str, tmp_path: Path) -> None:
    deck = decks.DECKS[name]().replace("*CONTACT PAIR", "*FRICTION\n0.3, 1e6\n*CONTACT PAIR")
    ours, theirs = compare.by_ccx(name, deck, tmp_path / "a"), compare.by_solve(name, deck, tmp_path / "b")
    assert compare.same_places(name, ours, theirs) < SAME
    if name == "punch":
        # It shifts the punch: without friction its force is straight up.
        assert abs(ours.reaction[0]) > 1e-3 * abs(ours.reaction[2])


def test_forces_of_contact_balance_the_reaction(tmp_path: Path) -> None:
    ours = compare.by_ccx("punch", decks.punch(), tmp_path)
    table = np.loadtxt(tmp_path / "punch.fmc.csv", delimiter=",", skiprows=1)
    force, size = table[:, 6:9], np.abs(table[:, 6:9]).sum()
    assert np.abs(force.sum(axis=0)).max() < 1e-12 * size
    # The block has the first 6 × 6 × 4 nodes, and is held at its bottom alone.
    on_block = force[table[:, 2] <= 144].sum(axis=0)
    assert np.abs(on_block + ours.reaction).max() < 1e-6 * np.abs(ours.reaction).max()


def test_convergence_is_quadratic(tmp_path: Path) -> None:
    steps = compare.corrections(compare.by_ccx("punch", decks.punch(), tmp_path).log)
    # Once the facets in contact stay the same: the order of the last two corrections.
    order = np.log(steps[-1] / steps[-2]) / np.log(steps[-2] / steps[-3])
    assert order > 1.7, steps


def test_nodes_in_contact_may_be_in_equations(tmp_path: Path) -> None:
    # The bottom of the punch stays flat: all its nodes go up and down with the first.
    deck = decks.punch()
    lines = deck.split("\n")
    begin = lines.index("*NSET, NSET=PUNCH_Z0") + 1
    nodes = [int(line.strip(",")) for line in lines[begin : begin + 16]]
    equations = "".join(f"*EQUATION\n2\n{node}, 3, 1., {nodes[0]}, 3, -1.\n" for node in nodes[1:])
    ours = compare.by_ccx("punch", deck.replace("*STEP\n", equations + "*STEP\n"), tmp_path)
    height = ours.displacements[np.isin(ours.labels, nodes), 2]
    assert np.ptp(height) < 1e-12 and height.max() < -1e-3
    # A flat punch is stiffer, and without the right factors in the tangent convergence is not quadratic.
    assert ours.reaction[2] > compare.by_ccx("punch", deck, tmp_path / "free").reaction[2]
    steps = compare.corrections(ours.log)
    assert np.log(steps[-1] / steps[-2]) / np.log(steps[-2] / steps[-3]) > 1.7, steps


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("OVERCLOSURE=LINEAR", "OVERCLOSURE=TIED", "PRESSURE-OVERCLOSURE=TIED is not known to fmc-contact: use *TIE"),
        ("TYPE=NODE TO SURFACE", "TYPE=NODE TO SURFACE, ADJUST=0.1", "ADJUST of *CONTACT PAIR is not known"),
        ("*STATIC\n1., 1.", "*DYNAMIC\n1., 1.", "contact is known in *STATIC steps"),
        ("TYPE=C3D4", "TYPE=C3D4, ELSET=ALL\n*ELEMENT, TYPE=CPS3", "of type"),
    ],
)
def test_what_is_not_known_ends_ccx_with_its_name(old: str, new: str, message: str, tmp_path: Path) -> None:
    deck = decks.punch().replace("*ELASTIC\n", "*DENSITY\n1.,\n*ELASTIC\n").replace(old, new)
    if "CPS3" in new:
        deck = decks.punch().replace(
            "*CONTACT PAIR",
            "*NODE\n9001, 9., 0., 0.\n9002, 9.5, 0., 0.\n9003, 9., 1., 0.\n"
            "*ELEMENT, TYPE=CPS3, ELSET=FLAT\n9001, 9001, 9002, 9003\n"
            "*SOLID SECTION, ELSET=FLAT, MATERIAL=STEEL\n1.,\n*CONTACT PAIR",
        )
        deck = deck.replace("*SURFACE, NAME=MASTER, TYPE=ELEMENT\n", "*SURFACE, NAME=MASTER, TYPE=ELEMENT\n9001, S1\n")
    (tmp_path / "deck.inp").write_text(deck)
    done = subprocess.run([os.environ["CCX_FMC"], "deck"], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert done.returncode == 201
    assert "*ERROR in fmc-contact" in done.stdout and message in done.stdout, done.stdout[-2000:]


def test_own_contact_stays_at_hand(tmp_path: Path) -> None:
    (tmp_path / "punch.inp").write_text(decks.punch())
    log = compare.run([os.environ["CCX_FMC"], "punch"], tmp_path, "own")
    assert "Number of contact spring elements" in log and "fmc-contact" not in log
