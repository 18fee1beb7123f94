"""Straight faces that stand for round surfaces, set on the adapter."""

import numpy as np
import pytest
from fmc_contact.errors import NotPositiveError
from fmc_contact_skfem import SkfemContact
from skfem import (
    Basis,
    ElementHex1,
    ElementHex2,
    ElementHexS2,
    ElementQuad1,
    ElementQuad2,
    ElementQuadS2,
    ElementTetP1,
    ElementTetP2,
    ElementTriP1,
    ElementTriP2,
    ElementVector,
    MeshHex,
    MeshQuad,
)


def sector(inner, outer, count):
    """A third of a ring around the origin."""
    mesh = MeshQuad.init_tensor(np.linspace(inner, outer, 3), np.linspace(0, 2 * np.pi / 3, count + 1))
    radius, angle = mesh.p
    return MeshQuad(radius * np.stack([np.cos(angle), np.sin(angle)]), mesh.t)


def rings():
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in (sector(0.5, 1.001, 11), sector(1.0, 1.5, 14))]
    return SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=1e3)


def test_the_adapter_hands_it_on():
    adapter, by_hand = rings(), rings()
    u = np.zeros(adapter.size)
    straight = adapter.force(u)
    assert "curved_faces" in [warning.kind for warning in adapter.evaluate(u).warnings]
    adapter.set_surface_smoothing(30.0)
    by_hand.contact.mesh.set_surface_smoothing(30.0)
    assert np.array_equal(adapter.force(u), by_hand.force(u)) and not np.array_equal(adapter.force(u), straight)
    assert not {"curved_faces", "coarse_faces"} & {warning.kind for warning in adapter.evaluate(u).warnings}
    adapter.set_surface_smoothing(0.0)
    assert np.array_equal(adapter.force(u), straight)
    with pytest.raises(NotPositiveError, match="feature_angle"):
        adapter.set_surface_smoothing(90.0)


def solid_ring(inner, outer, count):
    """A quarter of a ring, 5 high."""
    angles = np.linspace(0, np.pi / 2, count + 1)
    mesh = MeshHex.init_tensor(np.linspace(inner, outer, 3), angles, np.linspace(0, 5, 2))
    radius, angle, height = mesh.p
    return MeshHex(np.stack([radius * np.cos(angle), radius * np.sin(angle), height]), mesh.t)


def test_nothing_presses_along_rims():
    # A pin in its hole: a clearance of 0.03 is left, the sag of both sides is 0.048.
    bases = [Basis(mesh, ElementVector(ElementHex1())) for mesh in (solid_ring(5, 10, 8), solid_ring(10.05, 20, 8))]
    adapter = SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=1e6)
    u = np.zeros(adapter.size)
    u[: bases[0].N] = bases[0].project(lambda x: np.stack([0.02 * x[0], 0.02 * x[1], 0 * x[2]]) / np.hypot(x[0], x[1]))
    adapter.set_surface_smoothing(30.0)
    # The cut faces of the quarter lie in planes of symmetry, its ends are free. They touch by rounding.
    adapter.contact.mesh.set_symmetry_planes([([0, 0, 0], [1, 0, 0]), ([0, 0, 0], [0, 1, 0])])
    found = adapter.evaluate(u)
    assert np.abs(found.forces).max() < 1e-6 and "curved_faces" not in [warning.kind for warning in found.warnings]


def bent(inner, outer, count, element):
    """A quarter of a ring, 0.2 high where it is a solid: its cells are straight."""
    angles, radii = np.linspace(0, np.pi / 2, count + 1), np.linspace(inner, outer, 3)
    is_plane = element.dim == 2
    mesh = MeshQuad.init_tensor(radii, angles) if is_plane else MeshHex.init_tensor(radii, angles, np.linspace(0, 0.2, 2))
    x = np.stack([mesh.p[0] * np.cos(mesh.p[1]), mesh.p[0] * np.sin(mesh.p[1]), *mesh.p[2:]])
    mesh = type(mesh)(x, mesh.t)
    if element.refdom.nnodes == element.dim + 1:
        mesh = mesh.to_meshtri() if is_plane else mesh.to_meshtet()
    return Basis(mesh, ElementVector(element))


@pytest.mark.parametrize("first, second", [
    (ElementQuad1(), ElementQuad2()),
    (ElementQuad1(), ElementQuadS2()),
    (ElementTriP1(), ElementTriP2()),
    (ElementHex1(), ElementHex2()),
    (ElementHex1(), ElementHexS2()),
    (ElementTetP1(), ElementTetP2()),
])
def test_second_order_on_a_straight_mesh_is_that_mesh(first, second):
    # Rings with an interference of 1e-3, a third of the sag. Exact: k δ²/2 over the cylinder. The overlap of polygons has 0.75 of it.
    exact = 0.5 * 1e3 * 1e-6 * np.pi / 2 * (1.0 if first.dim == 2 else 0.2)
    told, energies = [], []
    for element in (first, second):
        bases = [bent(0.5, 1.001, 11, element), bent(1.0, 1.5, 14, element)]
        adapter = SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=1e3)
        axes = np.eye(first.dim)
        ends = [(0 * axes[0], axes[0]), (0 * axes[0], axes[1])]
        ends += [(0 * axes[0], axes[2]), (0.2 * axes[2], axes[2])] if first.dim == 3 else []
        adapter.contact.mesh.set_symmetry_planes(ends)
        u = np.zeros(adapter.size)
        told.append([w.text for w in adapter.evaluate(u).warnings if w.kind == "curved_faces"])
        adapter.set_surface_smoothing(30.0)
        found = adapter.evaluate(u)
        assert "curved_faces" not in [warning.kind for warning in found.warnings]
        energies.append(found.energy)
    # Of one geometry one sag is told, but for the places where the facets of the two touch.
    sags = [float(text.split(" are ")[1].split(" away")[0]) for [text] in told]
    assert sags[1] == pytest.approx(sags[0], rel=5e-3)
    assert energies == pytest.approx([exact, exact], rel=3e-3)
    assert energies[1] == pytest.approx(energies[0], rel=1e-3)
