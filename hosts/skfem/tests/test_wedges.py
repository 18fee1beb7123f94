"""Wedges: hexahedra cut in two, on the same vertices."""

import numpy as np
import pytest
import skfem
from fmc_contact import Contact
from fmc_contact_skfem import SkfemContact
from fmc_contact_skfem.field import cells_of, mesh_from_cells
from scenes import blocks, displacement, joined
from skfem import Basis, ElementVector

pytestmark = pytest.mark.skipif(not hasattr(skfem, "MeshWedge1"), reason="this scikit-fem has no wedges")


def wedges():
    """The bases of two blocks in wedges, and those in hexahedra."""
    hexahedra = blocks("Q1 3D")
    bases = []
    for basis in hexahedra:
        _, conn = cells_of(basis.mesh)
        cut = np.concatenate([conn[:, [0, 1, 2, 4, 5, 6]], conn[:, [0, 2, 3, 4, 6, 7]]])
        mesh = mesh_from_cells(basis.mesh.p.T, cut, "wedge")
        bases.append(Basis(mesh, ElementVector(skfem.ElementWedge1())))
    return bases, hexahedra


def test_forces_are_those_of_the_package_and_of_hexahedra():
    bases, hexahedra = wedges()
    u = displacement(hexahedra)
    contact = SkfemContact(joined(bases), stiffness=1e4, estimator="exact", law="volume")
    cells, first = [], 0
    for basis in bases:
        kind, conn = cells_of(basis.mesh)
        assert kind == "wedge"
        cells.append((kind, conn + first))
        first += basis.mesh.nvertices
    x = np.concatenate([basis.mesh.p.T for basis in bases])
    by_vertex = u[np.concatenate([basis.nodal_dofs.T + offset for basis, offset in joined(bases)])]
    alone = Contact(x, cells, stiffness=1e4, estimator="exact", law="volume").evaluate(x + by_vertex)
    found = contact.evaluate(u)
    assert alone.volume > 1e-4 and (found.forces == alone.forces).all()
    # Undeformed, their blocks are the same.
    still = np.zeros(contact.size)
    expected = SkfemContact(joined(hexahedra), stiffness=1e4, estimator="exact", law="volume").evaluate(still)
    assert contact.evaluate(still).volume == pytest.approx(expected.volume, rel=1e-12)


def test_force_is_minus_the_slope_of_the_energy():
    bases, hexahedra = wedges()
    u, direction = displacement(hexahedra), displacement(hexahedra, 1.0, seed=2, bulge=0.0)
    contact = SkfemContact(joined(bases), stiffness=1e4)
    step = 1e-6
    energies = [contact.evaluate(u + s * step * direction).energy for s in (-1, 1)]
    assert (energies[1] - energies[0]) / (2 * step) == pytest.approx(-contact.force(u) @ direction, rel=1e-6)
