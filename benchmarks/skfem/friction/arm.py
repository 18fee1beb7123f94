"""An arm that presses a block down the more, the more friction holds it: P = P0 + alpha Q, so that Q = mu P0 / (1 - mu alpha)."""

import numpy as np
from bodies import Bodies, grid
from scipy.sparse import csr_matrix

YOUNG, WEIGHT, SPRING = 1e7, 4905.0, 1e6


class Arm:
    """A block, 1 by 0.5, on a rigid plane, pulled at its side by springs; what they pull with, times ``alpha``, presses on
    its top."""

    def __init__(self, coefficient, alpha, law="depth", factor=10):
        mesh = grid(np.linspace(0, 1, 9), np.linspace(0, 0.5, 5))
        self.coefficient, self.alpha = coefficient, alpha
        k = factor * YOUNG / 0.125
        self.block = block = Bodies([mesh], [YOUNG], 0.3, k, law)
        block.contact.contact.obstacles.add_half_space((0, 0), (0, 1))
        block.load[1::2] = -WEIGHT / block.size * 2
        block.z[1::2] = -WEIGHT / k
        self.side = block.dofs(lambda p: (p[0] > 1 - 1e-9) & (np.abs(p[1] - 0.1875) < 0.07))[0]
        self.top = block.dofs(lambda p: p[1] > 0.5 - 1e-9)[1]
        # Each spring pulls its node by SPRING/2 (end - u), and every node of the top down by alpha of that.
        part = SPRING / len(self.side)
        rows = np.concatenate([self.side, np.tile(self.top, len(self.side))])
        cols = np.concatenate([self.side, np.repeat(self.side, len(self.top))])
        values = np.concatenate([np.full(2, part), np.full(2 * len(self.top), -alpha * part / len(self.top))])
        block.stiffness = block.stiffness + csr_matrix((values, (rows, cols)), block.stiffness.shape)
        self.weight = block.load.copy()

    def exact(self):
        return self.coefficient * WEIGHT / (1 - self.coefficient * self.alpha)

    def force(self, end):
        return SPRING * (end - self.block.u[self.side].mean())

    def pull(self, steps=12):
        """Q by what it is to be after every step, and iterations."""
        block, end = self.block, 0.0
        block.begin_friction(self.coefficient)
        block.solve([])
        block.commit()
        forces, counts = [], []
        for step in range(1, steps + 1):
            end = 2.2 * self.exact() / SPRING * 2 * step / steps
            block.load = self.weight.copy()
            block.load[self.side] += SPRING / len(self.side) * end
            block.load[self.top] -= self.alpha * SPRING * end / len(self.top)
            counts.append(block.solve([]))
            forces.append(self.force(end) / self.exact())
            block.commit()
        return np.array(forces), counts
