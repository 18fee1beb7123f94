"""Bodies that slide and do not separate, in equilibrium: stress under a pull, bodies that are free to slide, and a pin in its hole."""

import numpy as np
import pytest
from fmc_contact import NotConvergedError, find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementQuad1, ElementQuad2, ElementVector, LinearForm, MeshQuad, MeshQuad2
from test_ties import IN_PLANE, IN_SPACE, Tied, block, finite, stress_error, uniform


def sliding(bases, stiffness=0.0):
    pair = Tied(bases, stiffness=stiffness)
    pair.contact.contact.pairs.set(0, 1, interface="no_separation")
    return pair


def held_sideways(pair):
    """Holds the upper body at a corner of its upper face, and in space against turning about it; the stress leaves both where they are."""
    (basis, first), dim = pair.bases[1], len(pair.bases[0][0].mesh.p)
    above = basis.mesh.p[-1] > basis.mesh.p[-1].max() - 1e-9
    corner = above & (basis.mesh.p[:-1].max(0) < 1e-9)
    pair.free[first + basis.nodal_dofs[: dim - 1][:, corner].ravel()] = False
    if dim == 3:
        other = above & (basis.mesh.p[0] > 1 - 1e-9) & (basis.mesh.p[1] < 1e-9)
        pair.free[first + basis.nodal_dofs[1][other]] = False


def normal_stress(dim):
    return 1e-2 * np.diag([0.3, 1.0] if dim == 2 else [0.3, 0.2, 1.0])


@pytest.mark.parametrize("kinds, edges", [(IN_PLANE, (3, 7)), (IN_SPACE, (2, 3))])
def test_a_uniform_pull_passes(kinds, edges):
    # As by a tie; rounding in matrices of this size is 1e-12.
    for below in kinds:
        for above in kinds:
            pair = sliding([block(below, edges[0], 0.0), block(above, edges[1], 0.5)], stiffness=50.0)
            stress = normal_stress(pair.contact.contact.dim)
            prescribed = uniform(pair, stress)
            held_sideways(pair)
            assert stress_error(pair, pair.by_penalty(prescribed), stress) < 1e-11, (below, above)


def test_the_search_finds_the_pull_of_a_tie():
    pair = sliding([block("Q9", 3, 0.0), block("Q4", 7, 0.5)])
    stress = normal_stress(2)
    prescribed = uniform(pair, stress)
    held_sideways(pair)
    found = pair.found(prescribed)
    assert stress_error(pair, found.x, stress) < 1e-9 and not found.warnings
    nodes = pair.contact.contact.tie_nodes(pair.contact.coords(found.x))
    assert set(nodes.body) == {0} and np.allclose(nodes.traction, [0.0, stress[1, 1]], atol=1e-9)
    # Sheared by 0.05 in the same state there is no force along the faces.
    moved = found.x.copy()
    basis, first = pair.bases[1]
    moved[first + basis.nodal_dofs[0]] += 0.05
    forces = pair.contact.contact.evaluate(pair.contact.coords(moved)).forces
    assert np.abs(forces[:, 0]).max() < 1e-5 * np.abs(forces[:, 1]).max()


def test_a_body_that_is_held_along_the_normal_alone_is_told():
    pair = sliding([block("Q4", 7, 0.0), block("Q4", 3, 0.5)])
    basis, first = pair.bases[1]
    # On a soft body it would slide down the dent of its own load: no state is stable.
    pair.free[:first] = False
    pull = LinearForm(lambda v, w: 1e-3 * v[1]).assemble(basis)
    pair.load[first:] = pull
    found = pair.found()
    assert [text for text in found.warnings if text.startswith("free: body 1 along (1.00, 0.00)")], found.warnings
    force = pair.contact.contact.evaluate(pair.contact.coords(found.x)).bodies[1].force
    assert force == pytest.approx([0.0, -pull.sum()], abs=1e-6 * pull.sum())
    # Along the faces nothing holds it.
    pair.load[first:] = LinearForm(lambda v, w: 1e-3 * v[0]).assemble(basis)
    with pytest.raises(NotConvergedError, match="body 1 along"):
        pair.found()


def ring(radii, edges, is_second_order):
    mesh = MeshQuad.init_tensor(np.linspace(0, 1, edges + 1), np.linspace(0, 1, 3))
    around = mesh.p[0] < 1 - 1e-9
    number = np.cumsum(around) - 1
    for k in np.flatnonzero(~around):
        number[k] = number[np.flatnonzero(around & (mesh.p[0] < 1e-9) & np.isclose(mesh.p[1], mesh.p[1, k]))[0]]
    angle = -2 * np.pi * mesh.p[0, around]
    radius = radii[0] + (radii[1] - radii[0]) * mesh.p[1, around]
    closed = MeshQuad(np.array([radius * np.cos(angle), radius * np.sin(angle)]), number[mesh.t])
    if not is_second_order:
        return Basis(closed, ElementVector(ElementQuad1()), intorder=4)
    # Points in the middle have the mean radius.
    straight = MeshQuad2.from_mesh(closed)
    radii = MeshQuad2.from_mesh(MeshQuad(np.array([radius, 0 * radius]), closed.t)).doflocs[0]
    curved = MeshQuad2(straight.doflocs * radii / np.hypot(*straight.doflocs), straight.t)
    return Basis(curved, ElementVector(ElementQuad2()), intorder=6)


@pytest.mark.parametrize("is_second_order", [False, True])
def test_a_pin_turns_in_its_hole_under_a_pull(is_second_order):
    """The pin is turned at its inner rim and pulled aside. A circle of facets, of 9 degrees each, stands off by 3e-3 of its radius: as far from
    the centre may a force pass."""
    edges = (14, 20) if is_second_order else (40, 56)
    bases = [ring((0.4, 1.0), edges[0], is_second_order), ring((1.0, 2.0), edges[1], is_second_order)]
    starts = np.cumsum([0] + [basis.N for basis in bases])
    contact = SkfemContact(list(zip(bases, starts)))
    contact.contact.pairs.set(0, 1, interface="no_separation")
    free, places, axis = np.ones(starts[-1], bool), [], []
    for basis, first, radius in zip(bases, starts, (0.4, 2.0)):
        own = np.zeros(basis.N, int)
        for k in range(2):
            own[basis.get_dofs(elements=True).all(f"u^{k + 1}")] = k
        axis.append(own)
        places.append(basis.doflocs.T)
        free[first : first + basis.N] = ~np.isclose(np.hypot(*basis.doflocs), radius, atol=1e-3)
    places, axis = np.concatenate(places), np.concatenate(axis)
    inner = np.arange(starts[-1]) < starts[1]
    u = np.zeros(starts[-1])
    for step in range(1, 4):
        angle, pull = np.radians(9.7) * step, 2e-3
        c, s = np.cos(angle), np.sin(angle)
        turned = places.copy()
        turned[inner] = places[inner] @ np.array([[c, s], [-s, c]]) + [pull, 0.0]
        rigid = np.take_along_axis(turned - places, axis[:, None], 1)[:, 0]
        found = find_equilibrium(finite(bases), contact, u, free, rigid)
        u = found.x
        body = contact.contact.evaluate(contact.coords(u)).bodies[0]
        torque = body.moment[2] - pull * body.force[1]
        assert body.force[0] < 0 and abs(torque) < 3e-3 * np.hypot(*body.force[:2])
        assert abs(body.force[1]) < 1e-2 * abs(body.force[0])
