"""Displacements whose unknowns are no nodes: forces and tangent come back to the basis' own unknowns."""

import numpy as np
import pytest
import skfem
from fmc_contact_skfem import LayoutError, SkfemContact
from scenes import MESHES, joined
from skfem import Basis, ElementVector, FacetBasis, LinearForm

ELEMENTS = {
    "P3": (skfem.MeshTri, skfem.ElementTriP3),
    "P4": (skfem.MeshTri, skfem.ElementTriP4),
    "bubble": (skfem.MeshTri, skfem.ElementTriMini),
    "CCR": (skfem.MeshTri, skfem.ElementTriCCR),
    "Hermite": (skfem.MeshTri, skfem.ElementTriHermite),
    "Quad P3": (skfem.MeshQuad, lambda: skfem.ElementQuadP(3)),
    "Quad P4": (skfem.MeshQuad, lambda: skfem.ElementQuadP(4)),
    "bubble 3D": (skfem.MeshTet, skfem.ElementTetMini),
}


def stacked(name, depth=0.01):
    mesh, element = ELEMENTS[name]
    bases = []
    for count, height in ((3, 0.0), (2, 1.0 - depth)):
        dim = mesh().dim()
        ticks = [np.linspace(0.0, 1.0, count + 1)] * (dim - 1) + [np.linspace(height, height + 1.0, count + 1)]
        bases.append(Basis(mesh.init_tensor(*ticks), ElementVector(element()), intorder=8))
    return bases


def pair(name, law="fiber", **options):
    bases = stacked(name)
    return bases, SkfemContact(joined(bases), stiffness=1e4, estimator="exact", law=law, **options)


def some(contact, size):
    return size * np.random.default_rng(5).standard_normal(contact.size)


@pytest.mark.parametrize("name", ELEMENTS)
def test_uniform_pressure_is_the_load_of_the_shape_functions(name):
    bases, contact = pair(name)
    found = contact.force(np.zeros(contact.size))
    assert contact.evaluate(np.zeros(contact.size)).bodies[1].force[-1] == pytest.approx(100.0, rel=1e-9)

    def load(basis, height):
        facets = basis.mesh.facets_satisfying(lambda x: np.isclose(x[-1], height), boundaries_only=True)
        return LinearForm(lambda v, w: v[-1]).assemble(FacetBasis(basis.mesh, basis.elem, facets=facets, intorder=8))

    expected = np.concatenate([-100.0 * load(bases[0], 1.0), 100.0 * load(bases[1], 0.99)])
    assert np.abs(found - expected).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.parametrize("name", ELEMENTS)
def test_nodes_are_where_the_displacement_puts_them(name):
    """Vertices by scikit-fem itself."""
    bases, contact = pair(name)
    u = some(contact, 1e-3)
    nodes = contact.at_vertices(contact.nodes(u))
    for (basis, offset), at in zip(joined(bases), nodes):
        scalar = Basis(basis.mesh, basis.elem.elem, intorder=4)
        dim = basis.mesh.dim()
        for axis in range(dim):
            of_axis = np.zeros(scalar.N)
            of_axis[scalar.element_dofs] = u[offset + basis.element_dofs[axis::dim]]
            corners = basis.mesh.refdom.p
            for corner, t in enumerate(basis.mesh.t):
                values = sum(
                    of_axis[scalar.element_dofs[k]] * np.asarray(scalar.elem.gbasis(scalar.mapping, corners[:, [corner]].astype(float), k)[0])[:, 0]
                    for k in range(len(scalar.element_dofs))
                )
                assert np.abs(at[t, axis] - basis.mesh.p[axis, t] - values).max() < 1e-12


@pytest.mark.parametrize("name", ELEMENTS)
def test_forces_are_those_of_nodes_brought_back(name):
    """Against the same cells whose nodes are moved by themselves."""
    _bases, contact = pair(name)
    u = some(contact, 1e-3)
    found = contact.evaluate(u)
    nodes = contact.nodes(u)
    contact.contact.mesh.set_basis(None)
    of_nodes = contact.contact.evaluate(nodes)
    expected = contact._matrix.T @ of_nodes.forces
    assert np.abs(found.forces[nodes.shape[1] :] - expected).max() < 1e-12 * np.abs(expected).max()
    assert found.energy == pytest.approx(of_nodes.energy, rel=1e-12)


@pytest.mark.parametrize("law", ["fiber", "volume", "depth"])
@pytest.mark.parametrize("name", ELEMENTS)
def test_tangent_is_the_derivative_of_the_force(name, law):
    bases, contact = pair(name, law)
    u = some(contact, 1e-3)
    # The upper block bulges, so that no wall is in contact.
    for (basis, offset), part in zip(joined(bases), (0.0, 1.0)):
        x = basis.project(lambda x: np.array([*(0 * x[:-1]), part * 0.2 * ((x[:-1] - 0.5) ** 2).sum(axis=0)]))
        u[offset : offset + basis.N] += x
    contact.keep_patches(u)
    way = some(contact, 1.0)[::-1].copy()
    h = 1e-7
    by_differences = (contact.force(u - h * way) - contact.force(u + h * way)) / (2 * h)
    found = contact.tangent(u) @ way
    assert np.abs(by_differences).max() > 0
    assert np.abs(found - by_differences).max() < 1e-6 * np.abs(found).max()


def test_beside_bases_of_nodes():
    """P3 on P2: the resultants cancel, and a P2 block bears what it bears on its like."""
    upper = stacked("P3")[1]
    mesh = MESHES["P"][2].init_tensor(*[np.linspace(0.0, 1.0, 4)] * 2)
    lower = Basis(mesh, ElementVector(skfem.ElementTriP2()), intorder=4)
    forces = []
    for other in (upper, Basis(upper.mesh, ElementVector(skfem.ElementTriP2()), intorder=4)):
        contact = SkfemContact(joined([lower, other]), stiffness=1e4, estimator="exact", law="fiber")
        forces.append(contact.force(np.zeros(contact.size))[: lower.N])
    assert np.abs(forces[0] - forces[1]).max() < 1e-12 * np.abs(forces[1]).max()


@pytest.mark.parametrize(
    "mesh, element, words",
    [
        (skfem.MeshTri, skfem.ElementTriCR, "do not agree"),
        (skfem.MeshTri, skfem.ElementTriP0, "do not agree"),
        (skfem.MeshTet, skfem.ElementTetCCR, "faces of tetrahedra"),
    ],
)
def test_what_cannot_be_read_is_refused(mesh, element, words):
    with pytest.raises(LayoutError, match=words):
        SkfemContact(Basis(mesh().refined(1), ElementVector(element()), intorder=2), stiffness=1.0)
