"""A corner slides off a corner: the force turns and ends without a jump."""

import numpy as np
from fmc_contact import Contact

from .bodies import grid, together
from .drawing import DARK, LOWER, THIRD, UPPER, Frame, Picture

DEEP, SHOWN = 0.12, {"a": -0.45, "b": -0.12, "c": -0.04}


def picture():
    lower, upper = grid((4, 4), (-1, 0), (-1, 0)), grid((4, 4), (0, 1), (-DEEP, 1 - DEEP))
    coords, cells, firsts = together(lower, upper)
    contact = Contact(coords, cells, "quad", stiffness=1 / DEEP)

    def at(slid):
        moved = coords.copy()
        moved[firsts[1] :, 0] += slid
        return moved, np.array(contact.evaluate(moved).bodies[1].force)

    places = np.linspace(-0.7, 0.1, 161)
    forces = np.array([at(slid)[1] for slid in places])

    made = Picture(300, "A corner slides off a corner, and the force on it")
    made.text((205, 22), "a square slides off another: direction of the force")
    chart = Frame(made, (470, 50, 235, 190), (-0.7, 0.1), (0, 0.62))
    made.text((587, 22), "force on the upper square")
    chart.line(np.column_stack([places, forces[:, 1]]), DARK)
    chart.line(np.column_stack([places, forces[:, 0]]), THIRD)
    chart.axes("place of the corner", "", [(-0.6, "−0.6"), (-0.3, "−0.3"), (0, "0")], [(0, "0"), (0.3, "0.3"), (0.6, "0.6")])
    made.key((575, 64), DARK, "upwards", line=True)
    made.key((575, 86), THIRD, "to the right", line=True)
    for row, (name, slid) in enumerate(SHOWN.items()):
        scene = Frame(made, (12 + 134 * row, 44, 122, 190), (-0.55, 0.55), (-0.75, 0.75), equal=True)
        moved, force = at(slid)
        for body, colour in enumerate((LOWER, UPPER)):
            scene.mesh(moved, cells[(cells[:, 0] >= firsts[body]) & (cells[:, 0] < firsts[body + 1])], colour)
        middle = np.array([[max(slid, -0.3 + slid / 2) / 2, -DEEP / 2]])
        scene.arrows(middle, [force / np.linalg.norm(force)], DARK, 52, 3)
        made.text((73 + 134 * row, 258), name)
        chart.text((slid + 0.015, np.interp(slid, places, forces[:, 1]) + 0.03), name, "start")
    return made
