"""Bytes that ``fmc_mpi.h`` moves, also where there are more than MPI counts in one message."""

import os
import subprocess
from pathlib import Path

import pytest
from launch import printed


@pytest.mark.parametrize("ranks", [1, 3, 4])
@pytest.mark.parametrize("parts", [(), ("-DIN_PARTS",)], ids=["whole", "in parts"])
def test_every_byte_arrives(parts, ranks, tmp_path):
    source, prefix = Path(__file__).with_name("messages.c"), Path(os.environ["FMC_PRESS"]).parents[1]
    program = tmp_path / "messages"
    library = ["-I", prefix / "include", "-L", prefix / "lib", "-lfmc_contact", f"-Wl,-rpath,{prefix / 'lib'}"]
    subprocess.run(["mpicc", "-std=c99", "-Wall", "-Wextra", "-Werror", *parts, source, "-o", program, *library], check=True)
    printed(ranks, program)
