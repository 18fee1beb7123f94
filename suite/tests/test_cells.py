"""A few cells of fmc-contact, and the parts that measure them: about a minute."""

import json
import subprocess

import numpy as np
import pytest
from fmc_suite import cell, elastic, page, table
from fmc_suite.codes import CODES
from fmc_suite.problem import Problem
from skfem import Basis, ElementQuad1, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

LIMITS = {
    "patch-2d": 1e-3,
    "patch-3d": 1e-3,
    "patch-2d-oblique": 1e-3,
    "patch-3d-oblique": 1e-3,
    "touching": 1e-4,
    "gap": 1e-4,
    "stack": 1e-3,
    "unload": 1e-3,
    "tied-patch": 1e-9,
    "slide": 1e-3,
}
"""Largest errors: some times what was found, 2e-5 to 3e-4, which the penetration tolerance leaves."""


@pytest.mark.parametrize("name", LIMITS)
def test_fmc_solves(tmp_path, name):
    found = cell.run(tmp_path, "fmc_skfem", "default", name)
    assert found["status"] == "ok", found["message"]
    assert abs(found["error"]) < LIMITS[name] and found["iterations"] > 0 and found["cpu"] > 0 and found["memory"] > 10
    assert json.loads(cell.path(tmp_path, "fmc_skfem", "default", name).read_text()) == found


@pytest.mark.parametrize("name", ["patch-3d", "mindlin", "tied-patch", "rings"])
def test_the_answer_does_not_depend_on_the_host(tmp_path, name):
    """Numbers of nodes, order of corners, loads, supports and planes of symmetry go through FEniCSx and come back. Both searches solve the
    same equations, of which rounding differs: 2e-11 was found."""
    if subprocess.run([CODES["fmc_dolfinx"].interpreter(), "-c", "import dolfinx"], capture_output=True).returncode:
        pytest.skip("no dolfinx")
    first, second = (cell.run(tmp_path, code, "default", name) for code in ("fmc_skfem", "fmc_dolfinx"))
    assert second["status"] == "ok", second["message"]
    assert second["error"] == pytest.approx(first["error"], abs=1e-8) and second["iterations"] == first["iterations"]


def test_a_cell_that_takes_too_long_has_failed(tmp_path):
    found = cell.run(tmp_path, "fmc_skfem", "default", "patch-2d", seconds=0.05)
    assert found["status"] == "failed" and "not done" in found["message"]


def test_the_pages_show_every_status(tmp_path):
    cells = [
        {"status": "ok", "error": 2e-3, "iterations": 3, "cpu": 1.0, "memory": 50.0, "message": ""},
        {"status": "failed", "message": "no equilibrium <here>"},
        {"status": "not supported", "message": "no ties"},
    ]
    for code, one in zip(("fmc_skfem", "getfem", "ipctk"), cells):
        one |= {"problem": "tied-patch", "code": code, "variant": "default"}
        cell.path(tmp_path, code, "default", "tied-patch").write_text(json.dumps(one))
    found = table.results(tmp_path)
    assert [table.grade(one) for one in found.values()] == ["fair", "failed", "unsupported"]
    assert "**default: 0.2 %, 3 it., 1.0 s, 50 MB**" in table.text(found)
    assert "| tied-patch | 0.2 % | failed | not supported |" in table.errors(found)
    text = page.write(tmp_path).read_text()
    assert "<svg" in text and "no equilibrium &lt;here&gt;" in text and 'class="unsupported"' in text


def test_the_stiffness_is_that_of_scikit_fem():
    """Of skewed quadrilaterals, at any displacement."""
    body = Problem.load("patch-2d").bodies[0]
    basis = Basis(MeshQuad(body.points.T.copy(), body.cells.T.copy()), ElementVector(ElementQuad1()), intorder=3)
    theirs = linear_elasticity(*lame_parameters(1000.0, 0.3)).assemble(basis)
    at = basis.nodal_dofs.T.ravel()
    difference = elastic.stiffness(body.points, body.cells, 1000.0, 0.3) - theirs[at][:, at]
    assert np.abs(difference.data).max() < 1e-9 * np.abs(theirs.data).max()


@pytest.mark.parametrize("name", ["patch-2d", "patch-3d", "press-fit", "hertz-ball"])
def test_facets_look_outwards(name):
    """The facets of all sides of a body close it: their normals by area sum up to zero, and enclose its volume."""
    problem = Problem.load(name)
    for body in problem.bodies:
        facets = np.concatenate(list(body.sides.values()))
        corner = body.points[facets]
        if problem.dim == 2:
            along = corner[:, 1] - corner[:, 0]
            normals = np.stack([along[:, 1], -along[:, 0]], 1)
        else:
            normals = np.cross(corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1]) / 2
        volume = elastic.gradients(body.points, body.cells)[1].sum()
        assert volume > 0
        assert np.abs(normals.sum(axis=0)).max() < 1e-9 * np.abs(normals).sum()
        assert (corner.mean(axis=1) * normals).sum() / problem.dim == pytest.approx(volume, rel=1e-2)
