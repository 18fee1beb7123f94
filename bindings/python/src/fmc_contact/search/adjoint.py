"""Derivatives of an equilibrium: by one linear system, the transposed system of the last step."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import finite
from ..errors import UnsupportedError
from ..gradients import Gradients, PairGradient, names_of
from .at_equilibrium import AtEquilibrium
from .bodies import Bodies
from .closed import LAST, End, Place, closed, multipliers_put_back, slip_of
from .host import Host


@dataclass(frozen=True, eq=False)
class Adjoint:
    """Derivatives of a number J of an equilibrium by its parameters.

    Attributes
    ----------
    balance : ndarray
        λ in the shape of ``x``, zero where unknowns are held. The bodies' part of dJ/dp is ``-(balance * dR).sum()`` with dR the
        derivative by p of the residual that you gave to ``find_equilibrium``; a load in it has the derivative ``balance`` itself.
    gaps : ndarray, (m,)
        Adjoint of the gaps that multipliers close, in the order of ``contact.multipliers.values``.
    prescribed : ndarray
        Derivatives by the values of held unknowns, in the shape of ``x``; zero where unknowns are free.
    gradients : Gradients
        Requested total derivatives by parameters of the contact. ``coords``: by additional motions of all nodes of the contact, the unknowns and the
        bodies' residual held.
    warnings : list of str
        Where J may have no derivative, or not this one.
    x : ndarray
        Where all this is: the equilibrium with closed gaps, in the shape of ``x``. Take dR there.
    closing : float
        First-order change of J as the gaps close. J plus this change is accurate to second order.
    change : float
        Relative change of ``balance`` as gaps close: an estimate of the difference between these derivatives and the derivatives of a search with
        such gaps.

    Examples
    --------
    >>> from fmc_contact import find_equilibrium
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> found = find_equilibrium(bodies, contact, coords, range(16))
    >>> found.adjoint(np.ones((8, 2))).balance.shape
    (8, 2)
    """

    balance: np.ndarray
    gaps: np.ndarray
    prescribed: np.ndarray
    gradients: Gradients
    warnings: list[str]
    x: np.ndarray
    closing: float
    change: float


_AT_EDGE = 1e-3
"""Shift of a multiplier, and mean gap of a node without one, by the largest shift, below which contact just begins or ends."""

_OPEN = 1e-2
"""Gap of a node under pressure by the largest shift, and change of the derivatives as gaps close, above which J is told to be another one
than that of closed gaps."""


def adjoint(end: End, by_x: ArrayLike, by_forces: Optional[ArrayLike], by: Iterable[str]) -> Adjoint:
    """As ``Equilibrium.adjoint``.

    With R = bodies - F(x, s), gaps g(x) = 0 and their shifts s, J(x, F): Aᵀλ + Gᵀμ = dJ/dx, Sᵀ(λ + a) = 0, where A = dR/dx, G = dg/dx,
    S = dF/ds and a = dJ/dF."""
    names = names_of(by)
    contact, shape = end.unknowns.inner, end.x.shape
    nodes = end.unknowns.coords(end.x.ravel()).shape
    seed = finite(by_x, "by_x", shape).ravel()
    seed_of_forces = np.zeros(int(np.prod(nodes))) if by_forces is None else finite(by_forces, "by_forces", nodes).ravel()
    with multipliers_put_back(contact):
        bodies = bodies_of_end(end)
        found = Place(end, bodies, end.x.ravel())
        place = closed(end, bodies, found)
        if place is None:
            contact.multipliers.values = found.at.values
        there = place or found
        right, balance, of_gaps = _solved(there, seed, seed_of_forces)
        prescribed = right - there.saddle.total.T @ balance - there.saddle.gaps.T @ of_gaps
        prescribed[end.solved_for] = 0.0
        on_nodes, at = there.saddle.to_coords @ balance + seed_of_forces, there.at
        of_turns = np.repeat(there.saddle.shifts, at.dim) * (at.by_offsets.T @ on_nodes)
        gradients = _gradients(at, on_nodes, of_gaps, of_turns, there.saddle.forces_by_coords, names)
    closing, change = 0.0, 0.0
    if there is not found:
        before = _solved(found, seed, seed_of_forces)[1]
        change = float(np.linalg.norm(balance - before) / max(np.linalg.norm(balance), np.finfo(float).tiny))
        closing = float(seed @ (there.x - found.x) + seed_of_forces @ (there.forces - found.forces))
    texts = _warnings(found, place, change, closing)
    return Adjoint(balance.reshape(shape), of_gaps, prescribed.reshape(shape), gradients, texts, there.x.reshape(shape), closing, change)


def bodies_of_end(end: End) -> Bodies:
    """Errors: ``ValueError`` where the contact is not what it was; ``UnsupportedError``."""
    if isinstance(end.given, Host):
        raise UnsupportedError("the adjoint of bodies with their own solver")
    contact, coords = end.unknowns.inner, end.unknowns.coords(end.x.ravel())
    is_there = np.array_equal(contact.evaluate(coords).forces, end.forces)
    if not (is_there and np.array_equal(slip_of(contact), end.slip)):
        raise ValueError(
            "the contact has changed since the equilibrium: compute the adjoint before obstacles, options or multipliers change, "
            "and before commit_step"
        )
    if len(contact.multipliers.values) and len(contact.tie_nodes(coords)):
        raise UnsupportedError("the adjoint of multipliers with bodies that are tied or do not separate")
    return Bodies(end.given, end.contact, end.x.shape, end.solved_for, end.solve)


def _solved(there: Place, seed: np.ndarray, seed_of_forces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The right side, λ and μ."""
    saddle = there.saddle
    right = seed + saddle.to_coords.T @ (saddle.forces_by_coords.T @ seed_of_forces)
    return right, *saddle.transposed(right, saddle.forces_by_shifts.T @ seed_of_forces)


def _gradients(
    at: AtEquilibrium, on_nodes: np.ndarray, of_gaps: np.ndarray, of_turns: np.ndarray, by_coords: Any, names: tuple[str, ...]
) -> Gradients:
    """By the parameters of the contact: ``on_nodes`` is λ + a at nodes, ``of_turns`` the factor of a change of ``towards``."""
    contact, count = at.contact, at.contact.obstacles.count
    of_poses = [name for name in ("positions", "rotations") if name in names]
    by_differences = ["coords"] + ([] if at.is_exact else of_poses)
    asked = tuple(name for name in names if name not in by_differences)
    known = contact.vjp(at.coords, on_nodes.reshape(at.coords.shape), by=asked)
    found: dict[str, Optional[np.ndarray]] = {"reference": known.reference, "coords": None, "positions": None, "rotations": None}
    if "coords" in names:
        found["coords"] = (by_coords.T @ on_nodes - at.gaps_by_coords.T @ of_gaps).reshape(at.coords.shape)
    if of_poses:
        sums = np.zeros((count, at.dim + 3))
        for obstacle in range(count) if len(at.values) or not at.is_exact else ():
            forces, gaps, towards = at.by_pose(obstacle)
            sums[obstacle] = forces @ on_nodes - gaps @ of_gaps + towards @ of_turns
        for name, columns in (("positions", slice(0, at.dim)), ("rotations", slice(at.dim, None))):
            if name in names:
                exact = getattr(known, name)
                found[name] = sums[:, columns] if exact is None else exact + sums[:, columns]
    pairs = known.pairs
    if "gap_offset" in names:
        pairs = tuple(replace(pair, gap_offset=pair.gap_offset + _by_gap_offset(at, of_gaps, pair)) for pair in pairs)
    return Gradients(**found, pairs=pairs, slip=known.slip)


def _by_gap_offset(at: AtEquilibrium, of_gaps: np.ndarray, pair: PairGradient) -> float:
    """Contribution of the gaps for a pair of a body and a half-space: they close by its offset times their area."""
    values = at.values
    is_of_pair = (values["body"] == pair.a[1]) & (values["partner_kind"] == 1) & (values["partner"] == pair.b[1])
    return float((of_gaps * at.areas)[is_of_pair & (pair.b[0] == "obstacle")].sum())


def _warnings(found: Place, there: Optional[Place], change: float, closing: float) -> list[str]:
    """``there`` is where gaps are closed, if that was found."""
    texts, at = [], (there or found).at
    if at.edges:
        texts.append(f"{at.edges} degrees of freedom are at an edge, as where friction begins to slide: the derivative is the mean of both sides")
    if not len(at.values):
        return texts
    worst, most = np.abs(found.at.gaps).max(), found.at.values["shift"].max()
    said = f"gaps under pressure are {worst:.1e} where penetrations without multipliers would be {most:.1e}"
    asked = f"ask find_equilibrium for a penetration, such as {LAST * found.extent:.0e}"
    if there is None:
        texts.append(f"{said}, and could not be closed: the derivative is wrong by an unknown amount; {asked}")
    elif worst > _OPEN * most or change > _OPEN:
        texts.append(
            f"{said}; as they close, J changes by {closing:.1e} and its derivatives by {change:.1%}: this is the derivative "
            f"with closed gaps, and differs from differences of J with the gaps of the search; {asked}"
        )
    if begins := int((at.values["shift"] < _AT_EDGE * at.values["shift"].max()).sum()):
        texts.append(f"{begins} nodes are hardly pressed: where they part, J has an edge")
    return texts
