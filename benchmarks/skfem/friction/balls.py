"""Two balls, pressed together and dragged along one another: under Q < mu P the contact, of radius a, sticks within
c = a (1 - Q / mu P)^(1/3) (Mindlin 1949). Without lateral contraction, nu = 0, the stick is a circle.

One half, y > 0, of both; hexahedra that do not match.
"""

import numpy as np
from bodies import Bodies, grid
from cylinders import _graded
from scipy.integrate import trapezoid

YOUNG, RADIUS, MU, WIDTH = 200.0, 32.0, 0.3, 1.0
PRESS = 4 * (YOUNG / 2) * WIDTH**3 / (3 * RADIUS / 2)
"""P that gives the radius a = ``WIDTH`` by Hertz."""
LARGEST_PUSH = MU * PRESS


def loop_area(largest):
    """Exact work lost in a cycle between -+ ``largest`` mu P, nu = 0: the area between the ways there and back of Mindlin
    and Deresiewicz 1953, delta = C (2 (1 - (Q* - Q) / 2 mu P)^(2/3) - (1 - Q* / mu P)^(2/3) - 1), C = 3 mu P / 4 a G."""
    full = 3 * MU * PRESS / (16 * WIDTH) * 2 * 2 / (YOUNG / 2)
    q = np.linspace(-largest, largest, 200_001)
    back = 2 * (1 - (largest - q) / 2) ** (2 / 3) - (1 - largest) ** (2 / 3) - 1
    return MU * PRESS * full * trapezoid(back + back[::-1], q)


def _ball(facets, sign, ratio, reach):
    size = WIDTH / facets
    even = _graded(np.linspace(0, 1.2 * WIDTH, round(1.2 * facets) + 1), size, ratio, reach * WIDTH)
    x, height = np.concatenate([-even[:0:-1], even]), _graded([0, size], size, ratio, reach * WIDTH)
    top = reach * WIDTH

    def place(p):
        gap = (p[0] ** 2 + p[1] ** 2) / (2 * RADIUS)
        return np.array([sign * p[0], p[1], sign * (gap + p[2] / height[-1] * (top - gap))])

    return grid(x, even, height, place=place)


class Balls:
    def __init__(self, facets=5, factor=2, law="depth", ratio=1.6, reach=5):
        meshes = [_ball(facets, 1, ratio, reach), _ball(round(0.8 * facets), -1, ratio, reach)]
        self.bodies = bodies = Bodies(meshes, [YOUNG] * 2, 0.0, factor * YOUNG * facets / WIDTH, law)
        far = bodies.dofs(lambda p: p[2] > (reach - 1e-6) * WIDTH)
        bottom = bodies.dofs(lambda p: p[2] < -(reach - 1e-6) * WIDTH, 1)
        plane = np.concatenate([bodies.dofs(lambda p: p[1] < 1e-9, body)[1] for body in (0, 1)])
        bodies.contact.contact.mesh.set_symmetry_nodes(plane // 3)
        still = np.union1d(plane, np.concatenate([bottom.ravel(), far[1]]))
        (still, self.along, self.down), single = bodies.move_as_one([still, far[0], far[2]])
        self.still, self.ends = [still], (far[0], far[2])
        # The upper ball is moved down as one until it overlaps.
        upper = np.flatnonzero((single < bodies.offsets[1]) & (single % 3 == 2))
        bodies.z[np.append(upper, self.down)] = -0.1 * WIDTH**2 / RADIUS

    def load(self, pressed, dragged):
        for members, force in zip(self.ends, (dragged * MU * PRESS, -pressed * PRESS)):
            self.bodies.load[members] = force / 2 / len(members)

    def press(self, steps=3):
        for step in range(1, steps + 1):
            self.load((step / steps) ** 2, 0.0)
            self.bodies.solve([*self.still, self.along])
        self.bodies.begin_friction(MU)

    def loop(self, largest=0.6, quarter=5):
        """To Q = ``largest`` mu P and to and fro: Q by mu P and displacement after every step, what every step dissipates,
        and iterations. The loop proper begins with the step ``quarter - 1``."""
        way = np.linspace(0, largest, quarter + 1)[1:]
        down, up = np.linspace(largest, -largest, 2 * quarter + 1)[1:], np.linspace(-largest, largest, 2 * quarter + 1)[1:]
        loads, places, lost, counts = np.concatenate([way, down, up]), [], [], []
        for dragged in loads:
            counts.append(self.drag(dragged)[0])
            places.append(self.bodies.z[self.along].item())
            # Of both halves.
            lost.append(2 * self.bodies.result.friction.dissipation)
        return loads, np.array(places), np.array(lost), counts

    def drag(self, dragged):
        """One step; its iterations, and c / a by the areas that stick and slide."""
        self.load(1.0, dragged)
        count = self.bodies.solve(self.still)
        friction = self.bodies.result.friction
        self.bodies.commit()
        return count, np.sqrt(friction.stick_area / (friction.stick_area + friction.slip_area))
