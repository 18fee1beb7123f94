"""Meshes whose nodes were not merged: the option ``weld``."""

import numpy as np
import pytest
from fmc_contact import Contact, FmcError


def grid(x0, y0, nx, ny, h):
    """Nodes and cells of squares of size h."""
    x, y = np.meshgrid(x0 + h * np.arange(nx + 1), y0 + h * np.arange(ny + 1), indexing="ij")
    number = np.arange((nx + 1) * (ny + 1)).reshape(nx + 1, ny + 1)
    cells = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)
    return np.stack([x.ravel(), y.ravel()], axis=1), cells


def meshes():
    """Two plates as one mesh, and the same with nodes of its own for every cell."""
    lower, of_lower = grid(0.0, 0.0, 4, 2, 0.25)
    upper, of_upper = grid(0.13, 0.49, 3, 2, 0.21)
    coords, cells = np.vstack([lower, upper]), np.vstack([of_lower, of_upper + len(lower)])
    return coords, cells, np.arange(cells.size).reshape(-1, 4)


def test_forces_are_those_of_the_merged_mesh():
    coords, cells, own = meshes()
    expected = Contact(coords, cells, "quad", stiffness=1e3).evaluate(coords)
    contact = Contact(coords[cells.ravel()], own, "quad", stiffness=1e3, weld=1e-3)
    assert contact.body_count == 2
    assert contact.mesh.welded_node_count == cells.size - len(coords)
    found = contact.evaluate(coords[cells.ravel()])
    sums = np.zeros_like(coords)
    np.add.at(sums, cells.ravel(), found.forces)
    # Sums of at most four equal parts: rounding alone.
    np.testing.assert_allclose(sums, expected.forces, rtol=0, atol=1e-12 * np.abs(expected.forces).max())
    assert found.energy == pytest.approx(expected.energy, rel=1e-12)
    assert not found.warnings
    torn = Contact(coords[cells.ravel()], own, "quad", stiffness=1e3, bodies=np.repeat([0, 1], [8, 6]))
    assert "coinciding_faces" in {warning.kind for warning in torn.evaluate(coords[cells.ravel()]).warnings}
    assert torn.mesh.welded_node_count == 0


def pair(**options):
    """Both plates merged and welded, the same coordinates of each, a little bent, and what adds up entries of copies."""
    coords, cells, own = meshes()
    merged = Contact(coords, cells, "quad", stiffness=1e3, **options)
    welded = Contact(coords[cells.ravel()], own, "quad", stiffness=1e3, weld=1e-3, **options)
    at = coords + 0.002 * np.sin(3 * coords[:, ::-1])

    def summed(entries):
        sums = np.zeros_like(coords)
        np.add.at(sums, cells.ravel(), entries)
        return sums

    return merged, welded, coords, at, cells.ravel(), summed


def test_friction_is_that_of_the_merged_mesh():
    merged, welded, coords, at, copies, summed = pair(friction_coefficient=0.3)
    merged.friction.begin_step(coords)
    welded.friction.begin_step(coords[copies])
    expected = merged.evaluate(at).forces
    assert merged.evaluate(at).friction.energy > 0
    np.testing.assert_allclose(summed(welded.evaluate(at[copies]).forces), expected, rtol=0, atol=1e-12 * np.abs(expected).max())


def test_a_plane_of_symmetry_may_name_any_of_the_copies():
    merged, welded, coords, at, copies, summed = pair()
    without = merged.evaluate(at).forces.copy()
    in_plane = np.flatnonzero(np.isclose(coords[:, 0], 0.13))
    merged.mesh.set_symmetry_nodes(in_plane)
    welded.mesh.set_symmetry_nodes([np.flatnonzero(copies == node)[-1] for node in in_plane])
    expected = merged.evaluate(at).forces
    assert np.abs(expected - without).max() > 1e-4 * np.abs(expected).max()
    np.testing.assert_allclose(summed(welded.evaluate(at[copies]).forces), expected, rtol=0, atol=1e-12 * np.abs(expected).max())


def test_gradients_and_ties_are_those_of_the_merged_mesh():
    merged, welded, coords, at, copies, summed = pair()
    adjoint = np.random.default_rng(1).standard_normal(coords.shape)
    by = ("coords", "reference")
    expected, found = merged.vjp(at, adjoint=adjoint, by=by), welded.vjp(at[copies], adjoint=adjoint[copies], by=by)
    for name in by:
        value = getattr(expected, name)
        np.testing.assert_allclose(summed(getattr(found, name)), value, rtol=0, atol=1e-12 * np.abs(value).max())
    for contact in (merged, welded):
        contact.pairs.set(0, 1, interface="tied", reach=0.05)
    value = merged.evaluate(at).forces
    assert np.abs(value).max() > 0
    np.testing.assert_allclose(summed(welded.evaluate(at[copies]).forces), value, rtol=0, atol=1e-12 * np.abs(value).max())


def test_what_cannot_be_is_refused_by_name():
    coords, cells, _ = meshes()
    with pytest.raises(FmcError, match=r"'weld' is 2\.100e-1, .*cell 8 that are 2\.100e-1 apart"):
        Contact(coords, cells, "quad", stiffness=1e3, weld=0.21000000001)
    with pytest.raises(FmcError, match="'weld' is -0.1"):
        Contact(coords, cells, "quad", stiffness=1e3, weld=-0.1)
    with pytest.raises(FmcError, match="not finite|finite number"):
        Contact(coords, cells, "quad", stiffness=1e3, weld=float("nan"))
    edges = [[0, 1], [1, 2], [2, 0]]
    with pytest.raises(FmcError, match="'weld' is not supported for bodies given by facets"):
        Contact.from_facets([[0, 0], [1, 0], [0, 1]], edges, stiffness=1.0, law="fiber", weld=0.1)
    contact = Contact(coords, cells, "quad", stiffness=1e3)
    with pytest.raises(FmcError, match="'weld' belongs to the mesh"):
        contact.set_options(weld=0.1)
    assert contact.options["weld"] == 0


def test_the_tangent_is_the_derivative_of_the_forces():
    coords, cells, own = meshes()
    rng = np.random.default_rng(3)
    # Copies that lie apart.
    start = coords[cells.ravel()]
    contact = Contact(start, own, "quad", stiffness=1e3, weld=1e-3)
    at, along = start + 1e-3 * rng.random(start.shape), rng.standard_normal(start.shape)
    ahead, behind = (contact.evaluate(at + t * along).forces.copy() for t in (1e-7, -1e-7))
    slope = (behind - ahead).ravel() / 2e-7
    product = contact.tangent(at) @ along.ravel()
    np.testing.assert_allclose(product, slope, rtol=0, atol=1e-6 * np.abs(product).max())
