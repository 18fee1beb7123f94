"""Straight faces that stand for round surfaces, set on the adapter."""

import numpy as np
import pytest
from fmc_contact.errors import NotPositiveError
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementQuad1, ElementVector, MeshQuad


def sector(inner, outer, count):
    """A third of a ring around the origin."""
    mesh = MeshQuad.init_tensor(np.linspace(inner, outer, 3), np.linspace(0, 2 * np.pi / 3, count + 1))
    radius, angle = mesh.p
    return MeshQuad(radius * np.stack([np.cos(angle), np.sin(angle)]), mesh.t)


def rings():
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in (sector(0.5, 1.001, 11), sector(1.0, 1.5, 14))]
    return SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=1e3)


def test_the_adapter_hands_it_on():
    adapter, by_hand = rings(), rings()
    u = np.zeros(adapter.size)
    straight = adapter.force(u)
    assert "curved_faces" in [warning.kind for warning in adapter.evaluate(u).warnings]
    adapter.set_surface_smoothing(30.0)
    by_hand.contact.mesh.set_surface_smoothing(30.0)
    assert np.array_equal(adapter.force(u), by_hand.force(u)) and not np.array_equal(adapter.force(u), straight)
    assert not {"curved_faces", "coarse_faces"} & {warning.kind for warning in adapter.evaluate(u).warnings}
    adapter.set_surface_smoothing(0.0)
    assert np.array_equal(adapter.force(u), straight)
    with pytest.raises(NotPositiveError, match="feature_angle"):
        adapter.set_surface_smoothing(90.0)
