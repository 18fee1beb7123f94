"""What cannot be read is refused with a sentence, and a failed call leaves the contact as it was."""

import numpy as np
import pytest
import skfem
from fmc_contact import errors
from fmc_contact_skfem import LayoutError, SkfemContact
from scenes import blocks, displacement, joined
from skfem import Basis, ElementDG, ElementTriCR, ElementTriP1, ElementTriP2, ElementVector, MeshTri


@pytest.mark.parametrize(
    "element, words",
    [
        (ElementTriP1(), "a displacement is wanted"),
        (ElementVector(ElementTriCR()), "ElementTriCR"),
        (ElementVector(ElementDG(ElementTriP1())), "ElementDG"),
        (ElementVector(ElementTriP1(), 3), "3 components in 2D"),
        (ElementTriP2(), "a displacement is wanted"),
    ],
)
def test_other_unknowns_are_refused(element, words):
    with pytest.raises(LayoutError, match=words):
        SkfemContact(Basis(MeshTri(), element), stiffness=1.0)


def test_meshes_of_lines_are_refused():
    with pytest.raises(LayoutError):
        SkfemContact(Basis(skfem.MeshLine(), ElementVector(skfem.ElementLineP1())), stiffness=1.0)


def test_vectors_of_another_length_are_refused():
    bases = blocks("P1")
    contact = SkfemContact(joined(bases), stiffness=1e4)
    with pytest.raises(ValueError, match="shape"):
        contact.force(np.zeros(3))
    with pytest.raises(ValueError, match="too short"):
        SkfemContact(joined(bases), stiffness=1e4, size=5)


@pytest.mark.parametrize("element", ["P1", "P2", "Q1 3D"])
def test_numbers_that_are_none_are_told_and_survived(element):
    bases = blocks(element)
    contact = SkfemContact(joined(bases), stiffness=1e4, estimator="exact")
    u = displacement(bases)
    before = contact.force(u)
    bad = u.copy()
    bad[contact._dofs[0, 0]] = np.nan
    with pytest.raises(errors.NonFiniteCoordinateError):
        contact.force(bad)
    assert (contact.force(u) == before).all()


def test_a_cell_turned_inside_out_is_told():
    bases = blocks("P1")
    contact = SkfemContact(joined(bases), stiffness=1e4, estimator="exact")
    u = np.zeros(contact.size)
    inside = bases[0].mesh.interior_nodes()[0]
    u[bases[0].nodal_dofs[:, inside]] = 5.0
    with pytest.raises(errors.InvertedCellError):
        contact.force(u)


def test_unknown_options_are_refused():
    with pytest.raises((TypeError, errors.FmcError)):
        SkfemContact(blocks("P1")[0], stiffness=1.0, stifness=2.0)
    with pytest.raises(errors.UnknownOptionError, match="divisions"):
        SkfemContact(blocks("P2")[0], stiffness=1.0, divisions=2)


def test_curved_meshes_want_a_displacement_of_their_own_order():
    for mesh, element in ((skfem.MeshTri2, ElementTriP1), (skfem.MeshQuad2, skfem.ElementQuadS2)):
        with pytest.raises(LayoutError, match="curved"):
            SkfemContact(Basis(mesh(), ElementVector(element())), stiffness=1.0)
