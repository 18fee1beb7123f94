"""Planes of symmetry by regions of a mesh."""

import getfem as gf
import numpy as np
import pytest
from fmc_contact_getfem import GetfemContact
from scenes import ELEMENTS, OPTIONS, grid


def sliced(element):
    """Two blocks one on the other that end at x = 0: region 1; in 3D one cell thick, with the ends for region 2. Region 3 is one whole cell."""
    dim = 3 if "3" in ELEMENTS[element] else 2
    model, kept = gf.Model("real"), []
    for name, cells, low, high in (
        ("u", (4, 2, 1), (0.0, -1.0, 0.0), (1.0, 0.0, 0.3)), ("v", (3, 2, 1), (0.0, -0.02, 0.0), (0.6, 0.9, 0.3)),
    ):  # fmt: skip
        mesh = grid(ELEMENTS[element], cells[:dim], low[:dim], high[:dim])
        x = mesh.pts()
        mesh.set_region(1, mesh.faces_from_pid(np.flatnonzero(np.abs(x[0]) < 1e-9)))
        if dim == 3:
            ends = [mesh.faces_from_pid(np.flatnonzero(np.abs(x[2] - z) < 1e-9)) for z in (0.0, 0.3)]
            mesh.set_region(2, np.hstack(ends))
        mesh.set_region(3, np.array([[0], [-1]]))
        space = gf.MeshFem(mesh, dim)
        space.set_fem(gf.Fem(element))
        model.add_fem_variable(name, space)
        kept.append((space, mesh))
    return GetfemContact(model, ["u", "v"], **OPTIONS), dim


@pytest.mark.parametrize("element", ELEMENTS)
def test_regions_are_planes(element):
    contact, dim = sliced(element)
    forces = [contact.force()]
    normals = np.eye(dim)
    planes = [(0.0 * normals[0], normals[0]), *([(0.0 * normals[2], normals[2]), (0.3 * normals[2], normals[2])] if dim == 3 else [])]
    contact.contact.mesh.set_symmetry_planes(planes)
    forces.append(contact.force())
    contact.set_symmetry_regions()
    assert np.array_equal(contact.force(), forces[0]) and not np.array_equal(forces[0], forces[1])
    contact.set_symmetry_regions(*range(1, dim), 3)
    assert np.array_equal(contact.force(), forces[1])


def test_regions_of_mixed_cells_on_a_shared_mesh():
    """Squares and triangles by turns, two variables on one mesh, and cells whose numbers have gaps."""
    mesh, of_variable = gf.Mesh("empty", 2), {"u": [], "v": []}
    square, triangle = gf.GeoTrans("GT_QK(2,1)"), gf.GeoTrans("GT_PK(2,1)")
    corners = np.array([[0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]])
    mesh.add_convex(square, corners + [[5.0], [5.0]])
    for name, low in (("u", -1.0), ("v", -0.02)):
        size = 0.25 if name == "u" else 0.2
        for row in range(3):
            for column in range(3):
                at = size * (corners + [[column], [row]]) + [[0.0], [low if name == "v" else -3 * size]]
                if (row + column) % 2:
                    of_variable[name].append(mesh.add_convex(square, at))
                else:
                    of_variable[name] += [mesh.add_convex(triangle, at[:, list(k)]) for k in ((0, 1, 2), (1, 3, 2))]
    mesh.del_convex([0])
    x = mesh.pts()
    mesh.set_region(1, mesh.faces_from_pid(np.flatnonzero(np.abs(x[0]) < 1e-9)))
    model, kept = gf.Model("real"), []
    for name, cells in of_variable.items():
        space = gf.MeshFem(mesh, 2)
        kinds, index = mesh.geotrans()
        for cell in np.concatenate([np.ravel(one) for one in cells]):
            linear = "FEM_QK(2,1)" if len(mesh.pid_from_cvid(cell)[0]) == 4 else "FEM_PK(2,1)"
            space.set_fem(gf.Fem(linear), int(cell))
        model.add_fem_variable(name, space)
        kept.append((space, kinds, index))
    contact = GetfemContact(model, ["u", "v"], **OPTIONS)
    free = contact.force()
    contact.contact.mesh.set_symmetry_planes([((0, 0), (1, 0))])
    expected = contact.force()
    contact.contact.mesh.set_symmetry_planes([])
    contact.set_symmetry_regions(1)
    assert np.array_equal(contact.force(), expected) and not np.array_equal(expected, free)


def test_planes_are_those_of_the_region_at_another_reference():
    contact, _ = sliced("FEM_QK(2,1)")
    contact.set_symmetry_regions(1)
    expected = contact.force()
    contact.contact.mesh.set_reference(contact.coords() + [1.0, 0.0])
    # Depths are the same where all of it has been elsewhere, to rounding.
    assert np.abs(contact.force() - expected).max() < 1e-12 * np.abs(expected).max()


def test_a_region_that_no_mesh_has():
    contact, _ = sliced("FEM_QK(2,1)")
    with pytest.raises(ValueError, match=r"no mesh has a region 7; there are \[1, 3\]"):
        contact.set_symmetry_regions(1, 7)
