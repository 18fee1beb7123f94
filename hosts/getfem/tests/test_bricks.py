"""Contact as bricks of the model: its share of GetFEM's system, and Newton's method with them."""

import numpy as np
import pytest
from fmc_contact_getfem import Bricks, newton
from fmc_contact_getfem.system import is_linear, residual_and_tangent
from scenes import ELEMENTS, moved, touching, with_materials


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
        return residual_and_tangent(model, not nonlinear)

    direction, step = np.random.default_rng(2).standard_normal(len(state)), 1e-7
    slope = (residual(state + step * direction)[0] - residual(state - step * direction)[0]) / (2 * step)
    _, matrix = residual(state)
    assert np.abs(contact.force(state)).max() > 0.1
    # Forces have kinks in their slope where facets cross, so differences are good to the part of them in a step.
    assert np.linalg.norm(slope - matrix @ direction) < 1e-5 * np.linalg.norm(slope)
