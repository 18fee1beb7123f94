"""Two cylinders, pressed together and then dragged along one another: Cattaneo and Mindlin.

Under Q < mu P the contact, of half width a, sticks within c = a sqrt(1 - Q / mu P), and the traction is
mu p0 (sqrt(1 - x²/a²) - c/a sqrt(1 - x²/c²)). A load that goes to and fro loses the area of a loop in every cycle. A load that
grows with the pressure from nothing, in proportion, makes nothing slide: q = (Q / P) p.
"""

import numpy as np
from bodies import Bodies, grid
from scipy.integrate import trapezoid

YOUNG, POISSON, RADIUS, PRESS, MU = 200.0, 0.3, 8.0, 0.1, 0.3
MODULUS = YOUNG / (2 * (1 - POISSON**2))
WIDTH = np.sqrt(4 * PRESS * RADIUS / (np.pi * MODULUS))
"""a."""
PEAK = 2 * PRESS / (np.pi * WIDTH)
"""p0."""


def _root(x):
    return np.sqrt(np.clip(1 - x**2, 0, None))


def traction(x, dragged):
    """Exact q under Q = ``dragged`` mu P."""
    inner = WIDTH * np.sqrt(1 - dragged)
    return MU * PEAK * (_root(x / WIDTH) - inner / WIDTH * _root(x / inner))


def loop_area(largest):
    """Exact work lost in a cycle between -+ ``largest`` mu P."""
    t = np.linspace(0, largest, 200_001)
    moment = trapezoid(-t * np.log1p(-t), t)
    left = (1 - largest) * np.log1p(-largest) + largest
    return (MU * PRESS) ** 2 / (np.pi * MODULUS) * (8 * moment - 4 * largest * left)


def _graded(first, size, ratio, reach):
    values = list(first)
    while values[-1] < reach:
        size *= ratio
        values.append(values[-1] + size)
    return np.array(values)


def _cylinder(facets, sign, ratio, reach):
    """A block with a round side, ``facets`` to the half width of contact, growing away from it."""
    size = WIDTH / facets
    even = _graded(np.linspace(0, 1.5 * WIDTH, round(1.5 * facets) + 1), size, ratio, reach * WIDTH)
    x, height = np.concatenate([-even[:0:-1], even]), _graded([0, size], size, ratio, reach * WIDTH)
    top = reach * WIDTH

    def place(p):
        gap = p[0] ** 2 / (4 * RADIUS)
        return np.array([sign * p[0], sign * (gap + p[1] / height[-1] * (top - gap))])

    return grid(x, height, place=place)


class Cylinders:
    """``facets``: to the half width, of the upper body; of the lower one 0.7 times as many. ``factor``: k by E / h."""

    def __init__(self, facets=24, factor=2, law="depth", ratio=1.3, reach=20):
        meshes = [_cylinder(count, sign, ratio, reach) for count, sign in ((facets, 1), (round(0.7 * facets), -1))]
        self.bodies = bodies = Bodies(meshes, [YOUNG] * 2, POISSON, factor * YOUNG * facets / WIDTH, law)
        bodies.contact.contact.mesh.set_symmetry_nodes([])
        far = bodies.dofs(lambda p: p[1] > (reach - 1e-6) * WIDTH)
        bottom = bodies.dofs(lambda p: p[1] < -(reach - 1e-6) * WIDTH, 1)
        _, single = bodies.move_as_one([bottom[0], bottom[1], far[0], far[1]])
        # The upper body is moved down as one until it overlaps.
        bodies.z[np.append((single < bodies.offsets[1]) & (single % 2 == 1), [False] * 3 + [True])] = -0.05 * WIDTH**2 / RADIUS
        self.held, (self.along, self.down) = len(single) + np.arange(2), len(single) + np.arange(2, 4)
        self.ends = {self.along: far[0], self.down: far[1]}

    def load(self, pressed, dragged):
        """P = ``pressed`` times the whole, Q = ``dragged`` mu P."""
        bodies = self.bodies
        bodies.load[:] = 0
        for node, force in ((self.along, dragged * MU * PRESS), (self.down, -pressed * PRESS)):
            bodies.load[self.ends[node]] = force / len(self.ends[node])

    def press(self, steps=4):
        """Without friction, and begins it."""
        for step in range(1, steps + 1):
            self.load(step / steps, 0.0)
            self.bodies.solve(np.append(self.held, self.along), 0.0)
        self.bodies.begin_friction(MU)

    def drag(self, dragged, pressed=1.0):
        """One step; its iterations."""
        self.load(pressed, dragged)
        count = self.bodies.solve(self.held)
        self.result = self.bodies.result
        return count

    def profile(self, body=0):
        """Facets of a body in contact, once the step is committed: x of what is in contact by the centre of pressure, q, p,
        and its length. By the law "depth"."""
        bodies, contact = self.bodies, self.bodies.contact
        # Facets are in the order of cells, and no cell near the contact has two.
        order = [m.boundary_facets()[np.argsort(m.f2t[0, m.boundary_facets()], kind="stable")] for m in bodies.meshes]
        # Rows of facet, partner (kind and index), side, slip and how far it slid; a facet that carries nothing has none.
        rows = contact.contact.friction.slip
        slip = np.zeros(sum(map(len, order)))
        slip[rows[:, 0].astype(int)] = rows[:, 4]
        slip = slip[sum(map(len, order[:body])) :][: len(order[body])]
        q = (1, -1)[body] * contact.contact.options["stiffness"] * slip
        points = contact.contact.contact_points(contact.coords(bodies.u))
        centre = np.average(points.position[:, 0], weights=points.pressure * points.area)
        numbers = {tuple(sorted(ends)): facet for facet, ends in enumerate(bodies.meshes[body].facets[:, order[body]].T)}
        sums = np.zeros((3, len(q)))
        for side in (0, 1):
            # A side with two nodes is a facet, one with four a cell.
            own = (points.partner[:, side] == body) & ((points.nodes[:, side] >= 0).sum(axis=1) == 2)
            first = bodies.offsets[body] // 2
            facets = [numbers[tuple(sorted(ends))] for ends in points.nodes[own, side, :2] - first]
            # Each body bears half of the pressure: its facets stand for half of their length.
            length = 2 * points.area[own]
            parts = np.array([length, length * points.pressure[own], length * (points.position[own, 0] - centre)])
            np.add.at(sums.T, facets, parts.T)
        touching = np.flatnonzero(sums[0])
        length, p, x = sums[0, touching], *(sums[1:, touching] / sums[0, touching])
        rank = np.argsort(x)
        return x[rank], q[touching][rank], p[rank], length[rank]

    def profile_error(self, dragged):
        """In L2, over the facets of both bodies."""
        x, q, _, length = np.concatenate([self.profile(body) for body in (0, 1)], axis=1)
        exact = traction(x, dragged)
        return np.sqrt((length * (q - exact) ** 2).sum() / (length * exact**2).sum())

    def loop(self, largest=0.8, quarter=10):
        """To Q = ``largest`` mu P and to and fro: Q by mu P and displacement after every step, what every step dissipates,
        and iterations. The loop proper begins with the step ``quarter - 1``."""
        way = np.linspace(0, largest, quarter + 1)[1:]
        down, up = np.linspace(largest, -largest, 2 * quarter + 1)[1:], np.linspace(-largest, largest, 2 * quarter + 1)[1:]
        loads = np.concatenate([way, down, up])
        places, lost, counts = [], [], []
        for dragged in loads:
            counts.append(self.drag(dragged))
            places.append(self.bodies.z[self.along])
            lost.append(self.result.friction.dissipation)
            self.bodies.commit()
        return loads, np.array(places), np.array(lost), counts

    def in_proportion(self, dragged=0.5, steps=40):
        """From nothing, P and Q growing together: the error of q / p in L2, and iterations."""
        bodies, guess = self.bodies, self.bodies.z.copy()
        # Where they touch: that they overlap is but a guess for the first iteration.
        bodies.z[:] = 0
        bodies.begin_friction(MU)
        bodies.z = guess
        counts = []
        for step in range(1, steps + 1):
            counts.append(self.drag(dragged * step / steps, step / steps))
            bodies.commit()
        _, q, p, length = np.concatenate([self.profile(body) for body in (0, 1)], axis=1)
        return np.sqrt((length * (q - dragged * MU * p) ** 2).sum() / (length * (dragged * MU * p) ** 2).sum()), counts

    @property
    def stick_width(self):
        """c / a."""
        return self.result.friction.stick_area / (2 * WIDTH)
