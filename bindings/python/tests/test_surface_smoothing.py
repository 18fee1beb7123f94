"""Straight faces that stand for round surfaces."""

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.errors import NotPositiveError


def ring(inner, outer, count, first):
    """Two layers of quadrilaterals around the origin."""
    angle = 2 * np.pi * np.arange(count) / count
    circle = np.stack([np.cos(angle), np.sin(angle)], 1)
    coords = np.concatenate([radius * circle for radius in np.linspace(inner, outer, 3)])
    around = (np.arange(count) + 1) % count
    rows = [np.stack([k * count + np.arange(count), (k + 1) * count + np.arange(count)], 1) for k in range(2)]
    cells = [np.stack([r[:, 0], r[:, 1], r[around, 1], r[around, 0]], 1) for r in rows]
    return coords, first + np.concatenate(cells)


def rings(overlap):
    a, cells_a = ring(0.5, 1 + overlap, 32, 0)
    b, cells_b = ring(1.0, 1.5, 44, len(a))
    return np.concatenate([a, b]), np.concatenate([cells_a, cells_b]), len(a)


def test_rings_that_overlap_everywhere():
    """The force by k times the overlap and the circle, though facets of length h lie up to h²/8 beside it, five times the overlap."""
    overlap = 1e-3
    coords, cells, count = rings(overlap)
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    contact.mesh.set_symmetry_planes([])

    def force():
        result = contact.evaluate(coords)
        outwards = coords[:count] / np.linalg.norm(coords[:count], axis=1)[:, None]
        return -(result.forces[:count] * outwards).sum() / (2 * np.pi * overlap), [w.kind for w in result.warnings]

    straight, told = force()
    assert told == ["curved_faces"] and abs(straight - 1) > 0.2
    contact.mesh.set_surface_smoothing(30.0)
    smoothed, told = force()
    assert not told
    # The chords are shorter than the arcs, by h²/24, and the facets are inclined: 1 %.
    assert abs(smoothed - 1) < 0.01
    contact.mesh.set_surface_smoothing(0.0)
    assert force()[0] == straight
    # Below the angle between facets nothing is smooth.
    contact.mesh.set_surface_smoothing(5.0)
    assert force()[0] == straight


@pytest.mark.parametrize("angle", [-1.0, 90.0, np.nan])
def test_what_is_no_angle_is_refused(angle):
    coords, cells, _ = rings(1e-3)
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    with pytest.raises(NotPositiveError, match="feature_angle"):
        contact.mesh.set_surface_smoothing(angle)
