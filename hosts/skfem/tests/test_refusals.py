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
        (ElementTriP1(), "expected a displacement"),
        (ElementVector(ElementTriCR()), "ElementTriCR"),
        (ElementVector(ElementDG(ElementTriP1())), "ElementDG"),
        (ElementVector(ElementTriP1(), 3), "3 components in 2D"),
        (ElementTriP2(), "expected a displacement"),
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


@pytest.mark.parametrize(
    ("places", "words"),
    [
        ((0, 0), r"bases\[0\] has the unknowns 0 to 7 and bases\[1\] 0 to 7: every basis has separate unknowns"),
        ((6, 13), r"bases\[0\] has the unknowns 6 to 13 and bases\[1\] 13 to 20"),
        ((7, 0), r"bases\[1\] has the unknowns 0 to 7 and bases\[0\] 7 to 14"),
        ((-1, 8), r"the offset of bases\[0\] is -1, expected the number of its first unknown, from 0"),
        ((0, 8.0), r"the offset of bases\[1\] is 8.0"),
        ((0, True), r"the offset of bases\[1\] is True"),
        ((0, None), r"the offset of bases\[1\] is None"),
        ((0, np.arange(2)), r"the offset of bases\[1\] is array"),
    ],
)
def test_bases_have_unknowns_of_their_own(places, words):
    basis = Basis(MeshTri(), ElementVector(ElementTriP1()))
    with pytest.raises(ValueError, match=words):
        SkfemContact([(basis, place) for place in places], stiffness=1.0)
    other = Basis(MeshTri().translated((0, 1)), ElementVector(ElementTriP1()))
    # Beside one another, with a gap, and in another order.
    for first, second in ((0, 8), (3, np.int64(20)), (8, 0)):
        contact = SkfemContact(((basis, first), [other, second]), stiffness=1.0)
        assert contact.size == max(first, second) + 8


def test_bases_without_their_places_are_refused_with_what_to_give():
    basis = Basis(MeshTri(), ElementVector(ElementTriP1()))
    wanted = r"expected a pair of a basis and the place of its first unknown: \[\(first, 0\), \(second, first.N\)\]"
    for bases, words in (
        ([basis, basis], r"bases\[0\] is a basis alone, " + wanted),
        ((basis, 0), r"bases\[0\] is a basis alone, " + wanted),
        ([(basis, 0), basis], r"bases\[1\] is a basis alone, " + wanted),
        ([(basis, 0, 0)], r"bases\[0\] is a tuple of 3, " + wanted),
        ([(0, basis)], r"bases\[0\] is a pair that begins with a int, " + wanted),
        ([None], r"bases\[0\] is a NoneType, " + wanted),
        (zip([basis], [0]), r"bases is a zip, expected a basis or a list of \(basis, offset\)"),
    ):
        with pytest.raises(LayoutError, match=words):
            SkfemContact(bases, stiffness=1.0)
    with pytest.raises(ValueError, match="there is no basis"):
        SkfemContact([], stiffness=1.0)


def test_bases_of_the_plane_and_of_space_are_refused_together():
    plane = Basis(MeshTri(), ElementVector(ElementTriP1()))
    space = Basis(skfem.MeshTet(), ElementVector(skfem.ElementTetP1()))
    with pytest.raises(LayoutError, match=r"bases\[0\] is in 2D and bases\[1\] in 3D"):
        SkfemContact([(plane, 0), (space, plane.N)], stiffness=1.0)


@pytest.mark.parametrize("size", [9.0, "9", True])
def test_a_size_that_is_no_integer_is_refused(size):
    with pytest.raises(ValueError, match=f"the size is {size!r}, expected an integer"):
        SkfemContact(Basis(MeshTri(), ElementVector(ElementTriP1())), size=size)


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
