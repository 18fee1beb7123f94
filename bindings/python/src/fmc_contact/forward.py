"""Derivatives of energy and forces along a direction: the forward twin of ``gradients``."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional

import numpy as np

from .errors import UnsupportedError

if TYPE_CHECKING:
    from .contact import Contact


class Slopes(NamedTuple):
    """Result of ``Contact.jvp``.

    Attributes
    ----------
    energy : float
        Rate of the contact energy.
    forces : ndarray, (n, dim)
        Rates of the nodal forces.

    Examples
    --------
    >>> contact.jvp(coords, np.ones((8, 2))).forces.shape
    (8, 2)
    """

    energy: float
    forces: np.ndarray


def slopes(
    contact: Contact,
    coords: np.ndarray,
    motion: Optional[np.ndarray],
    positions: Optional[np.ndarray],
    rotations: Optional[np.ndarray],
    stiffness: float,
) -> Slopes:
    """Rates at ``coords``. What ``vjp`` refuses, this refuses."""
    rates = {"coords": motion, "positions": positions, "rotations": rotations}
    asked = [name for name, rate in rates.items() if rate is not None] + ["stiffness"] * (stiffness != 0.0)
    seeds = np.zeros((contact.unknown_count, contact.dim))
    found = contact.vjp(coords, seeds, 1.0, asked)
    energy = sum(float((getattr(found, name) * rate).sum()) for name, rate in rates.items() if rate is not None)
    forces = np.zeros(seeds.shape)
    if any(rate is not None for rate in rates.values()):
        forces -= _along(contact, coords, motion, positions, rotations)
    if stiffness != 0.0:
        shared = contact.options["stiffness"]
        slides = contact.evaluate(coords).friction
        if slides.stick_area + slides.slip_area > 0.0 and contact.options["friction_stiffness"] > 0.0:
            raise UnsupportedError("rates of frictional forces by a stiffness where sticking contact has a friction_stiffness of its own")
        if any(contact.pairs.options(pair.a, pair.b)["law"] is not None for pair in found.pairs) or shared <= 0.0:
            raise UnsupportedError("rates by a stiffness that not all pairs have from the option 'stiffness'")
        energy += stiffness * found.stiffness
        forces += stiffness / shared * contact.evaluate(coords).forces
    return Slopes(energy, forces)


def _along(
    contact: Contact,
    coords: np.ndarray,
    motion: Optional[np.ndarray],
    positions: Optional[np.ndarray],
    rotations: Optional[np.ndarray],
) -> np.ndarray:
    """The tangent times a motion of nodes and obstacles, at the nodes."""
    count, obstacles, dim = contact.unknown_count, contact.obstacles.count, contact.dim
    parts = contact.tangent_parts(coords, obstacles=True)
    if rotations is not None and parts.size == (count + obstacles) * dim:
        contact.obstacles.set_rotations(True)
        try:
            parts = contact.tangent_parts(coords, obstacles=True)
        finally:
            contact.obstacles.set_rotations(False)
    along = np.zeros((parts.size // dim, dim))
    if motion is not None:
        along[:count] = motion
    if positions is not None:
        along[count : count + obstacles] = positions
    if rotations is not None and obstacles:
        # In the plane the angle is the first entry.
        along[count + obstacles :] = rotations if dim == 3 else rotations[:, [2, 2]] * [1.0, 0.0]
    moved: np.ndarray = (parts @ along)[: count * dim].reshape(count, dim)
    return moved
