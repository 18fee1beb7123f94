"""Stiff contact partners of a layer: confined rubber and sheets of one cell, which are stiffer than Young's modulus by a size says."""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import BY_NAME, disc, grid
from problem import Expected, Problem, Step
from solver import contact_of

SOLVES = 6
_PUSH = 0.01


def rubber(cells, poisson, count=8):
    """A pad that cannot bulge is pressed on a floor by its top."""
    cells = BY_NAME[cells]
    dim, young = cells.dim, 1.4
    bodies = Bodies([grid(cells.mesh, [0] * dim, [1] * dim, [count if dim == 2 else 3] * dim)], cells, young, poisson)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_half_space([0] * dim, [0] * (dim - 1) + [1])
    at_side = lambda x, axis: (x[axis] < 1e-9) | (x[axis] > 1 - 1e-9)
    held = [bodies.unknowns(0, lambda x, a=axis: at_side(x, a), axis) for axis in range(dim - 1)]
    top = bodies.unknowns(0, lambda x: x[-1] > 1 - 1e-9, -1)
    prescribed = np.zeros(bodies.size)
    prescribed[top] = -_PUSH
    force = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) * _PUSH
    pressed = Expected("F/ref", lambda found: -found.result.obstacles[0].force[-1] / force, 1.0, 1e-3, "oedometer")
    step = Step(bodies.host(), bodies.free([*held, top]), prescribed, expected=(pressed,), most_solves=SOLVES)
    return Problem(contact, np.zeros(bodies.size), [step])


def sheet(cells, thickness, poisson=0.0, layers=1):
    """A sheet with facets of length 1 between two plates that press it by a hundredth of its thickness."""
    cells = BY_NAME[cells]
    young, strain = 100.0, 0.01
    bodies = Bodies([grid(cells.mesh, [0, 0], [10, thickness], [10, layers])], cells, young, poisson)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_half_space([0, strain * thickness / 2], [0, 1])
    contact.contact.obstacles.add_half_space([0, thickness * (1 - strain / 2)], [0, -1])
    held = [bodies.unknowns(0, lambda x: x[0] < 1e-9, 0)]
    force = 10 * young * strain / (1 - poisson**2)
    pressed = Expected("F/ref", lambda found: -found.result.obstacles[0].force[1] / force, 1.0, 1e-3, "a uniform strain, free to widen")
    step = Step(bodies.host(), bodies.free(held), expected=(pressed,), most_solves=SOLVES)
    return Problem(contact, np.zeros(bodies.size), [step])


RINGS = {"linear": 0.25924, "neo-Hookean": 0.30384}
"""Force of the floor on the ring by material: 12 small steps with the middle held, for no penetration."""


def o_ring(material, steps=4, push=0.3):
    """The section of a ring of rubber in a groove that it nearly fills, under a lid that moves down in equal steps.

    The lid is a block of which every node is moved. In the last steps the rubber is confined by the walls too.
    """
    walls, young, poisson = 1.05, 1.4, 0.499
    lid = grid(BY_NAME["Quad4"].mesh, [-1, 2], [1, 2.4], [10, 2])
    bodies = Bodies([disc(1.0, 3, (0, 1)), lid], [BY_NAME["Tri6"], BY_NAME["Quad4"]], [young, 1e3 * young], [poisson, 0.3], material == "linear")
    contact = contact_of(bodies)
    for point, normal in (([0, 0], [0, 1]), ([-walls, 0], [1, 0]), ([walls, 0], [-1, 0])):
        contact.contact.obstacles.add_half_space(point, normal)
    held = [bodies.unknowns(1, lambda x: x[0] < np.inf, axis) for axis in (0, 1)]
    found = []
    for i in range(1, steps + 1):
        prescribed = np.zeros(bodies.size)
        prescribed[held[1]] = -push * i / steps
        bears = Expected("floor/lid", lambda found: found.result.obstacles[0].force[1] / found.reactions[held[1]].sum(), 1.0, 1e-6, "statics")
        expected = [bears]
        if i == steps:
            force = lambda found: -found.result.obstacles[0].force[1]
            expected.append(Expected("F/ref", lambda found: force(found) / RINGS[material], 1.0, 1e-3, "small steps, no penetration"))
        found.append(Step(bodies.host(), bodies.free(held), prescribed, expected=tuple(expected), most_solves=36))
    return Problem(contact, np.zeros(bodies.size), found)


PROBLEMS = {
    f"confined {cells}, ν {poisson:g}": partial(rubber, cells, poisson)
    for cells in ("Quad9", "Quad4", "Tri6", "Hex8", "Tet10")
    for poisson in (0.3, 0.49, 0.499, 0.4995, 0.4999)
}
PROBLEMS |= {f"sheet of {cells}, t/h {t:g}": partial(sheet, cells, t) for cells in ("Quad4", "Tri3", "Tri6") for t in (1.0, 0.3, 0.1, 0.03, 0.01)}
PROBLEMS |= {f"sheet of Quad9, t/h {t:g}, ν 0.3": partial(sheet, "Quad9", t, 0.3) for t in (1.0, 0.1, 0.01)}
PROBLEMS |= {f"O-ring in a groove, {material}": partial(o_ring, material) for material in RINGS}
SLOW = set()
