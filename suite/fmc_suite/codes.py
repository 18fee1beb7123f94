"""The codes of the table: where each is found, its variants, and the advice that these follow."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Code:
    """A code, the name of its runner's module, and its variants: first its defaults, then what its own pages advise beyond them."""

    title: str
    python: str
    """Name of the environment variable with the interpreter that has the code; else the one that runs the suite."""
    variants: Mapping[str, str] = field(default_factory=lambda: {"default": ""})

    def interpreter(self) -> str:
        return os.environ.get(self.python, sys.executable)


CODES = {
    "fmc_skfem": Code(
        "fmc-contact in scikit-fem",
        "SUITE_PYTHON_FMC",
        {
            "default": "`SkfemContact(bases)` and `find_equilibrium`; planes of symmetry are named",
            "smooth surfaces": "the same with `set_surface_smoothing(30.0)`",
        },
    ),
    "fmc_dolfinx": Code(
        "fmc-contact in FEniCSx",
        "SUITE_PYTHON_FENICSX",
        {
            "default": "`DolfinxContact(spaces)` and `find_equilibrium`; planes of symmetry are named",
            "smooth surfaces": "the same with `set_surface_smoothing(30.0)`",
        },
    ),
    "fmc_getfem": Code("fmc-contact in GetFEM", "SUITE_PYTHON_GETFEM", {"default": "`GetfemContact(model, variables)` and `find_equilibrium`"}),
    "getfem": Code(
        "GetFEM",
        "SUITE_PYTHON_GETFEM",
        {
            "default": "augmented Lagrangian in the integral, r = E, the first option; friction: rays over large sliding; ties: multipliers",
            "fine integration": "the same with contact integrated to degree 13 on every facet",
            "rays": "rays over large sliding, also without friction, to degree 13",
        },
    ),
    "ipctk": Code(
        "IPC Toolkit",
        "SUITE_PYTHON_IPCTK",
        {
            "default": "area-weighted barrier, dhat a thousandth of the diagonal, κ = E; the suite's own bodies are its host",
            "small dhat": "dhat 1e-6 of the diagonal",
        },
    ),
    "kratos": Code(
        "Kratos",
        "SUITE_PYTHON_KRATOS",
        {
            "default": "`ALMContactFrictionless` or `ALMContactFrictional` with all parameters left out; ties: `ComponentsMeshTying`",
            "other slave": "the same with the coarser side as the slave",
            "wide search": "the same with a `search_factor` of 20 instead of 3.5",
        },
    ),
    "calculix": Code(
        "CalculiX",
        "SUITE_PYTHON_CALCULIX",
        {
            "default": "face to face, `PRESSURE-OVERCLOSURE=HARD`; ties: `TIED` with 50 E",
            "stiff": "face to face, `LINEAR` with 1000 E (the default is 50 E)",
        },
    ),
}
