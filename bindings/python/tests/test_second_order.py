"""Cells of second order: pressure as the integrals of their shape functions, cells that fit and that do not, points."""

import numpy as np
import pytest
from fmc_contact import Contact, contact_force, errors
from numpy.polynomial.legendre import leggauss
from scenes import K

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
MIDDLE = [[0.5, 0.5, 0.5]]
FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]

CELLS = {
    "triangle6": (SQUARE, [[0, 1, 2], [0, 2, 3]], "01 12 20"),
    "quad8": (SQUARE, [[0, 1, 2, 3]], "01 12 23 30"),
    "quad9": (SQUARE, [[0, 1, 2, 3]], "01 12 23 30 0123"),
    "tetra10": (CUBE, [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]], "01 12 20 03 13 23"),
    "hexahedron20": (CUBE, [list(range(8))], "01 12 23 30 45 56 67 74 04 15 26 37"),
    "hexahedron27": (
        CUBE,
        [list(range(8))],
        "01 12 23 30 45 56 67 74 04 15 26 37 0473 1265 0154 3762 0321 4567 01234567",
    ),
    "wedge15": (CUBE, [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]], "01 12 20 34 45 53 03 14 25"),
    "pyramid13": (np.vstack([CUBE, MIDDLE]), [[*face[::-1], 8] for face in FACES], "01 12 23 30 04 14 24 34"),
}
"""Corners of a unit block, cells, and what lies between which corners of a cell, in meshio's order."""


def with_middles(corners, blocks):
    """Nodes and cells of second order, given straight cells by type; nodes are shared."""
    coords, numbers = [tuple(x) for x in corners], {}
    found = []
    for name, cells in blocks:
        between = [[int(digit) for digit in word] for word in CELLS[name][2].split()]
        conn = []
        for cell in cells:
            row = list(cell)
            for around in between:
                key = frozenset(cell[k] for k in around)
                if key not in numbers:
                    numbers[key] = len(coords)
                    coords.append(tuple(np.mean([corners[node] for node in key], axis=0)))
                row.append(numbers[key])
            conn.append(row)
        found.append((name, conn))
    return np.array(coords), found


def block(name):
    corners, cells, _ = CELLS[name]
    return with_middles(corners, [(name, cells)])


def together(*bodies):
    """Bodies on one array of nodes."""
    start, blocks = 0, []
    for coords, cells in bodies:
        blocks += [(name, (np.array(conn) + start).tolist()) for name, conn in cells]
        start += len(coords)
    return np.vstack([coords for coords, _ in bodies]), blocks


def integral(of_node, corners):
    """The integral over a face or edge of the polynomial of second order that is 1 at one of its nodes, 0 at the others, by Gauss's
    quadrature; ``corners`` 2, 3 or 4."""
    points, weights = leggauss(4)
    points, weights = (points + 1) / 2, weights / 2
    if corners == 2:
        nodes, terms = [[0], [1], [0.5]], lambda s: [1, s, s * s]
        grid = [(terms(s), w) for s, w in zip(points, weights)]
    elif corners == 3:
        nodes = [[0, 0], [1, 0], [0, 1], [0.5, 0], [0.5, 0.5], [0, 0.5]]
        terms = lambda s, t: [1, s, t, s * s, s * t, t * t]
        # By Duffy's map of the square.
        grid = [(terms(s, t * (1 - s)), v * w * (1 - s)) for s, v in zip(points, weights) for t, w in zip(points, weights)]
    else:
        nodes = [[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0], [1, 0.5], [0.5, 1], [0, 0.5], [0.5, 0.5]]
        full = lambda s, t: [s**i * t**j for i in range(3) for j in range(3)]
        count = len(of_node)
        terms = full if count == 9 else lambda s, t: full(s, t)[:8]
        nodes = nodes[:count]
        grid = [(terms(s, t), v * w) for s, v in zip(points, weights) for t, w in zip(points, weights)]
    coefficients = np.linalg.solve([terms(*x) for x in nodes], of_node)
    return sum(w * np.dot(values, coefficients) for values, w in grid)


def shares(coords, faces, full):
    """Integrals of the shape functions of the nodes on a flat face, ``faces`` its parts as corners."""
    found = np.zeros(len(coords))
    for corners in faces:
        x = coords[corners]
        rim = [(x[k] + x[(k + 1) % len(x)]) / 2 for k in range(len(x))] if len(x) > 2 else [x.mean(axis=0)]
        places = [*x, *rim] + ([x.mean(axis=0)] if len(x) == 4 and full else [])
        if len(x) == 2:
            size = np.linalg.norm(x[1] - x[0])
        else:
            # Twice the area of a triangle, the area of a parallelogram.
            size = np.linalg.norm(np.cross(x[1] - x[0], x[-1] - x[0]))
        for k, place in enumerate(places):
            node = np.flatnonzero(np.abs(coords - place).max(axis=1) < 1e-12)
            assert len(node) == 1
            found[node[0]] += size * integral(np.eye(len(places))[k], len(x))
    return found


def bottom(name):
    """Parts of the lower face as corners."""
    return {
        "triangle6": [[0, 1]],
        "quad8": [[0, 1]],
        "quad9": [[0, 1]],
        "tetra10": [[0, 1, 2], [0, 2, 3]],
        "wedge15": [[0, 1, 2], [0, 2, 3]],
    }.get(name, [[0, 1, 2, 3]])


def dimension(name):
    return CELLS[name][0].shape[1]


@pytest.mark.parametrize("name, other", [(a, b) for a in CELLS for b in CELLS if dimension(a) == dimension(b)])
@pytest.mark.parametrize("law", ["fiber", "volume"])
def test_uniform_pressure_is_that_of_the_shape_functions(name, other, law):
    upper, lower = block(name), block(other)
    dim = upper[0].shape[1]
    deep = 1e-3
    shift = np.full(dim, 0.1)
    shift[-1] = 1 - deep
    # Upper on the middle of the lower: its face all in contact.
    small = upper[0] * 0.8
    coords, cells = together((lower[0], lower[1]), (small + shift, upper[1]))
    result = contact_force(coords, cells, stiffness=K, law=law, estimator="exact")
    forces = result.forces[len(lower[0]) :]
    pressure = K * deep if law == "fiber" else K
    expected = pressure * shares(small, bottom(name), full=name in ("quad9", "hexahedron27"))
    np.testing.assert_allclose(forces[:, -1], expected, atol=1e-9 * pressure)
    assert result.volume == pytest.approx(deep * 0.8 ** (dim - 1), rel=1e-9)


def test_cells_that_fit_together():
    # A pyramid of thirteen nodes on a hexahedron of twenty, tetrahedra of ten at the pyramid's sides.
    corners = np.vstack([CUBE, [[0.5, 0.5, 1.5], [1.5, 0.5, 1.25]]])
    blocks = [
        ("hexahedron20", [list(range(8))]),
        ("pyramid13", [[4, 5, 6, 7, 8]]),
        ("tetra10", [[5, 6, 8, 9]]),
    ]
    coords, cells = with_middles(corners, blocks)
    contact = Contact(coords, cells, stiffness=K, law="volume", estimator="exact")
    assert contact.body_count == 1
    contact.obstacles.add_half_space((0, 0, 0.1), (0, 0, 1))
    assert contact.evaluate(coords).volume == pytest.approx(0.1, rel=1e-12)
    found = contact.mesh.boundary_facets()
    # Five faces of the hexahedron, three of the pyramid, three of the tetrahedron.
    assert len(found) == contact.facet_count == 5 * 16 + 3 * 4 + 3 * 4
    assert {cell: set(found.local_face[found.cell == cell]) for cell in range(3)}[0] == {0, 1, 2, 3, 4}


def test_cells_that_do_not_fit():
    coords, cells = block("hexahedron20")
    apex = len(coords)
    coords = np.vstack([coords, [[0.5, 0.5, 1.5]]])
    with pytest.raises(errors.NonConformingError, match="cells 0 and 1 do not conform"):
        Contact(coords, [*cells, ("pyramid", [[4, 5, 6, 7, apex]])], stiffness=K)
    # Hexahedra of twenty and of twenty-seven nodes: only one of them has a node in the middle of their face.
    upper = CUBE + [0, 0, 1]
    both = [("hexahedron20", [list(range(8))]), ("hexahedron27", [[4, 5, 6, 7, 8, 9, 10, 11]])]
    with pytest.raises(errors.NonConformingError):
        Contact(*with_middles(np.vstack([CUBE, upper[4:]]), both), stiffness=K)
    with pytest.raises(ValueError):
        Contact(coords, [list(range(8))], "hexahedron20", stiffness=K)
    with pytest.raises(errors.UnknownCellTypeError, match="hexahedron27"):
        Contact(coords, [list(range(20))], "hexahedron21", stiffness=K)
    assert errors.BY_STATUS[43] is errors.NonConformingError


@pytest.mark.parametrize("base", [0, 1])
@pytest.mark.parametrize("name", CELLS)
def test_points_are_brought_to_nodes(name, base):
    coords, cells = block(name)
    dim = coords.shape[1]
    contact = Contact(
        coords, [(name, np.array(conn) + base) for name, conn in cells], stiffness=K, law="fiber", index_base=base
    )
    contact.obstacles.add_half_space(np.full(dim, 0.01), np.eye(dim)[-1])
    weights = contact.mesh.point_weights()
    middles = {"quad8": 1, "hexahedron20": 7, "wedge15": 5, "pyramid13": 6}.get(name, 0)
    assert len(weights) == len(coords) + middles and weights.indptr[0] == 0
    matrix = np.zeros((len(weights), len(coords)))
    np.add.at(matrix, (np.repeat(np.arange(len(weights)), np.diff(weights.indptr)), weights.indices), weights.data)
    np.testing.assert_allclose(matrix.sum(axis=1), 1.0, atol=1e-14)
    np.testing.assert_allclose(matrix @ coords, weights.to_points(coords), atol=1e-14)
    np.testing.assert_allclose(matrix.T @ (matrix @ coords), weights.to_nodes(weights.to_points(coords)), atol=1e-13)
    np.testing.assert_allclose(weights.to_points(coords[:, 0]), matrix @ coords[:, 0], atol=1e-14)
    # Straight edges: points are where the nodes are, middles of faces in their middles.
    np.testing.assert_allclose(weights.to_points(coords)[: len(coords)], coords, atol=1e-14)
    facets = contact.mesh.boundary_facets()
    assert facets.nodes.max() - base < len(weights)
    points, result = contact.contact_points(coords), contact.evaluate(coords)
    at_points = np.zeros((len(weights), dim))
    push = -(points.pressure * points.area)[:, None] * points.normal
    numbers = points.nodes[:, 0]
    for k in range(8):
        used = numbers[:, k] >= 0
        np.add.at(at_points, numbers[used, k] - base, push[used] * points.weights[used, 0, k, None])
    np.testing.assert_allclose(weights.to_nodes(at_points), result.forces, atol=1e-12 * K)
    with pytest.raises(ValueError, match="values has shape .* expected"):
        weights.to_nodes(coords[:-1])
    gaps = contact.gap_constraints(coords, reach=0.3)
    assert gaps.node.max() - base < len(weights) and gaps.indices.max() < coords.size


def test_straight_cells_are_their_own_points(cubes):
    weights = Contact(*cubes, "hexahedron", stiffness=K).mesh.point_weights()
    np.testing.assert_array_equal(weights.indptr, np.arange(17))
    np.testing.assert_array_equal(weights.indices, np.arange(16))
    np.testing.assert_array_equal(weights.data, 1.0)


EDGES = ((0, 1), (1, 2), (2, 3), (3, 0))
NAMES = {(2, 3): "line3", (3, 6): "triangle6", (3, 8): "quad8", (3, 9): "quad9"}


def skin(name):
    """Facets of a block, by their nodes' places, and the bodies' nodes."""
    coords, _cells = block(name)
    dim, places = coords.shape[1], {tuple(x): node for node, x in enumerate(coords)}
    facets = {}
    for corners in FACES if dim == 3 else EDGES:
        # Six faces of two triangles each, or of a quadrilateral; edges of a square.
        pieces = [corners] if dim == 2 or name.startswith("hexa") else [corners[:3], [corners[0], *corners[2:]]]
        for piece in pieces:
            edges = [piece] if dim == 2 else [(piece[k], piece[(k + 1) % len(piece)]) for k in range(len(piece))]
            middles = [tuple(np.mean(coords[list(ends)], axis=0)) for ends in edges]
            middles += [tuple(np.mean(coords[list(piece)], axis=0))] if name == "hexahedron27" else []
            row = [*piece, *(places[x] for x in middles)]
            facets.setdefault(NAMES[dim, len(row)], []).append(row)
    return coords, list(facets.items())


@pytest.mark.parametrize("dtype", [np.int32, np.int64])
@pytest.mark.parametrize("name", ["triangle6", "quad8", "quad9", "hexahedron20", "hexahedron27"])
def test_facets_have_the_forces_of_cells(name, dtype):
    coords, facets = skin(name)
    _, cells = block(name)
    dim, rng = coords.shape[1], np.random.default_rng(3)
    shift = np.full(dim, 0.2)
    shift[-1] = 0.9
    both = np.vstack([coords, coords + shift]) + rng.uniform(-0.02, 0.02, (2 * len(coords), dim))
    twice = lambda blocks: [(of, np.array(conn, dtype) + start) for start in (0, len(coords)) for of, conn in blocks]
    options = {"stiffness": K, "law": "fiber", "estimator": "exact"}
    expected = Contact(both, twice(cells), **options).evaluate(both)
    contact = Contact.from_facets(both, twice(facets), **options)
    found = contact.evaluate(both)
    assert found.volume == pytest.approx(expected.volume, rel=1e-12) and contact.body_count == 2
    assert found.forces == pytest.approx(expected.forces, abs=1e-12 * np.abs(expected.forces).max())
    given = contact.mesh.boundary_facets().input_facet
    assert set(given) == set(range(sum(len(conn) for _, conn in twice(facets))))
    # One type by name, with bodies.
    (of, conn), *others = facets
    assert not others
    conn = np.vstack([np.array(conn), np.array(conn) + len(coords)]).astype(dtype)
    ids = np.repeat([4, 2], len(conn) // 2).astype(dtype)
    named = Contact.from_facets(both, conn, of, bodies=ids, **options).evaluate(both)
    assert [body.id for body in named.bodies] == [2, 4]
    assert named.forces == pytest.approx(expected.forces, abs=1e-12 * np.abs(expected.forces).max())


def test_facets_that_cannot_be_taken():
    coords, ((name, conn),) = skin("quad8")
    with pytest.raises(errors.UnknownCellTypeError, match="line4.*triangle6"):
        Contact.from_facets(coords, conn, "line4", stiffness=K)
    with pytest.raises(ValueError, match="facets"):
        Contact.from_facets(coords, [row[:2] for row in conn], name, stiffness=K)
    with pytest.raises(ValueError, match="of other types"):
        Contact.from_facets(coords, [row * 2 for row in conn], stiffness=K)
    with pytest.raises(errors.OpenSurfaceError, match="facet"):
        Contact.from_facets(coords, conn[:3], name, stiffness=K)
    with pytest.raises(errors.DimensionError):
        Contact.from_facets(coords, [(name, conn), ("triangle6", [[0, 1, 2, 3, 4, 5]])], stiffness=K)
    coords[conn[0][2]] = coords[conn[0][0]] + [0.1, 0.01]
    with pytest.raises(errors.InvertedCellError, match="cell 0 is inverted .a facet"):
        Contact.from_facets(coords, conn, name, stiffness=K)
    coords, ((name, conn),) = skin("hexahedron20")
    mixed = [(name, conn[1:]), ("quad", [conn[0][:4]])]
    with pytest.raises(errors.NonConformingError, match="facets, where there are no cells") as caught:
        Contact.from_facets(coords, mixed, stiffness=K)
    assert caught.value.indices["cell"][1] == 5


def test_a_cell_that_folds_is_named_with_the_place():
    """A middle node nearer than a quarter of its edge to a corner, where the derivative along the edge turns round."""
    x = np.array([[0, 0], [1, 0], [0, 1], [0.5, 0], [0.5, 0.5], [0, 0.5]], float)
    contact = Contact(x, np.arange(6)[None], "triangle6", stiffness=1.0)
    x[3, 0] = 0.25
    contact.evaluate(x)
    x[3, 0] = 0.2
    # ∂x/∂ξ at the corner is 4 * 0.2 - 1, ∂y/∂η one.
    with pytest.raises(errors.InvertedCellError, match=r"cell 0 .* node 0, .* determinant is (-1\.9999\d*|-2|-2\.0000\d*)e-1:"):
        contact.mesh.set_reference(x)
    # At a node alone: iterates of a solver may pass there.
    contact.evaluate(x)
    x[3, 0] = -0.9
    with pytest.raises(errors.InvertedCellError, match="cell 0 .* quadrature point"):
        contact.evaluate(x)
    contact.set_options(check_cells=False)
    contact.evaluate(x)
