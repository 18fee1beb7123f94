"""Derivatives of what an equilibrium is: by one linear system, that of the last step, transposed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import floats
from ..errors import UnsupportedError
from ..gradients import NAMES, Gradients, PairGradient
from .at_equilibrium import AtEquilibrium
from .bodies import Bodies, Residual, Solve
from .host import Host
from .linear import factors
from .unknowns import Moved


@dataclass(frozen=True, eq=False)
class Adjoint:
    """Derivatives of a number J that hangs on an equilibrium, by what the equilibrium hangs on.

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
        Total derivatives by what the contact has, as asked for. ``coords``: where all nodes of the contact move by themselves, the
        unknowns and the bodies' residual held.
    warnings : list of str
        Where J may have no derivative, or not this one.

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


@dataclass
class End:
    """What an equilibrium was found of."""

    given: Union[Residual, Host]
    solve: Optional[Solve]
    contact: Any
    unknowns: Moved
    solved_for: np.ndarray
    x: np.ndarray
    forces: np.ndarray
    reach: float


_AT_EDGE = 1e-3
"""Shift of a multiplier, and mean gap of a node without one, by the largest shift, below which contact just begins or ends."""

_OPEN = 1e-2
"""Gap of a node under pressure by the largest shift above which J is told to be another one than that of closed gaps."""


def adjoint(end: End, by_x: ArrayLike, by_forces: Optional[ArrayLike], by: Iterable[str]) -> Adjoint:
    """As ``Equilibrium.adjoint``.

    With R = bodies - F(x, s), gaps g(x) = 0 and their shifts s, J(x, F): Aᵀλ + Gᵀμ = dJ/dx, Sᵀ(λ + a) = 0, where A = dR/dx, G = dg/dx,
    S = dF/ds and a = dJ/dF."""
    from scipy.sparse import csr_matrix, diags

    names = tuple(by)
    for name in names:
        if name not in NAMES:
            raise ValueError(f"'by' has no value '{name}', expected {', '.join(NAMES)}")
    contact, shape = end.unknowns.inner, end.x.shape
    coords = end.unknowns.coords(end.x.ravel())
    seed = floats(by_x, "by_x", shape).ravel()
    seed_of_forces = np.zeros(coords.size) if by_forces is None else floats(by_forces, "by_forces", coords.shape).ravel()
    matrix = _matrix(end, coords)
    at = AtEquilibrium(contact, coords, end.reach)
    # Offsets turn with the surfaces: o = s t(x).
    shifts = np.repeat(at.values["shift"], at.dim)
    along = diags(shifts) @ at.towards_by_coords
    forces_by_coords = at.by_coords + at.by_offsets @ along
    towards = at.values["towards"][:, : at.dim]
    count = len(at.values)
    places = np.arange(count * at.dim)
    forces_by_shifts = at.by_offsets @ csr_matrix((towards.ravel(), (places, places // at.dim)), (count * at.dim, count))

    unknown = end.unknowns.of_coordinate
    moved = np.flatnonzero(unknown >= 0)
    to_coords = csr_matrix((np.ones(len(moved)), (moved, unknown[moved])), (coords.size, end.unknowns.size))
    total = csr_matrix(matrix) - to_coords.T @ forces_by_coords @ to_coords
    gaps = at.gaps_by_coords @ to_coords
    right = seed + to_coords.T @ (forces_by_coords.T @ seed_of_forces)
    balance, of_gaps = _solved(
        end, total.tocsr(), gaps.tocsr(), (-to_coords.T @ forces_by_shifts).tocsr(), right, forces_by_shifts.T @ seed_of_forces
    )
    prescribed = right - total.T @ balance - gaps.T @ of_gaps
    prescribed[end.solved_for] = 0.0

    on_nodes = to_coords @ balance + seed_of_forces
    found = _gradients(at, on_nodes, of_gaps, shifts * (at.by_offsets.T @ on_nodes), forces_by_coords, names)
    return Adjoint(balance.reshape(shape), of_gaps, prescribed.reshape(shape), found, _warnings(at))


def _matrix(end: End, coords: np.ndarray) -> Any:
    """The bodies' matrix there. Errors: ``ValueError`` where the contact is not what it was; ``UnsupportedError``."""
    if isinstance(end.given, Host):
        raise UnsupportedError("the adjoint of bodies that solve by themselves")
    contact = end.unknowns.inner
    if not np.array_equal(contact.evaluate(coords).forces, end.forces):
        raise ValueError(
            "the contact is not what it was at the equilibrium: ask for the adjoint before obstacles, options or multipliers change, "
            "and before commit_step"
        )
    if len(contact.multipliers.values) and len(contact.tie_nodes(coords)):
        raise UnsupportedError("the adjoint of multipliers with bodies that are tied")
    bodies = Bodies(end.given, end.contact, end.x.shape, end.solved_for, end.solve)
    bodies.forces(end.x.ravel(), True)
    return bodies.matrix


def _solved(end: End, total: Any, gaps: Any, by_shifts: Any, right: np.ndarray, of_shifts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """λ and μ."""
    free, count = end.solved_for, gaps.shape[0]
    found, block, own = np.zeros(len(right)), total[free][:, free].T.tocsr(), end.solve
    if not count:
        found[free] = own(block, right[free]) if own is not None else factors(block)(right[free])
        return found, np.zeros(0)
    across, back = gaps[:, free].T.tocsr(), by_shifts[free].T.tocsr()
    if own is None:
        from scipy.sparse import bmat
        from scipy.sparse.linalg import splu

        both = splu(bmat([[block, across], [back, None]], "csc")).solve(np.concatenate([right[free], of_shifts]))
        found[free] = both[: len(free)]
        return found, both[len(free) :]
    alone = own(block, right[free])
    columns = np.stack([own(block, across[:, [one]].toarray().ravel()) for one in range(count)], axis=1)
    of_gaps = np.linalg.solve(back @ columns, back @ alone - of_shifts)
    found[free] = alone - columns @ of_gaps
    return found, of_gaps


def _gradients(
    at: AtEquilibrium, on_nodes: np.ndarray, of_gaps: np.ndarray, of_turns: np.ndarray, by_coords: Any, names: tuple[str, ...]
) -> Gradients:
    """By what the contact has: ``on_nodes`` is λ + a at nodes, ``of_turns`` what a change of ``towards`` is worth."""
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
    return Gradients(**found, pairs=pairs)


def _by_gap_offset(at: AtEquilibrium, of_gaps: np.ndarray, pair: PairGradient) -> float:
    """What the gaps add where the pair is one of a body and a half-space: they close by its offset times their area."""
    values = at.values
    is_of_pair = (values["body"] == pair.a[1]) & (values["partner_kind"] == 1) & (values["partner"] == pair.b[1])
    return float((of_gaps * at.areas)[is_of_pair & (pair.b[0] == "obstacle")].sum())


def _warnings(at: AtEquilibrium) -> list[str]:
    found = []
    if at.edges:
        found.append(f"{at.edges} degrees of freedom are at an edge, as where friction begins to slide: the derivative is the mean of both sides")
    if not len(at.values):
        return found
    most = at.values["shift"].max()
    if (worst := np.abs(at.gaps).max()) > _OPEN * most:
        found.append(
            f"gaps under pressure are {worst:.1e} where penetrations without multipliers would be {most:.1e}: the derivative is that with "
            "closed gaps; ask find_equilibrium for a penetration"
        )
    if begins := int((at.values["shift"] < _AT_EDGE * most).sum()):
        found.append(f"{begins} nodes are hardly pressed: where they part, J has an edge")
    return found
