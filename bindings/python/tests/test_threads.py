"""Threads, and how long things live."""

import gc
import subprocess
import sys
import threading
import weakref

import numpy as np
import pytest
from fmc_contact import Contact, _handle
from fmc_contact.errors import BusyError
from scenes import K, same_bits

OPTIONS = {"stiffness": K, "law": "volume"}


def plane(points):
    return points[:, 1] + 100, np.tile([0.0, 1.0], (len(points), 1))


def test_a_second_thread_is_told_that_the_contact_is_busy(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    entered, leave = threading.Event(), threading.Event()

    def wait(points):
        entered.set()
        assert leave.wait(60)
        return plane(points)

    contact.obstacles.add_signed_distance(wait)
    results = []
    thread = threading.Thread(target=lambda: results.append(contact.evaluate(coords)))
    thread.start()
    # Reached at all only because Python runs on during the evaluation of the other thread.
    assert entered.wait(60)
    try:
        for call in (
            lambda: contact.evaluate(coords),
            lambda: contact.tangent(coords),
            lambda: contact.set_options(stiffness=1),
            lambda: contact.obstacles.add_ball(1),
            lambda: contact.obstacles.set_pose(0, None),
            lambda: contact.patches.keep(coords),
        ):
            with pytest.raises(BusyError, match="in use by another call"):
                call()
    finally:
        leave.set()
        thread.join(60)
    assert contact.options["stiffness"] == K and same_bits(contact.evaluate(coords).forces, results[0].forces)


def test_a_function_that_calls_back_in_is_told_so(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    contact.obstacles.add_signed_distance(lambda points: contact.evaluate(coords))
    with pytest.raises(BusyError):
        contact.evaluate(coords)


def test_contacts_of_their_own_run_side_by_side(squares):
    coords, conn = squares
    expected = Contact(coords, conn, "quad", **OPTIONS).evaluate(coords).forces
    same = []

    def work():
        contact = Contact(coords, conn, "quad", **OPTIONS)
        same.append(all(same_bits(contact.evaluate(coords).forces, expected) for _ in range(20)))

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert same == [True] * 8


def test_a_context_is_freed_with_its_contact(squares, monkeypatch):
    coords, conn = squares
    freed = []
    free = _handle._free
    monkeypatch.setattr(_handle, "_free", lambda pointer: (freed.append(pointer.value), free(pointer)))
    contact = Contact(coords, conn, "quad", **OPTIONS)
    # A function that refers to its own contact makes a circle.
    contact.obstacles.add_signed_distance(lambda points: plane(points) if contact else None)  # noqa: F821
    contact.evaluate(coords)
    pointer, alive = contact._core.handle.pointer.value, weakref.ref(contact)
    del contact
    gc.collect()
    assert alive() is None and freed == [pointer]


def test_functions_live_as_long_as_their_contact(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    function = lambda points: plane(points)
    contact.obstacles.add_signed_distance(function)
    contact.set_log(lambda text: None)
    del function
    gc.collect()
    assert contact.evaluate(coords).obstacles[0].force == pytest.approx([0, 0])


def test_a_program_may_end_during_an_evaluation():
    program = """
import threading, time
from fmc_contact import Contact
entered = threading.Event()
def slow(points):
    entered.set()
    time.sleep(60)
contact = Contact([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], "triangle", stiffness=1.0, law="volume")
contact.obstacles.add_signed_distance(slow)
threading.Thread(target=contact.evaluate, args=([[0, 0], [1, 0], [0, 1]],), daemon=True).start()
assert entered.wait(30)
"""
    assert subprocess.run([sys.executable, "-c", program], timeout=50).returncode == 0


def test_nothing_grows_with_the_number_of_evaluations(squares):
    resource = pytest.importorskip("resource")
    coords, conn = squares
    contact = Contact(coords, conn, "quad", **OPTIONS)
    contact.obstacles.add_signed_distance(plane)

    def work(count):
        for _ in range(count):
            contact.evaluate(coords + np.random.default_rng(0).random() * 1e-3)
            Contact(coords, conn, "quad", **OPTIONS)
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    work(100)
    before = work(1)
    # In KiB; a leaked context, with its trees and arrays, is some KiB.
    assert work(500) - before < 2048
