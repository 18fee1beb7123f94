"""States that a search must not end in, or not miss: a corner that has come through a wall, a slope that friction holds, a push at once."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import NoSupportError, find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementQuad1, ElementTriP1, ElementTriP2, ElementVector, LinearForm, MeshQuad, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNG, WEIGHT = 1e6, 1e3


@pytest.mark.parametrize(("poisson", "down"), [(0.46, 0.02), (0.49, 0.02), (0.49, 0.01), (0.499, 0.02)])
def test_no_corner_of_a_confined_block_comes_through_a_wall(poisson: float, down: float) -> None:
    """The force of a block of triangles between three walls is (λ + 2 μ) times the strain."""
    ticks = np.linspace(0, 1, 5)
    basis = Basis(MeshTri.init_tensor(ticks, ticks), ElementVector(ElementTriP1()))
    lam, mu = lame_parameters(YOUNG, poisson)
    matrix = linear_elasticity(lam, mu).assemble(basis)
    contact = SkfemContact(basis)
    for point, normal in (((0, 0), (1, 0)), ((1, 0), (-1, 0)), ((0, 0), (0, 1))):
        contact.contact.obstacles.add_half_space(point, normal)
    top = basis.get_dofs(lambda x: x[1] == 1).all("u^2")
    end = basis.zeros()
    end[top] = -down
    found = find_equilibrium(lambda u: (matrix @ u, matrix), contact, basis.zeros(), basis.complement_dofs(top), end)
    # What is left of the penetration takes a thousandth at most.
    assert found.reactions[top].sum() == pytest.approx(-down * (lam + 2 * mu), rel=2e-3) and not found.warnings


def slope(degrees: float, friction: float, element: str, push: float = 0.0):
    """A block of 2 by 1 on a plane, both turned by an angle, with a push along the plane by its weight."""
    angle = np.radians(degrees)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    ticks = np.linspace(0, 2, 5), np.linspace(0, 1, 5)
    kind, of_nodes = {"Quad4": (MeshQuad, ElementQuad1), "Tri3": (MeshTri, ElementTriP1), "Tri6": (MeshTri, ElementTriP2)}[element]
    mesh = kind.init_tensor(*ticks)
    basis = Basis(kind(turn @ mesh.p, mesh.t), ElementVector(of_nodes()))
    matrix = linear_elasticity(*lame_parameters(YOUNG, 0.3)).assemble(basis)
    contact = SkfemContact(basis, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space((0, 0), turn @ [0, 1])
    along = push * turn @ [1, 0]
    load = WEIGHT * LinearForm(lambda v, w: along[0] * v[0] + (along[1] - 1) * v[1]).assemble(basis)
    free = np.arange(basis.N)
    return find_equilibrium(lambda u: (matrix @ u - load, matrix), contact, basis.zeros(), free), 2 * WEIGHT


@pytest.mark.parametrize("element", ["Quad4", "Tri3", "Tri6"])
@pytest.mark.parametrize(("degrees", "friction"), [(5, 0.18), (15, 0.55), (26, 0.63), (26, 0.634), (30, 1.2)])
def test_a_block_that_touches_a_slope_stays(element: str, degrees: float, friction: float) -> None:
    found, weight = slope(degrees, friction, element)
    assert found.result.obstacles[0].force == pytest.approx([0, -weight], abs=1e-6 * weight)
    # Elastic strains are a thousandth; a block that slides goes a tenth of its length before it is held.
    assert np.abs(found.x).max() < 3e-3 and not found.warnings


@pytest.mark.parametrize("element", ["Quad4", "Tri3", "Tri6"])
@pytest.mark.parametrize("push", [0.01, 0.2, 0.35, 0.45])
def test_a_block_that_touches_a_floor_and_is_pushed_stays(element: str, push: float) -> None:
    found, weight = slope(0, 0.5, element, push)
    assert found.result.obstacles[0].force == pytest.approx([push * weight, -weight], abs=1e-6 * weight)
    assert np.abs(found.x).max() < 3e-3 and not found.warnings


@pytest.mark.parametrize("degrees", [20, 30])
def test_a_slope_beyond_friction_is_refused(degrees: float) -> None:
    with pytest.raises(NoSupportError, match="body 0 along"):
        slope(degrees, 0.95 * np.tan(np.radians(degrees)), "Quad4")
