"""Every status arrives as its class, with the sentence that names the culprit, and leaves everything as it was."""

import ctypes
from ctypes import byref, c_size_t

import numpy as np
import pytest
from fmc_contact import Contact, FmcError, Pose, contact_force, errors
from fmc_contact._library import check, library
from fmc_contact._structs import fmc_cell_block, fmc_options, fmc_pair_result
from fmc_contact.options import changed, defaults
from numpy.lib.stride_tricks import as_strided
from scenes import K, same_bits

OPTIONS = {"stiffness": K, "law": "volume", "estimator": "exact"}


def moved(coords, node, *to):
    coords = coords.copy()
    coords[node] = to
    return coords


def meshes(coords, conn):
    """Class, fragment of the sentence, coordinates and cells."""
    yield errors.NodeOutOfRangeError, "1 names node 8, but there are 8 nodes", coords, [conn[0], [4, 5, 8, 7]]
    yield errors.NodeOutOfRangeError, "1 names node -3", coords, [conn[0], [4, 5, -3, 7]]
    yield errors.NodeOutOfRangeError, "0 names node 1099511627776", coords, [[0, 1, 2, 1 << 40]]
    yield errors.RepeatedNodeError, "1 names node 4 twice", coords, [conn[0], [4, 5, 4, 7]]
    yield errors.NonFiniteCoordinateError, "coordinate 1 of node 5", moved(coords, 5, 1, np.nan), conn
    yield errors.NonFiniteCoordinateError, "coordinate 0 of node 2", moved(coords, 2, -np.inf, 1), conn
    yield errors.InvertedCellError, "cell 1", moved(coords, 6, 1.1, 0.2), conn
    line = coords.copy()
    line[4:] = [[4, 0], [5, 0], [6, 0], [7, 0]]
    yield errors.ZeroMeasureError, "1 has zero measure", line, conn
    yield errors.EmptyError, "no cells", coords, np.empty((0, 4), np.int32)
    yield errors.EmptyError, "no cells", coords, []


def test_bad_meshes(squares):
    for error, text, coords, conn in meshes(*squares):
        with pytest.raises(error, match=text):
            contact_force(coords, conn, "quad", **OPTIONS)


def test_indices_come_as_numbers(squares):
    coords, conn = squares
    expected = [
        ({"cell": (1,), "node": (8,)}, coords, [conn[0], [4, 5, 8, 7]]),
        ({"cell": (1,), "node": (4,)}, coords, [conn[0], [4, 5, 4, 7]]),
        ({"coordinate": (1,), "node": (5,)}, moved(coords, 5, 1, np.nan), conn),
        ({"cell": (1,)}, moved(coords, 6, 1.1, 0.2), conn),
        ({}, coords, []),
    ]
    for indices, x, cells in expected:
        with pytest.raises(FmcError) as caught:
            contact_force(x, cells, "quad", **OPTIONS)
        assert caught.value.indices == indices
    with pytest.raises(errors.OpenSurfaceError) as caught:
        Contact.from_facets(coords[:3], [[0, 1], [1, 2]], **OPTIONS)
    assert set(caught.value.indices) == {"facet", "node"} and len(caught.value.indices["node"]) == 1
    with pytest.raises(errors.DimensionError) as caught:
        contact_force(coords, [("quad", conn), ("tetra", conn)], **OPTIONS)
    assert caught.value.indices == {"block": (1,)}


def test_bad_cells(squares):
    coords, conn = squares
    fan = np.array([[0, 0], [1, 0], [0, 1], [0, -1], [1, 1.0]])
    with pytest.raises(errors.NonManifoldError, match="2 is the third to meet at nodes"):
        contact_force(fan, [[0, 1, 2], [1, 0, 3], [0, 1, 4]], "triangle", **OPTIONS)
    with pytest.raises(errors.UnknownCellTypeError, match="no cell type 'quad16'; there are triangle, quad, tetra"):
        contact_force(coords, conn, "quad16", **OPTIONS)
    with pytest.raises(errors.DimensionError, match="block 1 has cells of dimension 3"):
        contact_force(coords, [("quad", conn), ("tetra", conn)], **OPTIONS)
    with pytest.raises(errors.EmptyError):
        contact_force(coords, [], **OPTIONS)


TETRA = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
SHELL = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def test_bad_surfaces():
    for error, text, facets in [
        (errors.OpenSurfaceError, "nodes", SHELL[:3]),
        (errors.InvertedSurfaceError, "body 0", SHELL[:, [1, 0, 2]]),
        (errors.InconsistentOrientationError, "oriented against its neighbour", [[2, 0, 1], *SHELL[1:]]),
        (errors.NonManifoldError, "4 is the third", [*SHELL, SHELL[0]]),
    ]:
        with pytest.raises(error, match=text):
            Contact.from_facets(TETRA, np.array(facets), **OPTIONS)


def test_bad_values_of_options(squares):
    for error, text, options in [
        (errors.NotPositiveError, "'stiffness' is -1", {"stiffness": -1}),
        (errors.NotPositiveError, "'exponent' is 0.5", {"exponent": 0.5}),
        (errors.NotPositiveError, "'threads' is 0", {"threads": 0}),
        (errors.NotPositiveError, "'spacing' is -1", {"spacing": -1, "estimator": "fibers"}),
        (errors.BadValueError, "finite number", {"stiffness": np.nan}),
        (errors.OptionsConflictError, "spacing", {"spacing": 0.1, "fiber_count": 10, "estimator": "fibers"}),
        (errors.TooManyFibersError, "spacing is too small", {"spacing": 1e-300, "estimator": "fibers"}),
        (errors.UnsupportedError, "not supported", {"law": "fiber", "estimator": "fibers", "pattern": "isotropic"}),
    ]:
        with pytest.raises(error, match=text):
            contact_force(*squares, "quad", **{**OPTIONS, **options})
    coords, conn = squares
    with pytest.raises(errors.RangeError, match="the energy is inf"):
        contact_force(1e3 * coords, conn, "quad", **{**OPTIONS, "stiffness": 1e308, "exponent": 1.5})


def test_after_an_error_a_contact_is_as_it_was(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    expected = contact.evaluate(coords).forces
    out = np.full((8, 2), 7.0)
    for error, text, call in [
        (errors.LengthError, "'coords' has 7 nodes, the mesh has 8", lambda: contact.evaluate(coords[:7], out=out)),
        (errors.InvertedCellError, "cell 1", lambda: contact.evaluate(moved(coords, 6, 1.1, 0.2), out=out)),
        (errors.BufferTooSmallError, "room for 7 nodes, the mesh has 8", lambda: contact.evaluate(coords, out=out[:7])),
        (errors.StrideError, "'forces' overlap", lambda: contact.evaluate(coords, as_strided(out, (8, 2), (8, 8)))),
        (errors.NotPositiveError, "'radius' is -2", lambda: contact.obstacles.add_ball(-2)),
        (errors.NotPositiveError, "is 0", lambda: contact.obstacles.add_cuboid((1, 0))),
        (errors.NotPositiveError, "is NaN", lambda: contact.obstacles.add_cylinder(1, np.nan)),
        (errors.BadPoseError, "no direction", lambda: contact.obstacles.add_half_space((0, 0), (0, 0))),
        (errors.BadPoseError, "obstacle 0", lambda: contact.obstacles.add_ball(1, Pose((0, 0), [[2, 0], [0, 1]]))),
        (errors.BadPoseError, "obstacle 0", lambda: contact.obstacles.add_ball(1, Pose((0, 0), scale=0))),
        (errors.OpenSurfaceError, "at node", lambda: contact.obstacles.add_polytope(coords[:3], [[0, 1], [1, 2]])),
        (errors.ObstacleOutOfRangeError, "no obstacle 0", lambda: contact.obstacles.set_pose(0, (0, 0))),
        (IndexError, "no obstacle -1", lambda: contact.obstacles.set_pose(-1, (0, 0))),
        (ValueError, "the pose has 3 axes, the contact 2", lambda: contact.obstacles.add_ball(1, (0, 0, 0))),
        (ValueError, r"normal has shape \(3,\)", lambda: contact.obstacles.add_half_space((0, 0), (0, 0, 1))),
    ]:
        with pytest.raises(error, match=text):
            call()
    assert np.all(out == 7) and contact.obstacles.count == 0
    assert same_bits(contact.evaluate(coords).forces, expected)


def test_what_the_package_itself_never_asks_for(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    pointer, empty, options = contact._core.handle.pointer, fmc_options(), changed(defaults(), OPTIONS)
    odd = np.zeros(65, np.uint8)[1:].view(np.float64)
    block = fmc_cell_block(9, conn.itemsize, conn.ctypes.data, 1)
    for error, text, call in [
        (errors.NullPointerError, "'options'", lambda: library.fmc_options_init(None)),
        (errors.IndexOutOfRangeError, "no pair 0", lambda: library.fmc_context_pair_result(pointer, 0, byref(fmc_pair_result()))),
        (errors.StructSizeError, "struct_size 0", lambda: library.fmc_context_set_options(pointer, byref(empty))),
        (
            errors.MisalignedPointerError,
            "'coords' is not aligned to 8 bytes",
            lambda: library.fmc_contact_force(2, odd, 4, byref(block), 1, None, byref(options), None, np.empty(8), None),
        ),
        (errors.BufferTooSmallError, "room for 0 entries", lambda: entries_without_room(contact, coords)),
    ]:
        with pytest.raises(error, match=text):
            check(call())
    with pytest.raises(ctypes.ArgumentError, match="expected a contiguous array of dtype int32 or int64, not of float64"):
        library.fmc_context_tangent_entries(pointer, np.zeros(3), None, None, 0, None)


def entries_without_room(contact, coords):
    contact.set_options(law="fiber")
    contact.tangent(coords)
    none = np.empty(0, np.int32)
    return library.fmc_context_tangent_entries(contact._core.handle.pointer, none, none, np.empty(0), 0, None)


def test_errors_are_what_python_would_call_them():
    natural = {
        ValueError: (errors.InvertedCellError, errors.UnknownOptionError, errors.LengthError),
        IndexError: (errors.NodeOutOfRangeError, errors.ObstacleOutOfRangeError, errors.IndexOutOfRangeError),
        NotImplementedError: (errors.UnsupportedError,),
        OverflowError: (errors.RangeError,),
        RuntimeError: (errors.BusyError, errors.PanicError, errors.ThreadsError),
        ImportError: (errors.LibraryError,),
    }
    for builtin, classes in natural.items():
        assert all(issubclass(error, builtin) and issubclass(error, FmcError) for error in classes)
    for status, error in errors.BY_STATUS.items():
        assert error.status == status and isinstance(errors.of_status(status, "text"), error)
    later = errors.of_status(77, "a later status")
    assert type(later) is FmcError and later.status == 77 and str(later) == "a later status"


def test_counts_of_a_context(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    nodes = c_size_t()
    contact._core.handle.call(library.fmc_context_counts, byref(nodes), None, None)
    assert nodes.value == contact.node_count == 8
    assert (contact.dim, contact.facet_count, contact.body_count, contact.obstacles.count) == (2, 8, 2, 0)
