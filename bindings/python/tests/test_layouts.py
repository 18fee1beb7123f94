"""Arrays of float64 go in where they lie, in every layout; other real numbers are converted; nonsense is refused by name."""

import numpy as np
import pytest
from fmc_contact import Contact, Pose, contact_force, errors
from fmc_contact._arrays import coords_view
from scenes import K, same_bits

OPTIONS = {"stiffness": K, "law": "volume", "estimator": "exact"}


def layouts(rows):
    """The same coordinates in every layout, with a name for each."""
    n, dim = rows.shape
    yield "rows", rows
    yield "columns", np.ascontiguousarray(rows.T)
    yield "transposed rows", rows.T
    yield "rows by columns", np.asfortranarray(rows)
    yield "every other row", np.repeat(rows, 2, axis=0)[::2]
    yield "backwards", rows[::-1].copy()[::-1]
    if dim == 2:
        yield "three columns", np.c_[rows, np.zeros(n)]
        yield "two of three columns", np.c_[rows, np.full(n, np.nan)][:, :2]


@pytest.mark.parametrize("scene", ["squares", "cubes"])
def test_every_layout_gives_the_same_bits(scene, request):
    coords, conn = request.getfixturevalue(scene)
    cell_type = "quad" if scene == "squares" else "hexahedron"
    expected = contact_force(coords, conn, cell_type, **OPTIONS).forces
    for name, array in layouts(coords):
        forces = Contact(array, conn, cell_type, **OPTIONS).evaluate(array).forces
        in_columns = array.shape[0] == coords.shape[1]
        assert same_bits(forces.T if in_columns else forces, expected), name


@pytest.mark.parametrize("scene", ["squares", "cubes"])
def test_nothing_is_copied(scene, request):
    coords, _ = request.getfixturevalue(scene)
    for name, array in layouts(coords):
        view = coords_view(array, coords.shape[1])
        assert view.struct.data == array.__array_interface__["data"][0] and view.array is array, name


def test_forces_go_into_arrays_of_every_layout(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    expected = contact.evaluate(coords).forces
    for name, array in layouts(np.full_like(coords, 0.5)):
        out = array.copy(order="K") if array.flags.owndata else array
        result = contact.evaluate(coords, out=out)
        assert result.forces is out
        rows = out.T if out.shape[0] == 2 else out
        assert same_bits(rows[:, :2], expected), name
        assert rows.shape[1] == 2 or np.all(rows[:, 2] == 0), "a third column is left alone"
    twice = expected.copy()
    contact.evaluate(coords, out=twice, add=True)
    assert same_bits(twice, expected + expected)


def test_a_single_triangle_in_columns():
    coords = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    contact = Contact(coords, [[0, 1, 2]], "triangle", **OPTIONS)
    assert contact.node_count == 3 and contact.evaluate(coords).forces.shape == (2, 3)


@pytest.mark.parametrize("dtype", [np.int8, np.uint16, np.uint32, np.int64, np.uint64, ">i4"])
def test_integers_of_every_kind_are_node_numbers(squares, dtype):
    coords, conn = squares
    expected = contact_force(coords, conn, "quad", **OPTIONS).forces
    assert same_bits(contact_force(coords, conn.astype(dtype), "quad", **OPTIONS).forces, expected)
    assert same_bits(contact_force(coords, np.asfortranarray(conn), "quad", **OPTIONS).forces, expected)


def bad_coords(coords):
    yield TypeError, "coords has dtype complex128, expected real numbers: take .real", coords.astype(complex)
    yield TypeError, "coords has dtype bool, expected real numbers", coords > 0.5
    yield TypeError, "coords has dtype object, expected real numbers: its entries are Python objects", coords.astype(object)
    yield TypeError, "coords has dtype <U32, expected real numbers", coords.astype(str)
    yield TypeError, "coords has masked entries", np.ma.masked_greater(coords, 1.5)
    yield ValueError, "coords is no array of numbers: ", [[0, 0], [1]]
    yield ValueError, r"coords has shape \(16,\), expected \(nodes, 2\), \(nodes, 3\) or \(2, nodes\) in 2D", coords.ravel()
    yield ValueError, r"coords has shape \(4, 4\), expected", coords.reshape(4, 4)


def converted(coords):
    """The same coordinates as other arrays of real numbers, none of which the library could read in place."""
    for dtype in (np.float32, np.float16, np.longdouble, ">f8", np.int64, np.int8, np.uint16):
        yield str(dtype), coords.astype(dtype)
        yield f"{dtype} by columns", np.asfortranarray(coords.astype(dtype))
        yield f"{dtype}, every other", np.repeat(coords.astype(dtype), 2, axis=0)[::2]
    packed = np.zeros(len(coords), np.dtype([("gap", "u1"), ("x", "2f8")]))
    packed["x"] = coords
    yield "between bytes", packed["x"]
    yield "nothing masked", np.ma.masked_invalid(coords)
    yield "lists", coords.tolist()


def test_other_real_numbers_are_converted(squares):
    # Whole numbers of eighths, which every type holds.
    coords = np.round(squares[0] * 8)
    contact = Contact(coords, squares[1], "quad", **OPTIONS)
    expected = contact.evaluate(coords).forces
    assert np.abs(expected).max() > 0
    for name, array in converted(coords):
        assert same_bits(Contact(array, squares[1], "quad", **OPTIONS).evaluate(array).forces, expected), name
        assert same_bits(contact.tangent(array).toarray(), contact.tangent(coords).toarray()), name
    everywhere = np.broadcast_to(np.float64(0), (8, 2))
    with pytest.raises(errors.ZeroMeasureError):
        contact.evaluate(everywhere)


@pytest.mark.parametrize("dtype", [np.float32, np.int64, ">f8"])
def test_numbers_are_converted_wherever_they_go_in(squares, dtype):
    """Each once as float64 and once as another type, Fortran-ordered where it has rows and columns."""
    coords, conn = squares
    other = lambda values: np.asfortranarray(np.array(values, float).astype(dtype))
    found = []
    for as_given in (lambda values: np.array(values, float), other):
        contact = Contact(coords, conn, "quad", **{**OPTIONS, "law": "depth"})
        contact.obstacles.add_half_space(as_given([0, 0]), as_given([0, 1]))
        contact.obstacles.add_cuboid(as_given([1, 1]), Pose(as_given([3, 0]), as_given([[0, -1], [1, 0]])))
        contact.obstacles.add_polytope(as_given([[0, -4], [4, -4], [2, -3]]), np.array([[0, 1], [1, 2], [2, 0]], ">i2"))
        contact.obstacles.add_convex_hull(as_given([[0, -4], [4, -4], [2, -3]]))
        contact.obstacles.add_height_field(as_given([0, 1, 0]), as_given([4]), 1, as_given([0, -6]))
        contact.set_options(friction_coefficient=1.0, friction_stiffness=1.0)
        contact.friction.begin_step(coords)
        contact.friction.slip = as_given([[0, 0, 1, 0, 1, 2, 0, 0], [4, 0, 0, 1, 2, 1, 0, 0]])
        contact.mesh.set_basis(as_given(np.eye(8)))
        result = contact.evaluate(coords)
        step = contact.contact_step(coords, [2, 4], as_given(1000 * np.eye(2)), as_given([0, 0]), np.array([8, 14], np.uint8))
        masses, at_points = as_given(np.ones(8)), contact.mesh.point_weights().to_nodes(as_given(np.ones((8, 2))))
        found.append([result.forces, contact.friction.slip, step.displacement, contact.stable_step(coords, masses), at_points])
    for one, two in zip(*found):
        assert same_bits(np.asarray(one), np.asarray(two))


def test_what_would_be_nonsense_is_refused_by_name(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    contact.friction.begin_step(coords)
    multipliers = contact.multipliers
    for error, text, call in [
        (TypeError, "normal has dtype complex128", lambda: contact.obstacles.add_half_space((0, 0), (0, 1j))),
        (TypeError, "position has dtype bool", lambda: Pose((True, False))),
        (TypeError, "heights has dtype", lambda: contact.obstacles.add_height_field(["a", "b"], [1], 1)),
        (TypeError, "half_extents has dtype object", lambda: contact.obstacles.add_cuboid(np.array([1, None]))),
        (TypeError, "nodes has dtype float64, expected integers", lambda: contact.mesh.set_symmetry_nodes([0.5])),
        (TypeError, "nodes has dtype bool", lambda: contact.mesh.set_symmetry_nodes(coords[:, 0] == 0)),
        (TypeError, "bodies has dtype float64", lambda: Contact(coords, conn, "quad", bodies=[0.0, 1.0], **OPTIONS)),
        (TypeError, "facets has dtype float64", lambda: contact.obstacles.add_polytope(coords[:3], [[0.0, 1.0]])),
        (TypeError, "masses has dtype complex128", lambda: contact.stable_step(coords, np.ones(8, complex))),
        (TypeError, "dofs has dtype float64", lambda: contact.contact_step(coords, [2.0], [[1.0]], [0.0])),
        (TypeError, "slip has dtype bool", lambda: setattr(contact.friction, "slip", np.zeros((8, 2), bool))),
        (TypeError, "matrix has dtype complex128", lambda: contact.mesh.set_basis(np.eye(8) * 1j)),
        (TypeError, "multipliers has dtype float64", lambda: setattr(multipliers, "values", np.zeros(3))),
        (ValueError, r"masses has shape \(7,\), expected \(8,\)", lambda: contact.stable_step(coords, np.ones(7))),
        (ValueError, r"slip has shape \(8, 2\), expected \(rows, 8\)", lambda: setattr(contact.friction, "slip", np.zeros((8, 2)))),
        (ValueError, r"residual has shape \(2,\), expected \(1,\)", lambda: contact.contact_step(coords, [2], [[1.0]], [0.0, 0.0])),
        (ValueError, r"rotation has shape \(3, 3\), expected \(2, 2\)", lambda: Pose((0, 0), np.eye(3))),
    ]:
        with pytest.raises(error, match=text):
            call()


def test_coordinates_that_are_none_are_refused(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    for error, text, array in bad_coords(coords):
        for call in (contact.evaluate, contact.tangent, contact.patches.keep):
            with pytest.raises(error, match=text):
                call(array)
        with pytest.raises(error, match=text):
            Contact(array, conn, "quad", **OPTIONS)


def test_outputs_that_cannot_be_written_are_refused(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    fixed = np.zeros((8, 2))
    fixed.flags.writeable = False
    with pytest.raises(ValueError, match="out is read-only"):
        contact.evaluate(coords, out=fixed)
    with pytest.raises(TypeError, match="out is a list, expected a numpy array"):
        contact.evaluate(coords, out=coords.tolist())
    with pytest.raises(TypeError, match="out has dtype float32"):
        contact.evaluate(coords, out=np.zeros((8, 2), np.float32))
    with pytest.raises(ValueError, match="out has strides"):
        contact.evaluate(coords, out=np.zeros(8, np.dtype([("gap", "u1"), ("x", "2f8")]))["x"])
    with pytest.raises(ValueError, match="give the array as out"):
        contact.evaluate(coords, add=True)


def test_connectivity_that_is_none_is_refused(squares):
    coords, conn = squares
    for error, text, array in [
        (TypeError, "conn has dtype float64, expected integers", conn.astype(float)),
        (ValueError, r"conn has shape \(4, 2\), expected \(cells, 4\): transpose it", conn.T),
        (ValueError, r"shape \(8,\), expected \(cells, 4\): reshape it", conn.ravel()),
        (ValueError, "no number of anything", np.full((1, 4), 2**64 - 1, np.uint64)),
    ]:
        with pytest.raises(error, match=text):
            Contact(coords, array, "quad", **OPTIONS)
    with pytest.raises(TypeError, match="give cell_type with conn"):
        Contact(coords, conn, **OPTIONS)
    with pytest.raises(TypeError, match="give cell_type with conn"):
        Contact(coords, conn.tolist(), **OPTIONS)
    with pytest.raises(ValueError, match=r"bodies has shape \(3,\), expected \(2,\), one number for each of the cells"):
        Contact(coords, conn, "quad", bodies=[0, 1, 2], **OPTIONS)
    with pytest.raises(ValueError, match=r"bodies has shape \(1, 2\)"):
        Contact(coords, conn, "quad", bodies=[[0, 1]], **OPTIONS)
    with pytest.raises(ValueError, match="facets has shape"):
        Contact.from_facets(coords, conn, **OPTIONS)


def test_a_surface_in_space_is_not_taken_for_a_plane_mesh():
    coords = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    with pytest.raises(ValueError, match="vary in z.*Contact.from_facets"):
        Contact(coords, [[0, 1, 2], [0, 1, 3]], "triangle", **OPTIONS)
