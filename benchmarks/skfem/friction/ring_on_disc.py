"""A ring, pressed evenly on a disc that turns: its torque is 2/3 mu P (Ro³ - Ri³) / (Ro² - Ri²).

3D, hexahedra on hexahedra that do not match. The disc is rigid, so that the pressure stays even. Polygons have the area of
their circles.
"""

import numpy as np
from bodies import Bodies, grid

YOUNG, INNER, OUTER, PRESSURE, MU = 1e3, 0.5, 1.0, 1.0, 0.3


def _ring(inner, outer, low, high, sectors, rings):
    """Closed: the last nodes around are the first."""
    line = np.linspace(inner, outer, rings + 1)
    mesh = grid(line, np.linspace(0, 1, sectors + 1), np.array([low, high]))
    p, t = mesh.p, mesh.t
    key = np.round(np.column_stack([p[0], p[1] % 1.0, p[2]]), 9)
    _, first, number = np.unique(key, axis=0, return_index=True, return_inverse=True)
    turn = 2 * np.pi / sectors
    radius = p[0, first] * np.sqrt(turn / np.sin(turn))
    angle = 2 * np.pi * (p[1, first] % 1.0)
    points = np.array([radius * np.cos(angle), radius * np.sin(angle), p[2, first]])
    return type(mesh)(points, number.ravel()[t])


class RingOnDisc:
    def __init__(self, sectors=24, rings=3, law="depth"):
        meshes = [
            _ring(0.2, 1.3, -0.2, 0.0, round(0.7 * sectors), round(1.4 * rings)),
            _ring(INNER, OUTER, 0.0, 0.2, sectors, rings),
        ]
        k = 10 * YOUNG / ((OUTER - INNER) / rings)
        self.bodies = bodies = Bodies(meshes, [YOUNG] * 2, 0.0, k, law)
        self.disc = np.arange(bodies.offsets[1])
        top = bodies.dofs(lambda p: p[2] > 0.2 - 1e-9, 1)
        self.turned, self.load = top[:2].ravel(), top[2]
        x = meshes[1].p[:, meshes[1].p[2] > 0.2 - 1e-9]
        # An even pressure, as a grid of rings has it: half as much at its rims.
        radius = np.hypot(x[0], x[1])
        rim = np.isclose(radius, radius.min()) | np.isclose(radius, radius.max())
        width = (radius.max() - radius.min()) / rings
        share = np.where(rim, 0.5 * (radius + np.where(radius < 0.8, 0.25, -0.25) * width), radius)
        self.force = PRESSURE * np.pi * (OUTER**2 - INNER**2)
        bodies.load[self.load] = -self.force * share / share.sum()
        bodies.z[bodies.offsets[1] + 2 :: 3] = -PRESSURE / k

    def exact(self):
        return 2 / 3 * MU * self.force * (OUTER**3 - INNER**3) / (OUTER**2 - INNER**2)

    def turn(self, steps=6, angle=3e-3):
        """Torque by the exact one after every step, and iterations."""
        bodies = self.bodies
        held, values = np.concatenate([self.disc, self.turned]), np.zeros(len(self.disc) + len(self.turned))
        bodies.solve(held, values)
        bodies.begin_friction(MU)
        x, torques, counts = self.bodies.meshes[0].p, [], []
        for step in range(1, steps + 1):
            turned = angle * step / steps
            values[: len(self.disc)] = (turned * np.array([-x[1], x[0], 0 * x[0]])).T.ravel()
            counts.append(bodies.solve(held, values))
            torques.append(-bodies.result.bodies[0].moment[2] / self.exact())
            bodies.commit()
        return np.array(torques), counts
