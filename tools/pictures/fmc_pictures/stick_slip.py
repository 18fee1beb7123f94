"""An elastic block is pressed on a floor and pulled: it slides from its edges inwards, and then as a whole."""

import numpy as np
from fmc_contact import Contact, find_equilibrium

from .bodies import grid, stiffness
from .drawing import DARK, LOWER, UPPER, Frame, Picture

MU, YOUNG, PRESS, PULLS, SHOWN = 0.4, 1.0, 0.02, np.linspace(0.002, 0.04, 20), (2, 11)


def picture():
    coords, cells = grid((16, 6), (-1, 1), (0, 1))
    matrix, h = stiffness(coords, cells, YOUNG), 2 / 16
    contact = Contact(coords, cells, "quad", stiffness=100 * YOUNG / h, friction_coefficient=MU)
    floor = contact.obstacles.add_half_space((0, 0), (0, 1))
    top = np.flatnonzero(coords[:, 1] == 1)
    free = np.setdiff1d(np.arange(coords.size), np.concatenate([2 * top, 2 * top + 1]))
    host = lambda x: (matrix @ (x - coords).ravel(), matrix)

    contact.friction.begin_step(coords)
    x, states = coords, []
    for pull in (0.0, *PULLS):
        prescribed = x.copy()
        prescribed[top] = coords[top] + [pull, -PRESS]
        found = find_equilibrium(host, contact, x, free, prescribed)
        x = found.x
        nodal, force = contact.nodal_contact(x), np.array(found.result.obstacles[floor].force)
        states.append((pull, x, nodal, abs(force[0]) / (MU * abs(force[1]))))
        contact.friction.commit_step(x)

    made = Picture(300, "An elastic block is pressed on a floor and pulled: sticking and sliding nodes")
    made.text((205, 22), "a pressed block is pulled to the right")
    chart = Frame(made, (470, 50, 235, 190), (0, 0.042), (0, 1.25))
    made.text((587, 22), "pull / (μ × normal force)")
    chart.line([(0, 1), (0.042, 1)], "#bbb", 1)
    chart.line([(pull, ratio) for pull, _, _, ratio in states], DARK, 1.5)
    chart.axes("motion of the top", "", [(0, "0"), (0.01, "0.01"), (0.02, "0.02"), (0.04, "0.04")], [(0, "0"), (0.5, "0.5"), (1, "1")])
    for row, at in enumerate(SHOWN):
        pull, x, nodal, ratio = states[at + 1]
        scene = Frame(made, (12 + 205 * row, 54, 190, 120), (-1.08, 1.15), (-0.1, 1.2), equal=True)
        shown = coords + 3 * (x - coords)
        scene.mesh(shown, cells, LOWER)
        scene.line([(-1.08, -0.03), (1.15, -0.03)], DARK, 1.5)
        scene.dots(shown[nodal.slides & (nodal.area > 0.25 * h)], UPPER, 4)
        scene.dots(shown[nodal.sticks & (nodal.area > 0.25 * h)], LOWER, 4)
        made.text((107 + 205 * row, 196), "abc"[row])
        chart.dots([(pull, ratio)], DARK)
        chart.text((pull - 0.0005, ratio + 0.06), "abc"[row], "end")
    chart.text((0.037, 1.06), "all slide", size=13)
    made.key((80, 240), LOWER, "node sticks")
    made.key((220, 240), UPPER, "node slides")
    return made
