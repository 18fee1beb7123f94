"""The equilibrium with closed gaps next to one with small gaps: by Newton's method for unknowns and multipliers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np

from ..contact import Contact
from ..errors import FmcError, NoStepError
from ..friction import WIDTH
from .at_equilibrium import AtEquilibrium
from .bodies import Bodies, Residual, Solve
from .host import Host, Refused
from .saddle import Saddle
from .unknowns import Moved

CLOSED = 1e-9
"""Gap by the extent of the mesh that is closed: it changes derivatives by no more than differences do."""

LAST = 1e-5
"""Step by the extent after which no other is made: the next is its square."""

STEPS = 10
"""At most. From what the search leaves, two or three are made."""


@dataclass
class End:
    """Input of the search that found an equilibrium."""

    given: Union[Residual, Host]
    solve: Optional[Solve]
    contact: Any
    unknowns: Moved
    solved_for: np.ndarray
    x: np.ndarray
    forces: np.ndarray
    reach: float
    slip: np.ndarray


def slip_of(contact: Contact) -> np.ndarray:
    """Elastic slip that was carried into the step; no rows where none has begun."""
    try:
        return contact.friction.slip
    except NoStepError:
        return np.zeros((0, WIDTH))


class Place:
    """The bodies and the contact at unknowns, with the multipliers that the contact has then."""

    def __init__(self, end: End, bodies: Bodies, x: np.ndarray) -> None:
        self.x, self.coords = x, end.unknowns.coords(x)
        bodies_forces, _ = bodies.forces(x, True)
        self.at = AtEquilibrium(end.unknowns.inner, self.coords, end.reach)
        self.saddle = Saddle(self.at, bodies.matrix, end.unknowns.of_coordinate, end.solved_for, end.solve)
        self.forces = end.unknowns.inner.evaluate(self.coords).forces.ravel()
        self.residual = bodies_forces - self.saddle.to_coords.T @ self.forces
        self.extent = float(np.ptp(self.coords, axis=0).max())


@contextmanager
def multipliers_put_back(contact: Contact) -> Iterator[None]:
    """Afterwards the contact has its present multipliers again."""
    kept = contact.multipliers.values
    try:
        yield
    finally:
        if len(kept):
            contact.multipliers.values = kept


def closed(end: End, bodies: Bodies, found: Place) -> Optional[Place]:
    """The same with closed gaps; the contact has its multipliers then. ``None`` where that is not found."""
    contact, place = end.unknowns.inner, found
    if np.abs(found.at.gaps).max(initial=0.0) <= CLOSED * found.extent:
        return found
    try:
        for _ in range(STEPS):
            step, shifts = place.saddle.closing(place.residual, place.at.gaps * place.at.areas)
            there = place.x + step
            values = place.at.values.copy()
            values["shift"] += shifts
            values["towards"][:, : place.at.dim] = place.at.towards(end.unknowns.coords(there)).reshape(-1, place.at.dim)
            contact.multipliers.values = values[values["shift"] > 0]
            place = Place(end, bodies, there)
            if np.abs(place.saddle.to_coords @ step).max() <= LAST * found.extent:
                return place
    except (Refused, FmcError, RuntimeError, np.linalg.LinAlgError):
        # Where bodies cannot be, a gap out of reach, a singular system: too far from an equilibrium with closed gaps.
        pass
    return None
