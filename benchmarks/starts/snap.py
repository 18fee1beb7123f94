"""A half ring, pressed flat on a stiffer block by its feet, whose crown snaps inwards.

Expected are the forces of 240 steps (40 cells, where any number of steps gives the same), and of steps that go down the energy in small
ones, each with a stiffness between the last place and the next that vanishes (80 and 160 cells, and the same for 40).
"""

import json
from functools import partial
from pathlib import Path

import numpy as np
from bodies import Bodies
from meshes import QUAD4, grid
from problem import Expected, Problem, Step
from skfem import MeshQuad
from solver import contact_of

_CURVES = Path(__file__).parent / "snap.json"


def curves():
    """Force after every thirtieth part of the way, by the number of cells."""
    return json.loads(_CURVES.read_text())


def ring(count, steps, down=0.9):
    """The ring has so many cells around; its feet move down in equal steps."""
    strip = grid(QUAD4.mesh, [0, 0.9], [np.pi, 1.0], [count, 3])
    angle, radius = strip.p
    arch = MeshQuad(np.array([radius * np.cos(angle), 1 - radius * np.sin(angle)]), strip.t[[0, 3, 2, 1]])
    lowest = arch.p[1].min()
    block = grid(QUAD4.mesh, [-1.3, lowest - 0.3], [1.3, lowest], [52, 3])
    bodies = Bodies([block, arch], QUAD4, [1e4, 1e2], 0.3, is_linear=False)
    feet = [bodies.unknowns(1, lambda x: x[1] > 1 - 1e-9, axis) for axis in (0, 1)]
    bottom = bodies.unknowns(0, lambda x: x[1] < lowest - 0.3 + 1e-9)
    free = bodies.free([*feet, bottom])
    curve = curves()[str(count)]
    force = lambda found: found.result.bodies[1].force[1]
    balance = Expected("feet/block", lambda found: -found.reactions[feet[1]].sum() / force(found), 1.0, 1e-6, "statics")
    found = []
    for i in range(1, steps + 1):
        prescribed = np.zeros(bodies.size)
        prescribed[feet[1]] = -down * i / steps
        expected = [balance]
        place = len(curve) * i / steps
        if place == int(place):
            wanted = curve[int(place) - 1]
            expected.append(Expected("F", force, wanted, 0.01 * wanted, "many small steps, down the energy"))
        found.append(Step(bodies.host(), free, prescribed, expected=tuple(expected), most_solves=60))
    return Problem(contact_of(bodies), np.zeros(bodies.size), found)


PROBLEMS = {f"{count} cells, {steps} steps": partial(ring, count, steps) for count in (40, 80, 160) for steps in (30, 60)}
SLOW = set(PROBLEMS)
