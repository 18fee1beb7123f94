"""What the problems are built of: bodies against differences, expected values against others."""

import arches
import numpy as np
import pytest
from bodies import Bodies
from meshes import BY_NAME, grid, ring
from skfem.models.elasticity import lame_parameters, linear_elasticity


@pytest.mark.parametrize("cells", BY_NAME)
def test_tangent_is_the_derivative_of_the_forces(cells):
    one, random = BY_NAME[cells], np.random.default_rng(1)
    bodies = Bodies([grid(one.mesh, [0] * one.dim, [1] * one.dim, [2] * one.dim)], one, 3.0, 0.3, is_linear=False)
    host, u, step = bodies.host(), 0.02 * random.standard_normal(bodies.size), 1e-6 * random.standard_normal(bodies.size)
    change = (host(u + step)[0] - host(u - step)[0]) / 2
    assert np.linalg.norm(host(u)[1] @ step - change) < 1e-8 * np.linalg.norm(change)


@pytest.mark.parametrize("cells", BY_NAME)
def test_linear_bodies_are_those_of_scikit_fem(cells):
    one = BY_NAME[cells]
    bodies = Bodies([grid(one.mesh, [0] * one.dim, [1] * one.dim, [2] * one.dim)], one, 3.0, 0.3)
    wanted = linear_elasticity(*lame_parameters(3.0, 0.3)).assemble(bodies.bases[0])
    assert abs(bodies.stiffness - wanted).max() < 1e-13 * abs(wanted).max()


@pytest.mark.parametrize("cells", BY_NAME)
def test_loads_add_up_to_what_is_applied(cells):
    one = BY_NAME[cells]
    bodies = Bodies([grid(one.mesh, [0] * one.dim, [1] * one.dim, [2] * one.dim)], one, 3.0, 0.3)
    is_top = lambda x: x[-1] > 1 - 1e-9
    pulled = bodies.traction(0, is_top, [0] * (one.dim - 1) + [2.0])
    assert np.isclose(bodies.weight(5.0).sum(), -5) and np.isclose(pulled.sum(), 2)
    assert set(np.flatnonzero(np.abs(pulled) > 1e-12)) <= set(bodies.unknowns(0, is_top, -1))


def test_rings_have_cells_of_positive_area():
    bodies = Bodies([ring(0.5, 1.0, 3, 16)], BY_NAME["Quad4"], 1.0, 0.3)
    assert bodies.bases[0].dx.min() > 0


@pytest.mark.parametrize("count", [15, 27])
def test_least_thickness_of_rigid_arches_is_near_heymans(count):
    # Fewer joints than a continuous ring has places for hinges: a little less.
    assert 0.105 < arches.least_thickness(count, 0.8) < 0.1075
