"""Named parts of surfaces that are tied, beside which the same bodies are in contact."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact
from fmc_contact.errors import BadValueError, OptionsConflictError, UnsupportedError

COORDS = np.array([[x, y] for y in (0, 1, 1, 2) for x in (0, 1, 2)], float)
CONN = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [6, 7, 10, 9], [7, 8, 11, 10]])


@pytest.fixture
def contact() -> Contact:
    """Two blocks, one on the other, of two cells each."""
    return Contact(COORDS, CONN, "quad", bodies=[0, 0, 1, 1], stiffness=1e3)


def left(contact: Contact) -> np.ndarray:
    middle = COORDS[contact.mesh.boundary_facets().nodes].mean(axis=1)
    return (middle[:, 1] == 1) & (middle[:, 0] < 1)


def test_the_tied_half_holds_and_the_other_presses(contact: Contact) -> None:
    by_mask = contact.mesh.add_surface(left(contact))
    by_number = contact.mesh.add_surface(np.flatnonzero(left(contact))[::-1])
    assert (by_mask, by_number) == (1, 2)
    contact.pairs.set(1, 0, interface="tied", surfaces=(by_mask, by_number), reach=0.05)
    assert contact.pairs.options(0, 1)["surfaces"] == (2, 1)
    assert contact.pairs.options(1, 0)["surfaces"] == (1, 2)
    tie = contact.pairs.tie(0, 1)
    assert (tie.area, tie.reach) == (1.0, 0.05)
    for lift, expected in ((1e-6, [-0.5, -0.5, 0.0]), (-1e-6, [0.5, 1.0, 0.5])):
        moved = COORDS.copy()
        moved[6:, 1] += lift
        forces = contact.evaluate(moved).forces[6:9, 1]
        # Corners of cells of size 1 at the rim differ by the penetration.
        assert forces == pytest.approx(1e-3 * np.array(expected), abs=1e-8)


def test_what_is_refused_changes_nothing(contact: Contact) -> None:
    surface = contact.mesh.add_surface(left(contact))
    far = contact.mesh.add_surface([0])
    contact.pairs.set(0, 1, interface="tied", surfaces=(surface, surface))
    before = contact.pairs.options(0, 1)
    for facets in ([0, 99], [-1]):
        with pytest.raises(BadValueError, match="of 'facets'"):
            contact.mesh.add_surface(facets)
    with pytest.raises(UnsupportedError, match="without facets"):
        contact.mesh.add_surface(np.zeros(12, bool))
    with pytest.raises(TypeError, match="'facets'"):
        contact.mesh.add_surface([0.5])
    # Marks of another mesh name other facets.
    for marks in (np.ones(11, bool), np.ones((12, 1), bool)):
        with pytest.raises(ValueError, match="there are 12 boundary facets"):
            contact.mesh.add_surface(marks)
    for wrong in (surface, (surface,), (surface, "left")):
        with pytest.raises(TypeError, match="expected two numbers of add_surface"):
            contact.pairs.set(0, 1, interface="tied", surfaces=wrong)
    with pytest.raises(ValueError, match="no such number"):
        contact.pairs.set(0, 1, interface="tied", surfaces=(surface, 2**32 + surface))
    with pytest.raises(BadValueError, match="entry 1 of 'surfaces' is 7"):
        contact.pairs.set(0, 1, interface="tied", surfaces=(surface, 7))
    with pytest.raises(OptionsConflictError, match="'surface_a'"):
        contact.pairs.set(0, 1, interface="tied", surfaces=(surface, 0))
    with pytest.raises(UnsupportedError, match="no facet of its body"):
        contact.pairs.set(0, 1, interface="tied", surfaces=(surface, far))
    with pytest.raises(UnsupportedError, match="that is not held together"):
        contact.pairs.set(0, 1, surfaces=(surface, surface))
    assert contact.pairs.options(0, 1) == before
