"""A child that was forked while a contact had threads."""

import os
import signal
import sys

import numpy as np
import pytest
from fmc_contact import Contact
from scenes import K


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_a_forked_child_goes_on_alone_with_the_same_bits():
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.1, 0.9], [0.9, 0.9], [0.9, 1.9], [0.1, 1.9]])
    contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=K, threads=2)
    expected = contact.evaluate(coords).forces.tobytes()
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        # What hangs is killed; nothing of pytest must run here.
        signal.alarm(20)
        is_same = contact.evaluate(coords).forces.tobytes() == expected
        contact.set_options(threads=3)
        is_same = is_same and contact.evaluate(coords).forces.tobytes() == expected
        del contact
        os._exit(0 if is_same else 1)
    assert os.waitpid(child, 0)[1] == 0
    assert contact.evaluate(coords).forces.tobytes() == expected
