"""Capstan: a thin strip around half a rigid drum, pulled by T1 at one end; at the other it slides at T2.

Euler and Eytelwein: T2 / T1 = exp(mu beta). Friction acts at the radius R of the drum and the tension in the middle of a
strip of thickness t: balance of moments about the axis gives dT (R + t/2) = mu T R dθ, the exponent mu beta R / (R + t/2).
"""

import numpy as np
from bodies import Bodies, grid

YOUNG, RADIUS, PULL = 1e6, 1.0, 1.0
SOFT = 0.1
"""k by E / h. Bent over the drum, a strip of a third of its facets' length is far softer than its material: with 1 and 10
the result is the same within 1e-3, in 8 and 9 iterations a step."""


class Capstan:
    def __init__(self, cells=60, thickness=0.02, coefficient=0.3, law="depth"):
        angle, height = np.linspace(0, np.pi, cells + 1), np.linspace(RADIUS, RADIUS + thickness, 3)
        mesh = grid(angle, height, place=lambda p: np.array([-p[1] * np.cos(p[0]), p[1] * np.sin(p[0])]))
        self.coefficient, self.thickness = coefficient, thickness
        facet = RADIUS * np.pi / cells
        self.strip = Bodies([mesh], [YOUNG], 0.0, SOFT * YOUNG / facet, law)
        if law == "fiber":
            # The estimator ``exact`` knows no curved obstacles: a polygon with corners on the nodes and between them.
            turn = np.linspace(0, 2 * np.pi, 8 * cells, endpoint=False)
            self.strip.contact.contact.obstacles.add_convex_hull(RADIUS * np.column_stack([np.cos(turn), np.sin(turn)]))
        else:
            self.strip.contact.contact.obstacles.add_ball(RADIUS)
        # As deep as the tension presses it; a chord is below the drum by itself.
        deep = PULL / RADIUS / (SOFT * YOUNG / facet) - facet**2 / 12 / RADIUS
        self.strip.z[:] = (-deep * mesh.p / np.linalg.norm(mesh.p, axis=0)).T.ravel()
        self.loose = self.strip.dofs(lambda p: (p[0] > 0) & (np.abs(p[1]) < 1e-9))[1]
        self.pulled = self.strip.dofs(lambda p: (p[0] < 0) & (np.abs(p[1]) < 1e-9))[1]
        # Linear along the thickness, for bending is none of the problem: a load of the middle.
        self.strip.load[self.loose] = -PULL * np.array([0.25, 0.5, 0.25])

    def pull(self, steps=10):
        """Drags the end by one and a half of what stretches the strip until all of it slides. T2 by T1 after every step, and iterations."""
        strip = self.strip
        strip.solve(self.pulled, strip.z[self.pulled])
        strip.begin_friction(self.coefficient)
        stretch = (np.exp(self.coefficient * np.pi) - 1) / self.coefficient - np.pi
        way = 1.5 * stretch * PULL * RADIUS / YOUNG / self.thickness
        rest = strip.z[self.pulled]
        tensions, counts = [], []
        for part in np.linspace(0, 1, steps + 1)[1:]:
            counts.append(strip.solve(self.pulled, -part * way + rest))
            tensions.append(-strip.reactions[self.pulled].sum() / PULL)
            strip.commit()
        return np.array(tensions), counts

    def exact(self):
        return np.exp(self.coefficient * np.pi)

    def exact_of_thick_strip(self):
        return np.exp(self.coefficient * np.pi / (1 + self.thickness / 2 / RADIUS))

