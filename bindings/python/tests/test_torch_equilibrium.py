"""An equilibrium within a PyTorch program against differences: bodies of PyTorch, a contact of the library."""

import numpy as np
import pytest
from fmc_contact import Contact
from scenes import grid

torch = pytest.importorskip("torch", reason="torch is not installed")
pytest.importorskip("scipy.sparse")

from elastic import stiffness  # noqa: E402
from fmc_contact.torch import equilibrium  # noqa: E402

COORDS, QUADS = grid((4, 3), (0, 1), (0, 0.8))
FIRST = COORDS + 0.01 * np.random.default_rng(3).uniform(-1, 1, COORDS.shape)
TOP = np.flatnonzero(COORDS[:, 1] == 0.8)
FREE = np.setdiff1d(np.arange(FIRST.size), np.concatenate([2 * TOP, 2 * TOP + 1]))
MATRIX = torch.tensor(stiffness(FIRST, QUADS, 1.0).toarray())


def residual(x, parameters):
    moved = (x - torch.tensor(FIRST)).ravel()
    # Stiffer as it moves, so that the matrix is another one at every state.
    return (parameters["young"] * (MATRIX @ moved) * (1 + moved**2).sum()).reshape(x.shape) - parameters["load"]


def pressed(penetration):
    contact = Contact(FIRST, QUADS, "quad", stiffness=2000.0)
    contact.obstacles.add_half_space((0.0, 0.0), (0.1, 1.0))
    return equilibrium(contact, residual, FREE, penetration=penetration, tolerance=1e-13, max_updates=60)


@pytest.mark.parametrize("penetration", [None, 1e-12], ids=["law", "multipliers"])
def test_by_parameters_supports_and_obstacles(penetration):
    of, random = pressed(penetration), np.random.default_rng(1)
    factors = torch.tensor(random.standard_normal(FIRST.shape))
    end = FIRST.copy()
    end[TOP] -= [0.0, 0.04]
    values = (np.array(100.0), np.zeros(FIRST.shape), end, FIRST, np.zeros((1, 2)))
    directions = [random.uniform(-1, 1, np.shape(value)) for value in values]

    def value(*tensors):
        young, load, prescribed, reference, positions = tensors
        return (factors * of({"young": young, "load": load}, torch.tensor(FIRST), prescribed, reference, positions)).sum()

    leaves = [torch.tensor(one, requires_grad=True) for one in values]
    value(*leaves).backward()
    ends = [float(value(*(torch.tensor(v + by * d) for v, d in zip(values, directions)))) for by in (1e-6, -1e-6)]
    along = sum(float((leaf.grad.numpy() * d).sum()) for leaf, d in zip(leaves, directions))
    size = np.sqrt(sum(float((leaf.grad**2).sum()) for leaf in leaves))
    assert abs(along - (ends[0] - ends[1]) / 2e-6) < 1e-6 * size
    assert all(float(abs(leaves[one].grad).max()) > 0 for one in (0, 1, 2, 4))


def test_other_numbers_are_refused():
    with pytest.raises(TypeError, match=r"x has dtype torch\.float32 on cpu, expected torch\.float64"):
        pressed(None)({}, torch.tensor(FIRST, dtype=torch.float32))
