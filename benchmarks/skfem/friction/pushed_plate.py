"""GRECO's plate (code_aster SSNV128): pressed on a rigid plane and pushed along it, with mu = 1 and displacements published."""

import numpy as np
from bodies import Bodies, grid

YOUNG, SIDE, PUSH, PRESS = 1.3e11, 0.04, 15e7, 5e7
PLACES = 1e-3 * np.array([0, 1.25, 5, 7.5, 11.25])
PUBLISHED = 1e-5 * np.array([2.86, 2.72, 2.28, 1.98, 1.54])
"""u_x of the lower side at ``PLACES``."""


class Plate:
    def __init__(self, cells, factor=10, law="depth", penetration=None):
        line = np.linspace(0, SIDE, cells + 1)
        mesh, facet = grid(line, line), SIDE / cells
        k = factor * YOUNG / facet
        self.plate = plate = Bodies([mesh], [YOUNG], 0.2, k, law)
        plate.contact.contact.obstacles.add_half_space((0, 0), (0, 1))
        share = np.full(cells + 1, facet)
        share[[0, -1]] /= 2
        self.penetration = penetration
        self.full = np.zeros(plate.size)
        self.full[plate.dofs(lambda p: p[0] < 1e-9)[0]] = PUSH * share
        self.full[plate.dofs(lambda p: p[1] > SIDE - 1e-9)[1]] = -PRESS * share
        self.held = plate.dofs(lambda p: p[0] > SIDE - 1e-9)[0]
        self.lower = plate.dofs(lambda p: p[1] < 1e-9)
        plate.z[1::2] = -PRESS / k
        plate.begin_friction(1.0)

    def push(self, steps=1):
        """u_x at ``PLACES``, and iterations."""
        plate, counts = self.plate, []
        for step in range(1, steps + 1):
            plate.load = self.full * step / steps
            counts.append(plate.solve(self.held, penetration=self.penetration))
            self.friction = plate.result.friction
            plate.commit()
        return np.interp(PLACES, plate.meshes[0].p[0, self.lower[0] // 2], plate.u[self.lower[0]]), counts
