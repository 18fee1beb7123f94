"""Planes of symmetry by the tags of facets, on any number of ranks."""

import numpy as np
import pytest
from dolfinx import fem
from dolfinx.mesh import meshtags
from fmc_contact.boundary import corners_of
from fmc_contact_dolfinx import DolfinxContact
from fmc_contact_dolfinx.symmetry import OwnFacets, tagged_faces
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from scenes import COMM, NAMES, block, cracked, permuted, sliced, tagged


@pytest.fixture(scope="module")
def alone(ranks, tmp_path_factory):
    return told(ranks, tmp_path_factory.mktemp("alone"), 1)


def told(ranks, folder, count, *how):
    out = folder / "cut.npz"
    run = ranks(count, "cut", out, *how)
    assert run.returncode == 0, run.stdout + run.stderr
    return dict(np.load(out))


def test_tags_are_planes(alone):
    for case in {name.split("/")[0] for name in alone}:
        of = {name.split("/")[1]: force for name, force in alone.items() if name.startswith(case)}
        if case.startswith("crack"):
            # The block in the crack touches it, as surface beside a ligament, and not where all of it is cut.
            assert np.array_equal(of["ligament"], of["none"])
            assert np.abs(of["both"] - of["none"]).max() > 1e-3 * np.abs(of["none"]).max()
        else:
            assert np.abs(of["tags"] - of["none"]).max() > 1e-3 * np.abs(of["tags"]).max()
            assert np.array_equal(of["tags"], of["planes"])


@pytest.mark.parametrize("count, how", [(1, "parts"), (2, "parts"), (3, "whole"), (4, "parts")])
def test_ranks_find_the_same_planes(ranks, alone, tmp_path, count, how):
    several = told(ranks, tmp_path, count, how)
    assert several.keys() == alone.keys()
    for name, force in alone.items():
        assert np.array_equal(several[name], force), name


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("kind", NAMES)
def test_a_rank_divides_faces_as_the_library_does(kind, order):
    x, cells, _ = permuted(*sliced(kind))
    space = vector_space(mesh_from_cells(COMM, x, cells, kind), order)
    contact = DolfinxContact(space, stiffness=1e4)
    field, mesh = contact._fields[0], contact.contact.mesh
    own = OwnFacets.of(field, tagged_faces(COMM, [field], [tagged(space.mesh, wall=lambda x: np.isclose(x[0], 0.0))], [1])[0])
    facets = mesh.boundary_facets()
    corners = corners_of(facets, mesh.point_weights().to_points(contact.coords(fem.Function(space))), 0)
    middles = [np.sort(np.round(each.mean(axis=1), 9).view([("", float)] * x.shape[1]).ravel()) for each in (own.corners, corners)]
    assert np.array_equal(*middles)
    assert np.array_equal(own.is_named, np.isclose(own.corners[:, :, 0], 0.0).all(axis=1)) and own.is_named.any()
    # Blocks are the nodes, in another order.
    assert facets.nodes.max() < contact.contact.node_count
    counts = [np.unique(each[each >= 0], return_counts=True)[1] for each in (own.nodes, facets.nodes)]
    assert np.array_equal(*map(np.sort, counts))


def test_prisms():
    from fmc_contact_dolfinx.cells import faces

    # Both triangles, and the quadrilaterals on the edges of the first: as VTK and as basix count them.
    assert sorted(faces("prism")) == list(range(5)) and sorted(faces("pyramid")) == list(range(5))
    assert set(faces("prism")[[0, 4]]) == {0, 1} and faces("pyramid")[0] == 0


def test_elements_whose_unknowns_are_no_nodes():
    x, cells, _ = permuted(*sliced("triangle"))
    space = vector_space(mesh_from_cells(COMM, x, cells, "triangle"), 3)
    contact, u = DolfinxContact(space, stiffness=1e4), fem.Function(space)
    forces = [contact.force(u)]
    contact.contact.mesh.set_symmetry_planes([((0, 0), (1, 0))])
    forces.append(contact.force(u))
    contact.contact.mesh.set_symmetry_planes([])
    contact.set_symmetry_boundaries(tagged(space.mesh, wall=lambda x: np.isclose(x[0], 0.0)), 1)
    forces.append(contact.force(u))
    assert not np.array_equal(forces[0], forces[1]) and np.array_equal(forces[1], forces[2])
    with pytest.raises(ValueError, match="set_symmetry_boundaries"):
        contact.set_symmetry_blocks([0])


def test_planes_are_those_of_the_boundary_at_another_reference():
    x, cells, _ = permuted(*sliced("hexahedron"))
    space = vector_space(mesh_from_cells(COMM, x, cells, "hexahedron"))
    contact, u = DolfinxContact(space, stiffness=1e4), fem.Function(space)
    places = {"wall": lambda x: np.isclose(x[0], 0.0), "low": lambda x: np.isclose(x[2], 0.0), "high": lambda x: np.isclose(x[2], 0.3)}
    contact.set_symmetry_boundaries(tagged(space.mesh, **places), 1, 2, 3)
    expected = contact.force(u)
    contact.contact.mesh.set_reference(contact.coords(u) + [1.0, 2.0, 3.0])
    # Depths are the same where all of it has been elsewhere, to rounding.
    assert np.abs(contact.force(u) - expected).max() < 1e-12 * np.abs(expected).max()


def test_two_spaces():
    parts = [block("quad", 4, [0.0, -1.0], [1.0, 0.0]), block("quad", 3, [0.0, -0.02], [0.6, 0.9])]
    spaces = [vector_space(mesh_from_cells(COMM, *part, "quad")) for part in parts]
    us = [fem.Function(space) for space in spaces]
    for in_parts in (False, True):
        contact = DolfinxContact(spaces, stiffness=1e4, in_parts=in_parts)
        wall = [tagged(space.mesh, wall=lambda x: np.isclose(x[0], 0.0)) for space in spaces]
        contact.contact.mesh.set_symmetry_planes([((0, 0), (1, 0))])
        expected = contact.force(*us)
        # The wall of the second alone.
        contact.set_symmetry_boundaries([None, wall[1]], 1)
        assert not np.array_equal(contact.force(*us)[0], expected[0])
        contact.set_symmetry_boundaries(wall, 1)
        assert all(map(np.array_equal, contact.force(*us), expected))


@pytest.mark.parametrize("in_parts", [False, True])
def test_what_names_no_boundaries_is_refused(in_parts):
    x, cells = cracked()
    mesh, other = (mesh_from_cells(COMM, x, cells, "quad") for _ in range(2))
    space = vector_space(mesh)
    contact = DolfinxContact(space, stiffness=1e4, in_parts=in_parts)
    below = lambda x: np.isclose(x[1], 0.0)
    tags = tagged(mesh, ligament=lambda x: below(x) & (abs(x[0] - 0.5625) > 0.1), crack=below)
    with pytest.raises(ValueError, match=r"no facet has the tag 7; there are \[1, 2\]"):
        contact.set_symmetry_boundaries(tags, 1, 7)
    with pytest.raises(ValueError, match="of another mesh"):
        contact.set_symmetry_boundaries(tagged(other, wall=below), 1)
    with pytest.raises(ValueError, match="dimension 2, expected facets"):
        contact.set_symmetry_boundaries(meshtags(mesh, 2, np.array([0], np.int32), np.array([1], np.int32)), 1)
    with pytest.raises(TypeError, match="expected MeshTags"):
        contact.set_symmetry_boundaries(1, 2)
    with pytest.raises(ValueError, match="tags of 2 spaces, and there are 1"):
        contact.set_symmetry_boundaries([tags, tags], 1)
    if in_parts:
        with pytest.raises(TypeError, match="set_symmetry_boundaries"):
            contact.contact.mesh.set_symmetry_facets([0], x)
