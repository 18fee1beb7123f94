"""The adjoint of an equilibrium against central differences of ``find_equilibrium``: a contact and bodies made anew for each."""

import pickle

import numpy as np
import pytest
from fmc_contact import Contact, OnUnknowns, Pose, find_equilibrium
from fmc_contact.errors import UnsupportedError
from fmc_contact.search import Host
from scenes import grid

pytest.importorskip("scipy.sparse")
from elastic import stiffness

YOUNG, LAW = 100.0, 3000.0
SOFT = 500.0
"""With multipliers a soft law moves surfaces out by more, and what their turning adds is 1e-5 of a derivative."""

PENALTY = 1e-7
"""Of a derivative by the size of the gradient that it is of: differences with steps of 1e-5 of the parameter leave 1e-8."""
CLOSED = 1e-6
"""The same with multipliers: gaps are closed to 1e-12, which differences divide by their step."""

WITH = pytest.mark.parametrize("penetration", [None, 1e-12], ids=["law", "multipliers"])


def disturbed(coords, seed, by=0.01):
    return coords + by * np.random.default_rng(seed).uniform(-1, 1, coords.shape)


def slope(value, step):
    return (value(step) - value(-step)) / (2 * step)


class Punch:
    """A rounded punch on a block: bodies of squares on no lattice. The punch's top goes down, the block's bottom is held."""

    def __init__(self, penetration=None):
        (block, of_block), (punch, of_punch) = grid((8, 4), (0, 2), (-1, 0)), grid((5, 3), (0.45, 1.4), (0, 0.8))
        self.top = len(block) + np.flatnonzero(punch[:, 1] == 0.8)
        bottom = np.flatnonzero(block[:, 1] == -1)
        lower = punch[:, 1] == 0
        punch[lower, 1] = 0.01 + 0.05 * (punch[lower, 0] - 0.9) ** 2
        self.first = disturbed(np.concatenate([block, punch]), 1)
        self.quads = np.concatenate([of_block, of_punch + len(block)])
        self.upper = np.arange(len(self.first)) >= len(block)
        held = np.concatenate([self.top, bottom])
        self.free = np.setdiff1d(np.arange(self.first.size), np.concatenate([2 * held, 2 * held + 1]))
        self.penetration, self.law = penetration, LAW if penetration is None else SOFT
        self.load = np.zeros(self.first.shape)
        self.load[len(block) + 8] = 1.0
        # J: displacements by any factors, and the vertical force on the punch.
        self.factors = np.random.default_rng(5).standard_normal(self.first.shape)
        self.of_forces = np.zeros(self.first.shape)
        self.of_forces[self.upper, 1] = 3.0

    def solved(self, first=None, young=YOUNG, push=0.06, load=0.0, law=None):
        law = law or self.law
        first = self.first if first is None else first
        self.matrix = matrix = stiffness(first, self.quads, young)
        self.contact = Contact(first, self.quads, "quad", stiffness=law)
        end = first.copy()
        end[self.top, 1] -= push
        host = lambda x: (matrix @ (x - first).ravel() - load * self.load.ravel(), matrix)
        found = find_equilibrium(
            host, self.contact, first, self.free, end, penetration=self.penetration, tolerance=1e-13, max_iterations=3000, max_updates=400
        )
        return found, first

    def value(self, **changes):
        found, first = self.solved(**changes)
        return (self.factors * (found.x - first)).sum() + (self.of_forces * found.result.forces).sum()


@WITH
def test_by_loads_moduli_and_what_is_prescribed(penetration):
    punch = Punch(penetration)
    within = PENALTY if penetration is None else CLOSED
    found, first = punch.solved()
    matrix, count, raised = punch.matrix, len(punch.contact.multipliers.values), punch.contact.options["stiffness"] / punch.law
    got = found.adjoint(punch.factors, punch.of_forces, by=["stiffness"])
    assert got.warnings == [] and (count >= 3) == (penetration is not None)
    by_load = (got.balance * punch.load).sum()
    assert by_load == pytest.approx(slope(lambda by: punch.value(load=by), 1e-3), rel=within)
    by_young = -got.balance.ravel() @ (matrix @ (found.x - first).ravel()) / YOUNG
    assert by_young == pytest.approx(slope(lambda by: punch.value(young=YOUNG + by), 1e-2), rel=within)
    by_push = -got.prescribed[punch.top, 1].sum()
    assert by_push == pytest.approx(slope(lambda by: punch.value(push=0.06 + by), 1e-5), rel=within)
    # With multipliers the law presses at the rim alone, and the search has raised its stiffness.
    by_law = got.gradients.stiffness * raised
    assert by_law == pytest.approx(slope(lambda by: punch.value(law=punch.law + by), 1.0), rel=1e-5, abs=1e-10)
    assert (got.balance.ravel()[np.setdiff1d(np.arange(first.size), punch.free)] == 0).all()
    assert (got.prescribed.ravel()[punch.free] == 0).all()


@WITH
def test_by_the_shape_of_the_punch(penetration):
    """Nodes move with all that hangs on them: coordinates of held nodes, undeformed coordinates, the bodies' matrix."""
    punch = Punch(penetration)
    found, first = punch.solved()
    got = found.adjoint(punch.factors, punch.of_forces, by=["reference"])
    moved = np.random.default_rng(2).uniform(-0.1, 0.1, first.shape) * punch.upper[:, None]
    by_matrix = slope(lambda by: stiffness(first + by * moved, punch.quads, YOUNG), 1e-6)
    by_residual = by_matrix @ (found.x - first).ravel() - punch.matrix @ moved.ravel()
    by_shape = (
        -(punch.factors * moved).sum()
        - got.balance.ravel() @ by_residual
        + ((got.gradients.reference + got.prescribed) * moved).sum()
    )
    # What is left of gaps is divided by the step: a longer one where there are any.
    differences = slope(lambda by: punch.value(first=first + by * moved), 1e-6 if penetration is None else 1e-5)
    assert by_shape == pytest.approx(differences, rel=PENALTY if penetration is None else CLOSED)


class Block:
    """A block pressed on an obstacle, and along it where there is friction."""

    def __init__(self, obstacle, penetration=None, friction=0.0, slide=0.0):
        coords, self.quads = grid((5, 3), (0.45, 1.4), (0, 0.8))
        self.first = disturbed(coords, 3)
        self.top = np.flatnonzero(coords[:, 1] == 0.8)
        self.free = np.setdiff1d(np.arange(self.first.size), np.concatenate([2 * self.top, 2 * self.top + 1]))
        self.obstacle, self.penetration, self.friction, self.slide = obstacle, penetration, friction, slide
        self.pose = {"half_space": ((0.9, 0.0), 0.1), "capsule": ((0.9, -0.4), 1.5)}[obstacle]
        self.factors = np.random.default_rng(5).standard_normal(self.first.shape)
        self.of_forces = np.tile([1.0, 3.0], (len(self.first), 1))

    def solved(self, moved=(0.0, 0.0), turned=0.0, young=YOUNG, slide=0.0, coefficient=0.0, gap_offset=0.0, law=0.0, **options):
        matrix = stiffness(self.first, self.quads, young)
        self.contact = contact = Contact(
            self.first, self.quads, "quad", stiffness=LAW + law, friction_coefficient=self.friction + coefficient
        )
        add = contact.obstacles.add_capsule if self.obstacle == "capsule" else contact.obstacles.add_half_space
        add(*((0.4, 0.6) if self.obstacle == "capsule" else ((0, 0), (0, 1))))
        if gap_offset:
            contact.pairs.set(0, ("obstacle", 0), gap_offset=gap_offset)
        # The step begins with the obstacle where it is: it moves within.
        for by, turn in (((0.0, 0.0), 0.0), (moved, turned)):
            angle = self.pose[1] + turn
            rotation = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
            contact.obstacles.set_pose(0, Pose(np.add(self.pose[0], by), rotation))
            if self.friction and not turn and not any(by):
                contact.friction.begin_step(self.first)
        end = self.first.copy()
        end[self.top] += (self.slide + slide, -0.05)
        self.host = lambda x: (matrix @ (x - self.first).ravel(), matrix)
        self.matrix = matrix
        options = {"penetration": self.penetration, "tolerance": 1e-13, "max_updates": 60, **options}
        return find_equilibrium(self.host, contact, self.first, self.free, end, **options)

    def value(self, **changes):
        found = self.solved(**changes)
        return (self.factors * found.x).sum() + (self.of_forces * found.result.forces).sum()

    def compare(self, within, by=("positions", "rotations")):
        found = self.solved()
        matrix = self.matrix
        got = found.adjoint(self.factors, self.of_forces, by=by)
        by_pose = got.gradients.positions[0]
        size = np.linalg.norm(by_pose)
        for axis in range(2):
            differences = slope(lambda by, axis=axis: self.value(moved=by * np.eye(2)[axis]), 1e-6)
            assert abs(by_pose[axis] - differences) < within * size
        assert abs(got.gradients.rotations[0, 2] - slope(lambda by: self.value(turned=by), 1e-6)) < within * size
        assert abs(got.prescribed[self.top, 0].sum() - slope(lambda by: self.value(slide=by), 1e-6)) < within * size
        by_young = -got.balance.ravel() @ (matrix @ (found.x - self.first).ravel()) / YOUNG
        assert by_young == pytest.approx(slope(lambda by: self.value(young=YOUNG + by), 1e-3), rel=within)
        return found, got


@WITH
@pytest.mark.parametrize("obstacle", ["half_space", "capsule"])
def test_by_the_pose_of_an_obstacle(obstacle, penetration):
    block = Block(obstacle, penetration)
    block.compare(PENALTY if penetration is None else CLOSED)
    assert (len(block.contact.multipliers.values) >= 3) == (penetration is not None)


@WITH
def test_by_a_gap_offset(penetration):
    block = Block("half_space", penetration)
    got = block.solved(gap_offset=1e-3).adjoint(block.factors, block.of_forces, by=["gap_offset"])
    differences = slope(lambda by: block.value(gap_offset=1e-3 + by), 1e-6)
    assert got.gradients.pairs[0].gap_offset == pytest.approx(differences, rel=PENALTY if penetration is None else CLOSED)


@WITH
@pytest.mark.parametrize("slide", [0.002, 0.05], ids=["sticks", "slides"])
def test_with_friction(slide, penetration):
    block = Block("half_space", penetration, 0.3, slide)
    found, got = block.compare(CLOSED, ("positions", "rotations", "friction", "coords", "stiffness"))
    friction = found.result.friction
    assert friction.slip_area > 0.2 if slide > 0.01 else friction.stick_area > 10 * friction.slip_area or penetration
    # Updates of multipliers leave some 1e-12 of a value, by the step of the differences.
    differences = slope(lambda by: block.value(coefficient=by), 1e-6 if penetration is None else 1e-5)
    size = max(abs(differences), 1e-3 * np.abs(got.gradients.positions).max())
    assert abs(got.gradients.pairs[0].friction - differences) < CLOSED * size
    if penetration is None:
        differences = slope(lambda by: block.value(law=by), 1e-2)
        assert got.gradients.stiffness == pytest.approx(differences, rel=CLOSED)


def test_by_bodies_that_are_all_held():
    """The block is rigid, and all its nodes are moved: their derivative comes through forces and gaps alone."""
    punch = Punch(1e-12)
    punch.free = punch.free[punch.upper[punch.free // 2]]
    found, first = punch.solved()
    got = found.adjoint(punch.factors, punch.of_forces)
    moved = np.random.default_rng(2).uniform(-0.1, 0.1, first.shape) * ~punch.upper[:, None]

    def value(by):
        end = first + by * moved
        end[punch.top, 1] -= 0.06
        contact = Contact(first, punch.quads, "quad", stiffness=punch.law)
        host = lambda x: (punch.matrix @ (x - first).ravel(), punch.matrix)
        options = {"penetration": 1e-12, "tolerance": 1e-13, "max_iterations": 3000, "max_updates": 400}
        there = find_equilibrium(host, contact, first, punch.free, end, **options)
        return (punch.factors * there.x).sum() + (punch.of_forces * there.result.forces).sum()

    assert (got.prescribed * moved).sum() == pytest.approx(slope(value, 1e-4), rel=CLOSED)


@WITH
def test_by_coordinates_of_which_the_unknowns_are_displacements(penetration):
    """All nodes of the contact move, and neither the bodies' matrix nor depths: a host whose mesh is another one."""
    block = Block("half_space", penetration)
    block.solved()
    matrix, moved = block.matrix, np.random.default_rng(2).uniform(-0.1, 0.1, block.first.shape)
    end = np.zeros(block.first.shape)
    end[block.top, 1] = -0.05

    def solved(by):
        contact = Contact(block.first, block.quads, "quad", stiffness=LAW)
        contact.obstacles.add_half_space(block.pose[0], (-np.sin(block.pose[1]), np.cos(block.pose[1])))
        on_host = OnUnknowns(contact, block.first + by * moved, np.arange(end.size).reshape(end.shape))
        options = {"penetration": penetration, "tolerance": 1e-13, "max_updates": 60}
        return find_equilibrium(lambda u: (matrix @ u, matrix), on_host, np.zeros(end.size), block.free, end.ravel(), **options)

    def value(by):
        found = solved(by)
        return block.factors.ravel() @ found.x + (block.of_forces * found.result.forces).sum()

    got = solved(0.0).adjoint(block.factors.ravel(), block.of_forces, by=["coords"])
    within = PENALTY if penetration is None else CLOSED
    assert (got.gradients.coords * moved).sum() == pytest.approx(slope(value, 1e-5 if penetration is None else 1e-4), rel=within)


def test_with_friction_the_matrix_is_transposed():
    """With the matrix as it is, not transposed, derivatives are others: the test of friction sees the difference."""
    block = Block("half_space", None, 0.3, 0.05)
    found = block.solved()
    tangent = block.contact.tangent(found.x)
    assert abs(tangent - tangent.T).max() > 1e-2 * abs(tangent).max()


def test_where_friction_begins_to_slide_it_is_told():
    """All points stick with the traction at which they would slide: k_T s = μ k d."""
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    moved = coords + [0.3 * 0.0625, -0.0625]
    for by, is_told in ((0.0, True), (-1e-3, False), (1e-3, False)):
        contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=LAW, friction_coefficient=0.3)
        contact.obstacles.add_half_space((0, 0), (0, 1))
        contact.friction.begin_step(coords)
        found = find_equilibrium(lambda x: (np.zeros(8), np.eye(8)), contact, moved + [by, 0.0], [])
        told = found.adjoint(np.ones((4, 2))).warnings
        assert any("begins to slide" in text for text in told) == is_told


@WITH
def test_a_solver_of_ones_own_and_unknowns_of_ones_own(penetration):
    from scipy.sparse.linalg import spsolve

    block = Block("half_space", penetration)
    got = block.solved().adjoint(block.factors, block.of_forces, by=["positions"])
    own = block.solved(solve=lambda matrix, right: spsolve(matrix.tocsc(), right))
    again = own.adjoint(block.factors, block.of_forces, by=["positions"])
    assert again.balance == pytest.approx(got.balance, rel=1e-7, abs=1e-7 * np.abs(got.balance).max())

    # All displacements along x before those along y, and an unknown that moves nothing.
    count = len(block.first)
    order = np.arange(2 * count).reshape(2, count).T
    contact = Contact(block.first, block.quads, "quad", stiffness=LAW)
    contact.obstacles.add_half_space(block.pose[0], (-np.sin(block.pose[1]), np.cos(block.pose[1])))
    size = 2 * count + 1
    matrix = np.eye(size)
    matrix[np.ix_(order.ravel(), order.ravel())] = block.matrix.toarray()
    free = np.append(order.ravel()[block.free], size - 1)
    end, factors = np.zeros(size), np.zeros(size)
    end[order[block.top, 1]] = -0.05
    factors[order.ravel()] = block.factors.ravel()
    on_host = OnUnknowns(contact, block.first, order, size)
    found = find_equilibrium(
        lambda u: (matrix @ u, matrix), on_host, np.zeros(size), free, end, penetration=penetration, tolerance=1e-13, max_updates=60
    )
    there = found.adjoint(factors, block.of_forces, by=["positions"])
    assert there.balance.shape == (size,) and there.balance[-1] == 0
    assert there.gradients.positions == pytest.approx(got.gradients.positions, rel=1e-6)
    assert there.balance[order] == pytest.approx(got.balance, rel=1e-6, abs=1e-6 * np.abs(got.balance).max())


def test_the_contact_is_what_it_was():
    block = Block("half_space", 1e-12, 0.3, 0.05)
    found = block.solved()
    before = block.contact.multipliers.values.tobytes(), block.contact.evaluate(found.x).forces.tobytes()
    found.adjoint(block.factors, block.of_forces, by=["positions", "rotations"])
    assert before == (block.contact.multipliers.values.tobytes(), block.contact.evaluate(found.x).forces.tobytes())


def test_what_is_no_derivative_is_told():
    block = Block("half_space", None, 0.3, 0.05)
    found = block.solved()
    with pytest.raises(ValueError, match="by_x has shape"):
        found.adjoint(np.ones(3))
    with pytest.raises(ValueError, match="'by' has no value 'shape'"):
        found.adjoint(block.factors, by=["shape"])
    with pytest.raises(ValueError, match="'by' is the text 'positions', expected a list .*'positions'.*rotations, stiffness"):
        found.adjoint(block.factors, by="positions")
    for name in ("by_x", "by_forces"):
        wrong = block.factors.copy()
        wrong[2, 1] = np.nan
        with pytest.raises(ValueError, match=rf"{name}\[2, 1\] is nan, expected finite numbers"):
            found.adjoint(*((wrong,) if name == "by_x" else (block.factors, wrong)))
    with pytest.raises(UnsupportedError, match="friction by reference coordinates"):
        punch = Punch()
        contact = Contact(punch.first, punch.quads, "quad", stiffness=LAW, friction_coefficient=0.3)
        contact.friction.begin_step(punch.first)
        contact.vjp(punch.first - 0.02 * punch.upper[:, None], np.ones(punch.first.shape), by=["reference"])
    block.contact.friction.commit_step(found.x)
    with pytest.raises(ValueError, match="the contact has changed"):
        found.adjoint(block.factors)
    # Gaps that are not closed: J is another one.
    loose = Block("half_space", 1e-3)
    found = loose.solved(max_updates=1)
    assert any("ask find_equilibrium for a penetration" in text for text in found.adjoint(loose.factors).warnings)


def test_a_copy_of_the_result_has_no_adjoint():
    """It can be stored, as the bodies and the contact cannot."""
    found = Block("half_space").solved()
    copy = pickle.loads(pickle.dumps(found))
    assert np.array_equal(copy.x, found.x) and copy.result.energy == found.result.energy
    with pytest.raises(ValueError, match="not one of find_equilibrium"):
        copy.adjoint(np.zeros(found.x.shape))


def test_bodies_that_solve_by_themselves_have_none():
    class Springs(Host):
        def forces(self, x, matrix):
            return 1e3 * (x - block.first.ravel()), None

        def product(self, vector, magnitudes):
            return 1e3 * vector

        def diagonal(self):
            return np.full(block.first.size, 1e3)

        def solve(self, x, flags, shift, right):
            total = 1e3 * (1 + shift) * np.eye(len(x)) + block.contact.tangent(x.reshape(-1, 2)).toarray()
            return np.linalg.solve(total, right)

    block = Block("half_space")
    block.solved()
    found = find_equilibrium(Springs(), block.contact, block.first, range(block.first.size))
    with pytest.raises(UnsupportedError, match="bodies with their own solver"):
        found.adjoint(block.factors)
