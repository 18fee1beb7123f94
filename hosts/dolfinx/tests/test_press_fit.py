"""A press fit in second-order spaces on straight cells, which the library measures as round after `set_surface_smoothing`."""

import numpy as np
import pytest
import ufl
from dolfinx import fem, mesh
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, find_equilibrium
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from scenes import COMM

MODULUS, RATIO, INTERFERENCE = 1e6, 0.3, 2e-3


def quarter(inner, outer, count, kind):
    """A quarter of a ring in the plane, two cells thick."""
    radius, angle = np.meshgrid(np.linspace(inner, outer, 3), np.linspace(0, np.pi / 2, count + 1), indexing="ij")
    x = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=-1).reshape(-1, 2)
    number = np.arange(len(x)).reshape(radius.shape)
    a, b, c, d = (number[i, j].ravel() for i, j in [np.s_[:-1, :-1], np.s_[1:, :-1], np.s_[1:, 1:], np.s_[:-1, 1:]])
    cells = {"quad": [(a, b, c, d)], "triangle": [(a, b, c), (a, c, d)]}[kind]
    return mesh_from_cells(COMM, x, np.concatenate([np.stack(each, axis=1) for each in cells]), kind)


def on_axes(ring):
    """Facets on both planes of symmetry, with the tags 1 and 2."""
    facets = [mesh.locate_entities_boundary(ring, 1, lambda x, k=k: np.isclose(x[k], 0)) for k in (0, 1)]
    tags = np.repeat([1, 2], [len(each) for each in facets]).astype(np.int32)
    order = np.argsort(np.concatenate(facets))
    return mesh.meshtags(ring, 1, np.concatenate(facets)[order], tags[order])


def fit(kind, degree, smoothing):
    rings = [quarter(0.5, 1 + INTERFERENCE / 2, 8, kind), quarter(1 - INTERFERENCE / 2, 1.5, 11, kind)]
    spaces = [vector_space(ring, degree) for ring in rings]
    contact = DolfinxContact(spaces)
    contact.set_surface_smoothing(smoothing)
    contact.set_symmetry_boundaries([on_axes(ring) for ring in rings], 1, 2)
    strain = lambda w: ufl.sym(ufl.grad(w))
    lame = MODULUS * RATIO / ((1 + RATIO) * (1 - 2 * RATIO)), MODULUS / (2 * (1 + RATIO))
    residuals, held, displacements = [], [], [fem.Function(space) for space in spaces]
    for space, u in zip(spaces, displacements):
        v = ufl.TestFunction(space)
        stress = lame[0] * ufl.tr(strain(u)) * ufl.Identity(2) + 2 * lame[1] * strain(u)
        residuals.append(ufl.inner(stress, strain(v)) * ufl.dx)
        for axis in (0, 1):
            part, _ = space.sub(axis).collapse()
            dofs = fem.locate_dofs_geometrical((space.sub(axis), part), lambda x, k=axis: np.isclose(x[k], 0))
            held.append(fem.dirichletbc(fem.Function(part), dofs, space.sub(axis)))
    return find_equilibrium(ContactProblem(residuals, displacements, held, contact))


@pytest.mark.parametrize("kind", ["quad", "triangle"])
def test_a_second_order_space_on_straight_cells_is_smoothed(kind):
    """Lamé's pressure on a quarter; without smoothing the library warns, and the force is wrong."""
    exact = INTERFERENCE * MODULUS / (1 - RATIO**2) / (3.25 / 1.25 + 1.25 / 0.75)
    smooth, straight = fit(kind, 2, 30.0), fit(kind, 2, 0.0)
    assert smooth.result.bodies[1].force == pytest.approx([exact, exact], rel=5e-3)
    assert straight.result.bodies[1].force[0] > 1.5 * exact
    advised = [any("round" in str(warning) for warning in found.result.warnings) for found in (smooth, straight)]
    assert advised == [False, True]
