"""Forces and tangent on degrees of freedom, against the package itself and against differences."""

import numpy as np
import pytest
import skfem
from fmc_contact import Contact
from fmc_contact_skfem import SkfemContact
from fmc_contact_skfem.field import cells_of, mesh_from_cells
from scenes import ELEMENTS, blocks, by_axis, displacement, joined

OPTIONS = dict(stiffness=1e4, estimator="exact", momentum_correction=False)


@pytest.mark.parametrize("element", [e for e in ELEMENTS if "1" in e])
def test_first_order_gives_the_bits_of_the_package(element):
    bases = blocks(element)
    u = displacement(bases)
    contact = SkfemContact(joined(bases), stiffness=1e4, estimator="exact")
    undeformed, coords, cells, first = [], [], [], 0
    for basis, offset in joined(bases):
        kind, conn = cells_of(basis.mesh)
        undeformed.append(basis.mesh.p.T)
        coords.append(basis.mesh.p.T + u[basis.nodal_dofs + offset].T)
        cells.append((kind, conn + first))
        first += len(coords[-1])
    # Depths are those without displacement.
    alone = Contact(np.concatenate(undeformed), cells, stiffness=1e4, estimator="exact").evaluate(np.concatenate(coords))
    assert alone.volume > 1e-4
    total = contact.force(u)
    start = 0
    for basis, offset in joined(bases):
        count = basis.mesh.nvertices
        assert (total[basis.nodal_dofs + offset].T == alone.forces[start : start + count]).all()
        start += count
    assert np.count_nonzero(total) == np.count_nonzero(alone.forces)


@pytest.mark.parametrize("element", ELEMENTS)
def test_force_is_minus_the_slope_of_the_energy(element):
    bases = blocks(element)
    u = displacement(bases)
    contact = SkfemContact(joined(bases), **OPTIONS)
    contact.keep_patches(u)
    direction = displacement(bases, 1.0, seed=2, bulge=0.0)
    step = 1e-6
    energies = [contact.evaluate(u + s * step * direction).energy for s in (-1, 1)]
    slope = (energies[1] - energies[0]) / (2 * step)
    # Central differences of an energy with a continuous second derivative: the step squared, and rounding by the step.
    assert slope == pytest.approx(-contact.force(u) @ direction, rel=1e-6)


@pytest.mark.parametrize("element", ELEMENTS)
def test_tangent_is_minus_the_slope_of_the_force(element):
    bases = blocks(element)
    u = displacement(bases)
    contact = SkfemContact(joined(bases), **OPTIONS)
    contact.keep_patches(u)
    direction = displacement(bases, 1.0, seed=2, bulge=0.0)
    step = 1e-7
    forces = [contact.force(u + s * step * direction) for s in (-1, 1)]
    slope = (forces[1] - forces[0]) / (2 * step)
    tangent = contact.tangent(u)
    assert tangent.shape == (contact.size, contact.size)
    # Forces have kinks in their slope where facets cross, so differences are good to the part of them in a step.
    assert np.linalg.norm(slope + tangent @ direction) < 1e-5 * np.linalg.norm(slope)


@pytest.mark.parametrize("element", ELEMENTS)
def test_forces_on_unknowns_keep_their_sum(element):
    """A shift of all unknowns moves all points alike, so what acts on the points arrives whole."""
    bases = blocks(element)
    u = displacement(bases)
    contact = SkfemContact(joined(bases), stiffness=1e4, estimator="exact")
    result, total = contact.evaluate(u), contact.force(u)
    for number, (basis, offset) in enumerate(joined(bases)):
        sums = [total[dofs + offset].sum() for dofs in by_axis(basis)]
        assert sums == pytest.approx(result.bodies[number].force, rel=1e-12, abs=1e-12 * np.abs(total).max())


@pytest.mark.parametrize("element", [e for e in ELEMENTS if "2" in e])
def test_second_order_encloses_the_volume_of_its_cells(element):
    """Cells bent by a displacement that is quadratic on the top, to which the volume is linear."""
    basis = blocks(element)[0]
    u = np.zeros(basis.N)
    x = basis.doflocs
    dofs = by_axis(basis)
    u[dofs[-1]] = 0.2 * x[0, dofs[-1]] * (1 - x[0, dofs[-1]]) * x[-1, dofs[-1]]
    assert _enclosed(basis, u) == pytest.approx(1.0 + 0.2 / 6.0, rel=1e-12)


def _enclosed(basis, u):
    """What of a body lies in a half-space around it."""
    contact = SkfemContact(basis, stiffness=1.0, law="volume", estimator="exact")
    up = np.eye(basis.mesh.dim())[-1]
    contact.contact.obstacles.add_half_space(10.0 * up, up)
    return contact.evaluate(u).volume


@pytest.mark.parametrize("element", ELEMENTS)
def test_boundary_is_closed_and_looks_outwards(element):
    for basis in blocks(element):
        volume = np.prod(np.ptp(basis.mesh.p, axis=1))
        assert _enclosed(basis, np.zeros(basis.N)) == pytest.approx(volume, rel=1e-13)


@pytest.mark.parametrize("element", [e for e in ELEMENTS if "1" in e])
def test_cells_come_back_in_the_order_they_went_in(element):
    mesh = blocks(element)[0].mesh
    kind, conn = cells_of(mesh)
    again = mesh_from_cells(mesh.p.T, conn, kind)
    assert (again.p == mesh.p).all() and (again.t == mesh.t).all()
    if kind == "hexahedron":
        # VTK: the first four corners go around a face, the last four stand above them.
        x = mesh.p.T[conn[0]]
        assert np.allclose(x[4:] - x[:4], x[4] - x[0]) and np.allclose(x[1] - x[0], x[2] - x[3])
        assert np.allclose(np.linalg.norm(np.diff(x[[0, 1, 2, 3, 0]], axis=0), axis=1), np.linalg.norm(x[1] - x[0]))


def test_one_basis_of_several_bodies():
    """Two blocks on one mesh are told apart as they hang together, or by the numbers of their cells."""
    bases = blocks("P1")
    p = np.hstack([b.mesh.p for b in bases])
    both = skfem.MeshTri(p, np.hstack([bases[0].mesh.t, bases[1].mesh.t + bases[0].mesh.nvertices]))
    basis = skfem.Basis(both, bases[0].elem)
    numbers = np.repeat([7, 9], [b.nelems for b in bases])
    plain, named = (SkfemContact(basis, stiffness=1e4, bodies=bodies) for bodies in (None, numbers))
    u = np.zeros(basis.N)
    assert plain.evaluate(u).volume > 0.001 and (plain.force(u) == named.force(u)).all()
    assert [body.id for body in named.evaluate(u).bodies] == [7, 9]


def test_obstacles_of_the_contact_below():
    basis = blocks("P1")[0]
    contact = SkfemContact(basis, stiffness=1e4, estimator="exact")
    wall = contact.contact.obstacles.add_half_space((0.0, 0.01), (0.0, 1.0))
    result = contact.evaluate(np.zeros(basis.N))
    # A strip of unit width and depth 0.01: pressure k times depth, here 100.
    assert result.obstacles[wall].force[1] == pytest.approx(-100.0, rel=0.03)


@pytest.mark.parametrize("element", ELEMENTS)
def test_nodal_pressure_at_vertices(element):
    bases = blocks(element)
    u = displacement(bases)
    contact = SkfemContact(joined(bases), stiffness=1e4, law="fiber", estimator="exact")
    field = contact.nodal_contact(u)
    coords = contact.coords(u)
    pressures, places = contact.at_vertices(field.pressure), contact.at_vertices(coords)
    assert field.touching.any()
    seen = 0
    for basis, pressure, place, (_, offset) in zip(bases, pressures, places, joined(bases)):
        assert pressure.shape == (basis.mesh.nvertices,)
        moved = basis.mesh.p.T + u[basis.nodal_dofs + offset].T
        assert (place == moved).all()
        seen += (pressure > 0).sum()
    assert seen >= 2
    carried = -(field.pressure * field.area)[:, None] * field.normal
    result = contact.evaluate(u)
    if "1" in element:
        np.testing.assert_allclose(carried, result.forces, atol=1e-9)
    elif "S" not in element or "3D" not in element:
        # What points have is shared out among nodes; sums over a body stay. Middles of faces without nodes are not told.
        upper = np.arange(len(coords)) >= len(coords) - bases[1].N // bases[1].mesh.dim()
        np.testing.assert_allclose(carried[upper].sum(axis=0), result.bodies[1].force, atol=1e-9)


def test_nodal_pressure_of_the_depth_law_carries_the_force():
    """Forces on nodes inside come to the surface above them: the sums over a block are what stays."""
    bases = blocks("Q1 3D")
    u = displacement(bases)
    contact = SkfemContact(joined(bases), stiffness=1e4)
    field, result = contact.nodal_contact(u), contact.evaluate(u)
    carried = -(field.pressure * field.area)[:, None] * field.normal
    upper = np.arange(len(carried)) >= bases[0].mesh.nvertices
    np.testing.assert_allclose(carried[upper].sum(axis=0), result.bodies[1].force, atol=1e-9)
