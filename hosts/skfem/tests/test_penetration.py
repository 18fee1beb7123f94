"""As little penetration as is wanted, at the stiffness that is there."""

import numpy as np
import pytest
from fmc_contact import NotConvergedError, find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementTriP1, ElementTriP2, ElementVector, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

R, E, NU, DOWN = 1.0, 1e3, 0.3, 0.02


def pressed_disc(element, **options):
    """A disc on a rigid plane, its upper half moved down as one: what ``find_equilibrium`` asks for."""
    mesh = MeshTri.init_circle(5).translated((0, R))
    basis = Basis(mesh, ElementVector(element))
    stiffness = linear_elasticity(*lame_parameters(E, NU)).assemble(basis)
    contact = SkfemContact(basis, stiffness=10 * E / mesh.param(), **options)
    contact.contact.obstacles.add_half_space((0, 0), (0, 1))
    held = basis.get_dofs(elements=mesh.elements_satisfying(lambda x: x[1] > R))
    prescribed = np.zeros(basis.N)
    prescribed[held.all("u^2")] = -DOWN
    free = np.setdiff1d(np.arange(basis.N), held.all())
    return (lambda u: (stiffness @ u, stiffness)), contact, np.zeros(basis.N), free, prescribed


@pytest.mark.parametrize("two_level", [True, False])
@pytest.mark.parametrize("element", [ElementTriP1(), ElementTriP2()])
def test_a_disc_on_a_plane(element, two_level):
    arguments = pressed_disc(element)
    contact = arguments[1]
    soft = find_equilibrium(*arguments, two_level=two_level)
    left = contact.contact.gap_constraints(contact.coords(soft.x), reach=0.1 * R)
    found = find_equilibrium(*arguments, two_level=two_level, penetration=1e-6 * R)
    print(soft.iterations, found.iterations, found.updates, found.contact_iterations, found.penetration)
    gaps = contact.contact.gap_constraints(contact.coords(found.x), reach=0.1 * R)
    mean = gaps.gap / gaps.area
    assert -(left.gap / left.area).min() > 1e-4 * R and found.penetration <= 1e-6 * R
    assert found.penetration == pytest.approx(max(0.0, -mean.min()), abs=1e-12)
    assert found.updates <= 12 and found.factorisations <= (1 if two_level else found.iterations)
    # What presses touches: those that are moved out, and no others.
    moved = contact.contact.multipliers.values
    assert (moved["shift"] > 0).all() and moved["towards"][:, 1] == pytest.approx(-1.0, abs=1e-12)
    assert np.abs(mean[np.isin(gaps.node, moved["node"])]).max() <= 1e-6 * R
    # The law alone comes as near with a stiffness that is as much higher, and to the same force.
    contact.contact.multipliers.release()
    contact.contact.set_options(stiffness=1e3 * contact.contact.options["stiffness"])
    hard = find_equilibrium(*arguments[:2], soft.x, *arguments[3:], max_iterations=60)
    pushed = arguments[4] != 0
    forces = [one.reactions[pushed].sum() for one in (soft, hard, found)]
    print(forces)
    # There every point counts, here the mean at a node: with two facets in half a width that is 1 % of the force.
    assert forces[2] == pytest.approx(forces[1], rel=1.5e-2) and abs(forces[2]) > 1.005 * abs(forces[0])


def test_what_is_refused():
    arguments = pressed_disc(ElementTriP1(), self_contact=True)
    with pytest.raises(NotConvergedError, match="with self-contact"):
        find_equilibrium(*arguments, penetration=1e-6)
    with pytest.raises(ValueError, match="a positive one"):
        find_equilibrium(*pressed_disc(ElementTriP1()), penetration=0.0)
    with pytest.raises(NotConvergedError, match="after 1 updates, expected 1.0e-9"):
        find_equilibrium(*pressed_disc(ElementTriP1()), penetration=1e-9, max_updates=1)
