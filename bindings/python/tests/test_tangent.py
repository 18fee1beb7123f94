"""The tangent against differences of the forces, in its three forms."""

import sys
from ctypes import c_size_t

import numpy as np
import pytest
from fmc_contact import Contact, Pose, errors
from fmc_contact._library import check, library
from scenes import K

sparse = pytest.importorskip("scipy.sparse")


def turned(coords, degrees):
    angle = np.radians(degrees)
    rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return coords @ rotation.T


def differences(contact, coords, h):
    """Minus the derivative of the forces, by central differences."""
    size = coords.size
    columns = np.empty((size, size))
    for dof in range(size):
        step = np.zeros(size)
        step[dof] = h
        ahead, back = (contact.evaluate(coords + sign * step.reshape(coords.shape)).forces for sign in (1, -1))
        columns[:, dof] = (back - ahead).ravel() / (2 * h)
    return columns


@pytest.mark.parametrize(("law", "estimator"), [("fiber", "exact"), ("volume", "exact")])
def test_tangent_is_minus_the_derivative_of_the_forces(squares, law, estimator):
    coords, conn = squares
    coords = turned(coords, 20) + 0.01 * np.random.default_rng(3).standard_normal(coords.shape)
    exponent = {"exponent": 2} if law == "volume" else {}
    contact = Contact(coords, conn, "quad", stiffness=K, law=law, estimator=estimator, momentum_correction=False, **exponent)
    assert contact.patches.keep(coords) == (1 if law == "fiber" else 0)
    tangent = contact.tangent(coords)
    assert sparse.issparse(tangent) and tangent.format == "csr" and tangent.shape == (16, 16)
    dense = tangent.toarray()
    scale = np.abs(dense).max()
    assert np.abs(dense - dense.T).max() < 1e-12 * scale
    # Truncation h^2 over the square of the overlap's size, 0.1; roundoff of the force over h: both about 1e-9.
    assert np.abs(dense - differences(contact, coords, 1e-5)).max() < 1e-6 * scale


@pytest.mark.parametrize("law", ["fiber", "volume"])
def test_the_forms_of_the_tangent_agree(squares, law):
    coords, conn = squares
    exponent = {"exponent": 2} if law == "volume" else {}
    contact = Contact(coords, conn, "quad", stiffness=K, law=law, estimator="exact", **exponent)
    contact.obstacles.add_half_space((0, 0.05), (0, 1))
    for obstacles, size in ((False, 16), (True, 18)):
        parts = contact.tangent_parts(coords, obstacles=obstacles)
        assert parts.size == size and (len(parts.rank_one) > 0) == (law == "volume")
        dense = contact.tangent(coords, obstacles=obstacles).toarray()
        x = np.random.default_rng(4).standard_normal(size)
        y = np.empty(size)
        check(library.fmc_context_tangent_product(contact._core.handle.pointer, x, y, c_size_t(size)))
        tolerance = 1e-12 * np.abs(dense).max()
        assert parts @ x == pytest.approx(dense @ x, abs=tolerance)
        assert parts.operator() @ x == pytest.approx(dense @ x, abs=tolerance)
        assert y == pytest.approx(dense @ x, abs=tolerance)
    # An overlap does not change when everything moves, the obstacle too; lines of the law "fiber" stay where they are.
    if law == "volume":
        assert dense @ np.tile([1.0, 2.0], 9) == pytest.approx(np.zeros(18), abs=1e-9 * np.abs(dense).max())


def test_the_semidefinite_part_has_no_negative_eigenvalue(squares):
    coords, conn = squares
    coords = turned(coords, 20)
    contact = Contact(coords, conn, "quad", stiffness=K, law="fiber", estimator="exact")
    values = np.linalg.eigvalsh(contact.tangent(coords, semidefinite=True).toarray())
    assert values.min() > -1e-10 * values.max() and values.max() > 0


def test_without_scipy_the_tangent_comes_as_triplets(squares, monkeypatch):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="volume", exponent=2, estimator="exact")
    expected = contact.tangent(coords).toarray()
    monkeypatch.setitem(sys.modules, "scipy.sparse", None)
    rows, cols, values = contact.tangent(coords)
    dense = np.zeros((16, 16))
    np.add.at(dense, (rows, cols), values)
    assert dense == pytest.approx(expected, abs=1e-12 * np.abs(expected).max())


def test_newton_reaches_the_equilibrium_of_hosts_c_newton():
    # A rigid square on a spring sinks onto another; see hosts/c/newton.c for the drawing and the closed form.
    start = np.array([[0, 0], [2, 0], [2, 1], [0, 1], [0.5, 1.1], [1.5, 1.1], [1.5, 2], [0.5, 2]])
    contact = Contact(start, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=K, law="fiber", estimator="exact")
    motion = np.zeros(16)
    motion[9::2] = -1
    u = 0.12
    contact.patches.keep(start + u * motion.reshape(8, 2))
    for _ in range(3):
        coords = start + u * motion.reshape(8, 2)
        residual = 0.8 - u + contact.evaluate(coords).forces.ravel() @ motion
        if abs(residual) < 1e-10:
            break
        u += residual / (1 + motion @ (contact.tangent(coords) @ motion))
    else:
        pytest.fail("linear where contact is closed: one step, and one to see that it was enough")
    assert u == pytest.approx(100.8 / 1001, abs=1e-9)


def test_patches_are_kept_and_released(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="fiber", estimator="exact")
    free = contact.evaluate(turned(coords, 5)).forces
    assert contact.patches.keep(coords) == 1
    kept = contact.evaluate(turned(coords, 5)).forces
    # The direction no longer turns with the squares.
    assert np.abs(kept - free).max() > 1e-6 * K
    contact.patches.release()
    assert np.array_equal(contact.evaluate(turned(coords, 5)).forces, free)


@pytest.mark.parametrize("law", ["fiber", "volume"])
@pytest.mark.parametrize("obstacles", [False, True])
def test_blocks_are_the_same_matrix(squares, law, obstacles):
    coords, conn = squares
    exponent = {"exponent": 2} if law == "volume" else {}
    contact = Contact(coords, conn, "quad", stiffness=K, law=law, estimator="exact", **exponent)
    contact.obstacles.add_half_space((0, 0.05), (0, 1))
    rows = contact.tangent(coords, obstacles=obstacles)
    blocks = contact.tangent(coords, obstacles=obstacles, blocks=True)
    assert rows.format == "csr" and blocks.format == "bsr" and blocks.blocksize == (2, 2)
    assert rows.has_sorted_indices and blocks.has_sorted_indices and rows.indices.dtype == np.int32
    assert blocks.shape == rows.shape and np.array_equal(blocks.toarray(), rows.toarray())
    # The same from its triplets.
    found, cols, values = contact.tangent_parts(coords, obstacles=obstacles).triplets()
    assert np.array_equal(sparse.csr_matrix((values, (found, cols)), shape=rows.shape).toarray(), rows.toarray())


def test_entries_of_the_library_are_those_of_the_rows(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="fiber", estimator="exact")
    found = contact.tangent_parts(coords)
    count = len(found.values)
    rows, cols, values = np.empty(count, conn.dtype), np.empty(count, conn.dtype), np.empty(count)
    check(library.fmc_context_tangent_entries(contact._core.handle.pointer, rows, cols, values, count, None))
    order = np.lexsort((cols, rows))
    assert np.array_equal(rows[order], found.rows) and np.array_equal(cols[order], found.cols)
    assert np.array_equal(values[order], found.values)
    # A contact that counts from 1 gives the library's matrix from 1, and its own from 0.
    other = Contact(coords, conn.astype(np.int64) + 1, "quad", stiffness=K, law="fiber", estimator="exact", index_base=1)
    again = other.tangent_parts(coords)
    assert again.cols.dtype == np.int64 and np.array_equal(again.cols, found.cols)
    offsets, wide = np.empty(17, np.int64), np.empty(count, np.int64)
    arguments = 0, offsets, 17, None, wide, values, count, None
    check(library.fmc_context_tangent_csr(other._core.handle.pointer, *arguments))
    assert np.array_equal(offsets, found.offsets + 1) and np.array_equal(wide, found.cols + 1)
    assert np.array_equal(values, found.values)


@pytest.mark.parametrize("law", ["fiber", "volume"])
def test_both_at_once(squares, law):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law=law, **({"exponent": 2} if law == "volume" else {}))
    expected, matrix = contact.evaluate(coords), contact.tangent(coords, semidefinite=True)
    out = np.ones((8, 2))
    found, both = contact.evaluate_tangent(coords, out, add=True, semidefinite=True)
    assert np.array_equal(both.toarray(), matrix.toarray()) and found.forces is out
    assert np.array_equal(out, expected.forces + 1)
    found, both = contact.evaluate_tangent(coords, blocks=True)
    assert np.array_equal(found.forces, expected.forces) and found.energy == expected.energy and both.format == "bsr"
    assert np.array_equal(both.toarray(), contact.tangent(coords).toarray())
    with pytest.raises(ValueError, match="give the array as out"):
        contact.evaluate_tangent(coords, add=True)


def test_a_kept_pattern_only_grows(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="fiber", estimator="exact")
    before = contact.tangent(coords)
    contact.pattern.keep()
    apart = coords + np.where(np.arange(8) < 4, 0, 5)[:, None]
    assert contact.tangent(apart).nnz == before.nnz and not contact.tangent(apart).toarray().any()
    slid = coords + np.where(np.arange(8) < 4, 0, 0.3)[:, None] * [0, 1]
    grown = contact.tangent(slid)
    contact.pattern.release()
    assert grown.nnz >= before.nnz and np.array_equal(grown.toarray(), contact.tangent(slid).toarray())
    assert contact.tangent(apart).nnz == 0


def test_stable_step(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="volume", exponent=2, estimator="exact")
    masses = np.linspace(1, 3, 8)
    scales = np.repeat(masses, 2) ** -0.5
    largest = np.linalg.eigvalsh(scales[:, None] * contact.tangent(coords).toarray() * scales).max()
    step = contact.stable_step(coords, masses)
    assert 0.9 < step / (2 / np.sqrt(largest)) <= 1
    assert contact.stable_step(coords + np.where(np.arange(8) < 4, 0, 5)[:, None], masses) == np.inf
    touched = int(np.flatnonzero(contact.evaluate(coords).forces.any(axis=1))[0])
    masses[touched] = 0
    with pytest.raises(errors.NotPositiveMassError, match="its mass is 0") as caught:
        contact.stable_step(coords, masses)
    assert caught.value.indices == {"node": (touched,)}
    with pytest.raises(ValueError, match=r"masses has shape \(7,\)"):
        contact.stable_step(coords, masses[1:])


def test_obstacles_turn(squares):
    coords, cells = squares
    contact = Contact(coords, cells, "quad", stiffness=K, law="depth")
    pose = np.array([0.2, 0.05]), 0.1
    turned = lambda at, angle: Pose(at, [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    contact.obstacles.add_half_space(pose[0], (-np.sin(pose[1]), np.cos(pose[1])))
    plain = contact.tangent_parts(coords, obstacles=True)
    contact.obstacles.set_rotations(True)
    tangent = contact.tangent_parts(coords, obstacles=True)
    assert (plain.size, tangent.size) == (18, 20)

    def moment(angle):
        contact.obstacles.set_pose(0, turned(pose[0], pose[1] + angle))
        result = contact.evaluate(coords)
        obstacle = result.obstacles[0]
        about = np.ravel(obstacle.moment)[-1] - (pose[0][0] * obstacle.force[1] - pose[0][1] * obstacle.force[0])
        return np.append(result.forces.ravel(), [*obstacle.force, about])

    expected = (moment(-1e-6) - moment(1e-6)) / 2e-6
    unit = np.zeros(20)
    unit[18] = 1
    np.testing.assert_allclose((tangent @ unit)[:19], expected, atol=1e-6 * abs(expected).max())
    contact.set_options(friction_coefficient=0.3)
    contact.friction.begin_step(coords)
    rubbed = contact.tangent_parts(coords, obstacles=True)
    assert rubbed.size == 20 and np.abs(rubbed @ unit - tangent @ unit).max() > 0
