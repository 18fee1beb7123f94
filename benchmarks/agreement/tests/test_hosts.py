"""Short forms of the cases in every host, against the reference host. ``make hosts`` sets the variables that name the
programs; ``make agree`` runs the cases whole."""

import os

import numpy as np
import pytest
from fmc_agreement import outcome, reference, runs, table
from fmc_agreement import problem as problems
from fmc_agreement.runs import Case, label

if "FMC" not in os.environ:
    pytest.skip("the environment variable FMC does not name the command fmc", allow_module_level=True)

NARROW = "bodies.upper.mesh.max=[0.9, 1.0]"
"""The upper block ends before the lower one. Where their walls are flush, rounding says whether the end of one lies in the other: the
lines of the law "fiber" turn by the penetration over the width, and two equilibria stand on their own lines, 2e-5 apart."""

COARSE = "bodies.disc.mesh.finest=0.1134"
EVERY = (("skfem", 1), ("getfem", 1), ("dolfinx", 1), ("dolfinx", 3), ("petsc", 1), ("petsc", 2))
SHORT = [
    Case("hertz", None, (COARSE,), 1e-8, EVERY, True),
    Case("patch3d"),
    Case("wedge", None, ("bodies.block.mesh.cells=8", "bodies.block.mesh.shells=11")),
    Case("cone", None, ("bodies.block.mesh.cells=3", "bodies.block.mesh.shells=6", "contact.spacing=0.02")),
    Case("punch", None, ("bodies.block.mesh.cells=[10,10]", "bodies.punch.mesh.cells=[6,8]")),
    Case(
        "ironing",
        None,
        (
            "bodies.block.mesh.cells=[30,10]",
            "bodies.die.mesh.finest=0.4",
            "load_steps.then=[6]",
            "contact.stiffness=1e5",
        ),
    ),
    Case("cgs4", None, ("load_steps.then=[5]",)),
    Case("hertz", "depth", (COARSE,)),
    Case("bar", None, ("time.end=0.3",)),
    Case("star", "smooth", ("contact.stiffness=1e9", "time.end=6e-4")),
]


@pytest.mark.parametrize("case", SHORT, ids=lambda case: "-".join(filter(None, (case.name, case.variant))))
def test_hosts_agree_node_by_node(tmp_path, case):
    problem = reference.run(tmp_path, case.name, case.variant, case.changes)
    for host, ranks in case.hosts:
        runs.run(host, ranks, case, problem, tmp_path)
    rows = table.rows(case, tmp_path)
    for row in rows:
        assert table.is_met(row), row
    assert all(row["same_bits"] for row in rows if row["host"].startswith(("skfem", "dolfinx", "getfem")))
    if problem.is_static:
        for row in rows:
            # The die's figures are of equilibria on the way, on patches that are found on it.
            on_the_way = 1e-4 * rows[0]["figures"].get("force_y_mean", 0.0)
            is_figure_of(row["figures"], rows[0]["figures"], on_the_way)
    arrays = outcome.read(tmp_path, label(*case.hosts[0]))[1]
    assert np.abs(arrays["one_shot"]).max() > 0.0, "nothing touches where forces are compared"


SECOND_ORDER = [
    Case("hertz", "tri6", (COARSE,)),
    Case("hertz", "depth-quad9", ("bodies.disc.mesh.finest=0.2",)),
    Case("patch2d", "tri6-quad9", (NARROW,)),
    Case("patch3d", "tet10"),
    Case("hertz3d", "tet10", ("bodies.ball.mesh.edges=3", "bodies.ball.mesh.finest=5e-3")),
]


@pytest.mark.parametrize("case", SECOND_ORDER, ids=lambda case: f"{case.name}-{case.variant}")
def test_hosts_agree_at_second_order(tmp_path, case):
    problem = reference.run(tmp_path, case.name, case.variant, case.changes)
    for host, ranks in case.hosts:
        runs.run(host, ranks, case, problem, tmp_path)
    rows = table.rows(case, tmp_path)
    assert len(rows) == 4
    assert all(row["displacement"] <= 1e-8 and row["force"] <= 1e-8 for row in rows), rows
    for host in ("skfem", "dolfinx", "getfem"):
        arrays = outcome.read(tmp_path, host)[1]
        found, wanted = arrays["force_at_reference"], arrays["one_shot"]
        # scikit-fem counts vertices first, and may turn cells: sums are made in another order.
        assert np.abs(found - wanted).max() <= (1e-12 if host == "skfem" else 0.0) * np.abs(wanted).max()
        assert np.abs(wanted).max() > 0.0


def is_figure_of(ours, theirs, least):
    """Two programs take the figures, one in each language."""
    for key, value in theirs.items():
        if value is not None:
            # The penetration is that of the points of a quadrature, of which rounding adds some at the ends of slivers. An
            # error of rounding has no digits of its own.
            relative = 0.3 if key == "penetration_max" else 1e-7
            smallest = max(1e-9, least) if key.startswith("force") else 1e-9
            assert ours[key] == pytest.approx(value, rel=relative, abs=smallest), key


@pytest.mark.parametrize(
    "case, variant, said", [("stop", None, "moves with friction"), ("wedge", "linearised", "is linearised")]
)
def test_what_these_hosts_do_not_do_is_refused_by_name(case, variant, said):
    with pytest.raises(ValueError, match=f"'{case}' {said}"):
        problems.load(case, variant).contact_options()


def test_ranks_do_not_matter(tmp_path):
    case = Case("hertz", None, (COARSE,))
    problem = reference.run(tmp_path, case.name, None, case.changes)
    fields = {}
    for ranks in (1, 2, 4):
        runs.run("petsc", ranks, case, problem, tmp_path)
        fields[ranks] = outcome.read(tmp_path, label("petsc", ranks))[1]["displacement"]
    for ranks in (2, 4):
        assert np.abs(fields[ranks] - fields[1]).max() < 1e-10 * np.abs(fields[1]).max()


def test_a_file_that_is_no_problem_ends_every_rank(tmp_path):
    bad = tmp_path / "bad.txt"
    bad.write_text("dimension 2\nnodes 3\n0 0 1")
    import subprocess

    program = os.environ["FMC_PETSC"]
    run = subprocess.run(
        ["timeout", "10", "mpirun", "--oversubscribe", "-n", "2", program, str(bad), str(tmp_path / "out.txt")],
        capture_output=True, text=True,
        env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"},
    )  # fmt: skip
    assert run.returncode not in (0, 124) and "no problem" in run.stdout + run.stderr
