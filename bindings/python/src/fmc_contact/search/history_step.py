"""One step of a history with friction, and the reverse derivative through it.

With the start x₀ of the step and the elastic slip e carried into it, contact has the forces F(x, x₀, e) and carries the slip
s(x, x₀, e) on. At the equilibrium R(x) = F. Let J have the derivatives r by x, a by F and b by s; some of them are of later steps:

    Aᵀ λ = r + F_xᵀ a + s_xᵀ b,   A = R_x - F_x
    dJ/dp = -λ · R_p + (λ + a) · F_p + b · s_p

and the same with x₀ and e for p goes to the step before."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import finite
from ..contact import Contact
from ..errors import UnsupportedError
from ..friction import WIDTH
from ..gradients import Gradients
from ..pose import Pose
from .adjoint import bodies_of_end
from .at_equilibrium import poses_of, set_poses
from .closed import End
from .history_slopes import StepSlopes
from .outcome import Equilibrium


@dataclass(frozen=True, eq=False)
class Begun:
    """Start of a step: all data to solve it once more with bit-for-bit identical results."""

    x: np.ndarray
    coords: np.ndarray
    poses: list[Optional[Pose]]
    slip: np.ndarray

    @classmethod
    def here(cls, contact: Contact, x: np.ndarray, coords: np.ndarray) -> Begun:
        """The step that has just begun at these coordinates."""
        return cls(x, coords, poses_of(contact), contact.friction.slip)

    def put_back(self, contact: Contact) -> None:
        """Has the contact begin this step."""
        set_poses(contact, self.poses)
        contact.friction.begin_step(self.coords)
        contact.friction.slip = self.slip


@dataclass(frozen=True, eq=False)
class Handed:
    """Derivatives of J by the start of a step, which it passes to the step before: coordinates, positions and rotations, rows of slip."""

    coords: np.ndarray
    positions: np.ndarray
    rotations: np.ndarray
    slip: np.ndarray

    @classmethod
    def nothing(cls, contact: Contact) -> Handed:
        """After the last step."""
        obstacles = contact.obstacles.count
        return cls(
            np.zeros((contact.unknown_count, contact.dim)), np.zeros((obstacles, contact.dim)), np.zeros((obstacles, 3)), np.zeros((0, WIDTH))
        )


@dataclass(frozen=True, eq=False)
class StepAdjoint:
    """Derivatives of a number J of a whole history by the parameters of one of its steps, as ``History.backward`` returns them.

    Attributes
    ----------
    step : int
        Number of the step, from 0.
    x : ndarray
        Unknowns at its end.
    balance : ndarray
        λ in the shape of ``x``: the part of the bodies in dJ/dp is ``-(balance * dR).sum()``, with dR the derivative by p of the residual
        in this step. A load of this step has the derivative ``balance``.
    prescribed : ndarray
        By the values of held unknowns at the end of the step; zero where unknowns are free.
    gradients : Gradients
        By ``positions`` and ``rotations`` at the end of the step, and by ``stiffness`` and ``friction`` of the pairs in this step; as requested.
    warnings : list of str
        Where J may have no derivative.

    Examples
    --------
    >>> from fmc_contact import StepAdjoint
    >>> StepAdjoint.__name__
    'StepAdjoint'
    """

    step: int
    x: np.ndarray
    balance: np.ndarray
    prescribed: np.ndarray
    gradients: Gradients
    warnings: list[str]


BY = ("positions", "rotations", "stiffness", "friction")
"""What a history is differentiated by, of what the contact has."""


def back_through(
    step: int,
    begun: Begun,
    found: Equilibrium,
    later: Handed,
    seeds: tuple[Optional[ArrayLike], Optional[ArrayLike]],
    names: tuple[str, ...],
) -> tuple[StepAdjoint, Handed]:
    """Derivatives by the parameters of a step, and by its start. The contact is as at the end of the search, and is not changed."""
    end: End = found.__dict__["_end"]
    contact, shape, coords = end.unknowns.inner, end.x.shape, np.ascontiguousarray(end.unknowns.coords(end.x.ravel()))
    bodies = bodies_of_end(end)
    by_x, by_forces = (np.zeros(one) if seed is None else finite(seed, name, one) for seed, name, one in _named(seeds, shape, coords.shape))
    slopes = StepSlopes(contact, begun, coords, end.forces)
    bodies.forces(end.x.ravel(), True)
    to_coords, matrix = _to_coords(end, bodies.matrix.shape[0]), _sparse(bodies.matrix)
    of_slip = slopes.rows(later.slip)
    forces_by_x, slip_by_x = slopes.by_coords()
    on_coords = forces_by_x.T @ by_forces.ravel() + slip_by_x.T @ of_slip + later.coords.ravel()
    right = by_x.ravel() + to_coords.T @ on_coords
    total = matrix - to_coords.T @ forces_by_x @ to_coords
    balance = _solved(total, right, end)
    prescribed = right - total.T @ balance
    prescribed[end.solved_for] = 0.0
    on_nodes = to_coords @ balance + by_forces.ravel()
    of_pairs = [name for name in names if name in ("stiffness", "friction")]
    known = contact.vjp(coords, on_nodes.reshape(coords.shape), by=[*of_pairs, "slip"], slip_adjoint=later.slip if len(later.slip) else None)
    assert known.slip is not None
    forces_by_start, slip_by_start = slopes.by_start()
    by_start = (forces_by_start.T @ on_nodes + slip_by_start.T @ of_slip).reshape(coords.shape)
    poses = [name for name in ("positions", "rotations") if name in names]
    by_end, by_begin = slopes.by_poses(on_nodes, of_slip, poses)
    positions, rotations = (by_end[:, : contact.dim] + later.positions, by_end[:, contact.dim :] + later.rotations)
    gradients = Gradients(
        None, None, positions if "positions" in names else None, rotations if "rotations" in names else None, known.pairs
    )
    texts = []
    if slopes.edges:
        texts.append(
            f"{slopes.edges} degrees of freedom of step {step} are at an edge, as where friction begins to slide: the derivative is the mean "
            "of both sides"
        )
    adjoint = StepAdjoint(step, end.x, balance.reshape(shape), prescribed.reshape(shape), gradients, texts)
    return adjoint, Handed(by_start, by_begin[:, : contact.dim], by_begin[:, contact.dim :], known.slip)


def _named(seeds: tuple[Any, Any], of_x: tuple[int, ...], of_forces: tuple[int, ...]) -> list[tuple[Any, str, tuple[int, ...]]]:
    return [(seeds[0], "by_x", of_x), (seeds[1], "by_forces", of_forces)]


def _sparse(matrix: Any) -> Any:
    from scipy.sparse import csr_matrix

    return csr_matrix(matrix)


def _to_coords(end: End, size: int) -> Any:
    """Coordinates from unknowns."""
    from scipy.sparse import csr_matrix

    unknown = end.unknowns.of_coordinate
    moved = np.flatnonzero(unknown >= 0)
    return csr_matrix((np.ones(len(moved)), (moved, unknown[moved])), (len(unknown), size))


def _solved(total: Any, right: np.ndarray, end: End) -> np.ndarray:
    """λ, zero where unknowns are held."""
    from scipy.sparse.linalg import splu

    free, found = end.solved_for, np.zeros(len(right))
    block = total.tocsr()[free][:, free]
    if end.solve is not None:
        found[free] = end.solve(block.T.tocsr(), right[free])
    elif len(free):
        found[free] = splu(block.tocsc()).solve(right[free], "T")
    return found


def refuse(contact: Contact) -> None:
    """Errors: ``UnsupportedError`` for features without derivatives in a history."""
    if len(contact.multipliers.values):
        raise UnsupportedError("derivatives of a history with multipliers: give find_equilibrium no penetration, and the contact a stiffness")
    if len(contact.mesh.point_weights()) != contact.unknown_count:
        raise UnsupportedError("derivatives of a history with cells of second order")
    if len(contact.wear.facets):
        raise UnsupportedError("derivatives of a history with wear")
    if len(contact.friction.history):
        raise UnsupportedError("derivatives of a history with a law of friction that keeps a history")
