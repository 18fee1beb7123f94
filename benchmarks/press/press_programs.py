"""The programs, the package that pip installs for each, and the module of that package."""

from pathlib import Path

REFERENCE = "scikit-fem"

PACKAGES = {
    REFERENCE: "scikit-fem",
    "Akantu": "akantu",
    "FElupe": "felupe",
    "Kratos": "KratosMultiphysics",
    "MFEM": "mfem",
    "NGSolve": "ngsolve",
    "OpenSees": "openseespy",
    "SfePy": "sfepy",
}

MODULES = PACKAGES | {REFERENCE: "skfem"}

FOLDERS = {name: name.lower() for name in PACKAGES} | {REFERENCE: "skfem/examples"}

PROGRAMS = {name: Path(__file__).parents[2] / "hosts" / folder / "press.py" for name, folder in FOLDERS.items()}
