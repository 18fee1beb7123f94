"""The IPC Toolkit with the suite's own elastic bodies as the host: Newton's method on the energy with the barrier, collision-free steps,
and the area-weighted (convergent) formulation that its tutorial advises. Friction is lagged until it changes no more, with a slip of dhat for
full friction. Bodies begin apart."""

from __future__ import annotations

import ipctk
import numpy as np
from scipy.sparse import coo_matrix, csc_matrix, csr_matrix, identity
from scipy.sparse.linalg import splu

from .. import elastic
from . import common

ITERATIONS, LAGS = 200, 50
PART, SMALL = 1e-3, 1e-6
"""dhat by the diagonal of all bodies: the default of Li et al. (2020), and a smaller one."""


class _Barrier:
    """Energy, gradient and Hessian of the barrier on the unknowns of the model."""

    def __init__(self, model: common.Model, points: np.ndarray, dhat: float, stiffness: float) -> None:
        facets = np.concatenate([one for pair in model.pairs for one in pair])
        self.nodes = np.unique(facets)
        local = np.searchsorted(self.nodes, facets).astype(np.int32)
        rest = np.asfortranarray(points[self.nodes])
        if model.dim == 2:
            self.mesh = ipctk.CollisionMesh(rest, np.asfortranarray(local))
        else:
            faces = np.asfortranarray(np.concatenate([local[:, [0, 1, 2]], local[:, [0, 2, 3]]]))
            self.mesh = ipctk.CollisionMesh(rest, ipctk.edges(faces), faces)
        self.rest, self.dim, self.size = rest, model.dim, model.points.size
        self.unknowns = (self.nodes[:, None] * model.dim + np.arange(model.dim)).ravel()
        self.dhat, self.potential = dhat, ipctk.BarrierPotential(dhat, stiffness, True)
        self.slip, self.slides, self.begun = ipctk.FrictionPotential(dhat), ipctk.TangentialCollisions(), rest

    def at(self, u: np.ndarray) -> np.ndarray:
        return np.asfortranarray(self.rest + u.reshape(-1, self.dim)[self.nodes])

    def _collisions(self, u: np.ndarray) -> tuple[ipctk.NormalCollisions, np.ndarray]:
        found, places = ipctk.NormalCollisions(), self.at(u)
        found.use_area_weighting = True
        found.collision_set_type = ipctk.NormalCollisions.IMPROVED_MAX_APPROX
        found.build(self.mesh, places, self.dhat)
        return found, places

    def lag(self, u: np.ndarray, begun: np.ndarray, friction: float) -> None:
        """Friction by the normal forces at a displacement, and by the slip since the begin of the step."""
        found, places = self._collisions(u)
        self.slides, self.begun = ipctk.TangentialCollisions(), self.at(begun)
        if friction:
            self.slides.build(self.mesh, places, found, self.potential, friction)

    def energy(self, u: np.ndarray) -> float:
        found, places = self._collisions(u)
        slip = self.slip(self.slides, self.mesh, np.asfortranarray(places - self.begun))
        return float(self.potential(found, self.mesh, places) + slip)

    def derivatives(self, u: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
        found, places = self._collisions(u)
        gradient = np.zeros(self.size)
        moved = np.asfortranarray(places - self.begun)
        gradient[self.unknowns] = self.potential.gradient(found, self.mesh, places) + self.slip.gradient(self.slides, self.mesh, moved)
        local = self.potential.hessian(found, self.mesh, places, ipctk.PSDProjectionMethod.CLAMP)
        local = coo_matrix(local + self.slip.hessian(self.slides, self.mesh, moved, ipctk.PSDProjectionMethod.CLAMP))
        rows, cols = self.unknowns[local.row], self.unknowns[local.col]
        return gradient, csr_matrix((local.data, (rows, cols)), shape=(self.size, self.size))

    def longest(self, u: np.ndarray, step: np.ndarray) -> float:
        """Part of a step that is free of collisions."""
        return float(ipctk.compute_collision_free_stepsize(self.mesh, self.at(u), self.at(u + step)))


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    if model.tied:
        raise common.NotSupported("no ties")
    if model.overlaps:
        raise common.NotSupported("bodies overlap at the start, and a barrier knows no overlap")
    ipctk.set_num_threads(1)
    young = float(model.materials[:, 0].min())
    dhat = (SMALL if variant == "small dhat" else PART) * float(np.linalg.norm(np.ptp(model.points, axis=0)))
    barrier, apart = _apart(model, dhat, young)
    bodies = zip(model.cells, model.materials)
    matrix = csr_matrix(sum(elastic.stiffness(model.points, cells, *material) for cells, material in bodies))
    free, u, iterations = np.flatnonzero(~model.fixed.ravel()), np.zeros(model.points.size), 0
    found: list[np.ndarray] = []
    for prescribed, loads in zip(model.prescribed, model.loads):
        goal = np.where(model.fixed, prescribed - apart, 0.0).ravel()
        begun = u
        for lag in range(LAGS):
            before = u
            barrier.lag(u, begun, model.friction)
            u, done = _newton(matrix, loads.ravel(), u, goal, free, barrier)
            iterations += done
            if not model.friction or np.abs(u - before).max() < 1e-5 * max(np.abs(u).max(), 1e-2 * dhat):
                break
        else:
            raise common.Failed(f"normal forces of friction still change after {LAGS} lags in step {len(found) + 1}")
        found.append(u.reshape(model.points.shape) + apart)
    return np.array(found), iterations


def _apart(model: common.Model, dhat: float, young: float) -> tuple[_Barrier, np.ndarray]:
    """Bodies moved apart along the mean normals of their pairs by half of ``dhat``: a barrier knows no touch."""
    apart, done, left = np.zeros_like(model.points), {0}, list(model.pairs)
    while left:
        known = [pair for pair in left if done & {model.body_of(side) for side in pair}]
        slave, master = known[0]
        left = [pair for pair in left if pair[0] is not slave]
        one, two = model.body_of(slave), model.body_of(master)
        if {one, two} <= done:
            continue
        normal = _normal(model.points[slave])
        here, there, sign = (one, two, 1) if one in done else (two, one, -1)
        apart[model.firsts[there] : model.firsts[there + 1]] = apart[model.firsts[here]] + sign * dhat / 2 * normal
        done |= {one, two}
    return _Barrier(model, model.points + apart, dhat, young), apart


def _normal(corner: np.ndarray) -> np.ndarray:
    """Mean outward normal of facets, (facets, corners, dim)."""
    if corner.shape[2] == 2:
        along = corner[:, 1] - corner[:, 0]
        total = np.stack([along[:, 1], -along[:, 0]], 1).sum(axis=0)
    else:
        total = np.cross(corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1]).sum(axis=0)
    return np.asarray(total / np.linalg.norm(total))


def _newton(matrix: csr_matrix, load: np.ndarray, u: np.ndarray, goal: np.ndarray, free: np.ndarray, barrier: _Barrier) -> tuple[np.ndarray, int]:
    """To the goal of held unknowns by steps that are free of collisions, then down the energy."""
    held = np.setdiff1d(np.arange(len(u)), free)
    reached, weak = False, 1e-10 * identity(len(u), format="csr") * matrix.diagonal().mean()
    for iteration in range(1, ITERATIONS + 1):
        gradient, hessian = barrier.derivatives(u)
        whole = matrix + hessian + weak
        step = np.zeros_like(u)
        step[held] = (goal - u)[held]
        right = load - matrix @ u - gradient - whole @ step
        step[free] = splu(csc_matrix(whole[free][:, free])).solve(right[free])
        reached = reached or not np.abs(step[held]).any()
        if reached and np.abs(step).max() < 1e-8 * barrier.dhat + 1e-9 * np.abs(u).max():
            return u, iteration
        part = barrier.longest(u, step)
        part = 1.0 if part >= 1.0 else 0.9 * part
        if reached:
            now = _energy(matrix, load, u, barrier)
            while part > 1e-8 and _energy(matrix, load, u + part * step, barrier) > now + 1e-12 * abs(now):
                part /= 2
        elif part == 1.0:
            reached = True
        u = u + part * step
    raise common.Failed(f"no equilibrium in {ITERATIONS} iterations")


def _energy(matrix: csr_matrix, load: np.ndarray, u: np.ndarray, barrier: _Barrier) -> float:
    return float(0.5 * u @ (matrix @ u) - load @ u + barrier.energy(u))


if __name__ == "__main__":
    common.main(solve)
