"""An equilibrium within a JAX program against differences: bodies of JAX, a contact of the library."""

import numpy as np
import pytest
from fmc_contact import Contact
from scenes import grid

jax = pytest.importorskip("jax", reason="jax is not installed")
jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp  # noqa: E402
from fmc_contact.jax import equilibrium  # noqa: E402

WITHIN = 1e-6
"""Of a derivative by the size of the gradient."""

COORDS, QUADS = grid((4, 3), (0, 1), (0, 0.8))
FIRST = COORDS + 0.01 * np.random.default_rng(3).uniform(-1, 1, COORDS.shape)
TOP = np.flatnonzero(COORDS[:, 1] == 0.8)
HELD = np.concatenate([2 * TOP, 2 * TOP + 1])
FREE = np.setdiff1d(np.arange(FIRST.size), HELD)


def det(matrices):
    return matrices[:, 0, 0] * matrices[:, 1, 1] - matrices[:, 0, 1] * matrices[:, 1, 0]


def energy(x, parameters):
    """Neo-Hookean squares with one point each, and springs against hourglasses."""
    slopes = np.array([[-1, 1, 1, -1], [-1, -1, 1, 1]]) / 4
    before, after = (jnp.einsum("ia,qaj->qij", slopes, nodes[QUADS]) for nodes in (parameters["first"], x))
    adjugate = jnp.stack([before[:, 1, 1], -before[:, 0, 1], -before[:, 1, 0], before[:, 0, 0]], 1).reshape(-1, 2, 2)
    stretch = jnp.einsum("qij,qjk->qik", adjugate, after) / det(before)[:, None, None]
    volume = jnp.log(det(after) / det(before))
    density = (stretch**2).sum((1, 2)) / 2 - 1 - volume + volume**2
    hourglass = jnp.einsum("a,qai->qi", np.array([1.0, -1.0, 1.0, -1.0]), (x - parameters["first"])[QUADS])
    return parameters["young"] * (4 * (det(before) * density).sum() + (hourglass**2).sum())


residual = jax.jit(jax.grad(energy))


def pressed(penetration):
    contact = Contact(FIRST, QUADS, "quad", stiffness=2000.0)
    contact.obstacles.add_half_space((0.0, 0.0), (0.1, 1.0))
    contact.obstacles.add_ball(0.3, (0.35, -0.25))
    return equilibrium(contact, residual, FREE, penetration=penetration, tolerance=1e-13, max_updates=60)


def slope(function, values, directions, step=1e-6):
    ends = [
        float(function(*jax.tree_util.tree_map(lambda v, d, by=by: v + by * d, values, directions))) for by in (step, -step)
    ]
    return (ends[0] - ends[1]) / (2 * step)


@pytest.mark.parametrize("penetration", [None, 1e-12], ids=["law", "multipliers"])
def test_by_parameters_supports_and_obstacles(penetration):
    of, random = pressed(penetration), np.random.default_rng(1)
    factors = random.standard_normal(FIRST.shape)
    prescribed = FIRST.copy()
    prescribed[TOP] -= [0.0, 0.04]
    values = ({"first": FIRST, "young": np.array(100.0)}, prescribed, FIRST, np.array([[0.0, 0.0], [0.35, -0.25]]))
    directions = jax.tree_util.tree_map(lambda value: random.uniform(-1, 1, np.shape(value)), values)

    def value(parameters, prescribed, reference, positions):
        x = of(parameters, FIRST, prescribed, reference, positions)
        return (factors * x).sum() + residual(x, parameters)[TOP, 1].sum()

    found = jax.grad(value, argnums=(0, 1, 2, 3))(*values)
    size = np.sqrt(sum(float((leaf**2).sum()) for leaf in jax.tree_util.tree_leaves(found)))
    along = sum(float((leaf * d).sum()) for leaf, d in zip(*map(jax.tree_util.tree_leaves, (found, directions))))
    assert abs(along - slope(value, values, directions)) < WITHIN * size
    assert all(float(abs(leaf).max()) > 0 for leaf in jax.tree_util.tree_leaves((found[0], found[1], found[3])))


def test_the_backward_pass_knows_its_own_equilibrium():
    """Two equilibria of one contact, and their derivatives after both."""
    of = pressed(1e-12)
    ends = [FIRST - (np.isin(np.arange(len(FIRST)), TOP)[:, None] * [0.0, by]) for by in (0.03, 0.05)]
    parameters = {"first": FIRST, "young": np.array(100.0)}

    def sums(young, number):
        return of({**parameters, "young": young}, ends[number])[:, 0].sum()

    alone = [jax.grad(sums)(100.0, number) for number in (0, 1)]
    both = jax.grad(lambda young: sums(young, 0) + sums(young, 1))(100.0)
    assert float(both) == pytest.approx(float(alone[0] + alone[1]), rel=1e-6)


def test_wrong_uses_are_told():
    of, parameters = pressed(None), {"first": FIRST, "young": np.array(100.0)}
    with pytest.raises(TypeError, match="outside of jit and vmap"):
        jax.jit(lambda x: of(parameters, x))(FIRST)
    with pytest.raises(TypeError, match="x has dtype float32"):
        of(parameters, FIRST.astype(np.float32))
    with pytest.raises(ValueError, match=r"positions has shape \(1, 2\), expected \(2, 2\)"):
        of(parameters, FIRST, positions=np.zeros((1, 2)))
