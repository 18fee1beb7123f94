"""The same press in eight hosts: each program finds the states of scikit-fem, in as many linear solves, and they are right.

A host that is not installed is skipped by name.
"""

from pathlib import Path

import numpy as np
import pytest
from press_programs import PACKAGES, PROGRAMS, REFERENCE
from record import STEPS
from states import code_of, differences, is_installed, states

PUSH = 0.01


@pytest.fixture(params=PACKAGES)
def name(request):
    if not is_installed(request.param):
        pytest.skip(f"{request.param} is not installed: pip install {PACKAGES[request.param]}")
    return request.param


def test_all_hosts_find_the_same_states(name):
    (ours, _), (theirs, _) = states(name), states(REFERENCE)
    # Places of nodes, by another mesh generator.
    assert ours["points"].shape == (189, 3) and np.abs(ours["points"] - theirs["points"]).max() < 1e-14
    displacement, force = differences(name, REFERENCE)
    assert displacement < 1e-10 and force < 1e-9
    assert abs(ours["resultants"][0, 1, 2] / theirs["resultants"][0, 1, 2] - 1) < 1e-12
    assert ours["iterations"].tolist() == theirs["iterations"].tolist()
    assert ours["warnings"].tolist() == [""] * len(STEPS)


def test_the_program_is_short_and_prints_what_its_page_shows(name):
    assert 20 <= len(code_of(name)) <= 45
    told = [line for line in states(name)[1].splitlines() if line.startswith("pushed by")]
    assert len(told) == 2
    if name != REFERENCE:
        assert "\n".join(told) in PROGRAMS[name].with_name("README.md").read_text()


def test_forces_balance_and_follow_the_push(name):
    found, _ = states(name)
    pressed = found["resultants"][0, 1, 2]
    assert pressed > 3000
    assert np.abs(found["resultants"].sum(axis=1)).max() < 1e-9 * pressed
    # By default the contact's work on the remaining penetration is at most a thousandth of the work of the bodies' forces: as much of
    # the push is lost by penetration.
    force = dict(zip(STEPS, found["resultants"][:, 1, 2]))
    assert abs(2 * force["half way back"] / pressed - 1) < 2e-3
    assert abs(force["back"]) < 1e-3 * pressed
    assert abs(force["pressed again"] / pressed - 1) < 2e-3
    assert force["lifted off"] == 0


def test_a_block_that_is_lifted_off_is_as_it_was(name):
    found, _ = states(name)
    points, x = found["points"], found["x"][STEPS.index("lifted off")]
    lifted = points + (0, 0, PUSH / 10)
    is_lower, is_upper = (np.abs(x - expected).max(axis=1) < 1e-9 * PUSH for expected in (points, lifted))
    assert is_lower.sum() == 125 and is_upper.sum() == 64
    assert (points[is_lower, 2] < 1.001).all() and (points[is_upper, 2] > 0.999).all()


def test_every_program_of_a_host_is_run():
    assert set(PROGRAMS.values()) == set((Path(__file__).parents[2] / "hosts").rglob("press.py"))


def test_the_page_has_a_row_for_every_host():
    page = (Path(__file__).parents[2] / "docs" / "hosts.md").read_text()
    table = page.split("## The press problem")[1].split("\n## ")[0]
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines() if line.startswith("| [")]
    assert [row[0].split("]")[0][1:] for row in rows] == list(PACKAGES)
    assert [int(row[2]) for row in rows] == [len(code_of(one)) for one in PACKAGES]
