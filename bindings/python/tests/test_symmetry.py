"""Planes of symmetry by a point and a normal, beside the nodes and the facets in them."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.errors import BadValueError, NotPositiveError, UnsupportedError
from fmc_contact.symmetry import lie_in, planes_through


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


def at(contact, points, axis, place):
    """Which facets have all their corners at a coordinate."""
    facets = contact.mesh.boundary_facets()
    return (np.isclose(points[facets.nodes, axis], place) | (facets.nodes < 0)).all(axis=1)


def slice_of_bricks(cell_type):
    """Two blocks of bricks, one on the other and one cell thick: all nodes lie in the planes z = 0 and z = 0.3."""
    coords, cells = [], []
    for width, low, n in ((1.0, -1.0, 4), (0.6, -0.02, 3)):
        x, y, z = np.meshgrid(np.linspace(0, width, n + 1), low + np.linspace(0, 1, 3), [0.0, 0.3], indexing="ij")
        first = sum(map(len, coords))
        coords.append(np.stack([x.ravel(), y.ravel(), z.ravel()], 1))
        i = np.arange((n + 1) * 6).reshape(n + 1, 3, 2) + first
        around = ((0, 0), (1, 0), (1, 1), (0, 1))
        cells += [[i[a + p, b + q, k] for k in (0, 1) for p, q in around] for a in range(n) for b in range(2)]
    bricks = np.array(cells)
    if cell_type == "wedge":
        return np.vstack(coords), np.concatenate([bricks[:, [0, 1, 2, 4, 5, 6]], bricks[:, [0, 2, 3, 4, 6, 7]]])
    return np.vstack(coords), bricks


@pytest.mark.parametrize("cell_type", ["hexahedron", "wedge"])
@pytest.mark.parametrize("base", [0, 1])
def test_facets_tell_what_is_cut_in_a_slice(cell_type, base):
    coords, cells = slice_of_bricks(cell_type)
    contact = Contact(coords, cells + base, cell_type, stiffness=1.0, index_base=base)
    contact.mesh.set_symmetry_planes([((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (0, 0, 1)), ((0, 0, 0.3), (0, 0, 1))])
    expected = contact.evaluate(coords)
    moved = np.vstack([coords[:1] * np.nan, coords]) if base else coords
    named = at(contact, moved, 0, 0.0) | at(contact, moved, 2, 0.0) | at(contact, moved, 2, 0.3)
    contact.mesh.set_symmetry_planes([])
    assert contact.evaluate(coords).energy != expected.energy
    for facets in (named, np.flatnonzero(named)[::-1]):
        contact.mesh.set_symmetry_facets(facets, coords.T)
        np.testing.assert_array_equal(contact.evaluate(coords).forces, expected.forces)
    # All nodes are named: they tell the planes of the slice alone.
    contact.mesh.set_symmetry_nodes(np.arange(len(coords)) + base)
    assert contact.evaluate(coords).energy != expected.energy


def test_facets_of_second_order_and_of_unknowns_are_planes():
    coords, cells = blocks()
    edges, middle = {}, []
    nine = []
    for cell in cells:
        ring = [tuple(sorted((a, b))) for a, b in zip(cell, np.roll(cell, -1))]
        for edge in ring:
            edges.setdefault(edge, len(coords) + len(edges))
        nine.append([*cell, *(edges[edge] for edge in ring)])
    middle = np.array([coords[list(edge)].mean(axis=0) for edge in edges])
    full, eight = np.vstack([coords, middle]), np.array(nine)
    # Unknowns are the nodes in another order.
    order = np.random.default_rng(1).permutation(len(full))
    for matrix in (None, np.eye(len(full))[:, order]):
        contact = Contact(full, eight, "quad8", stiffness=1.0)
        contact.mesh.set_basis(matrix)
        unknowns = full if matrix is None else full[order]
        contact.mesh.set_symmetry_planes([((0, 0), (1, 0))])
        expected = contact.evaluate(unknowns)
        points = contact.mesh.point_weights().to_points(unknowns)
        contact.mesh.set_symmetry_planes([])
        contact.mesh.set_symmetry_facets(at(contact, points, 0, 0.0), unknowns)
        np.testing.assert_array_equal(contact.evaluate(unknowns).forces, expected.forces)


def test_planes_of_facets_follow_the_reference():
    """Bodies that are told to have been elsewhere without deformation, where the same facets are cut."""
    coords, cells = blocks()
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    named = at(contact, coords, 0, 0.0)
    contact.mesh.set_symmetry_facets(named, coords)
    for elsewhere in (coords + [3.0, 0.0], coords @ turn.T, coords * [1.0, 1.1]):
        fresh = Contact(elsewhere, cells, "quad", stiffness=1.0)
        across = elsewhere[0] - elsewhere[1]
        fresh.mesh.set_symmetry_planes([(elsewhere[0], (-across[1], across[0]))])
        contact.mesh.set_reference(elsewhere)
        np.testing.assert_array_equal(contact.evaluate(coords).forces, fresh.evaluate(coords).forces)
    # Planes that were set stay, and are nowhere near.
    contact.mesh.set_symmetry_planes([((0, 0), (1, 0))])
    contact.mesh.set_reference(coords + [3.0, 0.0])
    free = Contact(coords + [3.0, 0.0], cells, "quad", stiffness=1.0)
    np.testing.assert_array_equal(contact.evaluate(coords).forces, free.evaluate(coords).forces)


def test_planes_of_facets_may_come_to_lie_beside_others():
    """Where the upper block has been to the left without deformation, its cut wall lies in the plane of the other's cut wall no more, and where it
    has been a little up, it still does."""
    coords, cells = blocks()
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    contact.mesh.set_symmetry_facets(at(contact, coords, 0, 0.0), coords)
    for shift in ([-0.6, 0.0], [0.0, 0.3]):
        beside = coords.copy()
        beside[15:] += shift
        contact.mesh.set_reference(beside)
        by_nodes = Contact(beside, cells, "quad", stiffness=1.0)
        by_nodes.mesh.set_symmetry_nodes(np.flatnonzero(coords[:, 0] == 0.0))
        np.testing.assert_array_equal(contact.evaluate(coords).forces, by_nodes.evaluate(coords).forces)


def crack(cells_below):
    """A block on half of its lower side, whose other half is a crack over a second block."""
    x, y = np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 3), indexing="ij")
    coords = [np.stack([x.ravel(), y.ravel()], 1)]
    x, y = np.meshgrid(np.linspace(0.05, 0.45, cells_below + 1), [-0.3, 0.01], indexing="ij")
    coords.append(np.stack([x.ravel(), y.ravel()], 1))
    i, j = np.arange(15).reshape(5, 3), 15 + np.arange(2 * cells_below + 2).reshape(-1, 2)
    cells = [[k[a, b], k[a + 1, b], k[a + 1, b + 1], k[a, b + 1]]
             for k, n, m in ((i, 4, 2), (j, cells_below, 1)) for a in range(n) for b in range(m)]  # fmt: skip
    return np.vstack(coords), np.array(cells)


def test_a_crack_beside_a_ligament_stays_surface():
    coords, cells = crack(3)
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    expected = contact.evaluate(coords)
    assert expected.energy > 0.0
    bottom, middle = at(contact, coords, 1, 0.0), coords[contact.mesh.boundary_facets().nodes].mean(axis=1)
    contact.mesh.set_symmetry_facets(bottom & (middle[:, 0] > 0.5), coords)
    np.testing.assert_array_equal(contact.evaluate(coords).forces, expected.forces)
    # A crack one facet long has named nodes alone.
    before = contact.mesh.boundary_facets()
    with pytest.raises(ValueError, match="leave out 0 of them, and name 1 others"):
        contact.mesh.set_symmetry_facets(bottom & ((middle[:, 0] < 0.25) | (middle[:, 0] > 0.5)), coords)
    np.testing.assert_array_equal(contact.evaluate(coords).forces, expected.forces)
    assert len(before) == len(bottom)


def test_a_reference_that_is_refused_changes_nothing():
    """One half of a side is raised, so that the facet between the halves is inclined; where all of it is level, nodes would name this too."""
    level, cells = crack(3)
    bent = level.copy()
    bent[(level[:, 1] == 0.0) & (level[:, 0] < 0.3), 1] = 0.05
    contact = Contact(bent, cells, "quad", stiffness=1.0)
    facets = contact.mesh.boundary_facets()
    ends = level[facets.nodes]
    below = (ends[:, :, 1] == 0.0).all(axis=1)
    contact.mesh.set_symmetry_facets(below & ((ends[:, :, 0] < 0.3).all(axis=1) | (ends[:, :, 0] > 0.3).all(axis=1)), bent)
    expected = contact.evaluate(level)
    for coords, told in ((level, "name 1 others"), (bent[:3], "3")):
        with pytest.raises(ValueError, match=told):
            contact.mesh.set_reference(coords)
        np.testing.assert_array_equal(contact.evaluate(level).forces, expected.forces)
    contact.mesh.set_reference(bent)
    np.testing.assert_array_equal(contact.evaluate(level).forces, expected.forces)


def test_what_names_no_facets_in_planes_is_refused():
    coords, cells = blocks()
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    for facets, error, told in (
        ([0.5], TypeError, "integers"), ([-1], BadValueError, "negative"), ([99], BadValueError, "there are"), ([True], ValueError, "marks"),
        (np.ones(contact.facet_count, bool), UnsupportedError, "surface"),
    ):  # fmt: skip
        with pytest.raises(error, match=told):
            contact.mesh.set_symmetry_facets(facets, coords)
    with pytest.raises(ValueError, match="coords"):
        contact.mesh.set_symmetry_facets([0], coords[:4])
    around = np.linspace(0, 2 * np.pi, 1200, endpoint=False)
    ring = np.concatenate([r * np.stack([np.cos(around), np.sin(around)], 1) for r in (1.0, 1.1)])
    n = np.arange(1200)
    disc = Contact(ring, np.stack([n, 1200 + n, 1200 + (n + 1) % 1200, (n + 1) % 1200], 1), "quad", stiffness=1.0)
    inner = (disc.mesh.boundary_facets().nodes < 1200).all(axis=1)
    with pytest.raises(ValueError, match="curved surface"):
        disc.mesh.set_symmetry_facets(inner, ring)


def test_a_plane_is_fitted_to_all_facets_in_it():
    """Coordinates of seven digits in an oblique plane: the normal of a single facet would leave it before its end."""
    turn = np.linalg.qr(np.random.default_rng(2).standard_normal((3, 3)))[0]
    ticks = np.linspace(0.0, 1.0, 301)
    corners = np.array([[[a, 0.0, 0.0], [b, 0.0, 0.0], [b, 0.004, 0.0]] for a, b in zip(ticks, ticks[1:])])
    facets = np.round(corners @ turn.T, 7)
    assert len(planes_through(facets)) == 1 and lie_in(planes_through(facets), facets).all()
    mixed = np.concatenate([facets, facets @ np.diag([1.0, 1.0, -1.0])])
    first, second = planes_through(mixed), planes_through(mixed[np.random.default_rng(3).permutation(len(mixed))])
    assert len(first) == 2 and all(np.array_equal(*pair) for pair in zip(np.array(first), np.array(second)))
