"""The table of docs/hosts.md: cases in all hosts, as `make agree` records them."""

from fields import number

CASES = {
    "hertz": "`hertz`",
    "hertz3d": "`hertz3d`, 34 816 Tet4",
    "patch3d": "`patch3d`, Hex8",
    "patch3d, tet4": "`patch3d`, Tet4",
    "wedge": "`wedge`, 7 680 Tri3",
    "cone": "`cone`, 30 500 Tet4 ⁴",
    "punch": "`punch`, neo-Hookean",
    "hertz, bodies.disc.mesh.cell=quad4": "`hertz`, Quad4",
    "punch, depth": "`punch`, law `depth`",
    "ironing": "`ironing`, neo-Hookean, 23 steps",
    "cgs4": "`cgs4`, friction, 21 steps",
    "hertz, depth": "`hertz`, law `depth`",
    "hertz, tri6": "`hertz`, Tri6",
    "bar": "`bar`, 540 steps",
    "star, smooth, contact.stiffness=1e9, time.end=9e-3": "`star`, m = 2 ³, 2 315 steps",
}
MOTIONS = ("bar", "star")

HOSTS = {
    "reference": "reference",
    "skfem": "scikit-fem",
    "dolfinx": "FEniCSx",
    "getfem": "GetFEM",
    "petsc": "PETSc ⁶, 1, 2, 4 ranks",
    "dealii": "deal.II ⁷",
}
BY_SNES = {("hertz", "dolfinx"): "FEniCSx ⁶, 1, 2, 3, 4 ranks"}
SMALL = {("hertz", "dolfinx"), ("hertz", "petsc")}
"""Their seconds are measured on one rank, footnote 2."""

COLUMNS = ("case", "host", "displacement", "force", "bit-identical ¹", "checks met", "iterations", "time", "in contact")


def table(results):
    """Its text. Every case that a host has run must be named here."""
    found = {tuple(run.split("/")[1:]) for run in results.runs if run.startswith("agree/") and run.count("/") == 2}
    if unknown := sorted({case for case, _ in found} - set(CASES)):
        raise ValueError(f"hosts.py has no label for {', '.join(unknown)}")
    lines = [COLUMNS, ["---"] * len(COLUMNS)]
    for case, label in CASES.items():
        hosts = [host for host in HOSTS if (case, host) in found]
        lines += [[label if host == hosts[0] else "", *_row(results, case, host)] for host in hosts]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def _row(results, case, host):
    figures = results.run(f"agree/{case}/{host}")["figures"]
    is_reference, seconds = host == "reference", figures["seconds"]
    return [
        BY_SNES.get((case, host), HOSTS[host]),
        "–" if is_reference else number(figures["displacement"], ".0e"),
        "–" if is_reference else number(figures["force"], ".0e") if "force" in figures else "none ⁵",
        number(figures["same_bits"], "yes") if "same_bits" in figures else "",
        f"{figures['checks_met']:.0f} of {figures['checks']:.0f}" if figures["checks"] else "",
        "" if case.startswith(MOTIONS) else number(figures["iterations"], ".0f"),
        number(seconds, ".2f" if seconds < 0.995 else ".1f") + " s" + (" ²" if (case, host) in SMALL else ""),
        number(figures["in_contact"], ".0%"),
    ]
