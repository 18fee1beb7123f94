"""Contact as bricks of the model: its share of GetFEM's system, and equilibria with and without them."""

import numpy as np
import pytest
from fmc_contact import NotConvergedError
from fmc_contact_getfem import Bricks, find_equilibrium
from fmc_contact_getfem.system import from_getfem, is_linear, residual_and_tangent, to_getfem
from scenes import ELEMENTS, add_supports, moved, touching, with_materials
from scipy.sparse import random as random_matrix


def is_slope(scene, state, linear):
    """Whether the matrix of the model, bricks of contact included, is the slope of its residual."""
    model, bricks = scene.model, Bricks(scene.contact)
    scene.contact.keep_patches()

    def residual(at):
        model.to_variables(at)
        bricks.update()
        return bricks.residual()

    direction, step = np.random.default_rng(2).standard_normal(len(state)), 1e-7
    slope = (residual(state + step * direction) - residual(state - step * direction)) / (2 * step)
    residual(state)
    assert np.abs(bricks.force).max() > 0.1
    _, matrix = residual_and_tangent(model, linear)
    # Forces have kinks in their slope where facets cross, so differences are good to the part of them in a step.
    return np.linalg.norm(slope - matrix @ direction) < 1e-5 * np.linalg.norm(slope)


@pytest.mark.parametrize("nonlinear", [False, True])
@pytest.mark.parametrize("element", ELEMENTS)
def test_matrix_is_the_slope_of_the_residual(element, nonlinear):
    """Through GetFEM's own assembly."""
    scene = touching(element)
    with_materials(scene, nonlinear)
    state = moved(scene.model)
    assert is_linear(scene.model) != nonlinear
    assert is_slope(scene, state, not nonlinear)


def solve_by_getfem(bricks, semidefinite=0, most=20):
    """By GetFEM's own ``solve``, whole steps, the first ones without terms that can be negative; how many it took."""
    for iteration in range(most):
        bricks.update(semidefinite=iteration < semidefinite)
        if bricks.relative(bricks.residual()) < 1e-9:
            return iteration
        bricks.contact.model.solve("max_iter", 1, "lsearch", "simplest", "alpha min", 1.0)
    raise AssertionError(f"no equilibrium in {most} iterations")


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
            result = find_equilibrium(contact, held=held, prescribed=values)
            assert result.iterations <= 4 and result.way == "condensed"
        else:
            add_supports(scene, -0.03)
            if way == "bricks":
                bricks = Bricks(contact)
                assert solve_by_getfem(bricks, semidefinite=2) <= 12
                # What the model says of itself then, bricks of contact included.
                assert bricks.relative(bricks.residual()) < 1e-9
                # The same where the other method goes on from there, with the bricks in the model.
                assert find_equilibrium(contact, bricks=bricks).iterations == 0
            else:
                find_equilibrium(contact)
        found.append(np.concatenate([model.variable(name) for name in "uv"]))
    largest = np.abs(found[0]).max()
    assert largest > 0.01
    for other in found[1:]:
        # Residuals of 1e-9 of the forces.
        assert np.abs(other - found[0]).max() < 1e-8 * largest


def test_friction_drags_the_upper_block_alike_by_both_methods():
    """Pressed and pulled along until all of it slides, in steps that are committed; the matrix is unsymmetric."""
    found = []
    for by_bricks in (False, True):
        scene = touching("FEM_QK(2,1)", stiffness=1e5, estimator="auto", friction_coefficient=0.3)
        with_materials(scene)
        model, contact = scene.model, scene.contact
        add_supports(scene, 0.0)
        bricks = Bricks(contact) if by_bricks else None
        contact.begin_step()
        for part in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
            model.set_variable("move_v", [0.05 * part, -0.01 * part])
            solve_by_getfem(bricks) if bricks else find_equilibrium(contact)
            matrix, force = contact.tangent(), contact.evaluate().bodies[1].force
            contact.commit_step()
        assert abs(matrix - matrix.T).max() > 1e-2 * abs(matrix).max()
        # The sides of the upper block reach into the lower one, which pushes back there.
        assert force[1] > 1.0 and 0.25 < -force[0] / force[1] < 0.3
        found.append(force)
    assert found[1] == pytest.approx(found[0], rel=1e-7)


def test_a_step_that_fails_leaves_the_model_where_it_was():
    scene = touching("FEM_QK(2,1)", stiffness=1e5)
    with_materials(scene, nonlinear=True)
    add_supports(scene, -2.5)
    start = moved(scene.model, 1e-3)
    bricks = Bricks(scene.contact)
    with pytest.raises(NotConvergedError):
        find_equilibrium(scene.contact, bricks=bricks)
    assert (scene.model.from_variables() == start).all()
    assert scene.contact.contact.options["stiffness"] == 1e5


def test_matrices_go_to_getfem_and_back():
    matrix = random_matrix(7, 5, 0.4, random_state=1, format="csr")
    back = from_getfem(to_getfem(matrix))
    assert back.shape == matrix.shape and (back != matrix).nnz == 0
