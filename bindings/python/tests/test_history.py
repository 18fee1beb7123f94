"""Histories of frictional steps, differentiated from their last step back to the first, against differences of whole histories."""

import numpy as np
import pytest
from fmc_contact import Contact, History, Pose, find_equilibrium
from fmc_contact.errors import UnsupportedError
from scenes import grid
from test_adjoint import disturbed, slope

pytest.importorskip("scipy.sparse")
from elastic import stiffness

YOUNG, LAW, FRICTION = 100.0, 1000.0, 0.3
WITHIN = 1e-7
"""Of a derivative by its size."""


class Dragged:
    """A block of squares on no lattice, pressed on a floor by its top, and dragged to and fro."""

    def __init__(self, count):
        self.count, self.parts = count, []
        block, self.quads = grid((6, 3), (0, 1.5), (0, 0.75))
        self.top = np.flatnonzero(block[:, 1] == 0.75)
        self.first = disturbed(block, 1)
        # Round below, so that facets come to bear one after the other.
        self.first[:7, 1] = 0.004 + 0.03 * (self.first[:7, 0] - 0.8) ** 2
        held = np.concatenate([2 * self.top, 2 * self.top + 1])
        self.free = np.setdiff1d(np.arange(block.size), held)
        random = np.random.default_rng(5)
        # J: all displacements of the last step, and the forces of all of them.
        self.of_x = random.standard_normal(block.shape)
        self.of_forces = random.standard_normal((count, *block.shape)) / YOUNG

    def ends(self, drag):
        """Displacements of the top at the end of every step."""
        time = (np.arange(self.count) + 1) / self.count
        return np.stack([drag * np.sin(2.2 * np.pi * time + 0.1), -0.02 - 0.01 * np.sin(3 * np.pi * time)], 1)

    def begun(self, young=YOUNG, law=LAW, friction=FRICTION, drag=0.03, floor=0.0, first=None, states=20, tilt=0.0):
        first = self.first if first is None else first
        self.contact = Contact(self.first, self.quads, "quad", stiffness=law, friction_coefficient=friction)
        self.contact.obstacles.add_half_space((0, 0), (0, 1))
        self.matrix, ends = stiffness(self.first, self.quads, young), self.ends(drag)

        def solve(step, x):
            end = x.copy()
            end[self.top] = self.first[self.top] + ends[step]
            turn = tilt * (step + 1)
            pose = Pose((0, floor * (step + 1)), [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
            self.contact.obstacles.set_pose(0, pose)
            residual = lambda x: (self.matrix @ (x - self.first).ravel(), self.matrix)
            return find_equilibrium(residual, self.contact, x, self.free, end, tolerance=1e-14, straight_slip=True)

        return History(self.contact, solve, self.count, states), first

    def value(self, **changes):
        history, first = self.begun(**changes)
        total = 0.0
        for step, found in history.forward(first):
            total += (self.of_forces[step] * found.result.forces).sum()
            self.parts.append(found.result.friction)
        self.history = history
        return total + (self.of_x * (found.x - self.first)).sum()

    def seed(self, step, found):
        return self.of_x if step == self.count - 1 else None, self.of_forces[step]


def test_fifty_steps_of_a_block_that_is_dragged_over_a_floor():
    block = Dragged(50)
    block.parts = []
    block.value()
    sliding = sum(part.slip_area > 0 for part in block.parts)
    sticking = sum(part.stick_area > 0 for part in block.parts)
    assert sliding > 20 and sticking > 20, (sliding, sticking)
    history, end = block.history, block.contact.friction.slip
    got = dict.fromkeys(("young", "law", "friction", "drag", "floor", "tilt"), 0.0)
    rates = block.ends(1.0) * [1, 0]
    for back in history.backward(block.seed, ["positions", "rotations", "stiffness", "friction"]):
        assert not back.warnings, (back.step, back.warnings)
        got["young"] -= back.balance.ravel() @ (block.matrix @ (back.x - block.first).ravel()) / YOUNG
        got["law"] += back.gradients.stiffness
        got["friction"] += sum(pair.friction for pair in back.gradients.pairs)
        got["drag"] += back.prescribed[block.top].sum(0) @ rates[back.step]
        got["floor"] += (back.step + 1) * back.gradients.positions[0, 1]
        got["tilt"] += (back.step + 1) * back.gradients.rotations[0, 2]
    assert history.kept <= 20 and history.solved < 4 * block.count
    assert np.array_equal(block.contact.friction.slip, end)
    at = {"young": YOUNG, "law": LAW, "friction": FRICTION, "drag": 0.03, "floor": 0.0, "tilt": 0.0}
    steps = {"young": 1e-3, "law": 1e-2, "friction": 1e-5, "drag": 1e-6, "floor": 1e-7, "tilt": 1e-7}
    found = {name: slope(lambda by, name=name: block.value(**{name: at[name] + by}), steps[name]) for name in at}
    for name in at:
        assert abs(got[name] - found[name]) < WITHIN * abs(found[name]), name


class Blocks:
    """A block of squares on another, dragged to and fro: facets of both carry slip against those of the other."""

    count = 4

    def __init__(self, options):
        (lower, of_lower), (upper, of_upper) = grid((5, 1), (0, 1.5), (-0.5, 0)), grid((3, 1), (0.25, 1.2), (0, 0.5))
        upper[:4, 1] = 0.004 + 0.02 * (upper[:4, 0] - 0.7) ** 2
        self.options, self.top = options, len(lower) + np.flatnonzero(upper[:, 1] == 0.5)
        self.first = disturbed(np.concatenate([lower, upper]), 1, by=0.004)
        self.quads = np.concatenate([of_lower, of_upper + len(lower)])
        held = self.held = np.concatenate([self.top, np.flatnonzero(lower[:, 1] == -0.5)])
        self.free = np.setdiff1d(np.arange(self.first.size), np.concatenate([2 * held, 2 * held + 1]))
        self.factors = np.random.default_rng(5).standard_normal((2, *self.first.shape))

    def begun(self, first=None, friction=FRICTION, law=LAW, drag=0.01, slip=None, states=20, still=False):
        start = self.first if first is None else first
        contact = self.contact = Contact(self.first, self.quads, "quad", stiffness=law, friction_coefficient=friction, **self.options)
        if slip is not None:
            contact.friction.begin_step(start)
            contact.friction.slip = slip
        matrix = stiffness(self.first, self.quads, YOUNG)

        def solve(step, x):
            end = self.first.copy()
            end[self.top] += [0.05, -0.02] if still else [drag * np.sin(1.1 * step), -0.02 - 0.001 * step]
            residual = lambda x: (matrix @ (x - self.first).ravel(), matrix)
            return find_equilibrium(residual, contact, x, self.free, end, tolerance=1e-14, straight_slip=True)

        return History(contact, solve, self.count, states), start

    def value(self, **changes):
        history, start = self.begun(**changes)
        self.history, self.ends = history, [found for _, found in history.forward(start)]
        return (self.factors[0] * (self.ends[-1].x - self.first)).sum() + (self.factors[1] * self.ends[-2].result.forces).sum()

    def seed(self, step, found):
        return {self.count - 1: (self.factors[0], None), self.count - 2: (None, self.factors[1])}.get(step)


@pytest.mark.parametrize("options", [{}, {"friction_stiffness": 700.0}, {"memoryless_slip": 0.01}], ids=["law", "own", "memoryless"])
def test_two_bodies_by_how_the_history_began(options):
    blocks = Blocks(options)
    blocks.value()
    history, pressed = blocks.history, blocks.ends[1].x
    # Again from within, so that facets bear and carry slip when it begins.
    slip = blocks.contact.friction.slip
    blocks.value(first=pressed, slip=slip)
    history = blocks.history
    backs = list(history.backward(blocks.seed, ["stiffness", "friction"]))
    assert not [back.warnings for back in backs if back.warnings]
    start = history.start
    random = np.random.default_rng(8)
    along, of_slip = random.standard_normal(pressed.shape), slip.copy()
    of_slip[:, 4:] = 0
    of_slip[:, 4:6] = random.standard_normal((len(slip), 2))
    of = {tuple(row[:4]): row[4:6] for row in start.slip}
    rates = {
        "first": (start.coords * along).sum(),
        "slip": sum(of[tuple(row[:4])] @ row[4:6] for row in of_slip if tuple(row[:4]) in of),
        "law": sum(back.gradients.stiffness for back in backs),
        "friction": sum(pair.friction for back in backs for pair in back.gradients.pairs),
    }
    steps = {"first": 1e-7, "slip": 1e-7, "law": 1e-2, "friction": 1e-5}
    # Of numbers by their effect on J, which is about 1.
    sizes = {"first": np.linalg.norm(start.coords), "slip": np.linalg.norm(start.slip[:, 4:6]), "law": 1 / LAW, "friction": 1 / FRICTION}

    def moved(name, by):
        change = np.zeros(slip.shape)
        change[:, 4:6] = by * of_slip[:, 4:6]
        changes = {"first": pressed + by * along, "slip": slip + change, "law": LAW + by, "friction": FRICTION + by}
        return blocks.value(**{"first": pressed, "slip": slip, name: changes[name]})

    for name, rate in rates.items():
        found = slope(lambda by, name=name: moved(name, by), steps[name])
        assert abs(rate - found) <= WITHIN * sizes[name], (name, rate, found)


def test_where_stick_and_slip_meet_it_is_told():
    """A step in which nothing moves, after one in which all slid: facets are at their limits, and go on or turn back."""
    blocks = Blocks({})
    blocks.count = 2
    history, start = blocks.begun(still=True)
    forces = [found.result.forces for _, found in history.forward(start)]
    assert np.abs(forces[-1] - forces[-2]).max() < 1e-9 * np.abs(forces[-1]).max()
    told = {back.step: back.warnings for back in history.backward(blocks.seed)}
    assert len(told[1]) == 1 and "of step 1 are at an edge, as where friction begins to slide" in told[1][0] and not told[0]


def test_what_a_history_does_not_have_is_refused():
    blocks = Blocks({})
    history, start = blocks.begun()
    with pytest.raises(ValueError, match="go through all of forward first"):
        next(history.backward(blocks.seed))
    assert [step for step, _ in history.forward(start)] == [0, 1, 2, 3]
    with pytest.raises(ValueError, match="a history has no derivative by 'reference', expected positions"):
        next(history.backward(blocks.seed, ["reference"]))
    with pytest.raises(ValueError, match="states is 2, expected an integer of at least 3"):
        History(blocks.contact, history.solve, 4, 2)
    blocks.contact.set_options(static_coefficient=0.4, weakening_slip=0.1)
    again = History(blocks.contact, history.solve, 1)
    assert len(list(again.forward(start))) == 1
    with pytest.raises(UnsupportedError, match="static friction, which carries more than slip"):
        next(again.backward(blocks.seed))


def test_the_same_bits_with_few_states():
    blocks = Blocks({})
    blocks.count = 3
    blocks.value()
    expected = list(blocks.history.backward(blocks.seed, ["friction"]))
    assert blocks.history.kept == blocks.count + 2 and blocks.history.solved == 2 * blocks.count
    blocks.value(states=3)
    found = list(blocks.history.backward(blocks.seed, ["friction"]))
    assert blocks.history.kept == 3 and blocks.history.solved == 9
    assert [one.step for one in found] == [2, 1, 0]
    for one, other in zip(found, expected):
        assert np.array_equal(one.balance, other.balance) and one.gradients.pairs == other.gradients.pairs


SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
OF_SQUARE = 1e3 * np.kron([[3, -1, -1, -1], [-1, 3, -1, -1], [-1, -1, 3, -1], [-1, -1, -1, 3]], np.eye(2))


def square(downs, friction=0.3, drag=0.001, contact=None, **options):
    """A square on a floor, pressed and dragged by its top; ``downs`` by step."""
    contact = contact or Contact(SQUARE, [[0, 1, 2, 3]], "quad", stiffness=1e4, friction_coefficient=friction, **options)
    if not contact.obstacles.count:
        contact.obstacles.add_half_space((0, 0), (0, 1))

    def solve(step, x):
        end = SQUARE.copy()
        end[2:] += (drag * (step + 1), -downs[step])
        bodies = lambda x: (OF_SQUARE @ (x - SQUARE).ravel(), OF_SQUARE)
        return find_equilibrium(bodies, contact, x, range(4), end, tolerance=1e-14, straight_slip=True)

    return History(contact, solve, len(downs))


def dragged(history, step):
    """The first coordinate at the end of a step, and its derivative by the way of each step along x."""
    goal = np.zeros((4, 2))
    goal[0, 0] = 1
    value = [found.x[0, 0] for _, found in history.forward(SQUARE)][step]
    back = history.backward(lambda at, found: (goal, None) if at == step else None, by=["positions"])
    return value, sum((one.step + 1) * one.prescribed[2:, 0].sum() for one in back)


@pytest.mark.parametrize("downs", [(0.01, 0.012, -0.02), (-0.02, 0.01, 0.012), (0.01, -0.02, 0.012), (-0.01, -0.02)])
@pytest.mark.parametrize("friction", [0.3, 0.0])
def test_steps_without_contact_or_friction_have_their_derivative(downs, friction):
    for step in range(len(downs)):
        _, found = dragged(square(downs, friction), step)
        ends = [dragged(square(downs, friction, 0.001 + by), step)[0] for by in (1e-6, -1e-6)]
        assert found == pytest.approx((ends[0] - ends[1]) / 2e-6, rel=1e-6, abs=1e-9)


def test_an_obstacle_that_was_removed_changes_nothing():
    contact = Contact(SQUARE, [[0, 1, 2, 3]], "quad", stiffness=1e4, friction_coefficient=0.3)
    contact.obstacles.add_half_space((0, 0), (0, 1))
    contact.obstacles.add_ball(0.3, (5, 5))
    contact.obstacles.remove(1)
    assert dragged(square((0.01, 0.012), contact=contact), 1) == dragged(square((0.01, 0.012)), 1)


def test_nodes_on_the_axis_stay_there():
    # Sheared to the side off the axis: the nodes on it are held along the radius.
    disc = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)

    def end(down):
        contact = Contact(disc, [[0, 1, 2, 3]], "quad", stiffness=1e4, friction_coefficient=0.3, axisymmetric=True)
        floor = contact.obstacles.add_half_space((0, 0), (0, 1))
        contact.friction.begin_step(disc)
        contact.obstacles.set_pose(floor, (0, down))
        host = lambda x: (OF_SQUARE @ (x - disc).ravel(), OF_SQUARE)
        return find_equilibrium(host, contact, disc, [1, 2, 3], tolerance=1e-14, straight_slip=True)

    goal = np.zeros((4, 2))
    goal[1] = 1
    found = end(0.01).adjoint(goal, by=["positions"]).gradients.positions[0, 1]
    ends = [end(0.01 + by).x[1].sum() for by in (1e-6, -1e-6)]
    assert found == pytest.approx((ends[0] - ends[1]) / 2e-6, rel=1e-6)


def test_wear_and_a_step_that_was_accepted_are_refused():
    history = square((0.01, 0.012, 0.012))
    history.contact.pairs.set_wear(0, ("obstacle", 0), 1e-5)
    with pytest.raises(UnsupportedError, match="wear"):
        list(history.backward(lambda step, found: None) for _ in history.forward(SQUARE))
    contact = Contact(SQUARE, [[0, 1, 2, 3]], "quad", friction_coefficient=0.3)
    only = square((0.02,), contact=contact, drag=0.003)
    contact.friction.begin_step(SQUARE)
    found = only.solve(0, SQUARE)
    found.adjoint(np.ones((4, 2)))
    contact.friction.commit_step(found.x)
    with pytest.raises(ValueError, match="before commit_step"):
        found.adjoint(np.ones((4, 2)))
