"""The operators for JAX against differences, under the transformations of JAX."""

import numpy as np
import pytest
from test_gradients import contact_of, plane, space

jax = pytest.importorskip("jax", reason="jax is not installed")
jax.config.update("jax_enable_x64", True)

from fmc_contact.jax import energy, forces  # noqa: E402

SCENES = pytest.mark.parametrize("scene", [plane, space])


def slope(function, values, directions):
    """The central difference of a function of several arrays."""
    by = 1e-6
    up, down = (function(*(v + sign * by * d for v, d in zip(values, directions))) for sign in (1, -1))
    return (float(up) - float(down)) / (2 * by)


def close(gradients, directions, expected):
    along = sum(float((g * d).sum()) for g, d in zip(gradients, directions))
    size = np.sqrt(sum(float((g**2).sum()) for g in gradients))
    return abs(along - expected) < 1e-6 * size


@SCENES
def test_gradients_of_energy_and_forces(scene):
    reference, cells, coords = scene()
    contact = contact_of(reference, cells)
    random = np.random.default_rng(1)
    adjoint = random.uniform(-1, 1, coords.shape)
    values = (coords, reference, np.array(30.0))
    directions = [random.uniform(-1, 1, np.shape(value)) for value in values]
    w, f = energy(contact), forces(contact)
    for function in (w, lambda *values: (adjoint * f(*values)).sum()):
        found = jax.jit(jax.grad(function, argnums=(0, 1, 2)))(*values)
        assert close(found, directions, slope(function, values, directions))


def test_second_derivatives_and_batches():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells)
    w = energy(contact)
    hessian = np.asarray(jax.jacrev(jax.grad(w))(coords)).reshape(coords.size, -1)
    assert np.abs(hessian - contact.tangent(coords).toarray()).max() < 1e-9 * np.abs(hessian).max()
    batch = np.stack([coords, coords - 0.01])
    assert np.allclose(jax.vmap(w)(batch), [w(x) for x in batch], rtol=1e-12)


def test_other_numbers_are_refused():
    reference, cells, coords = plane()
    with pytest.raises(TypeError, match="expected float64"):
        energy(contact_of(reference, cells))(coords.astype(np.float32))
