"""The example and the README run and check themselves."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent.parent


@pytest.mark.parametrize("count", [1, 3])
def test_the_block_falls_and_rebounds(count):
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
    command = ["timeout", "300", "mpirun", "--oversubscribe", "-n", str(count), sys.executable]
    run = subprocess.run(
        [*command, HERE / "examples" / "falling_block.py"], capture_output=True, text=True, env=environment
    )
    assert run.returncode == 0 and "rebound 1.00" in run.stdout, run.stdout + run.stderr


def test_a_mesh_in_parts_has_the_same_force_on_any_number_of_ranks():
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
    said = []
    for count in (1, 3, 4):
        command = ["timeout", "300", "mpirun", "--oversubscribe", "-n", str(count), sys.executable]
        run = subprocess.run(
            [*command, HERE / "examples" / "in_parts.py"], capture_output=True, text=True, env=environment
        )
        assert run.returncode == 0, run.stdout + run.stderr
        said.append(run.stdout.splitlines())
    assert len({force for force, *_ in said}) == 1
    for _, facets, _ in said:
        gathered, whole = int(facets.split()[0]), int(facets.split()[2])
        assert whole == 2 * (400 + 100 + 70 + 60) and gathered < whole / 4


def test_the_first_force_of_the_pages_runs_in_ten_lines():
    root = Path(__file__).parents[3]
    texts = [path.read_text() for path in (root / "docs" / "first-contact.md", root / "hosts" / "dolfinx" / "README.md")]
    programs = [[one.split("```")[0] for one in text.split("```python\n")[1:]] for text in texts]
    (code,) = [one for one in programs[0] if "fmc_contact_dolfinx" in one]
    assert code == programs[1][0]
    # With the line that installs.
    assert len([line for line in code.splitlines() if line.strip()]) + 1 <= 10
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    # A strip of unit width and depth 0.05: pressure k times depth makes 500, upwards.
    force = float(run.stdout.replace("[", " ").replace("]", " ").split()[1])
    assert force == pytest.approx(500.0, rel=0.02)


def test_the_search_of_the_readme_presses_a_block_on_a_plane():
    text = (HERE / "README.md").read_text()
    (code,) = [one.split("```")[0] for one in text.split("```python\n")[1:] if "find_equilibrium(" in one]
    shown = "step.result.bodies[0].force[1]"
    assert f"print(step.iterations, {shown})\n" in code
    code = code.replace(shown, shown + ", step.penetration or 0.0")
    for stiffness in ("", ", stiffness=1.6e8"):
        program = code.replace("DolfinxContact(V)", f"DolfinxContact(V{stiffness})")
        run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
        assert run.returncode == 0, run.stderr
        found = [[float(word) for word in line.split()] for line in run.stdout.splitlines()]
        for (iterations, force, left), push in zip(found, (0.002, 0.01, 0.02), strict=True):
            assert iterations <= 3
            if stiffness:
                # The block and the layer of contact, E / 1 and 160 E, one after the other. Of a residual of 1e-9 of the forces.
                assert force == pytest.approx(1e6 * push / (1 + 1 / 160), rel=1e-7)
            else:
                # The block alone, pressed by all but what it penetrates: at no node more than is told, and that is little.
                assert left < 1e-3 * push and 1e6 * (push - left) * (1 - 1e-9) <= force < 1e6 * push


def test_the_planes_of_symmetry_of_the_readme():
    text = (HERE / "README.md").read_text()
    (code,) = [one.split("```")[0] for one in text.split("```python\n")[1:] if "set_symmetry" in one]
    named = "contact.set_symmetry_boundaries([cut(block), cut(punch)], 1)\n"
    assert named in code
    for left_out, told in (("", r"The force is (\S+)\. "), (named, r"Without the planes it is (\S+), ")):
        program = code.replace(left_out, "") + "print(len(result.warnings))"
        run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
        assert run.returncode == 0, run.stderr
        force, warnings = run.stdout.splitlines()
        assert float(force.strip("[] ").split()[1]) == pytest.approx(float(re.search(told, text)[1]), abs=5e-3)
        assert int(warnings) == (1 if left_out else 0)
    # k depth over half of the width, less what the free edge of the punch loses.
    assert 0.99 < float(re.search(r"The force is (\S+)\. ", text)[1]) / (1e4 * 0.01 * 0.5) < 1.0


def test_the_iterative_solver_of_the_pages():
    page = (Path(__file__).parents[3] / "docs" / "large-problems.md").read_text()
    (piece,) = [one.split("```")[0] for one in page.split("```python\n")[1:]]
    readme = (HERE / "README.md").read_text()
    (program,) = [one.split("```")[0] for one in readme.split("```python\n")[1:] if "find_equilibrium(" in one]
    # The problem of the README, whose load steps are left out.
    assert piece.startswith("problem = ContactProblem(residual, u, bcs, contact)\n")
    before = program.split("problem = ")[0] + "bcs = [fem.dirichletbc(pushed, top)]\npushed.x.array[1::2] = -0.02\n"
    # With a stiffness, so that the force is that of a row of springs.
    before = before.replace("DolfinxContact(V)", "DolfinxContact(V, stiffness=1.6e8)")
    after = "\nprint(contact.evaluate(u).bodies[0].force[1])"
    run = subprocess.run([sys.executable, "-c", before + piece + after], capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr
    assert float(run.stdout.split()[-1]) == pytest.approx(1e6 * 0.02 / (1 + 1 / 160), rel=1e-6)
