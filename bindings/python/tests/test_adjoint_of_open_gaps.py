"""The adjoint where the search leaves gaps: with its own options, after loading and unloading, against differences.

J is a sum of displacements by factors of both signs, so that little of it is left."""

import numpy as np
import pytest
from fmc_contact import Contact, find_equilibrium
from fmc_contact.search import closed
from scenes import grid

pytest.importorskip("scipy.sparse")
from elastic import bricks, stiffness, stiffness_of_bricks

STEP = 1e-6
"""With a longer one some scenes pass a kink of the law."""
WITHIN = {0.0: 1e-6, 0.3: 2e-5}
"""Of a derivative by its size. What closing leaves is the square of its last step, 1e-10, which differences divide by theirs."""

SCENES = pytest.mark.parametrize("dim", [2, 3])
FRICTION = pytest.mark.parametrize("friction", [0.0, 0.3])


class Pressed:
    """A rounded punch that is pressed on a block, then lifted by half."""

    def __init__(self, dim, friction=0.0, seed=1):
        if dim == 2:
            (block, of_block), (punch, of_punch) = grid((12, 4), (0, 2), (-1, 0)), grid((9, 3), (0.45, 1.4), (0, 0.6))
            name, matrix = "quad", stiffness
        else:
            block, of_block = bricks((4, 4, 2), (0, 0, -1), (2, 2, 0))
            punch, of_punch = bricks((4, 4, 1), (0.45, 0.5, 0), (1.4, 1.55, 0.6))
            name, matrix = "hexahedron", stiffness_of_bricks
        self.top, bottom = len(block) + np.flatnonzero(punch[:, -1] == 0.6), np.flatnonzero(block[:, -1] == -1)
        lower = punch[:, -1] == 0
        punch[lower, -1] = 0.01 + 0.02 * ((punch[lower, :-1] - 1.0) ** 2).sum(axis=1)
        random = np.random.default_rng(seed)
        self.first = np.concatenate([block, punch])
        self.first += 0.005 * random.uniform(-1, 1, self.first.shape)
        self.cells, self.name, self.friction = np.concatenate([of_block, of_punch + len(block)]), name, friction
        held = np.concatenate([self.top, bottom])
        self.free = np.setdiff1d(np.arange(self.first.size), (dim * held[:, None] + np.arange(dim)).ravel())
        self.matrix = matrix(self.first, self.cells, 100.0)
        self.factors = random.standard_normal(self.first.shape)
        self.load = np.zeros(self.first.shape)
        self.load[-1], self.load[len(block) + 1, 0] = 1.0, 1.0

    def solved(self, by=0.0, last=(), **options):
        """``by`` changes moduli, loads, and what is prescribed, all at once, in the last load step."""
        contact = Contact(self.first, self.cells, self.name, friction_coefficient=self.friction)
        self.contact, x, options = contact, self.first, {"tolerance": 1e-12, "max_iterations": 3000, **options}
        for push, slide, change, more in ((0.1, 0.0, 0.0, {}), (0.05, 0.02 if self.friction else 0.0, by, dict(last))):
            end = self.first.copy()
            end[self.top] -= np.eye(len(end[0]))[-1] * (push + change)
            end[self.top, 0] += slide + change
            young, load = 1.0 + change, change * self.load.ravel()
            host = lambda x, young=young, load=load: (young * (self.matrix @ (x - self.first).ravel()) - load, young * self.matrix)
            if self.friction:
                if x is not self.first:
                    contact.friction.commit_step(x)
                contact.friction.begin_step(x)
            found = find_equilibrium(host, contact, x, self.free, end, straight_slip=True, **{**options, **more})
            x = found.x
        return found

    def slope(self, got):
        """What the adjoint has for the derivative by ``by``."""
        by_residual = self.matrix @ (got.x - self.first).ravel() - self.load.ravel()
        prescribed = got.prescribed[self.top]
        return prescribed[:, 0].sum() - prescribed[:, -1].sum() - got.balance.ravel() @ by_residual

    def value(self, x):
        return (self.factors * x).sum()


def differences(value):
    return (value(STEP) - value(-STEP)) / (2 * STEP)


@SCENES
@FRICTION
def test_it_is_the_derivative_with_closed_gaps_whatever_the_search_left(dim, friction):
    scene = Pressed(dim, friction)
    found = scene.solved()
    got = found.adjoint(scene.factors)
    assert found.penetration > 1e-5 and got.change > 1e-4
    assert scene.value(got.x) - scene.value(found.x) == pytest.approx(got.closing, abs=1e-14)

    def value(by):
        there = scene.solved(by)
        return scene.value(there.x) + there.adjoint(scene.factors).closing

    slope = scene.slope(got)
    assert slope == pytest.approx(differences(value), rel=WITHIN[friction])
    # Differences of what the search leaves are others, beyond the errors of these, and that is told.
    left = abs(slope - differences(lambda by: scene.value(scene.solved(by).x)))
    told = any("differs from differences of J with the gaps of the search" in text for text in got.warnings)
    assert left > 4 * WITHIN[friction] * abs(slope) and (told or left < 1e-2 * np.linalg.norm(got.prescribed))


@FRICTION
def test_coarsely_closed_gaps_have_the_derivative_of_finely_closed_ones(friction):
    """The law is as stiff in both: the search raises it alike."""
    scene = Pressed(3, friction)
    fine, coarse = ({"penetration": wanted, "max_updates": 400} for wanted in (1e-11, 1e-5))
    found = scene.solved(last=fine)
    best = found.adjoint(scene.factors)
    assert (best.closing, best.change, best.warnings) == (0.0, 0.0, []) and np.array_equal(best.x, found.x)
    found = scene.solved(last=coarse)
    got = found.adjoint(scene.factors)
    assert np.abs(found.x - got.x).max() > 1e-7
    assert np.linalg.norm(got.balance - best.balance) < 1e-5 * np.linalg.norm(best.balance)
    assert scene.value(found.x) + got.closing - scene.value(best.x) == pytest.approx(0.0, abs=1e-7)


def test_the_contact_is_what_it_was():
    scene = Pressed(2)
    found = scene.solved()
    before = scene.contact.multipliers.values.tobytes(), scene.contact.evaluate(found.x).forces.tobytes()
    assert not np.array_equal(found.adjoint(scene.factors, by=["coords"]).x, found.x)
    assert before == (scene.contact.multipliers.values.tobytes(), scene.contact.evaluate(found.x).forces.tobytes())


def test_a_solver_of_ones_own_closes_them_too():
    from scipy.sparse.linalg import spsolve

    scene = Pressed(2)
    got = scene.solved().adjoint(scene.factors)
    found = scene.solved(solve=lambda matrix, right: spsolve(matrix.tocsc(), right), two_level=True)
    own = found.adjoint(scene.factors)
    assert own.x == pytest.approx(got.x, abs=1e-9)
    assert own.balance == pytest.approx(got.balance, abs=1e-6 * np.abs(got.balance).max())


def test_gaps_that_cannot_be_closed_are_told(monkeypatch):
    monkeypatch.setattr(closed, "STEPS", 0)
    scene = Pressed(2)
    found = scene.solved()
    got = found.adjoint(scene.factors)
    assert any("could not be closed: the derivative is wrong by an unknown amount" in text for text in got.warnings)
    assert np.array_equal(got.x, found.x) and (got.closing, got.change) == (0.0, 0.0)
