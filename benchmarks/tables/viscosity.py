"""A double cantilever beam that a crack runs through, with and without viscosity, in one step and in many.

    python benchmarks/tables/viscosity.py

Needs scikit-fem, fmc_contact_skfem and pytest, whose tests have the beam; half a minute.
"""

import sys
from pathlib import Path

import numpy as np
from fmc_contact.errors import FmcError
from skfem import ElementQuad1

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "hosts/skfem/tests"))
from test_cohesive import Glued

END, STRENGTH, ENERGY = 0.04, 1e-3, 1e-6


def opened(steps, viscosity):
    """The beam after all steps: linear solves, load, and viscous by dissipated energy; or the step that fails."""
    law = {"viscosity": viscosity} if viscosity else {}
    glued = Glued(10.0, (40, 40), (ElementQuad1, ElementQuad1), normal_strength=STRENGTH, normal_energy=ENERGY, **law)
    for body in (0, 1):
        glued.free[glued.dofs(body, lambda x: x[0] > 10 - 1e-9)] = False
    lower = glued.dofs(0, lambda x: (x[0] < 1e-9) & (x[1] < -1 + 1e-9))[1]
    upper = glued.dofs(1, lambda x: (x[0] < 1e-9) & (x[1] > 1 - 1e-9))[1]
    glued.free[[lower, upper]] = False
    glued.pair.cohesive.set_time_step(1 / steps)
    solves = 0
    for step in range(1, steps + 1):
        prescribed = np.zeros(len(glued.u))
        prescribed[lower], prescribed[upper] = -END * step / steps, END * step / steps
        try:
            solves += glued.step(prescribed).iterations
        except FmcError as error:
            return f"fails at step {step} ({type(error).__name__})"
    interface = glued.pair.cohesive.interface(0, 1, glued.contact.coords(glued.u))
    load = (glued.matrix @ glued.u - glued.contact.force(glued.u))[upper]
    return solves, load, interface.viscous / interface.dissipated


if __name__ == "__main__":
    reference = None
    for steps, viscosity in ((1, 0.0), (20, 0.0), (20, 1e-4), (20, 1e-3), (80, 1e-4)):
        found = opened(steps, viscosity)
        if isinstance(found, str):
            print(steps, viscosity, found)
            continue
        reference = reference or found[1]
        print(f"{steps} {viscosity} {found[0]} solves, load {100 * (found[1] / reference - 1):+.1f} %, viscous / dissipated {found[2]:.2g}")
