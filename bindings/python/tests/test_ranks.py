"""Ranks that share the work of a contact; here they are threads."""

import threading

import fmc_contact
import numpy as np
import pytest


class Meeting:
    """What the ranks have in common."""

    def __init__(self, size):
        self.sent = [b""] * size
        self.barrier = threading.Barrier(size, timeout=60)


class Rank:
    """One of them, as mpi4py has them."""

    def __init__(self, meeting, rank):
        self.meeting, self.rank, self.size = meeting, rank, len(meeting.sent)

    def Allgatherv(self, sendbuf, recvbuf):
        received, (counts, displacements) = recvbuf
        self.meeting.sent[self.rank] = bytes(sendbuf)
        self.meeting.barrier.wait()
        for sent, count, at in zip(self.meeting.sent, counts, displacements):
            assert len(sent) == count
            received[at : at + count] = np.frombuffer(sent, np.uint8)
        self.meeting.barrier.wait()


class SendingRank(Rank):
    """One that sends to single others too."""

    def Alltoallv(self, sendbuf, recvbuf):
        sent, (counts, displacements) = sendbuf
        self.meeting.sent[self.rank] = [bytes(sent[at : at + count]) for count, at in zip(counts, displacements)]
        self.meeting.barrier.wait()
        received, (counts, displacements) = recvbuf
        for lists, count, at in zip(self.meeting.sent, counts, displacements):
            assert len(lists[self.rank]) == count
            received[at : at + count] = np.frombuffer(lists[self.rank], np.uint8)
        self.meeting.barrier.wait()


def on_ranks(size, work, kind=Rank):
    """What ``work(rank)`` returns or raises on every rank."""
    meeting, found = Meeting(size), [None] * size

    def run(rank):
        try:
            found[rank] = work(kind(meeting, rank))
        except Exception as error:
            found[rank] = error

    threads = [threading.Thread(target=run, args=(rank,)) for rank in range(size)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(120)
    return found


def contact_of(blocks, **options):
    coords, conn = blocks
    return fmc_contact.Contact(coords, conn, "quad", stiffness=30.0, **options)


def arrays(matrix):
    """Of a tangent: row pointers, columns, values; without SciPy it is these already."""
    return matrix if isinstance(matrix, tuple) else (matrix.indptr, matrix.indices, matrix.data)


@pytest.mark.parametrize("law", ["fiber", "depth", "volume"])
def test_every_rank_has_the_bits_of_one(blocks, law):
    alone, matrix = contact_of(blocks, law=law).evaluate_tangent(blocks[0])

    def work(comm):
        contact = contact_of(blocks, law=law)
        contact.ranks.set_communicator(comm)
        return *contact.evaluate_tangent(blocks[0]), contact.ranks.counts()

    for found, shared, counts in on_ranks(3, work):
        assert np.array_equal(found.forces, alone.forces) and found.energy == alone.energy
        assert all(map(np.array_equal, arrays(shared), arrays(matrix)))
        # The exact volume clips few facets here: those near the ends of the contact.
        assert counts.own_item_count < counts.item_count or law == "volume"
        assert counts.received_bytes >= counts.sent_bytes


def test_one_error_is_told_on_all(blocks):
    coords = blocks[0]

    def work(comm):
        contact = contact_of(blocks)
        contact.ranks.set_communicator(comm)
        wrong = coords.copy()
        if comm.rank == 1:
            wrong[7, 1] = np.nan
        contact.evaluate(wrong)

    kinds = [type(error) for error in on_ranks(2, work)]
    assert kinds == [fmc_contact.errors.OnOtherRankError, fmc_contact.errors.NonFiniteCoordinateError]
    shifted = on_ranks(2, lambda comm: shared(comm, blocks).evaluate(coords + 1e-9 * comm.rank))
    assert all(isinstance(error, fmc_contact.errors.RanksDifferError) for error in shifted)


SQUARES = (
    np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.2, 0.95], [0.8, 0.95], [0.8, 2], [0.2, 2]]),
    np.array([[0, 1, 2, 3], [4, 5, 6, 7]]),
)


@pytest.mark.parametrize("what", ["contact", "host"])
@pytest.mark.parametrize("two_level", [None, False])
def test_an_error_on_one_rank_ends_a_search_on_all(what, two_level):
    """Whenever it comes: where others took it for a state that cannot be, they would go on with a shorter step, alone."""
    coords = SQUARES[0]

    def search(comm, fails_at):
        contact, calls = shared(comm, SQUARES), 0

        def count():
            nonlocal calls
            calls += 1
            if comm.rank == 1 and calls == fails_at:
                raise ZeroDivisionError("of one rank")

        def distance(points):
            if what == "contact":
                count()
            return points[:, 1] + 10.0, np.tile([0.0, 1.0], (len(points), 1))

        def host(x):
            if what == "host":
                count()
            return 100.0 * (x - coords).ravel(), 100.0 * np.eye(coords.size)

        contact.obstacles.add_signed_distance(distance)
        fmc_contact.find_equilibrium(host, contact, coords, range(coords.size), two_level=two_level)
        return calls

    (_, calls) = on_ranks(2, lambda comm: search(comm, 0))
    assert calls > 1
    for at in range(1, calls + 1):
        kinds = [type(error) for error in on_ranks(2, lambda comm: search(comm, at))]
        assert kinds == [fmc_contact.errors.OnOtherRankError, ZeroDivisionError], at


def test_a_state_that_one_rank_refuses_is_refused_on_all():
    coords, stiffness = SQUARES[0], 100.0 * np.eye(SQUARES[0].size)

    def search(comm, refuses):
        states = []

        def host(x):
            states.append(x)
            if refuses and comm.rank == 1 and len(states) == 2:
                raise fmc_contact.errors.InvertedCellError("cell 0")
            return 100.0 * (x - coords).ravel(), stiffness

        contact = shared(comm, SQUARES)
        return fmc_contact.find_equilibrium(host, contact, coords, range(coords.size), two_level=False).x

    plain, _ = on_ranks(2, lambda comm: search(comm, False))
    one, other = on_ranks(2, lambda comm: search(comm, True))
    assert np.array_equal(one, other) and np.abs(one - plain).max() < 1e-8


def shared(comm, blocks):
    contact = contact_of(blocks)
    contact.ranks.set_communicator(comm)
    return contact


def test_what_a_communicator_raises_comes_out(blocks):
    class Broken:
        rank, size = 0, 2

        def Allgatherv(self, sendbuf, recvbuf):
            raise ConnectionError("no other rank")

    contact = shared(Broken(), blocks)
    with pytest.raises(ConnectionError, match="no other rank"):
        contact.evaluate(blocks[0])
    contact.ranks.set_communicator(None)
    assert contact.evaluate(blocks[0]).energy > 0 and contact.ranks.counts().call_count == 0
    with pytest.raises(fmc_contact.errors.BadRankError, match="rank 2 of 2"):
        shared(type("Nobody", (Broken,), {"rank": 2})(), blocks)
