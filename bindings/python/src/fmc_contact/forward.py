"""Derivatives of energy and forces along a direction: the forward twin of ``gradients``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from ctypes import byref, sizeof
from dataclasses import dataclass
from typing import NamedTuple, Optional

import numpy as np

from ._arrays import View
from ._constants import FMC_PARTNER
from ._handle import Handle
from ._library import check, library
from ._structs import fmc_directions, fmc_pair_gradient
from .gradients import PairGradient


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


@dataclass(frozen=True)
class Rates:
    """Rates of motions, in dense rows of finite numbers."""

    moved: Mapping[str, Optional[np.ndarray]]
    """``motion``, ``positions`` and ``rotations``."""
    of_all: Mapping[str, float]
    """``stiffness``, ``gap_offset`` and ``friction``."""
    pairs: Sequence[PairGradient]
    slip: Optional[np.ndarray]


def slopes(handle: Handle, coords: View, dim: int, rates: Rates) -> Slopes:
    """Rates at ``coords``. What ``vjp`` refuses, this refuses."""
    along = fmc_directions()
    check(library.fmc_directions_init(byref(along)))
    for name, rows in rates.moved.items():
        # Empty rows move nothing.
        if rows is not None and rows.size:
            setattr(along, "coords" if name == "motion" else name, rows.ctypes.data)
    for name, rate in rates.of_all.items():
        setattr(along, name, rate)
    pairs = (fmc_pair_gradient * len(rates.pairs))(*map(_pair, rates.pairs))
    if len(pairs):
        along.pairs, along.pair_count = pairs, len(pairs)
    if rates.slip is not None and rates.slip.size:
        along.slip, along.slip_count = rates.slip.ctypes.data, rates.slip.size
    energy, forces = np.empty(1), np.empty((coords.node_count, dim))
    handle.call(library.fmc_context_jvp, byref(coords.struct), byref(along), energy, forces)
    return Slopes(float(energy[0]), forces)


def _pair(rates: PairGradient) -> fmc_pair_gradient:
    kinds = {name: kind for kind, name in FMC_PARTNER.items()}
    for kind, _ in (rates.a, rates.b):
        if kind not in kinds:
            raise ValueError(f"a pair has a partner '{kind}', expected {', '.join(kinds)}")
    given = fmc_pair_gradient()
    given.struct_size = sizeof(given)
    given.a_kind, given.a = kinds[rates.a[0]], rates.a[1]
    given.b_kind, given.b = kinds[rates.b[0]], rates.b[1]
    given.stiffness, given.gap_offset, given.friction = rates.stiffness, rates.gap_offset, rates.friction
    return given
