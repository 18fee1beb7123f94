"""Derivatives of energy and forces: for design, identification and learning."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import addressof, byref, c_size_t
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ._arrays import View
from ._constants import FMC_ERROR_BUFFER_TOO_SMALL, FMC_GRADIENT_FRICTION, FMC_GRADIENT_GAP_OFFSET, FMC_GRADIENT_STIFFNESS, FMC_PARTNER
from ._handle import Handle
from ._library import check, library
from ._structs import fmc_gradients, fmc_pair_gradient
from .errors import FmcError
from .friction import WIDTH

_OF_PAIRS = {"stiffness": FMC_GRADIENT_STIFFNESS, "gap_offset": FMC_GRADIENT_GAP_OFFSET, "friction": FMC_GRADIENT_FRICTION}
_OF_OBSTACLES = {"positions": None, "rotations": 3}
_OF_NODES = ("coords", "reference")
NAMES = (*_OF_NODES, *_OF_OBSTACLES, *_OF_PAIRS, "slip")


def names_of(by: Iterable[str]) -> tuple[str, ...]:
    """Names of the variables of requested derivatives. Errors: ``ValueError`` for other names, and for one name that is no list."""
    if isinstance(by, str):
        raise ValueError(f"'by' is the text '{by}', expected a list of names such as ['positions'], of {', '.join(NAMES)}")
    names = tuple(by)
    for name in names:
        if name not in NAMES:
            raise ValueError(f"'by' has no value '{name}', expected {', '.join(NAMES)}")
    return names
"""What there are derivatives by."""


@dataclass(frozen=True)
class PairGradient:
    """Derivatives by the parameters of one pair; 0 if not requested. For ``Contact.jvp`` rates of this.

    Attributes
    ----------
    a, b : tuple of str and int
        ``("body", index)`` or ``("obstacle", index)``, as in ``Pair``.
    stiffness : float
        By the stiffness k of the pair's law.
    gap_offset : float
        By its gap offset.
    friction : float
        By its coefficient of friction, with the elastic slip at the start of the step held.

    Examples
    --------
    >>> gradients = contact.vjp(coords, energy=1.0, by=["stiffness"])
    >>> gradients.pairs[0].a
    ('body', 0)
    """

    a: tuple[str, int]
    b: tuple[str, int]
    stiffness: float = 0.0
    gap_offset: float = 0.0
    friction: float = 0.0


@dataclass(frozen=True, eq=False)
class Gradients:
    """Derivatives of ``energy * w + (adjoint * forces).sum()``, w being the contact energy; ``None`` if not requested. With ``slip_adjoint`` there is
    one term more, of the elastic slip with which the step ends.

    Attributes
    ----------
    coords : ndarray, (n, dim), or None
        By the coordinates.
    reference : ndarray, (n, dim), or None
        By the undeformed coordinates, the current ones held. A body whose shape is a parameter moves both: add ``coords``.
    positions : ndarray, (m, dim), or None
        By the position of every obstacle.
    rotations : ndarray, (m, 3), or None
        By a rotation vector of every obstacle about its position; in 2D only the last entry differs from zero.
    pairs : tuple of PairGradient
        By the parameters of each pair in contact, in the order of the pairs; empty if not requested.
    slip : ndarray, (rows, 8), or None
        By the elastic slip carried into the step, in columns 4 to 6: a row as in ``contact.friction.slip`` for each facet that friction
        acts on.

    Examples
    --------
    >>> gradients = contact.vjp(coords, energy=1.0, by=["coords"])
    >>> bool(np.abs(gradients.coords + contact.evaluate(coords).forces).max() < 1e-9)
    True
    """

    coords: Optional[np.ndarray]
    reference: Optional[np.ndarray]
    positions: Optional[np.ndarray]
    rotations: Optional[np.ndarray]
    pairs: tuple[PairGradient, ...]
    slip: Optional[np.ndarray] = None

    @property
    def stiffness(self) -> float:
        """By a stiffness k that all pairs share: the sum over the pairs."""
        return sum(pair.stiffness for pair in self.pairs)


def gradients(
    handle: Handle,
    coords: View,
    energy: float,
    adjoint: Optional[View],
    by: tuple[str, ...],
    obstacle_count: int,
    dim: int,
    slip_adjoint: Optional[np.ndarray] = None,
) -> Gradients:
    """Differentiates at ``coords``."""
    to = fmc_gradients()
    check(library.fmc_gradients_init(byref(to)))
    arrays: dict[str, np.ndarray] = {name: np.empty((coords.node_count, dim)) for name in _OF_NODES if name in by}
    arrays.update({name: np.empty((obstacle_count, axes or dim)) for name, axes in _OF_OBSTACLES.items() if name in by})
    for name, array in arrays.items():
        setattr(to, name, array.ctypes.data)
    to.of_pairs = sum(flag for name, flag in _OF_PAIRS.items() if name in by)
    count, capacity = c_size_t(), 16 if to.of_pairs else 0
    forces = None if adjoint is None else byref(adjoint.struct)
    if slip_adjoint is not None:
        to.slip_adjoint, to.slip_adjoint_count = slip_adjoint.ctypes.data, slip_adjoint.size
    slip, slip_count = np.empty((16 if "slip" in by else 0, WIDTH)), c_size_t()
    while True:
        if "slip" in by:
            to.slip, to.slip_capacity, to.slip_count = slip.ctypes.data, slip.size, addressof(slip_count)
        pairs = (fmc_pair_gradient * capacity)()
        try:
            handle.call(
                library.fmc_context_vjp, byref(coords.struct), energy, forces, byref(to), pairs, capacity, byref(count)
            )
        except FmcError as error:
            if error.status != FMC_ERROR_BUFFER_TOO_SMALL:
                raise
            capacity *= 8
            slip = np.empty((8 * len(slip), WIDTH))
            continue
        break
    of_pairs = tuple(_pair(pairs[index]) for index in range(count.value))
    by_place = {name: arrays.get(name) for name in (*_OF_NODES, *_OF_OBSTACLES)}
    return Gradients(**by_place, pairs=of_pairs, slip=slip[: slip_count.value // WIDTH].copy() if "slip" in by else None)


def _pair(found: fmc_pair_gradient) -> PairGradient:
    a, b = (FMC_PARTNER[found.a_kind], found.a), (FMC_PARTNER[found.b_kind], found.b)
    return PairGradient(a, b, found.stiffness, found.gap_offset, found.friction)
