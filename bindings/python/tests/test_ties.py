"""Tied bodies: options, results and refusals."""

import numpy as np
import pytest
from fmc_contact import Contact, errors
from test_ranks import arrays, on_ranks

COORDS = np.array([[0, 0], [2, 0], [2, 1], [0, 1], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]], float)
CONN = [[0, 1, 2, 3], [4, 5, 8, 7], [5, 6, 9, 8]]


def squares(gap=0.0):
    coords = COORDS + np.where(np.arange(10)[:, None] < 4, 0.0, [0.0, gap])
    return Contact(coords, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3), coords


def test_options_come_back_and_are_released():
    contact, coords = squares()
    assert contact.pairs.options(0, 1)["interface"] == "contact"
    contact.pairs.set(0, 1, interface="tied", reach=0.05)
    options = contact.pairs.options(1, 0)
    assert (options["interface"], options["reach"]) == ("tied", 0.05)
    tie = contact.pairs.tie(1, 0)
    assert (tie.area, tie.largest_gap, tie.node_count) == (pytest.approx(2.0), 0.0, 2)
    contact.pairs.reset(0, 1)
    assert contact.pairs.tie(0, 1).area == 0 and len(contact.tie_nodes(coords)) == 0


@pytest.mark.parametrize("index_base", [0, 1])
def test_what_is_pulled_off_is_held(index_base):
    coords, conn = COORDS, np.array(CONN) + index_base
    contact = Contact(coords, conn, "quad", bodies=[0, 1, 1], stiffness=1e3, index_base=index_base)
    contact.pairs.set(0, 1, interface="tied")
    moved = coords + np.where(np.arange(10)[:, None] < 4, 0.0, [1e-3, 2e-3])
    result = contact.evaluate(moved)
    # k times the jump times the length, by the mean of it at the nodes of an edge of length 2.
    assert result.bodies[0].force == pytest.approx([2.0, 4.0])
    assert result.energy == pytest.approx(0.5 * 1e3 * (1e-6 + 4e-6) * 2)
    nodes = contact.tie_nodes(moved)
    assert list(nodes.node) == [2 + index_base, 3 + index_base] and set(nodes.body) == {0} and set(nodes.partner) == {1}
    assert nodes.traction == pytest.approx(np.tile([1.0, 2.0], (2, 1))) and nodes.jump == pytest.approx(-nodes.traction / 1e3)
    rows = contact.tie_constraints()
    matrix = np.zeros((len(rows), 20))
    for row in range(len(rows)):
        own = slice(rows.indptr[row], rows.indptr[row + 1])
        matrix[row, rows.indices[own]] = rows.data[own]
    assert matrix @ coords.ravel() == pytest.approx(0, abs=1e-13)
    assert (matrix @ moved.ravel()).reshape(-1, 2) == pytest.approx(nodes.jump)


def test_refusals():
    contact, _ = squares(gap=0.3)
    with pytest.raises(errors.UntiedError, match="bodies 0 and 1 .* within 1.0000e-1: the nearest faces are 3.0000e-1 apart"):
        contact.pairs.set(0, 1, interface="tied", reach=0.1)
    with pytest.raises(errors.OptionsConflictError, match="'reach'"):
        contact.pairs.set(0, 1, reach=0.1)
    with pytest.raises(ValueError, match="no value 'glued'"):
        contact.pairs.set(0, 1, interface="glued")
    with pytest.raises(errors.NotPositiveError, match="reach"):
        contact.pairs.set(0, 1, interface="tied", reach=-1.0)
    floor = contact.obstacles.add_half_space((0, 0), (0, 1))
    with pytest.raises(errors.UnsupportedError, match="tied to an obstacle"):
        contact.pairs.set(0, ("obstacle", floor), interface="tied")
    contact.pairs.set(0, 1, interface="tied", reach=0.4)
    assert contact.pairs.tie(0, 1).largest_gap == pytest.approx(0.3)
    with pytest.raises(errors.UnsupportedError, match="keeps a gap"):
        contact.tie_constraints()


@pytest.mark.parametrize("size", [2, 3])
def test_every_rank_has_the_bits_of_one(size):
    # Three bodies: two are tied, the third presses on them.
    coords = np.vstack([COORDS, [[0.2, 1.95], [1.8, 1.95], [1.8, 2.5], [0.2, 2.5]]])
    conn = np.array([*CONN, [10, 11, 12, 13]])
    moved = coords + np.where((np.arange(14)[:, None] < 4) | (np.arange(14)[:, None] > 9), 0.0, [1e-3, 2e-3])

    def found(comm=None):
        contact = Contact(coords, conn, "quad", bodies=[0, 1, 1, 2], stiffness=1e3)
        if comm is not None:
            contact.ranks.set_communicator(comm)
        contact.pairs.set(0, 1, interface="tied")
        result, matrix = contact.evaluate_tangent(moved)
        return result.forces, result.energy, *arrays(matrix)

    alone = found()
    assert np.abs(alone[0][:4]).max() > 0 and np.abs(alone[0][10:]).max() > 0
    for of_rank in on_ranks(size, found):
        assert all(np.array_equal(one, other) for one, other in zip(of_rank, alone)), of_rank
