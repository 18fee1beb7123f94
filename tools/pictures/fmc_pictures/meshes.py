"""Two blocks whose meshes do not match, pressed by the same depth everywhere: each side gets forces at its nodes, and both have one pressure."""

import numpy as np
from fmc_contact import Contact

from .bodies import grid, together
from .drawing import DARK, LOWER, UPPER, Frame, Picture

DEEP = 0.004


def picture():
    lower, upper = grid((9, 3), (-1, 1), (-0.6, 0)), grid((5, 2), (-0.7, 0.8), (-DEEP, 0.58))
    coords, cells, firsts = together(lower, upper)
    contact = Contact(coords, cells, "quad", stiffness=1 / DEEP)
    found, nodal = contact.evaluate(coords), contact.nodal_contact(coords)

    made = Picture(290, "Blocks with meshes that do not match, and the pressure on both sides")
    scene = Frame(made, (10, 34, 360, 240), (-1.1, 1.1), (-0.6, 0.6), equal=True)
    made.text((190, 22), "forces at the nodes of both meshes")
    chart = Frame(made, (450, 50, 250, 170), (-1, 1), (0, 1.5))
    made.text((577, 22), "pressure on both sides")
    chart.line([(-0.7, 1), (0.8, 1)], DARK, 1.5)
    for body, colour in enumerate((LOWER, UPPER)):
        rows = slice(firsts[body], firsts[body + 1])
        scene.mesh(coords, cells[(cells[:, 0] >= firsts[body]) & (cells[:, 0] < firsts[body + 1])], colour)
        scene.arrows(coords[rows], found.forces[rows], colour, 60 / np.abs(found.forces).max())
        shown = nodal.area[rows] > 0.05
        chart.dots(np.column_stack([coords[rows, 0], nodal.pressure[rows]])[shown], colour, 4.5)
    chart.axes("x", "", [(-1, "−1"), (0, "0"), (1, "1")], [(0, "0"), (1, "k δ")])
    made.key((456, 200), LOWER, "lower nodes")
    made.key((576, 200), UPPER, "upper nodes")
    return made
