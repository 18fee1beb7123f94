"""Planes of symmetry by a point and a normal, beside the nodes in them."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.errors import NotPositiveError


def blocks():
    """Half of a block on half of a wider one, with x = 0 for a plane of symmetry."""
    grids = [np.meshgrid(np.linspace(0, w, n + 1), np.linspace(0, 1, 3), indexing="ij") for w, n in ((1.0, 4), (0.6, 3))]
    lower, upper = (np.stack([x.ravel(), y.ravel()], 1) for x, y in grids)
    coords = np.vstack([lower - [0, 1], upper - [0, 0.02]])
    cells = []
    for first, n in ((0, 4), (15, 3)):
        i = np.arange((n + 1) * 3).reshape(n + 1, 3) + first
        cells += [[i[a, b], i[a + 1, b], i[a + 1, b + 1], i[a, b + 1]] for a in range(n) for b in range(2)]
    return coords, np.array(cells)


def test_planes_are_those_of_their_nodes():
    coords, cells = blocks()
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    with_walls = contact.evaluate(coords)
    contact.mesh.set_symmetry_nodes(np.flatnonzero(coords[:, 0] == 0))
    by_nodes = contact.evaluate(coords)
    contact.mesh.set_symmetry_planes([((0, 5), (-3, 0))])
    by_planes = contact.evaluate(coords)
    np.testing.assert_array_equal(by_planes.forces, by_nodes.forces)
    assert by_planes.energy > with_walls.energy
    assert [warning.kind for warning in with_walls.warnings] == ["flush_faces"] and not by_planes.warnings
    contact.mesh.set_symmetry_planes([])
    assert contact.evaluate(coords).energy == with_walls.energy


def test_what_is_no_plane_is_refused():
    coords, cells = blocks()
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    with pytest.raises(NotPositiveError, match="normal"):
        contact.mesh.set_symmetry_planes([((0, 0), (0, 0))])
    with pytest.raises(ValueError, match="planes"):
        contact.mesh.set_symmetry_planes([((0, 0, 0), (1, 0, 0))])


def test_a_steep_distance_is_refused_and_a_gentle_one_told():
    coords, cells = blocks()

    def told(slope):
        contact = Contact(coords, cells, "quad", stiffness=1.0)
        contact.obstacles.add_signed_distance(lambda x: (slope * (x[:, 1] + 0.9), np.tile([0, slope], (len(x), 1))))
        return [warning.kind for warning in contact.evaluate(coords).warnings]

    assert "gentle_distance" not in told(1.0)
    assert "gentle_distance" in told(0.4)
    with pytest.raises(ValueError, match="grows faster than a distance"):
        told(3.0)


def test_the_local_pressure_is_that_of_the_law():
    coords, cells = blocks()
    field = Contact(coords, cells, "quad", stiffness=1.0).nodal_contact(coords)
    on_face = field.area > 0
    assert field.local_pressure.max() <= 0.02 * (1 + 1e-12)
    np.testing.assert_allclose(field.gap[on_face], -field.local_pressure[on_face], rtol=1e-12)
