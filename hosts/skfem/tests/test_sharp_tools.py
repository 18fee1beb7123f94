"""Rigid tools with sharp edges, with every argument at its default."""

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementHex1, ElementQuad1, ElementVector, MeshHex, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

MU = 0.3


def pressed(mesh, element, half, offset, **options):
    """A block on a held base, and a box that touches its upper face."""
    basis = Basis(mesh, ElementVector(element))
    stiffness = linear_elasticity(*lame_parameters(1e3, 0.3)).assemble(basis)
    contact = SkfemContact(basis, **options)
    obstacles = contact.contact.obstacles
    tool = obstacles.add_cuboid(half, offset)
    base = basis.nodal_dofs[:, mesh.p[-1] < mesh.p[-1].min() + 1e-9].ravel()
    free, u = np.setdiff1d(np.arange(basis.N), base), np.zeros(basis.N)
    contact.begin_step(u)

    def move(by):
        nonlocal u
        obstacles.set_pose(tool, np.add(offset, by))
        found = find_equilibrium(lambda u: (stiffness @ u, stiffness), contact, u, free)
        u = found.x
        contact.commit_step(u)
        return found, found.result.obstacles[tool].force

    return move


def test_friction_below_a_box_that_slides_stays_within_its_limit():
    height = -np.array([2, 1.5, 1.1, 0.8, 0.55, 0.25, 0])
    move = pressed(MeshQuad.init_tensor(np.linspace(-2, 2, 17), height), ElementQuad1(), (0.5, 0.5), (0.05, 0.5), friction_coefficient=MU)
    ways = [(0, -0.05), (0, -0.1), *((0.14 * k / 8, -0.1) for k in range(1, 9)), (0.14, -0.05), (0.14, -0.01)]
    for way in ways:
        found, force = move(way)
        assert not [text for text in found.warnings if "updates" in text]
        # A facet that lies across the edge is pushed along by the wall beside it, by the depth that is left there: an eighth of the friction.
        assert abs(force[0]) < 1.125 * MU * force[1], way
    assert force[1] > 0


@pytest.mark.parametrize("count", [1, 2])
def test_box_with_edges_on_those_of_cells_is_pressed_deep(count):
    xs = np.linspace(-1, 1, 9)
    move = pressed(MeshHex.init_tensor(xs, xs, np.array([-1, -0.6, -0.25, 0])), ElementHex1(), (0.5,) * 3, (0, 0, 0.5))
    for k in range(count):
        found, force = move((0, 0, -0.1 * (k + 1) / count))
        # Linear, but for the penetration that is left, of some percent below the edges.
        assert found.iterations < 10 and found.result.penetration < 0.06 * 0.1
    assert np.abs(force[:2]).max() < 1e-3 * force[2]
