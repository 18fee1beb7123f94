"""More tables of docs/hosts.md: the penetration tolerance, and the cost of the Python hosts."""

from fields import number

from hosts import HOSTS

CASES = {
    "hertz": "`hertz`",
    "hertz, depth": "`hertz`, law `depth`",
    "cone": "`cone`",
    "cone, depth": "`cone`, law `depth`",
    "ironing": "`ironing`, 23 steps",
    "ironing, depth": "`ironing`, law `depth`",
    "wedge": "`wedge`",
    "punch": "`punch`",
    "hertz3d": "`hertz3d`",
}


def table(results):
    """Every case without and with a tolerance, as `python -m fmc_agreement.penetration` records it."""
    head = ("case", "host", "tolerance", "without", "reached", "iterations", "contact iterations", "factorisations", "updates", "change of force")
    lines = [head, ["---"] * len(head)]
    for case, host, figures in _found(results, "penetration"):
        pair = {key: " · ".join(number(figures[f"{key}_{way}"], ".0f") for way in ("law", "wanted")) for key in COUNTS}
        force = figures["force_wanted"] / figures["force_law"] - 1
        lengths = [number(figures[key], form) for key, form in LENGTHS]
        lines.append([case, host, *lengths, *pair.values(), number(figures["updates_wanted"], ".0f"), number(force, "+.3%")])
    return _text(lines)


LENGTHS = (("wanted", ".1e"), ("penetration_law", ".0e"), ("penetration_wanted", ".0e"))
COUNTS = ("iterations", "contact_iterations", "factorisations")


def beside(results):
    """Iterations and time, as `python -m fmc_agreement.beside` records them."""
    head = ("case", "host", "iterations", "ratio to reference", "factorisations", "time", "ratio to reference", "with imports")
    lines, theirs = [head, ["---"] * len(head)], {}
    for case, host, figures in _found(results, "beside"):
        is_first = host == HOSTS["reference"]
        theirs = figures if is_first else theirs
        by = ["–" if is_first else number(figures[key] / theirs[key], ".2f") for key in ("iterations", "seconds")]
        program = "" if is_first else _seconds(figures["program"])
        counts = [number(figures[key], ".0f") for key in ("iterations", "factorisations")]
        lines.append([case, host, counts[0], by[0], counts[1], _seconds(figures["seconds"]), by[1], program])
    return _text(lines)


def _found(results, kind):
    """Cases and hosts as they are shown, with the figures."""
    for case, label in CASES.items():
        shown = False
        for host, name in HOSTS.items():
            run = results.runs.get(f"{kind}/{case}/{host}")
            if run:
                yield "" if shown else label, name, run["figures"]
                shown = True


def _seconds(seconds):
    return number(seconds, ".2f" if seconds < 0.995 else ".1f") + " s"


def _text(lines):
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)
