"""A bar is pushed through a block: force and energy have no jump at any depth, and none is left behind it."""

import numpy as np
from fmc_contact import Contact

from .bodies import grid, together
from .drawing import DARK, LOWER, UPPER, Frame, Picture

SHOWN = {"a": 0.2, "b": 0.6, "c": 1.2}


def picture():
    block, bar = grid((8, 4), (-1, 1), (-0.8, 0)), grid((2, 4), (-0.25, 0.25), (0, 1))
    coords, cells, firsts = together(block, bar)
    contact = Contact(coords, cells, "quad", stiffness=1.0)

    def at(depth):
        moved = coords.copy()
        moved[firsts[1] :, 1] -= depth
        return moved, contact.evaluate(moved)

    depths = np.linspace(0, 2.0, 161)
    results = [at(depth)[1] for depth in depths]
    force, energy = np.array([found.bodies[1].force[1] for found in results]), np.array([found.energy for found in results])

    made = Picture(300, "A bar is pushed through a block, and the force on it")
    made.text((205, 22), "a bar is pushed through a block: force on the bar")
    chart = Frame(made, (470, 50, 235, 190), (0, 2.0), (-0.15, 0.2))
    made.text((587, 22), "force on the bar, and energy")
    chart.line([(0, 0), (2, 0)], "#bbb", 1)
    chart.line(np.column_stack([depths, force]), UPPER)
    chart.line(np.column_stack([depths, energy]), DARK)
    chart.axes("depth of the tip", "", [(0, "0"), (1, "1"), (2, "2")], [(0, "0")])
    made.key((575, 64), UPPER, "force", line=True)
    made.key((575, 86), DARK, "energy", line=True)
    for row, (name, depth) in enumerate(SHOWN.items()):
        scene = Frame(made, (12 + 134 * row, 44, 122, 190), (-0.75, 0.75), (-1.35, 0.9), equal=True)
        moved, found = at(depth)
        for body, colour in enumerate((LOWER, UPPER)):
            scene.mesh(moved, cells[(cells[:, 0] >= firsts[body]) & (cells[:, 0] < firsts[body + 1])], colour)
        up = found.bodies[1].force[1]
        scene.arrows([[0, -0.4 if up > 0 else -0.2]], [[0, up]], DARK, 500, 3)
        made.text((73 + 134 * row, 258), name)
        chart.dots([(depth, up)], UPPER)
        chart.text((depth + 0.05, up + 0.008), name, "start")
    return made
