"""Memory that could not be allocated is an error, not the end of the program."""

import subprocess
import sys

import pytest

resource = pytest.importorskip("resource")

PROGRAM = """
import resource
import numpy as np
from fmc_contact import Contact, FmcError
from fmc_contact.errors import OutOfMemoryError

count = 500
line = np.linspace(0.0, 1.0, count + 1)
x, y = np.meshgrid(line, line)
coords = np.column_stack([x.ravel(), y.ravel()])
corner = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
cells = np.column_stack([corner, corner + 1, corner + count + 2, corner + count + 1])
small = Contact(coords[: 2 * (count + 1)], cells[:count], "quad", stiffness=1.0)
with open("/proc/self/statm") as file:
    pages = int(file.read().split()[0])
now, hard = pages * resource.getpagesize(), resource.getrlimit(resource.RLIMIT_AS)[1]
resource.setrlimit(resource.RLIMIT_AS, (now + 40 * 2**20, hard))
try:
    Contact(coords, cells, "quad", stiffness=1.0)
    print("made")
except OutOfMemoryError as error:
    print("refused:", error)
# What was there is there.
print(small.evaluate(coords[: 2 * (count + 1)]).volume)
resource.setrlimit(resource.RLIMIT_AS, (hard, hard))
Contact(coords, cells, "quad", stiffness=1.0)
print("enough")
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the limit of memory is set as Linux has it")
def test_memory_that_cannot_be_had_is_an_error():
    ended = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    refused, volume, enough = ended.stdout.splitlines()
    assert refused.startswith("refused: ") and "could not be allocated" in refused
    assert float(volume) == 0.0 and enough == "enough"
