"""A folded strip whose arms are pressed together and pulled along one another: one body in contact with itself, or two.

The lower arm is held at its bottom; the upper one, which goes over into it by the bend, is pressed down and pulled.
"""

import numpy as np
from bodies import Bodies, grid

YOUNG, MU, LENGTH, HEIGHT, GAP = 1e3, 0.3, 2.0, 0.25, 0.02


def _strip(cells):
    """Along the middle line of the fold: lower arm, bend, upper arm."""
    straight, turn = LENGTH, np.pi * (GAP + HEIGHT) / 2
    size = LENGTH / cells
    bend = max(6, round(turn / size / 2) * 2)
    along = np.concatenate(
        [
            np.linspace(0, straight, cells + 1),
            straight + turn * np.linspace(0, 1, bend + 1)[1:],
            straight + turn + straight * np.linspace(0, 1, round(1.3 * cells) + 1)[1:],
        ]
    )

    def place(p):
        angle = np.pi * np.clip((p[0] - straight) / turn, 0, 1)
        # From the middle line outwards.
        radius = (GAP + HEIGHT) / 2 + (p[1] - 0.5) * HEIGHT
        back = np.clip(p[0] - straight - turn, 0, None)
        x = np.where(p[0] < straight, p[0], straight - back)
        return np.array([x + radius * np.sin(angle), -radius * np.cos(angle)])

    return grid(along, np.linspace(1, 0, 5), place=place)


class Fold:
    def __init__(self, cells=24, apart=False, law="depth"):
        mesh = _strip(cells)
        x = mesh.p[:, mesh.t].mean(axis=1)
        numbers = (x[1] > 0).astype(int) if apart else np.zeros(mesh.t.shape[1], int)
        options = {"bodies": numbers, "self_contact": not apart}
        self.bodies = bodies = Bodies([mesh], [YOUNG], 0.3, 10 * YOUNG * cells / LENGTH, law, **options)
        reach = GAP / 2 + HEIGHT
        self.bottom = bodies.dofs(lambda p: (p[1] < -reach + 1e-9) & (p[0] < LENGTH - 1e-9)).ravel()
        self.top = bodies.dofs(lambda p: (p[1] > reach - 1e-9) & (p[0] < LENGTH / 2 - 1e-9))

    def pull(self, steps=10, down=0.024, along=-0.01):
        """Force along, force down at the upper arm and what is dissipated, at every step, and iterations."""
        bodies = self.bodies
        held = np.concatenate([self.bottom, *self.top])
        values, count = np.zeros(len(held)), len(self.top[0])
        bodies.begin_friction(MU)
        # Two bodies touch across the bend from the start, so their slip counts straight where the arms touch. One body does the same.
        bodies.straight_slip = True
        forces, counts = [], []
        for step in range(1, 2 * steps + 1):
            values[len(self.bottom) : -count] = along * max(0, step / steps - 1)
            values[-count:] = -down * min(1, step / steps)
            counts.append(bodies.solve(held, values))
            lost = bodies.result.friction.dissipation
            forces.append([*(bodies.reactions[axis].sum() for axis in self.top), lost])
            bodies.commit()
        return np.array(forces), counts
