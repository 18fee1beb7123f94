"""Ctrl-C ends what takes long, and leaves the contact as it was."""

import os
import signal
import threading
import time

import numpy as np
import pytest
from fmc_contact import Contact, FmcError


def blocks(count):
    """Two blocks of count x count squares, one 0.1 deep in the other."""
    line = np.linspace(0.0, 1.0, count + 1)
    x, y = np.meshgrid(line, line)
    square = np.column_stack([x.ravel(), y.ravel()])
    corner = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    cells = np.column_stack([corner, corner + 1, corner + count + 2, corner + count + 1])
    coords = np.vstack([square, 0.9 * square + [0.03, 0.9]])
    return coords, np.vstack([cells, cells + len(square)])


@pytest.fixture
def on_ctrl_c():
    """Sets a handler, for a test. Without one a Python that a shell started in the background ignores Ctrl-C."""
    before = signal.getsignal(signal.SIGINT)
    yield lambda handler: signal.signal(signal.SIGINT, handler)
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("threads", [1, 3])
def test_ctrl_c_ends_a_long_call(threads, on_ctrl_c):
    on_ctrl_c(signal.default_int_handler)
    coords, cells = blocks(8)
    # Lines for seconds, or minutes.
    contact = Contact(coords, cells, "quad", stiffness=1.0, law="volume", estimator="fibers", spacing=2e-7, threads=threads)
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        contact.evaluate(coords)
        time.sleep(10.0)
    # It is asked some twenty times a second; a machine that is busy may be late.
    assert time.monotonic() - begun < 8.0
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    contact.set_options(spacing=0.01)
    found = contact.evaluate(coords)
    fresh = Contact(coords, cells, "quad", stiffness=1.0, law="volume", estimator="fibers", spacing=0.01).evaluate(coords)
    assert (found.forces == fresh.forces).all() and found.volume == fresh.volume > 0.0


def test_a_handler_of_the_program_is_called(on_ctrl_c):
    coords, cells = blocks(4)
    contact = Contact(coords, cells, "quad", stiffness=1.0, law="volume", estimator="fibers", spacing=2e-7)
    heard = []
    on_ctrl_c(lambda number, frame: heard.append(number))
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(FmcError) as ended:
        contact.evaluate(coords)
    assert heard == [signal.SIGINT] and "ended by its caller" in str(ended.value)


def test_pairs_have_forces():
    coords, cells = blocks(4)
    found = Contact(coords, cells, "quad", stiffness=1.0).evaluate(coords)
    (pair,) = found.pairs
    assert pair.force.shape == (2,) and np.abs(pair.force).max() > 0.0
    np.testing.assert_allclose(pair.force, found.bodies[1].force, rtol=1e-12, atol=1e-15)
