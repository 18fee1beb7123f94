"""What holds two bodies: traction over opening and over sliding for every kind of interface."""

import numpy as np
from fmc_contact import Contact

from .drawing import LOWER, UPPER, Frame, Picture

MU, STIFFNESS = 0.4, 50.0
KINDS = {
    "contact": {"friction_coefficient": MU},
    "tied": {"interface": "tied"},
    "no separation": {"interface": "no_separation"},
    "rough": {"interface": "rough"},
    "cohesive": {"interface": "cohesive", "normal_strength": 1.0, "normal_energy": 0.04, "stiffness": STIFFNESS},
}
COORDS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1], [1, 1], [1, 2], [0, 2]], float)
OPENINGS, SLIDES, PRESSED = np.linspace(-0.02, 0.1, 61), np.linspace(0, 0.1, 51), 0.02


def tractions(options, moves):
    """Force on the upper square, which is moved from the lower one by each of these in turn; every move is a step."""
    contact = Contact(COORDS, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", bodies=[0, 1], stiffness=STIFFNESS)
    contact.pairs.set(0, 1, **options)
    contact.friction.begin_step(COORDS)
    found = []
    for move in moves:
        coords = COORDS.copy()
        coords[4:] += move
        found.append(contact.evaluate(coords).forces[4:].sum(axis=0))
        contact.friction.commit_step(coords)
    return -np.array(found)


def picture():
    made = Picture(362, "Traction over opening and over sliding for five kinds of interface")
    for column, (name, options) in enumerate(KINDS.items()):
        left = 46 + 136 * column
        made.text((left + 58, 22), name, bold=True)
        over = Frame(made, (left, 40, 116, 116), (-0.02, 0.1), (-1.2, 2.0))
        over.line([(-0.02, 0), (0.1, 0)], "#bbb", 1)
        over.line([(0, -1.2), (0, 2.0)], "#bbb", 1)
        over.line(np.column_stack([OPENINGS, tractions(options, [(0, one) for one in OPENINGS])[:, 1]]), LOWER)
        along = Frame(made, (left, 210, 116, 116), (0, 0.1), (-0.1, 2.0))
        along.line([(0, 0), (0.1, 0)], "#bbb", 1)
        along.line([(0, -0.1), (0, 2.0)], "#bbb", 1)
        along.line(np.column_stack([SLIDES, tractions(options, [(one, -PRESSED) for one in SLIDES])[:, 0]]), UPPER)
    made.text((360, 182), "normal traction over opening; pressure is negative")
    made.text((360, 348), "tangential traction over sliding, under pressure")
    return made
