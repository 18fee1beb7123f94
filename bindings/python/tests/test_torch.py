"""The operators for PyTorch against differences, by its own checks."""

import numpy as np
import pytest
from test_gradients import contact_of, plane, space

torch = pytest.importorskip("torch", reason="torch is not installed")

from fmc_contact.torch import energy, forces  # noqa: E402

SCENES = pytest.mark.parametrize("scene", [plane, space])
DIFFERENCES = {"eps": 1e-6, "rtol": 1e-6, "atol": 1e-6}
"""``atol`` by derivatives of up to 30; rounding is 1e-9."""


def leaf(values):
    return torch.tensor(values, dtype=torch.float64, requires_grad=True)


@SCENES
def test_gradients_of_energy_and_forces(scene):
    reference, cells, coords = scene()
    contact = contact_of(reference, cells)
    values = (leaf(coords), leaf(reference), leaf(30.0))
    assert torch.autograd.gradcheck(energy(contact), values, fast_mode=True, **DIFFERENCES)
    assert torch.autograd.gradcheck(forces(contact), values, fast_mode=True, **DIFFERENCES)


@SCENES
def test_second_derivatives(scene):
    reference, cells, coords = scene()
    contact = contact_of(reference, cells)
    assert torch.autograd.gradgradcheck(energy(contact), (leaf(coords),), fast_mode=True, **DIFFERENCES)


def test_what_is_not_asked_for_is_not_computed():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells, axisymmetric=True)
    # By the undeformed coordinates there is no derivative with axisymmetry.
    at = leaf(coords + [2, 0])
    energy(contact)(at).backward()
    assert np.array_equal(at.grad.numpy(), -contact.evaluate(at.detach().numpy()).forces)


def test_other_numbers_are_refused():
    reference, cells, coords = plane()
    with pytest.raises(TypeError, match=r"expected torch\.float64"):
        energy(contact_of(reference, cells))(torch.tensor(coords, dtype=torch.float32))
