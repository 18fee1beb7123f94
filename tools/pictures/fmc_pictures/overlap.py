"""Two blocks that overlap: the overlap, the forces on the nodes, and the pressure, which is k times the penetration."""

import numpy as np
from fmc_contact import Contact

from .bodies import grid, together, turned
from .drawing import DARK, LOWER, UPPER, Frame, Picture

DEEP, ANGLE = 0.09, 5


def picture():
    lower, upper = grid((12, 5), (-1.2, 1.2), (-1, 0)), grid((6, 6), (-0.5, 0.5), (0, 1))
    tilted = turned(upper[0], ANGLE)
    tilted[:, 1] -= tilted[:, 1].min() + DEEP
    coords, cells, firsts = together(lower, (tilted, upper[1]))
    contact = Contact(coords, cells, "quad", stiffness=1.0)
    found, nodal = contact.evaluate(coords), contact.nodal_contact(coords)

    made = Picture(300, "Two blocks overlap; the pressure is the stiffness times the penetration")
    scene = Frame(made, (10, 34, 360, 250), (-0.85, 0.85), (-0.3, 0.5), equal=True)
    for body, colour in enumerate((LOWER, UPPER)):
        rows = slice(firsts[body], firsts[body + 1])
        scene.mesh(coords, cells[(cells[:, 0] >= firsts[body]) & (cells[:, 0] < firsts[body + 1])], colour)
        scene.arrows(coords[rows], found.forces[rows], colour, 75 / np.abs(found.forces).max())
    scene.text((-0.05, 0.22), "B", size=20)
    scene.text((-0.05, -0.3), "A", size=20)
    made.text((190, 22), "overlap and nodal forces")

    chart = Frame(made, (450, 50, 250, 190), (-0.6, 0.6), (0, 1.15 * DEEP))
    made.text((577, 22), "pressure along the contact")
    corner = tilted[:, 0][tilted[:, 1].argmin()]
    end = corner + DEEP / np.tan(np.radians(ANGLE))
    chart.line([(corner, DEEP), (end, 0)], DARK, 1.5)
    for body, colour in enumerate((LOWER, UPPER)):
        rows = slice(firsts[body], firsts[body + 1])
        shown = nodal.area[rows] > 0.08
        chart.dots(np.column_stack([coords[rows, 0], nodal.pressure[rows]])[shown], colour, 4.5)
    low = nodal.pressure[firsts[1]]
    chart.text((corner + 0.04, low - 0.006), "corner of B", "start", size=13)
    chart.axes("x", "", [(-0.5, "−0.5"), (0, "0"), (0.5, "0.5")], [(0, "0"), (DEEP, "k δ")])
    made.key((560, 64), DARK, "k × depth", line=True)
    made.key((560, 86), LOWER, "nodes of A")
    made.key((560, 108), UPPER, "nodes of B")
    return made
