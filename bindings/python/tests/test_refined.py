"""Meshes that are refined in part: nodes hang in the middle of larger faces."""

import numpy as np
import pytest
from fmc_contact import Contact, errors

# A unit square: the left half of one cell, the right half of four; node 9 hangs in the middle of the edge between them.
COORDS = np.array(
    [[0, 0], [0.5, 0], [1, 0], [0, 1], [0.5, 1], [1, 1], [0.75, 0], [0.75, 0.5], [1, 0.5], [0.5, 0.5], [0.75, 1]], float
)
QUADS = [[0, 1, 4, 3], [1, 6, 7, 9], [6, 2, 8, 7], [9, 7, 10, 4], [7, 8, 5, 10]]
HANGING = 9


def two(shift):
    """The square, and above it a plain one that reaches into it."""
    above = np.array([[0.1, 0.9], [0.9, 0.9], [0.9, 1.5], [0.1, 1.5]]) + shift
    return np.concatenate([COORDS, above]), [*QUADS, [11, 12, 13, 14]]


@pytest.mark.parametrize("law", ["volume", "fiber", "depth"])
def test_the_body_stays_whole(law):
    coords, cells = two([0.0, 0.0])
    contact = Contact(coords, cells, "quad", stiffness=1e3, law=law, estimator="exact")
    # Three edges below and above, two on the right, one on the left, and four of the other body.
    assert (contact.body_count, contact.facet_count) == (2, 3 + 3 + 2 + 1 + 4)
    result = contact.evaluate(coords)
    corners = coords[[0, 2, 5, 3, 11, 12, 13, 14]]
    plain = Contact(corners, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=1e3, law=law, estimator="exact")
    expected = plain.evaluate(corners)
    assert abs(result.volume - expected.volume) < 1e-12
    np.testing.assert_array_equal(result.forces[HANGING], 0)


def test_what_hangs_is_where_its_parents_put_it():
    coords, cells = two([0.0, -0.5])
    contact = Contact(coords, cells, "quad", stiffness=1e3)
    expected = contact.evaluate(coords).forces
    moved = coords.copy()
    moved[HANGING] += [0.01, -0.02]
    np.testing.assert_array_equal(contact.evaluate(moved).forces, expected)
    np.testing.assert_allclose(contact.mesh.point_weights().to_points(moved)[HANGING], [0.5, 0.5])


def test_a_node_beside_the_middle_is_refused():
    coords, cells = two([0.0, 0.0])
    coords[HANGING] += [1e-4, 0]
    with pytest.raises(errors.NonConformingError, match="cells 0 and"):
        Contact(coords, cells, "quad", stiffness=1e3)
