"""Bodies and contact at a displacement."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable

import numpy as np

from ..contact import Contact
from ..result import Result

# Residual by |K| |x| that is made of rounding: some bits of the sums that a host takes over elements.
_ROUNDING = 8 * np.finfo(np.float64).eps

# Part of the energies that a change must exceed to be distinguished from rounding of some thousand pieces of contact.
_FLAT = 1e-12


@dataclass(eq=False)
class State:
    """Where the bodies are, and what balances there."""

    x: np.ndarray
    inside: np.ndarray
    """Internal less external forces, (size,)."""
    matrix: Any
    """Their derivative."""
    energy: float | None
    """Strain energy less the work of loads, where the host gives it."""
    forces: np.ndarray
    """Of the contact, (size,)."""
    result: Result
    residual: np.ndarray
    norm: float
    """Of the residual at free unknowns."""
    relative: float
    """The same by the forces."""

    def outgrows(self, other: State) -> bool:
        """Whether there is a new pair, or the area of contact has changed by more than half."""
        before, now = ({(pair.a, pair.b) for pair in one.result.pairs} for one in (other, self))
        area = other.result.contact_area
        return not now <= before or not 0.5 * area <= self.result.contact_area <= 2.0 * area

    def gained(self, other: State, step: np.ndarray) -> tuple[float, float, float]:
        """By how much the energy of another state is above this one's; what of that is rounding of sums, and of some thousand pieces
        of contact, near the end. Without an energy of the host its forces' work along the way, by the trapezoidal rule: exact for linear bodies."""
        if self.energy is not None and other.energy is not None:
            bodies, size = other.energy - self.energy, abs(self.energy)
        else:
            bodies, size = float(0.5 * (self.inside + other.inside) @ step), 0.0
        before, after = (energy_of(one.result) for one in (self, other))
        known = float(abs(other.forces) @ abs(other.x.ravel()))
        size += abs(before) + abs(after) + float(abs(other.inside) @ abs(step))
        return bodies + after - before, _ROUNDING * (8.0 * size + known), _FLAT * size + _ROUNDING * known


def energy_of(result: Result) -> float:
    """Of the contact; what frozen friction stores and takes out is its potential."""
    return result.energy + result.friction.energy + result.friction.dissipation


class Model:
    """A host with its contact."""

    def __init__(self, host: Callable[[np.ndarray], Any], contact: Any, shape: tuple[int, ...], free: np.ndarray) -> None:
        self.host, self.contact, self.shape, self.free = host, contact, shape, free
        self.inner: Contact = contact if isinstance(contact, Contact) else contact.contact
        self.size = int(np.prod(shape))

    def coords(self, x: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown."""
        return x if self.contact is self.inner else self.contact.coords(x)

    def at(self, x: np.ndarray) -> State:
        """Errors: those of ``Contact.evaluate``; ``ValueError`` for what a host may not give."""
        inside, matrix, *rest = self.host(x.copy())
        inside = np.ravel(inside)
        if inside.shape != (self.size,):
            raise ValueError(f"the residual has {inside.size} entries, x has {self.size}")
        return self._balanced(x, inside, matrix, float(rest[0]) if rest else None)

    def again(self, state: State) -> State:
        """The same place where the contact has become another."""
        return self._balanced(state.x, state.inside, state.matrix, state.energy)

    def _balanced(self, x: np.ndarray, inside: np.ndarray, matrix: Any, energy: float | None) -> State:
        result = self.contact.evaluate(x)
        forces = np.ravel(result.forces if self.contact is self.inner else self.contact.on_dofs(result.forces))
        residual = inside - forces
        size, norm = max(np.linalg.norm(inside), np.linalg.norm(forces)), float(np.linalg.norm(residual[self.free]))
        relative = 0.0 if _is_rounding(norm, matrix, x) else float(norm / size)
        return State(x, inside, matrix, energy, forces, result, residual, norm, relative)


def _is_rounding(norm: float, matrix: Any, x: np.ndarray) -> bool:
    """Whether a residual is: bodies that moved as one have forces of rounding alone, of which no part is small."""
    if not np.isfinite(norm):
        return False
    # Never less than the one below, and soon found.
    entries = matrix if isinstance(matrix, np.ndarray) else matrix.data
    if norm > _ROUNDING * np.linalg.norm(entries) * np.linalg.norm(x):
        return False
    return bool(norm <= _ROUNDING * np.linalg.norm(abs(matrix) @ abs(x.ravel())))
