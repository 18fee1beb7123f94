"""Friction in whole problems: a block on an incline, a block that stops, and two cylinders that are pushed along one another."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact, find_equilibrium
from scipy.sparse import block_diag, csr_matrix, diags
from scipy.sparse.linalg import spsolve
from skfem import Basis, ElementQuad1, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

GRAVITY, MU = 9.81, 0.3


def stiffness(points: np.ndarray, quads: np.ndarray, young: float) -> csr_matrix:
    """Of plane strain, unknown ``2 * node + axis``."""
    basis = Basis(MeshQuad(points.T.copy(), quads.T.copy()), ElementVector(ElementQuad1()))
    matrix = linear_elasticity(*lame_parameters(young, 0.3)).assemble(basis)
    dofs = basis.nodal_dofs.T.ravel()
    return matrix[dofs][:, dofs].tocsr()


def quads_of(rows: int, cols: int) -> np.ndarray:
    nodes = np.arange(rows * cols).reshape(rows, cols)
    corners = nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]
    return np.stack(corners, axis=-1).reshape(-1, 4)


class Block:
    """An elastic block, 1 by 0.5, on a rigid plane, pressed on it by its weight."""

    def __init__(self, law: str, angle: float = 0.0, k: float = 1e8) -> None:
        x, y = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 0.5, 5))
        self.start, quads = np.stack([x.ravel(), y.ravel()], axis=1), quads_of(5, 9)
        self.stiffness, self.mass = stiffness(self.start, quads, 1e7), np.zeros(len(self.start))
        np.add.at(self.mass, quads.ravel(), 1000 * 0.5 / len(quads) / 4)
        self.weight = GRAVITY * np.array([np.sin(angle), -np.cos(angle)])
        self.penetration = 1000 * 0.5 * GRAVITY * np.cos(angle) / k
        # Of the law "volume" the pressure is 2 k V, the same here as k by the penetration.
        options = {"stiffness": k / 2, "exponent": 2, "friction_stiffness": k} if law == "volume" else {"stiffness": k}
        self.contact = Contact(self.start, quads, "quad", law=law, estimator="exact", friction_coefficient=MU, **options)
        self.contact.obstacles.add_half_space((0, 0), (0, 1))
        self.x, self.v = self.start - [0, self.penetration], np.zeros_like(self.start)
        self.contact.friction.begin_step(self.x)

    def balance(self, x: np.ndarray, contact: np.ndarray) -> np.ndarray:
        inner = (self.stiffness @ (x - self.start).ravel()).reshape(x.shape)
        return contact + self.mass[:, None] * self.weight - inner

    def place(self) -> float:
        return float(self.mass @ (self.x - self.start)[:, 0] / self.mass.sum())

    def implicit_step(self, dt: float) -> None:
        """By the backward Euler method."""
        y = self.x + dt * self.v
        for _ in range(25):
            result, tangent = self.contact.evaluate_tangent(y)
            inertia = self.mass[:, None] * ((y - self.x) / dt - self.v) / dt
            residual = (self.balance(y, result.forces) - inertia).ravel()
            if np.abs(residual).max() < 1e-9 * self.mass.sum() * GRAVITY:
                break
            matrix = diags(np.repeat(self.mass, 2) / dt**2) + self.stiffness + tangent
            y = y + spsolve(matrix.tocsc(), residual).reshape(y.shape)
        self.v, self.x = (y - self.x) / dt, y
        self.contact.friction.commit_step(y)


@pytest.mark.parametrize("law", ["depth", "fiber"])
def test_a_block_on_an_incline(law: str) -> None:
    """tan 16.7 degrees is 0.3."""
    steep = Block(law, np.radians(16))
    for _ in range(300):
        steep.implicit_step(2e-3)
    settled = steep.place()
    for _ in range(300):
        steep.implicit_step(2e-3)
    # What is left of the motion of the start dies away.
    assert abs(steep.place() - settled) < 0.05 * MU * steep.penetration
    for degrees in (17, 25):
        angle = np.radians(degrees)
        block, speeds = Block(law, angle), []
        for _ in range(300):
            block.implicit_step(2e-3)
            speeds.append(float(block.mass @ block.v[:, 0] / block.mass.sum()))
        acceleration = (speeds[-1] - speeds[99]) / (200 * 2e-3)
        assert abs(acceleration / GRAVITY - (np.sin(angle) - MU * np.cos(angle))) < 1e-4


@pytest.mark.parametrize("law", ["depth", "fiber", "volume"])
def test_a_block_that_stops(law: str) -> None:
    """By central differences from 1 m/s: after v^2 / (2 mu g), with all energy accounted for.

    On a plane as soft as this the block stays on it. On a stiffer one it hops, and goes 1 % further.
    """
    block, dt, lost = Block(law, k=1e7), 2e-4, 0.0
    block.v[:, 0] = 1.0

    def energy(result) -> float:
        u = (block.x - block.start).ravel()
        stored = 0.5 * u @ (block.stiffness @ u) + result.energy + result.friction.energy
        weight = -block.mass @ (block.x - block.start) @ block.weight
        return float(0.5 * block.mass @ (block.v**2).sum(axis=1) + stored + weight)

    first = None
    for _ in range(10_000):
        result = block.contact.evaluate(block.x)
        assert result.friction.dissipation >= 0
        lost += result.friction.dissipation
        first = energy(result) if first is None else first
        block.contact.friction.commit_step(block.x)
        block.v += dt * block.balance(block.x, result.forces) / block.mass[:, None]
        block.x = block.x + dt * block.v
        if block.mass @ block.v[:, 0] <= 0:
            break
    kinetic = 0.5 * block.mass.sum()
    # The speed is half a step behind, which is 1e-3 of it.
    assert abs(energy(block.contact.evaluate(block.x)) + lost - first) < 0.01 * kinetic
    assert block.place() == pytest.approx(1 / (2 * MU * GRAVITY), rel=3e-3)


YOUNG, RADIUS, LOAD = 200.0, 8.0, 0.1
MODULUS = YOUNG / (2 * (1 - 0.3**2))
WIDTH = np.sqrt(4 * LOAD * RADIUS / (np.pi * MODULUS))


def cylinder(facets: int, sign: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A block with a round side, ``facets`` to half the width of contact, growing away from it; points, quads, far side."""

    def graded(first: list[float]) -> np.ndarray:
        values, size = first, WIDTH / facets
        while values[-1] < 20 * WIDTH:
            size *= 1.3
            values.append(values[-1] + size)
        return np.array(values)

    even = graded(list(np.linspace(0, 1.5 * WIDTH, int(1.5 * facets) + 1)))
    x, height = np.concatenate([-even[:0:-1], even]), graded([0.0, WIDTH / facets])
    height /= height[-1]
    gap, top = x**2 / (4 * RADIUS), 20 * WIDTH
    y = sign * (gap + height[:, None] * (top - gap))
    points = np.stack([np.broadcast_to(x, y.shape).ravel(), y.ravel()], axis=1)
    quads = quads_of(*y.shape)
    return points, quads if sign > 0 else quads[:, ::-1], np.arange(y.size)[-len(x) :]


def test_cylinders_that_are_pushed_along_one_another() -> None:
    """Cattaneo and Mindlin: under Q the contact sticks within c = a sqrt(1 - Q / mu P)."""
    (upper, first, top), (lower, second, bottom) = cylinder(24, 1), cylinder(17, -1)
    points, quads = np.concatenate([upper, lower]), np.concatenate([first, second + len(upper)])
    bodies = block_diag([stiffness(upper, first, YOUNG), stiffness(lower, second, YOUNG)]).tocsr()
    moved, held = np.concatenate([2 * top, 2 * top + 1]), 2 * (bottom + len(upper))
    free = np.setdiff1d(np.arange(points.size), np.concatenate([moved, held, held + 1]))
    n = len(free)
    # The far side of the upper body moves as one.
    cols = np.concatenate([np.arange(n), np.full(len(top), n), np.full(len(top), n + 1)])
    motion = csr_matrix((np.ones(len(cols)), (np.concatenate([free, moved]), cols)), (points.size, n + 2))
    contact = Contact(points, quads, "quad", stiffness=2 * YOUNG * 24 / WIDTH)
    contact.mesh.set_symmetry_nodes([])

    def at(z: np.ndarray) -> np.ndarray:
        return points + (motion @ z).reshape(points.shape)

    def solve(z: np.ndarray, load: np.ndarray, unknowns: int) -> tuple[np.ndarray, int]:
        for iteration in range(20):
            result, tangent = contact.evaluate_tangent(at(z))
            residual = load + motion.T @ (result.forces.ravel() - bodies @ (motion @ z))
            residual = np.delete(residual, n) if unknowns == n + 1 else residual
            if np.abs(residual).max() < 1e-9 * LOAD:
                return z, iteration
            matrix = (motion.T @ (bodies + tangent) @ motion).tocsc()
            kept = np.delete(np.arange(n + 2), n) if unknowns == n + 1 else np.arange(n + 2)
            z = z.copy()
            z[kept] += spsolve(matrix[kept][:, kept], residual)
        raise AssertionError("no equilibrium")

    # Pressed together first, without friction, the upper body being moved as one.
    z, load = np.zeros(n + 2), np.zeros(n + 2)
    z[(free % 2 == 1).nonzero()[0][free[free % 2 == 1] < 2 * len(upper)]] = -0.1 * WIDTH**2 / RADIUS
    z[n + 1] = -0.1 * WIDTH**2 / RADIUS
    for part in (0.25, 0.5, 0.75, 1.0):
        load[n + 1] = -part * LOAD
        z, _ = solve(z, load, n + 1)
    contact.set_options(friction_coefficient=MU)
    contact.friction.begin_step(at(z))
    for step in range(1, 11):
        load[n] = 0.06 * step * MU * LOAD
        z, iterations = solve(z, load, n + 2)
        assert iterations <= 8
        sticks = contact.evaluate(at(z)).friction.stick_area / (2 * WIDTH)
        contact.friction.commit_step(at(z))
    # As many facets stick as do as a whole: one more or less on either body is 0.05.
    assert sticks == pytest.approx(np.sqrt(1 - 0.6), abs=0.05)
    # Held there, nothing moves.
    place, slip = z[n], contact.friction.slip
    for _ in range(5):
        z, iterations = solve(z, load, n + 2)
        assert iterations == 0
        contact.friction.commit_step(at(z))
    assert z[n] == place and np.abs(contact.friction.slip - slip).max() < 1e-12 * np.abs(slip).max()


@pytest.mark.parametrize("law", ["depth", "fiber"])
def test_lagged_friction_leads_to_the_same_equilibrium(law: str) -> None:
    """A block that is pressed down and pulled along by its top, some of it sliding; by matrices that are symmetric."""
    found = {}
    for lagged in (False, True):
        block, asymmetry = Block(law, k=1e8), []
        top = np.flatnonzero(block.start[:, 1] > 0.5 - 1e-9)
        held = np.concatenate([2 * top, 2 * top + 1])
        free = np.setdiff1d(np.arange(block.start.size), held)

        def solve(matrix: csr_matrix, right: np.ndarray, asymmetry: list = asymmetry) -> np.ndarray:
            asymmetry.append(abs(matrix - matrix.T).max() / abs(matrix).max())
            return spsolve(matrix.tocsc(), right)

        def host(x: np.ndarray, block: Block = block) -> tuple[np.ndarray, csr_matrix]:
            return block.stiffness @ (x - block.start).ravel(), block.stiffness

        x, solves = block.start, []
        block.contact.friction.begin_step(x)
        for pull in np.linspace(1e-3, 4e-3, 4):
            end = block.start + [pull, -1e-3]
            step = find_equilibrium(host, block.contact, x, free, end, solve=solve, lagged=lagged, max_iterations=60)
            x = step.x
            solves.append(step.iterations)
            # Friction has been released.
            assert step.residuals[-1] <= 1e-9 and np.array_equal(block.contact.evaluate(x).forces, step.result.forces)
            block.contact.friction.commit_step(x)
        assert step.result.friction.slip_area > 0.1
        assert max(asymmetry) < 1e-9 if lagged else max(asymmetry) > 1e-3
        found[lagged] = x, solves
    moved = np.abs(found[False][0] - block.start).max()
    assert np.abs(found[True][0] - found[False][0]).max() < 1e-7 * moved, found
    assert sum(found[True][1]) > sum(found[False][1])


def test_a_step_in_which_nothing_changes_needs_no_solve() -> None:
    """Also where multipliers have moved the surfaces out: slip is that of the material."""
    block = Block("depth", k=1.0)
    block.contact.set_options(stiffness=0.0)
    top = np.flatnonzero(block.start[:, 1] > 0.5 - 1e-9)
    free = np.setdiff1d(np.arange(block.start.size), np.concatenate([2 * top, 2 * top + 1]))

    def host(x: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
        return block.stiffness @ (x - block.start).ravel(), block.stiffness

    x = block.start.copy()
    block.contact.friction.begin_step(x)
    for part in (0.5, 1.0):
        end = x.copy()
        end[top] = block.start[top] + part * np.array([2e-3, -5e-3])
        x = find_equilibrium(host, block.contact, x, free, end).x
        before = block.contact.evaluate(x)
        assert len(block.contact.multipliers.values) > 0 and before.friction.slip_area > 0.1 < before.friction.stick_area
        block.contact.friction.commit_step(x)
        after = block.contact.evaluate(x)
        assert np.abs(after.forces - before.forces).max() < 1e-12 * np.abs(before.forces).max()
    for _ in range(2):
        again = find_equilibrium(host, block.contact, x, free, x.copy())
        assert again.iterations == 0 and np.array_equal(again.x, x)
        block.contact.friction.commit_step(x)


def test_a_step_that_was_never_committed_is_told() -> None:
    """Pulled on and back: without the commit slip counts from before the pull, and friction still holds against it."""
    forces = {}
    for commits in (True, False):
        block = Block("depth", k=1e8)
        top = np.flatnonzero(block.start[:, 1] > 0.5 - 1e-9)
        free = np.setdiff1d(np.arange(block.start.size), np.concatenate([2 * top, 2 * top + 1]))
        x, told = block.start, []
        block.contact.friction.begin_step(x)

        def host(x: np.ndarray, block: Block = block) -> tuple[np.ndarray, csr_matrix]:
            return block.stiffness @ (x - block.start).ravel(), block.stiffness

        for pull in (4e-3, 8e-3, 2e-3):
            end = x.copy()
            end[top] = block.start[top] + [pull, -1e-3]
            found = find_equilibrium(host, block.contact, x, free, end)
            x = found.x
            told.append(any("was not committed" in str(warning) for warning in found.warnings))
            if commits:
                block.contact.friction.commit_step(x)
        # The first step begins where friction does.
        assert told == ([False] * 3 if commits else [False, True, True])
        forces[commits] = found.result.obstacles[0].force[0]
    # It slides back after the commit.
    assert forces[True] == pytest.approx(-forces[False], rel=0.05)
