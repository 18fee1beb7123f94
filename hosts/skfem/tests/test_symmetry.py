"""Planes of symmetry by the names of a mesh's boundaries."""

import numpy as np
import pytest
import skfem
from fmc_contact_skfem import SkfemContact
from scenes import blocks, displacement, joined
from skfem import Basis, ElementHex1, ElementQuad1, ElementQuadP, ElementTriP3, ElementVector, MeshHex, MeshQuad


def named(bases):
    """The same bases with the wall at x = 0 of the lower block and that at x = 0.1 of the upper one by name."""
    for basis, places in zip(bases, ({"foot": 0.0}, {"wall": 0.1})):
        mesh = basis.mesh.with_boundaries({name: lambda x, at=at: np.isclose(x[0], at) for name, at in places.items()})
        yield Basis(mesh, basis.elem)


@pytest.mark.parametrize("element", ["P1", "Q1", "P2", "Q2", "P1 3D", "Q2 3D"])
def test_boundaries_are_planes(element):
    bases = list(named(blocks(element)))
    # Pressed flat, so that the walls matter.
    u = displacement(bases, bulge=0.0)
    found = []
    for how in (None, "names", "planes"):
        contact = SkfemContact(joined(bases), stiffness=1e4)
        normal = np.eye(contact.contact.dim)[0]
        if how == "names":
            contact.set_symmetry_boundaries("foot", "wall")
        elif how == "planes":
            contact.contact.mesh.set_symmetry_planes([(0.0 * normal, normal), (0.1 * normal, normal)])
        found.append(contact.force(u))
    without, by_names, by_planes = found
    assert np.abs(by_names - without).max() > 1e-3 * np.abs(without).max()
    assert np.array_equal(by_names, by_planes)


@pytest.mark.parametrize("element, kind", [(ElementTriP3(), "P2"), (ElementQuadP(3), "Q2")])
def test_of_elements_whose_unknowns_are_no_nodes(element, kind):
    bases = [Basis(basis.mesh, ElementVector(element)) for basis in named(blocks(kind))]
    contact = SkfemContact(joined(bases), stiffness=1e4)
    u = np.zeros(contact.size)
    forces = []
    for names in ((), ("foot", "wall"), ()):
        contact.set_symmetry_boundaries(*names)
        forces.append(contact.force(u))
    assert np.abs(forces[1] - forces[0]).max() > 1e-3 * np.abs(forces[0]).max()
    assert np.array_equal(forces[0], forces[2])


def quarter(start, end, facets):
    """A quarter of a ring, one cell thick, whose planes have names; ``both`` are the ends of the slice."""
    mesh = MeshHex.init_tensor(np.linspace(start, end, 3), np.linspace(0, np.pi / 2, facets + 1), [0.0, 0.1])
    radius, angle, height = mesh.p
    mesh = MeshHex(np.stack([radius * np.cos(angle), radius * np.sin(angle), height]), mesh.t)
    lies = {name: lambda x, axis=axis, at=at: np.isclose(x[axis], at) for name, axis, at in
            (("x", 0, 0.0), ("y", 1, 0.0), ("low", 2, 0.0), ("high", 2, 0.1))}  # fmt: skip
    lies["both"] = lambda x: lies["low"](x) | lies["high"](x)
    lies["all"] = lambda x: lies["x"](x) | lies["y"](x) | lies["both"](x)
    return Basis(mesh.with_boundaries(lies), ElementVector(ElementHex1()))


def test_a_slice_one_cell_thick():
    """All its nodes lie in the two planes of the slice, so that nodes alone do not tell a cut from the contact surface."""
    bases = [quarter(0.5, 1.0005, 16), quarter(0.9995, 1.5, 16)]
    contact = SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=1e4)
    contact.set_surface_smoothing(30.0)
    axes = np.eye(3)
    contact.contact.mesh.set_symmetry_planes([(0 * axes[0], axis) for axis in axes] + [(0.1 * axes[2], axes[2])])
    u = np.zeros(contact.size)
    expected = contact.force(u)
    contact.set_symmetry_boundaries("x", "y", "low", "high")
    assert np.array_equal(contact.force(u), expected)
    # Of one name for both ends, or for all planes, every plane counts.
    for names in (("both", "x", "y"), ("all",)):
        contact.set_symmetry_boundaries()
        assert not np.array_equal(contact.force(u), expected)
        contact.set_symmetry_boundaries(*names)
        assert np.array_equal(contact.force(u), expected)


@pytest.mark.skipif(not hasattr(skfem, "MeshWedge1"), reason="wedges came with scikit-fem 8")
def test_a_slice_of_wedges():
    flat = skfem.MeshTri.init_tensor(np.linspace(0.0, 1.0, 4), np.linspace(0.0, 0.5, 3))
    bases = []
    for width, low in ((1.0, -0.5), (0.7, -0.01)):
        ends = [np.stack([flat.p[0] * width, flat.p[1] + low, np.full(flat.nvertices, z)]) for z in (0.0, 0.2)]
        mesh = skfem.MeshWedge1(np.hstack(ends), np.vstack([flat.t, flat.t + flat.nvertices]))
        named = mesh.with_boundaries({"cut": lambda x: np.isclose(x[0], 0.0) | np.isclose(abs(x[2] - 0.1), 0.1)})
        bases.append(Basis(named, ElementVector(skfem.ElementWedge1())))
    contact = SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=1e4)
    u = np.zeros(contact.size)
    forces = [contact.force(u)]
    contact.contact.mesh.set_symmetry_planes([(np.zeros(3), axis) for axis in np.eye(3)[[0, 2]]] + [((0, 0, 0.2), (0, 0, 1))])
    forces.append(contact.force(u))
    contact.set_symmetry_boundaries("cut")
    forces.append(contact.force(u))
    assert np.abs(forces[1] - forces[0]).max() > 1e-3 * np.abs(forces[1]).max()
    assert np.array_equal(forces[1], forces[2])


def test_faces_of_collapsed_cells():
    """Quadrilaterals with a corner twice: triangles, whose faces are counted as those of quadrilaterals."""
    p = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]).T
    upper = MeshQuad(p + [[0.0], [0.98]], np.array([[0, 1, 2, 2], [3, 2, 2, 1]]).T).with_boundaries({"wall": lambda x: np.isclose(x[0], 0.0)})
    lower = MeshQuad().with_boundaries({"wall": lambda x: np.isclose(x[0], 0.0)})
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in (lower, upper)]
    contact = SkfemContact(joined(bases), stiffness=1e4)
    u = np.zeros(contact.size)
    contact.contact.mesh.set_symmetry_planes([((0.0, 0.0), (1.0, 0.0))])
    expected = contact.force(u)
    contact.set_symmetry_boundaries()
    assert not np.array_equal(contact.force(u), expected)
    contact.set_symmetry_boundaries("wall")
    assert np.array_equal(contact.force(u), expected)


def test_planes_are_those_of_the_boundary_at_another_reference():
    bases = list(named(blocks("Q1 3D")))
    u = displacement(bases, bulge=0.0)
    contact = SkfemContact(joined(bases), stiffness=1e4)
    contact.set_symmetry_boundaries("foot", "wall")
    expected, x = contact.force(u), contact.coords(np.zeros(contact.size))
    # Depths are the same where all of it has been elsewhere.
    contact.contact.mesh.set_reference(x + [1.0, 0.0, 0.0])
    assert np.abs(contact.force(u) - expected).max() < 1e-12 * np.abs(expected).max()


def test_a_crack_beside_a_ligament():
    """Of two boundaries in one plane the one without a name may touch another body."""
    upper = MeshQuad.init_tensor(np.linspace(0.0, 1.0, 5), np.linspace(0.0, 1.0, 5))
    upper = upper.with_boundaries({"ligament": lambda x: np.isclose(x[1], 0.0) & (x[0] > 0.5)})
    lower = MeshQuad.init_tensor(np.linspace(0.05, 0.45, 4), np.linspace(-0.3, 0.01, 3))
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in (upper, lower)]
    contact = SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=10.0)
    u = np.zeros(contact.size)
    expected = contact.force(u)
    assert np.abs(expected).max() > 0
    contact.set_symmetry_boundaries("ligament")
    assert np.array_equal(contact.force(u), expected)


def test_a_name_that_no_mesh_has():
    contact = SkfemContact(joined(list(named(blocks("P1")))), stiffness=1e4)
    with pytest.raises(ValueError, match="'top'; there are .'foot', 'wall'"):
        contact.set_symmetry_boundaries("wall", "top")
