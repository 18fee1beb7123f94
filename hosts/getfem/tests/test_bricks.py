"""Contact as bricks of the model: its share of GetFEM's system, and Newton's method with them."""

import numpy as np
import pytest
from fmc_contact_getfem import Bricks, newton, newton_by_bricks
from fmc_contact_getfem.system import from_getfem, is_linear, residual_and_tangent, to_getfem
from scenes import ELEMENTS, add_supports, moved, touching, with_materials
from scipy.sparse import random as random_matrix


@pytest.mark.parametrize("nonlinear", [False, True])
@pytest.mark.parametrize("element", ELEMENTS)
def test_matrix_is_the_slope_of_the_residual(element, nonlinear):
    """Through GetFEM's own assembly, of a model with the bricks."""
    scene = touching(element)
    model, contact = scene.model, scene.contact
    with_materials(scene, nonlinear)
    state = moved(model)
    contact.keep_patches()
    bricks = Bricks(contact)
    assert is_linear(model) != nonlinear

    def residual(at):
        model.to_variables(at)
        bricks.update()
        return bricks.residual()

    direction, step = np.random.default_rng(2).standard_normal(len(state)), 1e-7
    slope = (residual(state + step * direction) - residual(state - step * direction)) / (2 * step)
    model.to_variables(state)
    bricks.update()
    _, matrix = residual_and_tangent(model, not nonlinear)
    assert np.abs(bricks.force).max() > 0.1
    # Forces have kinks in their slope where facets cross, so differences are good to the part of them in a step.
    assert np.linalg.norm(slope - matrix @ direction) < 1e-5 * np.linalg.norm(slope)


@pytest.mark.parametrize("nonlinear", [False, True])
def test_both_methods_find_one_equilibrium(nonlinear):
    """By the package, with supports by multipliers and as unknowns that are held; by GetFEM's own solve."""
    found = []
    for way in ("multipliers", "held", "bricks"):
        scene = touching("FEM_QK(2,1)", stiffness=1e5, estimator="auto")
        with_materials(scene, nonlinear)
        model, contact = scene.model, scene.contact
        if way == "held":
            held, values = scene.supports(-0.03)
            result = newton(contact, young=1e3, held=held, prescribed=values)
            assert result.iterations <= 4 and result.plain_because == ""
        else:
            add_supports(scene, -0.03)
            if way == "bricks":
                bricks = Bricks(contact)
                assert newton_by_bricks(bricks, young=1e3) <= 12
                # What the model says of itself then, bricks of contact included.
                assert bricks.relative(bricks.residual()) < 1e-9
                # The same where the other method goes on from there, with the bricks in the model.
                assert newton(contact, young=1e3, bricks=bricks).iterations == 0
            else:
                newton(contact, young=1e3)
        found.append(np.concatenate([model.variable(name) for name in "uv"]))
    largest = np.abs(found[0]).max()
    assert largest > 0.01
    for other in found[1:]:
        # Residuals of 1e-9 of the forces.
        assert np.abs(other - found[0]).max() < 1e-8 * largest


def test_a_step_that_fails_leaves_the_model_where_it_was():
    scene = touching("FEM_QK(2,1)", stiffness=1e5)
    with_materials(scene, nonlinear=True)
    add_supports(scene, -2.5)
    start = moved(scene.model, 1e-3)
    bricks = Bricks(scene.contact)
    from fmc_contact.newton import NotConvergedError

    for method in (lambda: newton_by_bricks(bricks, young=1e3), lambda: newton(scene.contact, young=1e3, bricks=bricks)):
        with pytest.raises(NotConvergedError):
            method()
        assert (scene.model.from_variables() == start).all()
        assert scene.contact.contact.options["stiffness"] == 1e5


def test_matrices_go_to_getfem_and_back():
    matrix = random_matrix(7, 5, 0.4, random_state=1, format="csr")
    back = from_getfem(to_getfem(matrix))
    assert back.shape == matrix.shape and (back != matrix).nnz == 0
