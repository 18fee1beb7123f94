"""The reference host's time steps, for hosts that have internal forces and a lumped mass.

    v += h/2 M^-1 f(u)      u += h v      v += h/2 M^-1 f(u)

With several contact sub-steps the contact has steps of its own between the two kicks of the structure.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Callable, Protocol

import numpy as np


class Forces(Protocol):
    """What a host returns at a displacement, on unknowns of its own order."""

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces and strain energy."""

    def contact(self, u: np.ndarray) -> tuple[np.ndarray, Touch]:
        """Contact forces, and what is kept of them."""


@dataclass
class Touch:
    energy: float
    bodies: np.ndarray
    """Sums of the forces on bodies and then on obstacles, (partners, dim)."""


@dataclass
class History:
    """A row for every step, the start first."""

    time: list[float] = field(default_factory=list)
    kinetic: list[float] = field(default_factory=list)
    strain: list[float] = field(default_factory=list)
    contact: list[float] = field(default_factory=list)
    bodies: list[np.ndarray] = field(default_factory=list)
    momentum: list[np.ndarray] = field(default_factory=list)
    seconds: float = 0.0
    """Processor time."""
    contact_seconds: float = 0.0
    """What the contact took of it."""


@dataclass
class Motion:
    """Unknowns of a host, in one order: masses (0 is not allowed), which are held, and the velocities at the start."""

    mass: np.ndarray
    held: np.ndarray
    velocity: np.ndarray
    total: Callable[[float], float] = float
    """Adds up over the ranks."""
    momentum: Callable[[np.ndarray], np.ndarray] = lambda v: np.zeros(0)
    """Momentum of every body, (bodies, dim), from the velocities."""


def run(forces: Forces, motion: Motion, step: float, end: float, substeps: int) -> tuple[np.ndarray, History]:
    """The displacement at the end, and the history."""
    inverse = np.where(motion.held, 0.0, 1.0 / motion.mass)
    u, v = np.zeros_like(motion.mass), np.where(motion.held, 0.0, motion.velocity)
    history = History()

    def note(n: int, strain: float, touch: Touch, bodies: np.ndarray) -> None:
        history.time.append(n * step)
        history.kinetic.append(motion.total(float(0.5 * (motion.mass * v) @ v)))
        history.strain.append(motion.total(strain))
        history.contact.append(touch.energy)
        history.bodies.append(bodies)
        history.momentum.append(motion.momentum(v))

    begin = time.process_time()
    inside, strain = forces.internal(u)
    pushed, touch = forces.contact(u)
    note(0, strain, touch, touch.bodies)
    duration = step / substeps
    for n in range(1, max(int(np.ceil(end / step - 1e-6)), 1) + 1):
        v -= 0.5 * step * inverse * inside
        mean = np.zeros_like(touch.bodies)
        for _ in range(substeps):
            v += 0.5 * duration * inverse * pushed
            u += duration * v
            clock = time.process_time()
            pushed, touch = forces.contact(u)
            history.contact_seconds += time.process_time() - clock
            v += 0.5 * duration * inverse * pushed
            mean += touch.bodies / substeps
        inside, strain = forces.internal(u)
        v -= 0.5 * step * inverse * inside
        note(n, strain, touch, mean)
    history.seconds = time.process_time() - begin
    return u, history
