"""Runs what the pages name, and writes what came out to docs/results.json."""

import json
import os
import subprocess
import sys
import tempfile

import gallery
import others
import pages
from recorded import FILE

KEPT = ("figures", "iterations", "contact_iterations")


def record(fmc, *only):
    """``only``: runs of cases to be done again, by name; default: everything. The results of the others are kept."""
    wanted = {name for name in pages.runs() | gallery.runs() if not others.is_other(name)}
    if unknown := set(only) - wanted:
        raise ValueError(f"no page names the run {', '.join(sorted(unknown))}")
    old = json.loads(FILE.read_text(encoding="utf-8"))["runs"] if FILE.exists() else {}
    todo = sorted(only or wanted)
    runs = {name: run for name, run in old.items() if others.is_other(name) or name in wanted}
    for count, name in enumerate(todo, 1):
        print(f"{count} of {len(todo)}: fmc run {name}", file=sys.stderr, flush=True)
        runs[name] = run_of(fmc, name)
    runs.update({} if only else {**verified(fmc), **others.found()})
    FILE.write_text(json.dumps({"runs": dict(sorted(runs.items()))}, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def run_of(fmc, name):
    """What a run found, without what depends on the machine. Its checks may be missed: the pages say so."""
    with tempfile.TemporaryDirectory() as folder:
        command = [fmc, "run", *name.split(), "--json", "--out", folder]
        environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        run = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    if run.returncode not in (0, 1):
        raise ValueError(f"fmc run {name}: {run.stderr.strip()}")
    found = json.loads(run.stdout)
    checks = [{key: check[key] for key in ("name", "value", "reference", "ok", "source")} for check in found["checks"]]
    return rounded({**{key: found[key] for key in KEPT}, "checks": checks})


def verified(fmc):
    """verify/CASE/FORM/ESTIMATOR/QUANTITY: the largest error over θ."""
    rows = json.loads(subprocess.check_output([fmc, "verify", "--json", "-", "--no-pictures"]))
    errors = {}
    for row in rows:
        name = "/".join(["verify", *(row[key] for key in ("case", "form", "estimator", "quantity"))])
        errors[name] = max(errors.get(name, 0.0), row["scaled_error"])
    return {name: {"figures": {"error": float(f"{error:.3g}")}} for name, error in errors.items()}


def rounded(value):
    """Six digits, which pages have at most, and which hosts agree on."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    return [rounded(one) for one in value] if isinstance(value, list) else value
