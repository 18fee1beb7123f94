"""A pin in a hole of the same radius, a little too large: the pressure between round faces, straight or curved."""

import numpy as np
from fmc_contact import Contact

from .drawing import DARK, LOWER, THIRD, UPPER, Frame, Picture

FIT, AROUND = 5e-3, (16, 21)


def ring(inner, outer, count, first):
    """Quad8 of a ring, its mid-side nodes on the circles; the first cell begins at an angle."""
    angles = first + np.arange(2 * count) * np.pi / count
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    coords = np.concatenate([inner * circle, outer * circle, (inner + outer) / 2 * circle[::2]])
    at = 2 * np.arange(count)
    after = (at + 2) % (2 * count)
    n = 2 * count
    side = 2 * n + np.arange(count)
    cells = np.column_stack([at, n + at, n + after, after, side, n + at + 1, np.roll(side, -1), at + 1])
    return coords, cells


def radii(coords, cells, face, order):
    """Angles in degrees and radii along the faces of all cells: straight from corner to corner, or parabolas through their middles."""
    start, middle, end = (coords[cells[:, k], None] for k in face)
    s = np.linspace(0, 1, 13)[:-1, None]
    points = start + s * (end - start) if order == 1 else (1 - s) * (1 - 2 * s) * start + 4 * s * (1 - s) * middle + s * (2 * s - 1) * end
    points = points.reshape(-1, 2)
    angles = np.degrees(np.arctan2(points[:, 1], points[:, 0]))
    order = np.argsort(angles)
    return np.column_stack([angles, np.linalg.norm(points, axis=1)])[order]


def picture():
    pin, hole = ring(0.5, 1 + FIT, AROUND[0], 0.1), ring(1.0, 1.5, AROUND[1], 0)
    made = Picture(300, "Pressure between a pin and its hole, with straight and with curved faces")
    made.text((205, 22), "a pin (orange), its radius too large by δ, in a hole")
    chart = Frame(made, (470, 50, 235, 190), (0, 90), (0, 3))
    made.text((587, 22), "pressure / (k δ)")
    chart.axes("angle", "", [(0, "0°"), (45, "45°"), (90, "90°")], [(0, "0"), (1, "1"), (2, "2"), (3, "3")])
    for row, (order, colour, words) in enumerate(((1, THIRD, "straight faces"), (2, DARK, "curved faces"))):
        bodies = [(coords, cells if order == 2 else cells[:, :4]) for coords, cells in (pin, hole)]
        coords = np.concatenate([bodies[0][0], bodies[1][0]])
        used, cells = np.unique(np.concatenate([bodies[0][1], bodies[1][1] + len(bodies[0][0])]), return_inverse=True)
        contact = Contact(coords[used], cells.reshape(-1, 4 * order), "quad" if order == 1 else "quad8", stiffness=1 / FIT)
        points = contact.contact_points(coords[used])
        angles = np.degrees(np.arctan2(points.position[:, 1], points.position[:, 0]))
        shown = (angles > 0) & (angles < 90) & (points.area > 1e-3)
        chart.dots(np.column_stack([angles, points.pressure])[shown], colour, 4)
        made.key((560, 64 + 22 * row), colour, words)

        scene = Frame(made, (60, 40 + 110 * row, 340, 90), (0, 90), (1 - 5 * FIT, 1 + 3 * FIT))
        outer, inner = radii(*pin, (1, 5, 2), order), radii(*hole, (0, 7, 3), order)
        scene.shapes([[(-180, 0.9), *outer, (180, 0.9)]], UPPER, None, opacity=0.45)
        scene.shapes([[(-180, 1.1), *inner, (180, 1.1)]], LOWER, None, opacity=0.45)
        made.text((66, 56 + 110 * row), words, "start", size=13)
        made.text((54, scene.at((0, 1))[1] + 4), "1", "end", size=13)
        made.text((54, scene.at((0, 1 + FIT))[1] - 2), "1 + δ", "end", size=13)
    made.text((60, 262), "0°", "start", size=13)
    made.text((400, 262), "90°", "end", size=13)
    made.text((230, 262), "radius over angle")
    return made
