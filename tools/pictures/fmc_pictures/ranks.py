"""A mesh divided among four ranks: the cells of each, and the cells near the contact, which all of them have."""

import threading

import numpy as np
from fmc_contact import PartitionedContact

from .bodies import grid, together
from .drawing import FOURTH, LOWER, THIRD, UPPER, Frame, Picture

COLOURS = (LOWER, UPPER, THIRD, FOURTH)


class Rank:
    """A communicator among threads, with the one call that the library needs."""

    def __init__(self, rank, sent, barrier):
        self.rank, self.size, self.sent, self.barrier = rank, len(sent), sent, barrier

    def Allgatherv(self, sendbuf, recvbuf):
        received, (counts, starts) = recvbuf
        self.sent[self.rank] = bytes(sendbuf)
        self.barrier.wait()
        for sent, count, start in zip(self.sent, counts, starts):
            received[start : start + count] = np.frombuffer(sent, np.uint8)
        self.barrier.wait()


def on_ranks(size, work):
    """What ``work(rank)`` returns on each."""
    sent, barrier, found = [b""] * size, threading.Barrier(size, timeout=60), [None] * size

    def run(rank):
        found[rank] = work(Rank(rank, sent, barrier))

    threads = [threading.Thread(target=run, args=(rank,)) for rank in range(size)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    return found


def picture():
    lower, upper = grid((20, 8), (-1.2, 1.2), (-0.96, 0)), grid((7, 6), (-0.46, 0.46), (-0.02, 0.72))
    # Every rank has one cell of each body, the first: here it is near the contact.
    lower = (lower[0], lower[1][np.argsort(np.linalg.norm(lower[0][lower[1]].mean(axis=1), axis=1))])
    coords, cells, firsts = together(lower, upper)
    owner = np.clip(((coords[cells].mean(axis=1)[:, 0] + 1.2) / 0.6).astype(int), 0, 3)

    def work(comm):
        own = np.flatnonzero(owner == comm.rank)
        numbers, local = np.unique(cells[own], return_inverse=True)
        names = {"node_numbers": numbers, "cell_numbers": own, "bodies": (cells[own, 0] >= firsts[1]).astype(np.int32)}
        return PartitionedContact(comm, coords[numbers], local.reshape(-1, 4), "quad", stiffness=1.0, **names).gathered_cells()

    near, *_ = on_ranks(4, work)
    made = Picture(310, "A mesh on four ranks, and the cells that one of them holds")
    scenes = [Frame(made, (left, 40, 340, 236), (-1.25, 1.25), (-1.0, 0.72), equal=True) for left in (10, 370)]
    made.text((180, 22), "each cell belongs to one rank")
    for rank, colour in enumerate(COLOURS):
        scenes[0].mesh(coords, cells[owner == rank], colour)
        scenes[0].text((-0.9 + 0.6 * rank, -0.7), f"rank {rank}")
    made.text((540, 22), "cells that rank 1 holds")
    scenes[1].shapes(coords[cells], "none", "#ddd")
    scenes[1].mesh(coords, cells[owner == 1], COLOURS[1])
    scenes[1].mesh(coords, cells[near], "#555", 0.6)
    made.key((374, 298), COLOURS[1], "its own")
    made.key((464, 298), "#888", "near the contact, on all ranks")
    return made
