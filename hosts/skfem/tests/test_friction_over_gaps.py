"""Friction of bodies that come to touch in a step: it is that of the same bodies that touch when the step begins."""

import numpy as np
import pytest
from fmc_contact import NotConvergedError, find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementQuad1, ElementVector, LinearForm, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

# Another number of updates of the multipliers, each of which leaves less than 1e-3 of the forces.
ALIKE = 1e-3


class Block:
    """A block, 2 wide and 1 high, above a rigid plane with friction."""

    def __init__(self, gap, mu=0.3):
        self.mesh = MeshQuad.init_tensor(np.linspace(-1, 1, 21), np.linspace(0, 1, 11) + gap)
        self.basis = Basis(self.mesh, ElementVector(ElementQuad1()))
        self.matrix = linear_elasticity(*lame_parameters(1e3, 0.3)).assemble(self.basis)
        self.contact = SkfemContact(self.basis, friction_coefficient=mu)
        self.plane = self.contact.contact.obstacles.add_half_space((0, 0), (0, 1))
        self.load = np.zeros(self.basis.N)
        self.u = np.zeros(self.basis.N)
        self.contact.begin_step(self.u)

    def top(self, axis):
        return self.basis.nodal_dofs[axis, self.mesh.p[1] > self.mesh.p[1].max() - 1e-9]

    def moved(self, along, down):
        """A load step in which the top moves."""
        end = self.u.copy()
        end[self.top(0)], end[self.top(1)] = along, -down
        held = np.r_[self.top(0), self.top(1)]
        return self.solved(np.setdiff1d(np.arange(self.basis.N), held), end)

    def solved(self, free, end=None):
        found = find_equilibrium(lambda u: (self.matrix @ u - self.load, self.matrix), self.contact, self.u, free, end)
        self.contact.commit_step(found.x)
        self.u = found.x
        return found

    def friction(self, found):
        """On the right half of the base, which spreads."""
        return found.result.forces[self.mesh.p[0] > 1e-9, 0].sum()


def pressed(gap):
    block = Block(gap)
    found = block.moved(0.0, gap + 0.05)
    assert not found.warnings, found.warnings
    assert found.first_touches == (gap > 0)
    return block.friction(found)


def test_a_block_pressed_over_a_gap():
    touching = pressed(0.0)
    for gap in (1e-4, 0.01, 0.05, 0.5, 5.0):
        assert abs(pressed(gap) / touching - 1) < ALIKE, gap


def loaded(gap):
    """By its weight; nothing else holds it."""
    block = Block(gap)
    block.load = LinearForm(lambda v, w: -10.0 * v[1]).assemble(block.basis)
    return block.friction(block.solved(np.arange(block.basis.N)))


def test_a_loose_block_that_falls_over_a_gap():
    touching = loaded(0.0)
    for gap in (0.01, 0.5):
        assert abs(loaded(gap) / touching - 1) < ALIKE, gap


def test_a_block_that_goes_along_while_it_comes_down():
    """In one step, and in two with the end of the first where it touches: the way along before is no slip."""
    for gap in (0.05, 0.5, 5.0):
        one, two = Block(gap), Block(gap)
        found = one.moved(1.0, gap + 0.05)
        two.moved(gap / (gap + 0.05), gap)
        expected = two.moved(1.0, gap + 0.05)
        forces = [found.result.obstacles[one.plane].force, expected.result.obstacles[two.plane].force]
        # What is dissipated is force by way: the way is 0.5 of the step, 0.09, and 0.01.
        work = [found.result.friction.dissipation, expected.result.friction.dissipation]
        assert np.abs(forces[0] - forces[1]).max() < ALIKE * np.abs(forces[1]).max(), gap
        assert abs(work[0] - work[1]) < max(ALIKE * work[1], 1e-4), (gap, work)


@pytest.mark.parametrize("gaps", [(0.1, 0.1), (0.03, 0.5), (0.5, 0.03), (0.0, 0.1)])
def test_two_gaps_that_close_one_after_the_other(gaps):
    """A block pressed on another one above a plane, which springs hold that bear 1e-4 of the force, or less."""

    def spread(below, between):
        lower = MeshQuad.init_tensor(np.linspace(-1, 1, 21), np.linspace(0, 1, 11) + below)
        upper = MeshQuad.init_tensor(np.linspace(-0.9, 0.9, 14), np.linspace(0, 1, 9) + 1 + below + between)
        count = lower.p.shape[1]
        mesh = MeshQuad(np.hstack([lower.p, upper.p]), np.hstack([lower.t, upper.t + count]))
        basis = Basis(mesh, ElementVector(ElementQuad1()))
        matrix = linear_elasticity(*lame_parameters(1e3, 0.3)).assemble(basis).tolil()
        for unknown in basis.nodal_dofs[:, :count].ravel():
            matrix[unknown, unknown] += 1e-4
        matrix = matrix.tocsr()
        contact = SkfemContact(basis, friction_coefficient=0.3)
        contact.contact.obstacles.add_half_space((0, 0), (0, 1))
        top = basis.nodal_dofs[:, mesh.p[1] > mesh.p[1].max() - 1e-6]
        end = np.zeros(basis.N)
        end[top[1]] = -below - between - 0.05
        free = np.setdiff1d(np.arange(basis.N), top.ravel())
        found = find_equilibrium(lambda u: (matrix @ u, matrix), contact, np.zeros(basis.N), free, end, max_iterations=300)
        right, is_lower = mesh.p[0] > 1e-9, np.arange(mesh.p.shape[1]) < count
        return np.array([found.result.forces[right & is_lower, 0].sum(), found.result.forces[right & ~is_lower, 0].sum()])

    touching, found = spread(0.0, 0.0), spread(*gaps)
    assert np.abs(found - touching).max() < 2e-3 * np.abs(touching).max(), (found, touching)


def test_a_rigid_tool_that_comes_over_a_gap():
    """A ball that is moved over a gap and pressed in, beside one that is pressed in from the first touch."""

    def pressed_in(gap):
        edges = np.r_[0, np.cumsum(0.08 * 1.15 ** np.arange(20))]
        mesh = MeshQuad.init_tensor(edges, -edges[::-1])
        basis = Basis(mesh, ElementVector(ElementQuad1()))
        matrix = linear_elasticity(*lame_parameters(1e3, 0.3)).assemble(basis)
        contact = SkfemContact(basis, friction_coefficient=0.3)
        ball = contact.contact.obstacles.add_ball(4.0, (0, 4.0 + gap))
        u = np.zeros(basis.N)
        contact.begin_step(u)
        contact.contact.obstacles.set_pose(ball, (0, 3.9))
        left, low = mesh.p[0] < 1e-9, mesh.p[1] < mesh.p[1].min() + 1e-9
        free = np.setdiff1d(np.arange(basis.N), np.r_[basis.nodal_dofs[:, low].ravel(), basis.nodal_dofs[0, left]])
        found = find_equilibrium(lambda u: (matrix @ u, matrix), contact, u, free)
        return found.result.obstacles[ball].friction[0]

    touching = pressed_in(0.0)
    for gap in (1e-6, 0.1, 2.0):
        assert abs(pressed_in(gap) / touching - 1) < ALIKE, gap


def test_the_same_step_again_gives_the_same():
    """Tried twice, with another load in between: nothing of the first attempt is left."""

    def attempts(ends):
        block = Block(0.1)
        free = np.setdiff1d(np.arange(block.basis.N), np.r_[block.top(0), block.top(1)])
        for down in ends:
            end = block.u.copy()
            end[block.top(1)] = -down
            found = find_equilibrium(lambda u: (block.matrix @ u, block.matrix), block.contact, block.u, free, end)
        return found

    once, after = attempts([0.15]), attempts([0.15, 0.12, 0.15])
    # Multipliers of the other load are left, and the contact is as near as its updates have it.
    assert np.abs(once.result.forces - after.result.forces).max() < 1e-2 * np.abs(once.result.forces).max()
    assert after.first_touches == 1


def test_a_refused_search_leaves_what_the_one_before_has_found():
    block = Block(0.1)
    free = np.setdiff1d(np.arange(block.basis.N), np.r_[block.top(0), block.top(1)])
    host = lambda u: (block.matrix @ u, block.matrix)
    end = block.u.copy()
    end[block.top(1)] = -0.15
    found = find_equilibrium(host, block.contact, block.u, free, end)
    end[block.top(0)] = 0.3
    with pytest.raises(NotConvergedError):
        find_equilibrium(host, block.contact, block.u, free, end, max_iterations=1)
    assert np.array_equal(block.contact.evaluate(found.x).forces, found.result.forces)


@pytest.mark.parametrize("gap", [0.05, 0.5])
def test_a_table_without_friction_on_the_way_to_a_wall_with_it(gap):
    """A block comes down on a table and goes on into a wall, in one step, and in three that end where it touches: it does not come to the wall
    through the table."""

    def pushed(*parts):
        block = Block(gap, 0.0)
        wall = block.contact.contact.obstacles.add_half_space((1.2, 0), (-1, 0))
        block.contact.contact.pairs.set(0, ("obstacle", wall), friction_coefficient=0.3)
        for part in parts:
            found = block.moved(0.205 * part, (gap + 0.02) * part)
        return found.result.obstacles[wall]

    one, steps = pushed(1.0), pushed(gap / (gap + 0.02), 0.2 / 0.205, 1.0)
    # Pressed by the table the block is another one at the wall than the tangent of the start says.
    assert abs(one.friction[1] - steps.friction[1]) < 0.05 * abs(steps.force[0])
