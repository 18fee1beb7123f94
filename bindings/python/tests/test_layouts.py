"""Arrays go in where they lie, in every layout; what is no such array is refused with a sentence."""

import numpy as np
import pytest
from fmc_contact import Contact, contact_force
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
    yield TypeError, "dtype float32, float64 is wanted: convert it by .astype", coords.astype(np.float32)
    yield TypeError, "dtype int64, float64 is wanted", coords.astype(np.int64)
    yield TypeError, "dtype >f8, float64 is wanted", coords.astype(">f8")
    yield TypeError, "dtype object", coords.astype(object)
    yield ValueError, r"shape \(16,\), \(nodes, 2\) or \(nodes, 3\) or \(2, nodes\) is wanted in 2D", coords.ravel()
    yield ValueError, r"shape \(4, 4\)", coords.reshape(4, 4)
    yield ValueError, "that float64 cannot have: copy it", np.broadcast_to(np.float64(0), (8, 2))
    packed = np.zeros(8, np.dtype([("gap", "u1"), ("x", "2f8")]))
    yield ValueError, "that float64 cannot have: copy it", packed["x"]


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
    with pytest.raises(TypeError, match="out is a list, a numpy array is wanted"):
        contact.evaluate(coords, out=coords.tolist())
    with pytest.raises(TypeError, match="out has dtype float32"):
        contact.evaluate(coords, out=np.zeros((8, 2), np.float32))
    with pytest.raises(ValueError, match="give the array as out"):
        contact.evaluate(coords, add=True)


def test_connectivity_that_is_none_is_refused(squares):
    coords, conn = squares
    for error, text, array in [
        (TypeError, "conn has dtype float64, integers are wanted", conn.astype(float)),
        (ValueError, r"conn has shape \(4, 2\), \(cells, 4\) is wanted: transpose it", conn.T),
        (ValueError, r"shape \(8,\), \(cells, 4\) is wanted: reshape it", conn.ravel()),
        (ValueError, "no number of anything", np.full((1, 4), 2**64 - 1, np.uint64)),
    ]:
        with pytest.raises(error, match=text):
            Contact(coords, array, "quad", **OPTIONS)
    with pytest.raises(TypeError, match="give the cell type beside conn"):
        Contact(coords, conn, **OPTIONS)
    with pytest.raises(TypeError, match="give the cell type beside conn"):
        Contact(coords, conn.tolist(), **OPTIONS)
    with pytest.raises(ValueError, match="bodies has 3 entries, one for each of the 2 cells is wanted"):
        Contact(coords, conn, "quad", bodies=[0, 1, 2], **OPTIONS)
    with pytest.raises(ValueError, match=r"bodies has shape \(1, 2\)"):
        Contact(coords, conn, "quad", bodies=[[0, 1]], **OPTIONS)
    with pytest.raises(ValueError, match="facets has shape"):
        Contact.from_facets(coords, conn, **OPTIONS)


def test_a_surface_in_space_is_not_taken_for_a_plane_mesh():
    coords = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    with pytest.raises(ValueError, match="vary in z.*Contact.from_facets"):
        Contact(coords, [[0, 1, 2], [0, 1, 3]], "triangle", **OPTIONS)
