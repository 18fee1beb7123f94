"""What other programs have left: `make agree` in out/agree, `make peers` in out/peers, `make bench` in target/criterion and out/bench."""

import json
import os

from pages import ROOT


def is_other(name):
    return "/" in name


def found():
    """Runs by name, of those programs that have left something."""
    return {**_agreement(), **_penetration(), **_beside(), **_peers(), **_benches(), **_kept("scaling"), **_kept("statics")}


def _rows(path):
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else []


def _agreement():
    """agree/CASE/HOST, and agree/equilibria: how many there are, and the largest difference of displacements."""
    runs, apart = {}, {}
    for row in _rows(ROOT / "out" / "agree" / "table.json"):
        row["in_contact"] = row["contact_seconds"] / row["seconds"] if row["seconds"] else 0.0
        runs[f"agree/{row['case']}/{row['host']}"] = {"figures": _numbers(row)}
        if not any("energy" in figure for figure in row["figures"]):
            apart[row["case"]] = max(apart.get(row["case"], 0.0), row["displacement"])
    if apart:
        figures = {"count": len(apart), "displacement": float(f"{max(apart.values()):.3g}")}
        runs["agree/equilibria"] = {"figures": figures}
    return runs


def _penetration():
    """penetration/CASE/HOST; what was found with the law alone ends in _law, with the penetration asked for in _wanted."""
    runs = {}
    for row in _rows(ROOT / "out" / "agree" / "penetration.json"):
        both = {f"{key}_{way}": value for key, pair in row.items() if isinstance(pair, list) for way, value in zip(("law", "wanted"), pair)}
        runs[f"penetration/{row['case']}/{row['host']}"] = {"figures": _numbers({"wanted": row["wanted"], **both})}
    return runs


def _beside():
    """beside/CASE/HOST."""
    rows = _rows(ROOT / "out" / "agree" / "beside.json")
    return {f"beside/{row['case']}/{row['host']}": {"figures": _numbers(row)} for row in rows}


def _peers():
    """peers/CASE/PROGRAM, the case with a comma and `friction` where that acts."""
    rows = _rows(ROOT / "out" / "peers" / "table.json")
    case = {id(row): row["case"] + (", friction" if row.get("friction") else "") for row in rows}
    return {f"peers/{case[id(row)]}/{row['program']}": {"figures": _numbers(row)} for row in rows}


def _benches():
    """bench/GROUP/FUNCTION, the median in seconds; crossings where the benchmark counts them."""
    folder = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "criterion"
    runs = {}
    for file in sorted(folder.rglob("new/estimates.json")):
        about = json.loads((file.parent / "benchmark.json").read_text(encoding="utf-8"))
        seconds = json.loads(file.read_text(encoding="utf-8"))["median"]["point_estimate"] * 1e-9
        figures = {"seconds": seconds, **({"crossings": about["throughput"]["Elements"]} if about["throughput"] else {})}
        runs[f"bench/{about['full_id'].replace(':', '')}"] = {"figures": _numbers(figures)}
    return runs


def _kept(bench):
    """scaling/SCENE/PATH, times in milliseconds; statics/CASE, SIZE."""
    path = ROOT / "out" / "bench" / f"{bench}.json"
    found = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    return {f"{bench}/{name}": {"figures": _numbers(figures)} for name, figures in found.items()}


def _numbers(row):
    """What of a row is a number."""
    return {key: float(f"{value:.5g}") for key, value in row.items() if isinstance(value, (int, float))}
