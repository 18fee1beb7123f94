"""The boundary facets that a host is told of, against the mesh that it gave."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact._cells import face_numbers
from scenes import K

FACES = {
    "triangle": [[0, 1], [1, 2], [2, 0]],
    "quad": [[0, 1], [1, 2], [2, 3], [3, 0]],
    "tetra": [[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]],
    "hexahedron": [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]],
}
"""As in VTK's documentation."""

CUBE = np.array([[x, y, z] for z in (0.0, 1.0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])
SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
MESHES = {
    "triangle": (SQUARE, [[0, 1, 2], [0, 3, 2]]),
    "quad": (SQUARE, [[0, 1, 2, 3]]),
    "tetra": (CUBE, [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]]),
    "hexahedron": (CUBE, [[0, 1, 2, 3, 4, 5, 6, 7]]),
}


def area_vectors(facets, coords):
    x = coords[facets.nodes]
    if coords.shape[1] == 2:
        edge = x[:, 1] - x[:, 0]
        return np.column_stack([edge[:, 1], -edge[:, 0]])
    third = np.where(facets.nodes[:, 3:] < 0, x[:, 2], x.mean(axis=1))
    return 0.5 * np.cross(x[:, 1] - x[:, 0], third - x[:, 0])


@pytest.mark.parametrize("base", [0, 1])
@pytest.mark.parametrize("cell_type", MESHES)
def test_facets_are_outward_faces_of_their_cells(cell_type, base):
    coords, cells = MESHES[cell_type][0], np.array(MESHES[cell_type][1])
    contact = Contact(coords, cells + base, cell_type, stiffness=K, index_base=base)
    facets = contact.mesh.boundary_facets()
    assert len(facets) == contact.facet_count == len(facets.cell) == len(facets.local_face) == len(facets.nodes)
    for cell, face, nodes in zip(facets.cell, facets.local_face, facets.nodes):
        assert set(nodes[nodes >= 0] - base) == set(cells[cell - base][FACES[cell_type][face]])
    facets.nodes[facets.nodes >= 0] -= base
    areas, corner = area_vectors(facets, coords), coords[facets.nodes[:, 0]]
    np.testing.assert_allclose(areas.sum(axis=0), 0, atol=1e-14)
    inside = coords[cells].mean(axis=1)[facets.cell - base]
    assert (np.einsum("md,md->m", areas, corner - inside) > 0).all()
    assert np.linalg.norm(areas, axis=1).sum() == pytest.approx(2 * coords.shape[1], rel=1e-14)
    assert (facets.body == 0).all() and (facets.input_facet == -1).all()


REFERENCE = {
    "triangle": SQUARE[:3], "quad": SQUARE, "tetra": CUBE[[0, 1, 2, 6]], "hexahedron": CUBE, "wedge": CUBE[[0, 1, 2, 4, 5, 6]],
    "pyramid": np.vstack([CUBE[:4], [[0.5, 0.5, 1.0]]]),
}  # fmt: skip


@pytest.mark.parametrize("cell_type", REFERENCE)
def test_faces_are_numbered_by_their_corners(cell_type):
    coords = REFERENCE[cell_type]
    facets = Contact(coords, [np.arange(len(coords))], cell_type, stiffness=K).mesh.boundary_facets()
    is_corner = (facets.nodes[:, :, None] == np.arange(len(coords))).any(axis=1)
    np.testing.assert_array_equal(face_numbers(cell_type, is_corner), facets.local_face)
    with pytest.raises(ValueError, match="face 1 is no face"):
        face_numbers(cell_type, np.stack([is_corner[0], np.ones(len(coords), bool)]))


def test_bodies_come_in_the_order_of_results(squares):
    coords, cells = squares
    facets = Contact(coords, cells, "quad", stiffness=K, bodies=[7, -1]).mesh.boundary_facets()
    np.testing.assert_array_equal(facets.body, [0] * 4 + [1] * 4)
    np.testing.assert_array_equal(facets.cell, [1] * 4 + [0] * 4)


def test_facets_keep_the_numbers_that_they_were_given():
    edges = np.array([[0, 1], [4, 5], [1, 2], [5, 6], [2, 0], [6, 4]])
    coords = np.array([[0, 0], [1, 0], [0, 1], [9, 9], [3, 0], [4, 0], [3, 1]], dtype=float)
    facets = Contact.from_facets(coords, edges, stiffness=K, law="fiber", bodies=[1, 0] * 3).mesh.boundary_facets()
    np.testing.assert_array_equal(facets.input_facet, [1, 3, 5, 0, 2, 4])
    np.testing.assert_array_equal(facets.nodes, edges[facets.input_facet])
    np.testing.assert_array_equal(facets.body, [0] * 3 + [1] * 3)
    assert (facets.cell == -1).all() and (facets.local_face == -1).all()
