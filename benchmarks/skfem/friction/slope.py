"""NAFEMS CGS-4: a block is pushed up a gentle slope with friction.

The slope is tan a = 0.1, the block is pressed down by G and pushed at its side. While it slides, balance of the forces on it gives
F / G = (tan a + mu) / (1 - mu tan a). With the published E = 1100 the load tilts the interface itself; with a hundred times that
it does not: there the formula is exact.
"""

import numpy as np
from bodies import Bodies, grid

WEIGHT, SLOPE, WAY = 40.0, 0.1, 0.2


def exact(coefficient):
    return (SLOPE + coefficient) / (1 - coefficient * SLOPE)


class Slope:
    def __init__(self, coefficient, young=1.1e5, law="depth"):
        def below(p):
            return np.array([p[0], p[1] * (0.7 + SLOPE * p[0])])

        def above(p):
            bottom = 0.7 + SLOPE * p[0]
            return np.array([p[0], bottom + p[1] * (2 - bottom)])

        base = grid(np.linspace(0, 6, 13), np.linspace(0, 1, 4), place=below)
        slider = grid(np.linspace(1, 5, 10), np.linspace(0, 1, 4), place=above)
        self.coefficient = coefficient
        self.bodies = bodies = Bodies([base, slider], [young] * 2, 0.0, 10 * young / (4 / 9), law)
        self.bottom = bodies.dofs(lambda p: p[1] < 1e-9).ravel()
        self.side = bodies.dofs(lambda p: p[0] < 1 + 1e-9, 1)[0]
        top = bodies.dofs(lambda p: p[1] > 2 - 1e-9, 1)[1]
        bodies.load[top] = -WEIGHT / len(top)
        self.held = np.concatenate([self.bottom, self.side])

    def push(self, steps=20):
        """F by G after every step, and iterations."""
        bodies, values = self.bodies, np.zeros(len(self.held))
        # A touch of overlap, for only contact holds the block up.
        bodies.z[bodies.offsets[1] + 1 :: 2] -= 1e-9 * WEIGHT
        bodies.solve(self.held, values)
        bodies.begin_friction(self.coefficient)
        forces, counts = [], []
        for part in np.linspace(0, 1, steps + 1)[1:]:
            values[len(self.bottom) :] = part * WAY
            counts.append(bodies.solve(self.held, values))
            forces.append(bodies.reactions[self.side].sum() / WEIGHT)
            bodies.commit()
        return np.array(forces), counts
