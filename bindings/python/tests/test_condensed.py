"""What is expected to touch before anything does."""

import numpy as np
import pytest
from fmc_contact import Contact, condensed


def over_a_plane(count=20):
    """A strip of quadrilaterals whose bottom rises to the right, above a plane."""
    x, y = (a.ravel() for a in np.meshgrid(np.arange(count + 1.0), [0.0, 1.0], indexing="ij"))
    coords = np.stack([x, y + 0.01 + 0.02 * x], 1)
    cells = np.array([[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(count)])
    contact = Contact(coords, cells, cell_type="quad", stiffness=1.0)
    contact.obstacles.add_half_space([0, 0], [0, 1])
    return contact, coords


@pytest.mark.parametrize("most", [8, 1500])
def test_the_nearest_are_expected_where_they_are_too_many(monkeypatch, most):
    contact, coords = over_a_plane()
    monkeypatch.setattr(condensed, "MOST_EXPECTED", most)
    bodies = condensed.Condensed(contact, coords.size, np.arange(coords.size))
    moved = np.tile([0.0, -0.3], len(coords))
    bodies.expect(coords.ravel(), moved)
    nodes = np.unique(bodies.dofs // 2)
    # Mean gaps rise with x: those within the way lie left of 0.3 = 0.01 + 0.02 x, and the nearest at the left end.
    assert len(nodes) and (nodes % 2 == 0).all() and np.array_equal(nodes, np.arange(0, 2 * len(nodes), 2))
    assert len(bodies.dofs) == most if most == 8 else 20 <= len(bodies.dofs) <= 32
