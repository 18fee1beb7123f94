"""Wedges and pyramids, alone and beside other cells."""

import numpy as np
import pytest
from fmc_contact import Contact, contact_force, errors

K = 1e3
CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def block(kind, low):
    """A unit cube at this height, 0.8 wide in x, and its cells."""
    x = np.vstack([CUBE, [0.5, 0.5, 0.5]]) * [0.8, 1.0, 1.0] + [0.1, 0.0, low]
    pyramids = [[*face[::-1], 8] for face in FACES]
    cells = {
        "hexahedron": [("hexahedron", [list(range(8))])],
        "wedge": [("wedge", [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]])],
        # As VTK defines them.
        "mirrored": [("wedge", [[0, 2, 1, 4, 6, 5], [0, 3, 2, 4, 7, 6]])],
        "pyramid": [("pyramid", pyramids)],
        "mixed": [("pyramid", pyramids[:1] + pyramids[2:]), ("tetra", [[4, 6, 5, 8], [4, 7, 6, 8]])],
    }[kind]
    return x, cells


@pytest.mark.parametrize("kind", ["wedge", "mirrored", "pyramid", "mixed"])
@pytest.mark.parametrize("other", ["hexahedron", "wedge", "pyramid"])
def test_slab_between_two_blocks(kind, other):
    x, cells = block(kind, 0.9)
    y, more = block(other, 0.0)
    y[:, 0] += 0.05
    blocks = cells + [(name, (np.array(nodes) + len(x)).tolist()) for name, nodes in more]
    result = contact_force(np.vstack([x, y]), blocks, stiffness=K, law="volume", estimator="exact")
    # Overlap 0.75 x 1 x 0.1.
    assert result.volume == pytest.approx(0.075, rel=1e-12) and len(result.bodies) == 2
    assert np.abs(result.bodies[0].force[2]) == pytest.approx(0.75 * K, rel=1e-12)


def test_names_and_widths():
    x, _cells = block("wedge", 0.0)
    with pytest.raises(errors.UnknownCellTypeError, match="wedge, pyramid"):
        Contact(x, [[0, 1, 2, 4, 5, 6]], "prism", stiffness=K)
    with pytest.raises(ValueError):
        Contact(x, [[0, 1, 2, 4, 5]], "wedge", stiffness=K)
    # The second triangle the other way round.
    twisted = [[0, 1, 2, 4, 6, 5]]
    with pytest.raises((errors.InvertedCellError, errors.ZeroMeasureError)):
        Contact(x, twisted, "wedge", stiffness=K)
