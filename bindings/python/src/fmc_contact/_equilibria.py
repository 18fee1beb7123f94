"""Common part of differentiable equilibria of hosts with automatic differentiation: a contact with its parameters, and one adjoint."""

from __future__ import annotations

import warnings
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from .contact import Contact
from .pose import Pose
from .search import Adjoint, Equilibrium, find_equilibrium

Given = Optional[np.ndarray]

Bodies = Callable[[np.ndarray], Any]
"""As ``find_equilibrium`` takes them."""


class Equilibria:
    """Equilibria of a contact as a function of the start, the prescribed values, and the parameters of the contact.

    Each begins with the multipliers of the first moment, so that the same arguments have the same equilibrium."""

    def __init__(self, contact: Contact, free: ArrayLike, options: dict[str, Any]) -> None:
        self.contact, self.free, self.options = contact, free, options
        self._first = contact.multipliers.values
        self._reference: Given = None
        self._last: Optional[tuple[tuple[Any, ...], Equilibrium, np.ndarray]] = None

    def _tell(self, reference: Given, positions: Given) -> None:
        if reference is not None and (self._reference is None or not np.array_equal(reference, self._reference)):
            self.contact.mesh.set_reference(reference)
            self._reference = np.array(reference)
        if positions is not None:
            shape = self.contact.obstacles.count, self.contact.dim
            if np.shape(positions) != shape:
                raise ValueError(f"positions has shape {np.shape(positions)}, expected {shape}")
            for obstacle, position in enumerate(positions):
                pose = self.contact.obstacles.get(obstacle).pose
                self.contact.obstacles.set_pose(obstacle, Pose(position, pose.rotation, pose.scale))

    def solved(self, bodies: Bodies, key: tuple[Any, ...], x: np.ndarray, prescribed: Given, reference: Given, positions: Given) -> Equilibrium:
        """The equilibrium; ``key`` is equal for equal arguments, including the arguments of the bodies."""
        self._tell(reference, positions)
        self.contact.multipliers.values = self._first
        found = find_equilibrium(bodies, self.contact, x, self.free, prescribed, **self.options)
        self._last = key, found, self.contact.multipliers.values
        return found

    def adjoint(
        self, bodies: Bodies, key: tuple[Any, ...], by_x: np.ndarray, x: np.ndarray, prescribed: Given, reference: Given, positions: Given
    ) -> Adjoint:
        """The adjoint there; the equilibrium is recomputed if another one was found since."""
        names = [name for name, given in (("reference", reference), ("positions", positions)) if given is not None]
        if self._last is None or self._last[0] != key:
            self.solved(bodies, key, x, prescribed, reference, positions)
        assert self._last is not None
        _, found, multipliers = self._last
        self._tell(reference, positions)
        self.contact.multipliers.values = multipliers
        adjoint = found.adjoint(by_x, by=names)
        for text in adjoint.warnings:
            # Programs of such hosts have no other place for it.
            warnings.warn(text, stacklevel=2)
        return adjoint
