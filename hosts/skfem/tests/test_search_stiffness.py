"""The stiffness that a search finds from the host's matrix, and its multipliers, where unknowns are not the nodes of the contact."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact, find_equilibrium
from scipy.interpolate import BSpline
from scipy.sparse import coo_matrix, csr_matrix, identity, kron
from skfem import Basis, ElementQuad1, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNG, DOWN = 1e3, 0.02


def block(fine: int, young: float = YOUNG) -> tuple[np.ndarray, np.ndarray, csr_matrix]:
    """A square with unit edges: points, quads, and its matrix of plane strain, unknown ``2 * node + axis``."""
    ticks = np.linspace(0, 1, fine + 1)
    mesh = MeshQuad.init_tensor(ticks, ticks)
    basis = Basis(mesh, ElementVector(ElementQuad1()))
    matrix = linear_elasticity(*lame_parameters(young, 0.3)).assemble(basis)
    dofs = basis.nodal_dofs.T.ravel()
    return mesh.p.T.copy(), mesh.t.T.copy(), matrix[dofs][:, dofs].tocsr()


def pressed(contact: Contact, matrix: csr_matrix, points: np.ndarray, down: float = DOWN):
    """Its upper side moved down on a plane, by all unknowns there."""
    contact.obstacles.add_half_space((0, 0), (0, 1))
    top = np.isclose(points[:, 1], 1)
    free = np.flatnonzero(np.repeat(~top, 2))
    goal = points.copy()
    goal[top, 1] -= down

    def host(x: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
        return matrix @ (np.asarray(x) - points).ravel(), matrix

    return find_equilibrium(host, contact, points, free, goal)


def stiffness(found) -> float:
    """Of the law: with multipliers, too, its pressure by its penetration."""
    pair = found.result.pairs[0]
    return pair.pressure / pair.penetration


def torn(points: np.ndarray, quads: np.ndarray, matrix_of_cell, spring: float) -> tuple[np.ndarray, np.ndarray, csr_matrix]:
    """Cells with nodes of their own, which springs join to the first of their place."""
    conn = np.arange(quads.size).reshape(quads.shape)
    rows, cols, values = [], [], []
    for nodes in conn:
        dofs = (2 * nodes[:, None] + [0, 1]).ravel()
        rows.append(np.repeat(dofs, 8)), cols.append(np.tile(dofs, 8)), values.append(matrix_of_cell.ravel())
    matrix = coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(cols))), (2 * quads.size,) * 2)
    owner = quads.ravel()
    first = np.full(owner.max() + 1, -1)
    for node in range(quads.size - 1, -1, -1):
        first[owner[node]] = node
    others = np.flatnonzero(first[owner] != np.arange(quads.size))
    jump = csr_matrix(
        (
            np.tile([1.0, -1.0], len(others)),
            (np.repeat(np.arange(len(others)), 2), np.stack([others, first[owner[others]]], axis=1).ravel()),
        ),
        (len(others), quads.size),
    )
    springs = kron(spring * (jump.T @ jump), identity(2))
    return points[owner], conn, csr_matrix(matrix.tocsr() + springs)


@pytest.mark.parametrize("halves", [False, True])
@pytest.mark.parametrize("spring", [1e3, 1e6, 1e9])
def test_springs_that_join_welded_nodes_are_no_stiffness(spring: float, halves: bool) -> None:
    """Every cell with nodes of its own, or two halves: as of the merged mesh, whatever the springs and the unit of force."""
    points, quads, matrix = block(6)
    merged = pressed(Contact(points, quads, "quad"), matrix, points)
    expected = stiffness(merged)
    for unit in (1.0, 1e-6):
        if halves:
            left = points[quads].mean(axis=1)[:, 0] < 0.5
            own, conn, joined = two_halves(points, quads, left, spring * YOUNG * unit, unit)
        else:
            square, _, of_cell = block(1, YOUNG * unit)
            order = _corners(square, points[quads[0]])
            of_cell = of_cell.toarray()[np.ix_(order, order)]
            own, conn, joined = torn(points, quads, of_cell, spring * YOUNG * unit)
        contact = Contact(own, conn, "quad", weld=1e-6)
        assert contact.mesh.welded_node_count == len(own) - len(points)
        found = pressed(contact, joined, own)
        print(spring, unit, stiffness(found) / unit / expected, found.iterations, merged.iterations)
        # Springs of 1e3 E give way by 1e-3 of the body, those of 1e9 E round its matrix.
        assert stiffness(found) / unit == pytest.approx(expected, rel=1e-3)
        assert found.result.obstacles[0].force[1] / unit == pytest.approx(merged.result.obstacles[0].force[1], rel=1e-3)
        assert found.updates == merged.updates and found.iterations <= merged.iterations + 1
        assert found.penetration == pytest.approx(merged.penetration, rel=1e-2) and not found.warnings


@pytest.mark.parametrize("spring", [1e3, 1e5])
def test_a_welded_body_that_contact_alone_holds(spring: float) -> None:
    """It comes down under its load, as the merged one: springs do not make a body out of what hardly holds it."""
    points, quads, matrix = block(4)
    square, _, of_cell = block(1)
    order = _corners(square, points[quads[0]])
    of_cell = of_cell.toarray()[np.ix_(order, order)]
    found = {}
    for is_torn in (False, True):
        own, conn, joined = points, quads, matrix
        if is_torn:
            own, conn, joined = torn(points, quads, of_cell, spring * YOUNG)
        contact = Contact(own + [0, 0.1], conn, "quad", weld=1e-6 if is_torn else 0.0)
        contact.obstacles.add_half_space((0, 0), (0, 1))
        start, corner = own + [0, 0.1], np.all(np.isclose(own, [0, 1]), axis=1)
        free, load = np.ones(own.shape, bool), np.zeros(own.shape)
        free[corner, 0] = False
        top = np.flatnonzero(np.isclose(own[:, 1], 1))
        load[top, 1] = -1.0 / len(top)

        def host(x, start=start, joined=joined, load=load):
            return joined @ (np.asarray(x) - start).ravel() - load.ravel(), joined

        found[is_torn] = find_equilibrium(host, contact, start, np.flatnonzero(free.ravel()))
    print({key: (one.iterations, one.rigid_steps, one.warnings) for key, one in found.items()})
    assert found[True].result.obstacles[0].force[1] == pytest.approx(-1.0, rel=1e-6)
    # Of 1e5 E the host rounds its own forces to 1e-8.
    assert found[True].iterations <= found[False].iterations + 2
    assert all("forces are rounded" in text for text in found[True].warnings)


def _corners(square: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Unknowns of a cell of one, in the order of the corners of another that is smaller."""
    scaled = (corners - corners.min(axis=0)) / np.ptp(corners, axis=0)
    nodes = [int(np.flatnonzero(np.all(np.isclose(square, corner), axis=1))[0]) for corner in scaled]
    return (2 * np.array(nodes)[:, None] + [0, 1]).ravel()


def two_halves(points, quads, left, spring, unit):
    """The mesh cut in two, whose nodes are joined again by springs."""
    parts, conn, offset = [], np.empty_like(quads), 0
    own = []
    for side in (left, ~left):
        nodes, numbers = np.unique(quads[side], return_inverse=True)
        conn[side] = numbers.reshape(-1, 4) + offset
        own.append(points[nodes])
        basis = Basis(MeshQuad(points[nodes].T.copy(), numbers.reshape(-1, 4).T.copy()), ElementVector(ElementQuad1()))
        matrix = linear_elasticity(*lame_parameters(YOUNG * unit, 0.3)).assemble(basis)
        dofs = basis.nodal_dofs.T.ravel()
        parts.append(matrix[dofs][:, dofs])
        offset += len(nodes)
    first = len(own[0])
    own = np.concatenate(own)
    matrix = np.zeros((own.size, own.size))
    matrix[: 2 * first, : 2 * first], matrix[2 * first :, 2 * first :] = parts[0].toarray(), parts[1].toarray()
    for node in range(first, len(own)):
        for other in np.flatnonzero(np.all(np.isclose(own[:first], own[node]), axis=1)):
            for axis in (0, 1):
                pair = [2 * node + axis, 2 * other + axis]
                matrix[np.ix_(pair, pair)] += spring * np.array([[1.0, -1.0], [-1.0, 1.0]])
    return own, conn, csr_matrix(matrix)


def splines(count: int, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Quadratic B-splines over so many elements of an edge: their values, and the places of their control points."""
    knots = np.concatenate([[0, 0], np.linspace(0, 1, count + 1), [1, 1]])
    return BSpline.design_matrix(at, knots, 2).toarray(), np.array([knots[k + 1 : k + 3].mean() for k in range(count + 2)])


@pytest.mark.parametrize("moved", [False, True])
def test_a_basis_of_control_points(moved: bool) -> None:
    """Quadratic splines, whose unknowns are the places of control points, or how far these move: as of nodes, with updates."""
    fine = 12
    points, quads, matrix = block(fine)
    nodes = pressed(Contact(points, quads, "quad"), matrix, points)
    values, places = splines(6, np.linspace(0, 1, fine + 1))
    i, j = np.rint(points * fine).astype(int).T
    weights = csr_matrix(np.einsum("ka,kb->kab", values[i], values[j]).reshape(len(points), -1))
    control = np.array([(a, b) for a in places for b in places])
    assert np.abs(weights @ control - points).max() < 1e-14
    # Far from the origin: where the body is says nothing of how it is deformed.
    shift = np.array([30.0, 0.0]) if moved else np.zeros(2)
    contact = Contact(points + shift, quads, "quad")
    contact.mesh.set_basis(weights)
    onto = kron(weights, identity(2))
    found = pressed(contact, csr_matrix(onto.T @ matrix @ onto), control + shift)
    print(found.iterations, found.updates, found.penetration, nodes.penetration, stiffness(found) / stiffness(nodes))
    assert found.updates >= 1 and found.penetration < 1e-3 * DOWN
    # Twice the element, of second order: 4/3 of its stiffness.
    assert 0.4 < stiffness(found) / stiffness(nodes) < 1.5
    assert found.result.obstacles[0].force[1] == pytest.approx(nodes.result.obstacles[0].force[1], rel=1e-2)
