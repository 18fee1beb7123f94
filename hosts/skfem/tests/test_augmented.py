"""An augmented Lagrangian reaches any penetration at the stiffness that is there."""

import sys
from pathlib import Path

import numpy as np
import pytest
from fmc_contact import augmented, newton
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementTriP1, ElementTriP2, ElementVector, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

sys.path.insert(0, str(Path(__file__).parents[1] / "newton"))
import problems  # noqa: E402

R, E, NU, DOWN = 1.0, 1e3, 0.3, 0.02


def pressed_disc(element, **options):
    """A disc on a rigid plane, its upper half moved down as one: what ``newton`` asks for."""
    mesh = MeshTri.init_circle(5).translated((0, R))
    basis = Basis(mesh, ElementVector(element))
    stiffness = linear_elasticity(*lame_parameters(E, NU)).assemble(basis)
    contact = SkfemContact(basis, stiffness=10 * E / mesh.param(), **options)
    contact.contact.add_half_space((0, 0), (0, 1))
    held = basis.get_dofs(elements=mesh.elements_satisfying(lambda x: x[1] > R))
    prescribed = np.zeros(basis.N)
    prescribed[held.all("u^2")] = -DOWN
    free = np.setdiff1d(np.arange(basis.N), held.all())
    return (lambda u: (stiffness @ u, stiffness)), contact, np.zeros(basis.N), free, prescribed


@pytest.mark.parametrize("element", [ElementTriP1(), ElementTriP2()])
def test_a_disc_on_a_plane(element):
    arguments = pressed_disc(element)
    soft = newton(*arguments, young=E)
    found = augmented(*arguments, young=E, penetration=1e-6 * R)
    print(found.penetrations, found.iterations, found.stiffness)
    assert found.penetrations[-1] <= 1e-6 * R < found.penetrations[0] and len(found.penetrations) <= 11
    assert max(found.iterations[1:]) <= 8
    # Nothing pulls, and what presses touches.
    gap = found.gaps.gap / found.gaps.area
    assert (found.pressure >= 0).all() and np.abs(gap[found.pressure > 0]).max() <= 1e-6 * R
    # The law alone comes as near with a stiffness that is as much higher, and to the same force.
    contact = arguments[1]
    contact.contact.set_options(stiffness=1e3 * contact.contact.options["stiffness"])
    hard = newton(*arguments[:2], soft.x, *arguments[3:], young=E, max_iterations=60)
    pushed = arguments[4] != 0
    forces = [one.reactions[pushed].sum() for one in (soft, hard, found)]
    print(forces)
    # There every point counts, here the mean at a node: with two facets in half a width that is 1 % of the force.
    assert forces[2] == pytest.approx(forces[1], rel=1.5e-2) and abs(forces[2]) > 1.005 * abs(forces[0])


def test_a_disc_on_a_block():
    """Two bodies: one of them has the multipliers, and forces balance."""
    problem = problems.disc(32)
    contact = problem.contact(10.0)
    start, prescribed = np.zeros(problem.solid.offsets[-1]), np.zeros(problem.solid.offsets[-1])
    prescribed[problem.moved] = problem.pushes[4]
    found = augmented(
        lambda u: (problem.solid.forces(u), problem.solid.stiffness(u)), contact, start, problem.free, prescribed, young=problem.young, penetration=1e-6
    )
    print(found.penetrations, found.iterations, found.stiffness)
    assert found.penetrations[-1] <= 1e-6 and len(found.penetrations) <= 11
    assert found.penetrations[0] > 1e-4
    assert len(set(found.gaps.body.tolist())) == 1
    forces = found.reactions.reshape(-1, 2).sum(axis=0)
    assert np.abs(forces).max() < 1e-6 * np.abs(found.reactions).sum()


def test_what_is_refused():
    arguments = pressed_disc(ElementTriP1(), friction_coefficient=0.3)
    with pytest.raises(ValueError, match="with friction"):
        augmented(*arguments, young=E, penetration=1e-6)
    with pytest.raises(ValueError, match="a positive one"):
        augmented(*arguments, young=E, penetration=0.0)
