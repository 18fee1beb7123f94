"""The press of MFEM from C++: the program of hosts/mfem is compiled against the wheel, and finds the states of the program in Python."""

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from press_programs import PROGRAMS
from states import is_installed

ROOT = Path(__file__).parents[2]
SOURCE = PROGRAMS["MFEM"].with_suffix(".cpp")

# Any stiffness will do: with one that is given the equilibrium does not depend on how it is found.
STIFFNESS = 1e7

IN_PYTHON = """
import runpy, sys
import fmc_contact
import numpy as np

contact, find, states = fmc_contact.Contact, fmc_contact.find_equilibrium, []
fmc_contact.Contact = lambda *mesh: contact(*mesh, stiffness=float(sys.argv[2]))

def recorded(host, contact, *rest):
    found = find(host, contact, *rest)
    states.append((contact.coords(found.x) - contact.coords(0 * found.x), found.result.bodies[1].force[2]))
    return found

fmc_contact.find_equilibrium = recorded
runpy.run_path(sys.argv[1])
np.savez(sys.argv[3], u=[u for u, _ in states], force=[force for _, force in states])
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    if not is_installed("MFEM") or shutil.which("c++") is None:
        pytest.skip("MFEM from C++ needs a compiler and the wheel: pip install mfem")
    import fmc_contact._library as ours

    folder, wheel = tmp_path_factory.mktemp("cpp"), Path(find_spec("mfem").submodule_search_locations[0]) / "external" / "ser"
    # The program asks for the library by its soname.
    version = (ROOT / "Cargo.toml").read_text().split('version = "')[1].split('"')[0].rsplit(".", 1)[0]
    (folder / f"libfmc_contact.so.{version}").symlink_to(Path(ours.library._name).resolve())
    command = ["c++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-I", ROOT / "include", "-isystem", wheel / "include", SOURCE]
    command += ["-o", folder / "press", "-L", wheel / "lib", "-lmfem", folder / f"libfmc_contact.so.{version}"]
    command += [f"-Wl,-rpath,{folder}:{wheel / 'lib'}"]
    subprocess.run(command, check=True)
    return folder / "press"


def test_the_page_shows_what_it_prints(program):
    told = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    assert len(told.splitlines()) == 2 and told in SOURCE.with_name("README.md").read_text()
    assert len([line for line in SOURCE.read_text().splitlines() if line.strip() and not line.lstrip().startswith("//")]) <= 60


def test_both_languages_find_one_state(program, tmp_path):
    subprocess.run([program, tmp_path / "cpp.txt", str(STIFFNESS)], check=True)
    script = [sys.executable, "-c", IN_PYTHON, PROGRAMS["MFEM"], str(STIFFNESS), tmp_path / "python.npz"]
    subprocess.run(script, check=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    theirs = np.load(tmp_path / "python.npz")
    ours = np.loadtxt(tmp_path / "cpp.txt").reshape(theirs["u"].shape)
    assert theirs["u"].shape == (2, 189, 3) and theirs["force"][0] > 3000
    # Both iterate to the rounding of their residuals.
    assert np.abs(ours - theirs["u"]).max() < 1e-10 * np.abs(theirs["u"]).max()
