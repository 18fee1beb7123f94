"""What cannot be read is refused with a sentence, and a failed call leaves the contact as it was."""

import getfem as gf
import numpy as np
import pytest
from fmc_contact import errors
from fmc_contact_getfem import Bricks, GetfemContact, LayoutError
from scenes import touching


def variable(element, components=2, mesh=None):
    """A model of one variable on triangles, and what has to live."""
    mesh = mesh or gf.Mesh("regular simplices", [0.0, 0.5, 1.0], [0.0, 1.0])
    space = gf.MeshFem(mesh, components)
    space.set_fem(gf.Fem(element))
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    return model, space, mesh


@pytest.mark.parametrize(
    "element, components, words",
    [
        ("FEM_PK(2,1)", 1, "1 components in 2D"),
        ("FEM_PK(2,1)", 3, "3 components in 2D"),
        ("FEM_PK(2,3)", 2, "first or second order"),
        ("FEM_PK(2,0)", 2, "first or second order"),
        ("FEM_PK_DISCONTINUOUS(2,1)", 2, "continuous"),
        ("FEM_PK_WITH_CUBIC_BUBBLE(2,1)", 2, "BUBBLE"),
        ("FEM_HERMITE(2)", 2, "HERMITE"),
    ],
)
def test_other_unknowns_are_refused(element, components, words):
    model, *_kept = variable(element, components)
    with pytest.raises(LayoutError, match=words):
        GetfemContact(model, "u", stiffness=1.0)


def test_meshes_of_lines_and_meshes_that_are_gone_are_refused():
    model, *_kept = variable("FEM_PK(1,1)", 1, gf.Mesh("cartesian", [0.0, 1.0]))
    with pytest.raises(LayoutError, match="1D"):
        GetfemContact(model, "u", stiffness=1.0)
    model, _space, mesh = variable("FEM_PK(2,1)")
    del mesh
    with pytest.raises(LayoutError, match="still there"):
        GetfemContact(model, "u", stiffness=1.0)
    with pytest.raises(LayoutError, match="'v'"):
        GetfemContact(model, "v", stiffness=1.0)


def test_meshes_are_kept_by_the_contact():
    model, space, mesh = variable("FEM_PK(2,1)")
    mesh.set_region(3, mesh.faces_from_pid(np.flatnonzero(mesh.pts()[1] == 0.0)))
    contact = GetfemContact(model, "u", stiffness=1.0)
    del space, mesh
    assert len(contact.nodes("u", 3)) == 3
    assert (contact.coords()[contact.nodes("u", 3)][:, 1] == 0.0).all()


def test_unknowns_that_are_combined_are_refused():
    model, space, _mesh = variable("FEM_PK(2,1)")
    part = gf.MeshFem("partial", space, [0, 1, 2, 3])
    model.add_fem_variable("part", part)
    with pytest.raises(LayoutError, match="reduced|mesh_fem"):
        GetfemContact(model, "part", stiffness=1.0)


def test_curved_cells_want_a_displacement_of_their_own_order():
    mesh = gf.Mesh("regular simplices", [0.0, 1.0], [0.0, 1.0], "degree", 2)
    model, *_kept = variable("FEM_PK(2,1)", 2, mesh)
    with pytest.raises(LayoutError, match="more curved"):
        GetfemContact(model, "u", stiffness=1.0)


def test_complex_models_and_empty_lists_are_refused():
    with pytest.raises(LayoutError, match="complex"):
        GetfemContact(gf.Model("complex"), "u", stiffness=1.0)
    with pytest.raises(ValueError, match="no variable"):
        GetfemContact(gf.Model("real"), [], stiffness=1.0)


def test_variables_move_cells_of_their_own():
    model, space, mesh = variable("FEM_PK(2,1)")
    with pytest.raises(LayoutError, match="'u' is named twice"):
        GetfemContact(model, ["u", "u"], stiffness=1.0)
    model.add_fem_variable("same", space)
    with pytest.raises(LayoutError, match="'u' and 'same' both move cell 0 of the same mesh"):
        GetfemContact(model, ["u", "same"], stiffness=1.0)
    solid = gf.Mesh("cartesian", [0.0, 1.0], [0.0, 1.0], [0.0, 1.0])
    cubes = gf.MeshFem(solid, 3)
    cubes.set_fem(gf.Fem("FEM_QK(3,1)"))
    model.add_fem_variable("w", cubes)
    with pytest.raises(LayoutError, match="'u' is in 2D and 'w' in 3D"):
        GetfemContact(model, ["u", "w"], stiffness=1.0)
    # Cells of one mesh may be divided among variables.
    parts = []
    for name, cells in (("left", [0, 1]), ("right", [2, 3])):
        part = gf.MeshFem(mesh, 2)
        part.set_fem(gf.Fem("FEM_PK(2,1)"), cells)
        parts.append(part)
        model.add_fem_variable(name, part)
    assert len(GetfemContact(model, ["left", "right"], stiffness=1.0).coords()) == 8


def test_arrays_of_another_length_are_refused():
    scene = touching("FEM_PK(2,1)")
    with pytest.raises(ValueError, match="shape"):
        scene.contact.force(np.zeros(3))
    with pytest.raises(ValueError, match="bodies"):
        GetfemContact(scene.model, ["u", "v"], bodies=[1, 2], stiffness=1.0)


@pytest.mark.parametrize("element", ["FEM_PK(2,1)", "FEM_PK(2,2)", "FEM_QK(3,1)"])
def test_statuses_of_the_library_are_exceptions_and_are_survived(element):
    scene = touching(element)
    contact, model = scene.contact, scene.model
    before = contact.force()
    bad = model.from_variables()
    bad[contact.dofs[0, 0]] = np.nan
    with pytest.raises(errors.NonFiniteCoordinateError) as found:
        contact.force(bad)
    assert found.value.status == 9 and found.value.indices["node"] == (0,)
    turned = model.from_variables()
    turned[contact.dofs[0]] = 5.0
    with pytest.raises(errors.InvertedCellError) as found:
        contact.force(turned)
    assert found.value.status == 11
    assert (contact.force() == before).all()


def test_bricks_of_a_failed_update_are_as_they_were():
    scene = touching("FEM_PK(2,1)")
    bricks, model = Bricks(scene.contact), scene.model
    start = model.from_variables()
    bricks.update()
    force = bricks.force.copy()
    model.assembly("build_all")
    side = model.rhs().copy()
    turned = start.copy()
    turned[scene.contact.dofs[0]] = 5.0
    model.to_variables(turned)
    with pytest.raises(errors.InvertedCellError):
        bricks.update()
    model.to_variables(start)
    model.assembly("build_all")
    assert (model.rhs() == side).all() and (bricks.force == force).all() and force.any()


def test_options_are_those_of_the_package():
    model, *_kept = variable("FEM_PK(2,1)")
    with pytest.raises(errors.NotPositiveError):
        GetfemContact(model, "u", stiffness=-1.0)
    with pytest.raises((TypeError, errors.FmcError)):
        GetfemContact(model, "u", stiffness=1.0, stifness=2.0)
    with pytest.raises((errors.UnknownOptionError, ValueError)):
        GetfemContact(model, "u", stiffness=1.0, law="glue")
