"""One cell of the table: a code, in one of its variants, on a problem, in a process of its own with limits of time and memory."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from .codes import CODES
from .figures import error, figure
from .problem import Problem

SECONDS, GIGABYTES = 300, 12
PACKAGE = Path(__file__).resolve().parent.parent


def path(folder: Path, code: str, variant: str, problem: str) -> Path:
    return folder / f"{problem}--{code}--{variant.replace(' ', '-')}.json"


def run(folder: Path, code: str, variant: str, name: str, seconds: float = SECONDS) -> dict[str, Any]:
    """Solves, measures, and writes the result; also where there is none."""
    problem = Problem.load(name)
    cell: dict[str, Any] = {"problem": name, "code": code, "variant": variant}
    with tempfile.TemporaryDirectory() as scratch:
        model, out = Path(scratch, "model.npz"), Path(scratch, "out")
        np.savez(model, **problem.arrays())  # type: ignore[arg-type]
        cell |= _process([CODES[code].interpreter(), "-m", f"fmc_suite.runners.{code}", str(model), variant, str(out)], scratch, seconds)
        if cell["status"] == "ok":
            cell |= _measured(problem, out, cell)
    folder.mkdir(parents=True, exist_ok=True)
    path(folder, code, variant, name).write_text(json.dumps(cell, indent=1) + "\n")
    return cell


def _measured(problem: Problem, out: Path, cell: dict[str, Any]) -> dict[str, Any]:
    """What the runner wrote, with the figure and its error."""
    if not out.with_suffix(".json").exists():
        return {"status": "failed", "message": f"no answer: {cell['said']}"}
    answer = dict(json.loads(out.with_suffix(".json").read_text()))
    if answer["status"] == "ok":
        found = figure(problem, np.load(out.with_suffix(".npy")))
        answer |= {"figure": found, "error": error(problem, found)}
        if not np.isfinite(found):
            answer |= {"status": "failed", "message": "the figure is not finite"}
    return answer


def _process(command: list[str], scratch: str, seconds: float) -> dict[str, Any]:
    """Runs it in a group of its own. CPU seconds and memory are those of the process with its children."""
    words = {"PYTHONPATH": os.pathsep.join([str(PACKAGE), os.environ.get("PYTHONPATH", "")]), "OMP_NUM_THREADS": "1"}
    begun, log = time.monotonic(), Path(scratch, "said")
    with log.open("w") as said:
        process = subprocess.Popen(
            command, env={**os.environ, **words}, cwd=scratch, stdout=said, stderr=subprocess.STDOUT, preexec_fn=_limit, start_new_session=True
        )
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() - begun > seconds:
                os.killpg(process.pid, signal.SIGKILL)
                os.wait4(process.pid, 0)
                process.returncode = -9
                return {"status": "failed", "message": f"not done in {seconds:.0f} s"}
            time.sleep(0.02)
    # It has been waited for.
    process.returncode = os.waitstatus_to_exitcode(status)
    told = {"cpu": usage.ru_utime + usage.ru_stime, "memory": usage.ru_maxrss / 1024, "said": log.read_text(errors="replace")[-300:]}
    if process.returncode:
        code = process.returncode
        how = f"with {code}" if code > 0 else f"by the signal {signal.Signals(-code).name}"
        return {"status": "failed", "message": f"ended {how}: {told['said']}"[:400], **told}
    return {"status": "ok", **told}


def _limit() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (GIGABYTES << 30, GIGABYTES << 30))
