"""The contact at an equilibrium, and how its forces and gaps change there: exact where the library has it, else by differences."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional

import numpy as np

from ..contact import Contact
from ..errors import ObstacleRemovedError, UnsupportedError
from ..gaps import GapConstraints
from ..pose import Pose
from .coloured import slopes, slopes_ahead

STEP = 1e-7
"""Step of differences by the extent of the mesh: forces are rounded to 1e-16 of stiffness times extent, so that slopes are known to 1e-9."""

REACH = 0.05
"""Reach of the gaps by the extent, where none was given: as the search has it."""


class AtEquilibrium:
    """Forces F(x, o), with offsets o of the surface where it has multipliers, and the gaps g(x) there.

    A multiplier moves its point by ``o = shift * towards(x)``. At an equilibrium its gap is zero, and shifts follow all
    parameters so that it stays zero."""

    def __init__(self, contact: Contact, coords: np.ndarray, reach: float) -> None:
        self.contact, self.coords, self.dim = contact, np.ascontiguousarray(coords), contact.dim
        extent = float(np.ptp(coords, axis=0).max())
        self.reach, self.step = reach or REACH * extent, STEP * extent
        self.values = contact.multipliers.values
        self.edges = 0
        self.is_exact = self._is_exact()
        self.by_coords, self.by_offsets = self._of_forces()
        self.areas = np.zeros(0)
        self.gaps, self.gaps_by_coords, self.towards_by_coords = self._of_gaps()

    def _is_exact(self) -> bool:
        """Whether the tangent is minus the derivative of the forces."""
        try:
            self.contact.vjp(self.coords, np.zeros(self.coords.shape))
        except UnsupportedError:
            return False
        return True

    def _forces(self, x: np.ndarray) -> np.ndarray:
        return self.contact.evaluate(x.reshape(self.coords.shape)).forces.ravel()

    def _of_forces(self) -> tuple[Any, Any]:
        """Derivatives of the forces by coordinates and by the offset of every multiplier, (multipliers * dim)."""
        from scipy.sparse import csr_matrix

        tangent = csr_matrix(self.contact.tangent(self.coords))
        points = self._to_points()
        by_points = points[self.places(self.values["node"])]
        if self.is_exact:
            by_coords = -tangent
        else:
            pattern = off_axis(tangent, self.contact, self.coords, self.step)
            by_coords, edges = slopes(self._forces, self.coords.ravel(), pattern, self.step)
            self.edges += len(edges)
        if not len(self.values):
            return by_coords, csr_matrix((self.coords.size, 0))
        if self.is_exact and _is_identity(points):
            return by_coords, by_coords @ by_points.T
        pattern = abs(tangent) @ abs(by_points).T
        by_offsets, edges = slopes(self._forces_at_offsets, self._offsets(), pattern, self.step)
        self.edges += len(edges)
        return by_coords, by_offsets

    def _to_points(self) -> Any:
        """Points from coordinates, all axes."""
        from scipy.sparse import csr_matrix, identity, kron

        weights = self.contact.mesh.point_weights()
        matrix = csr_matrix((weights.data, weights.indices, weights.indptr), (len(weights), weights.node_count))
        return kron(matrix, identity(self.dim), "csr")

    def places(self, nodes: np.ndarray) -> np.ndarray:
        """Entries of points, all axes."""
        first = self.contact.options["index_base"]
        found: np.ndarray = ((nodes.astype(np.int64) - first)[:, None] * self.dim + np.arange(self.dim)).ravel()
        return found

    def _offsets(self) -> np.ndarray:
        offsets: np.ndarray = self.values["shift"][:, None] * self.values["towards"][:, : self.dim]
        return offsets.ravel()

    def _forces_at_offsets(self, offsets: np.ndarray) -> np.ndarray:
        rows, moved = offsets.reshape(-1, self.dim), self.values.copy()
        moved["shift"] = np.linalg.norm(rows, axis=1)
        moved["towards"][:, : self.dim] = rows / moved["shift"][:, None]
        try:
            self.contact.multipliers.values = moved
            return self._forces(self.coords)
        finally:
            self.contact.multipliers.values = self.values

    def _of_gaps(self) -> tuple[np.ndarray, Any, Any]:
        """Gaps of the multipliers divided by their area, derivatives of the gaps and of ``towards`` by coordinates."""
        from scipy.sparse import csr_matrix

        if not len(self.values):
            return np.zeros(0), csr_matrix((0, self.coords.size)), csr_matrix((0, self.coords.size))
        self._body_of_unknown = self._bodies()
        found, rows = self._rows_of_gaps(self.coords)
        matrix, self.areas = self._gradient(found)[rows], found.area[rows]
        pattern = matrix[np.repeat(np.arange(len(rows)), self.dim)]
        by_coords = slopes_ahead(lambda x: self.towards(x.reshape(self.coords.shape)), self.coords.ravel(), pattern, self.step)
        return found.gap[rows] / self.areas, matrix, by_coords

    def _bodies(self) -> np.ndarray:
        """Body of every unknown of the surface."""
        facets, weights = self.contact.mesh.boundary_facets(), self.contact.mesh.point_weights()
        found = np.full(weights.node_count, -1)
        of_point = np.full(len(weights), -1)
        nodes = facets.nodes.astype(np.int64) - self.contact.options["index_base"]
        for column in nodes.T:
            of_point[column[column >= 0]] = facets.body[column >= 0]
        on_surface = np.repeat(of_point, np.diff(weights.indptr))
        found[weights.indices[on_surface >= 0]] = on_surface[on_surface >= 0]
        return found

    def _rows_of_gaps(self, coords: np.ndarray) -> tuple[GapConstraints, np.ndarray]:
        """The gaps, and the row of every multiplier. Errors: ``UnsupportedError`` where one has none."""
        found = self.contact.gap_constraints(coords, self.reach)
        keys = zip(found.node.tolist(), found.body.tolist(), found.is_obstacle.tolist(), found.partner.tolist())
        place = {key: row for row, key in enumerate(keys)}
        names = (self.values[name].tolist() for name in ("node", "body", "partner_kind", "partner"))
        try:
            return found, np.array([place[node, body, kind == 1, partner] for node, body, kind, partner in zip(*names)])
        except KeyError as missing:
            raise UnsupportedError(f"the adjoint with a multiplier out of reach of its partner, of node {missing.args[0][0]}") from None

    def _gradient(self, found: GapConstraints) -> Any:
        from scipy.sparse import csr_matrix

        return csr_matrix((found.data, found.indices, found.indptr), (len(found), self.coords.size))

    def towards(self, coords: np.ndarray) -> np.ndarray:
        """Unit vector of every multiplier towards its partner: a body that moves as a whole changes a gap along its normal."""
        found, rows = self._rows_of_gaps(coords)
        own = self._gradient(found)[rows].tocoo()
        is_own = self._body_of_unknown[own.col // self.dim] == self.values["body"][own.row]
        sums = np.zeros((len(rows), self.dim))
        np.add.at(sums, (own.row[is_own], own.col[is_own] % self.dim), own.data[is_own])
        unit: np.ndarray = -sums / np.linalg.norm(sums, axis=1)[:, None]
        return unit.ravel()

    def by_pose(self, obstacle: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Derivatives of forces, gaps and ``towards`` by the position of an obstacle and a rotation vector about it, (dim + 3, values).
        Without multipliers the last two are empty; forces are where the library does not have their derivative, else 0."""
        pose, sizes = poses_of(self.contact)[obstacle], (self.coords.size, len(self.values), len(self.values) * self.dim)
        found = np.zeros((self.dim + 3, sum(sizes)))
        if pose is not None:
            try:
                for axis in range(self.dim + 3):
                    # In the plane the only axis is the third.
                    if self.dim == 3 or axis not in (2, 3):
                        found[axis] = self._along(obstacle, pose, axis)
            finally:
                self.contact.obstacles.set_pose(obstacle, pose)
        forces, gaps, towards = np.split(found, np.cumsum(sizes)[:2], axis=1)
        return forces, gaps, towards

    def _along(self, obstacle: int, pose: Pose, axis: int) -> np.ndarray:
        """Differences along one axis of the pose."""
        ends, step = [], self.step if axis < self.dim else STEP
        for by in (step, -step):
            self.contact.obstacles.set_pose(obstacle, moved_pose(pose, axis, by))
            forces = np.zeros(self.coords.size) if self.is_exact else self._forces(self.coords.ravel())
            gaps = np.zeros(0)
            if len(self.values):
                found, rows = self._rows_of_gaps(self.coords)
                gaps = np.concatenate([found.gap[rows], self.towards(self.coords)])
            ends.append(np.concatenate([forces, gaps]))
        along: np.ndarray = (ends[0] - ends[1]) / (2 * step)
        return along


def poses_of(contact: Contact) -> list[Optional[Pose]]:
    """Poses of all obstacles, ``None`` for one that was removed."""
    found: list[Optional[Pose]] = []
    for index in range(contact.obstacles.count):
        try:
            found.append(contact.obstacles.get(index).pose)
        except ObstacleRemovedError:
            found.append(None)
    return found


def set_poses(contact: Contact, poses: Sequence[Optional[Pose]]) -> None:
    """Moves all obstacles that are there."""
    for index, pose in enumerate(poses):
        if pose is not None:
            contact.obstacles.set_pose(index, pose)


def off_axis(pattern: Any, contact: Contact, coords: np.ndarray, step: float) -> Any:
    """A pattern without the radial coordinates of nodes on the axis, which stay there: none could move behind it."""
    if not contact.options["axisymmetric"]:
        return pattern
    from scipy.sparse import diags

    moves = np.ones(coords.shape)
    moves[coords[:, 0] <= step, 0] = 0.0
    found = (pattern @ diags(moves.ravel())).tocsr()
    found.eliminate_zeros()
    return found


def moved_pose(pose: Pose, axis: int, by: float) -> Pose:
    """A pose farther on along an axis, or turned about one by a small angle."""
    dim, position, turn = len(pose.position), pose.position.copy(), np.eye(3)
    if axis < dim:
        position[axis] += by
        return Pose(position, pose.rotation, pose.scale)
    first, second = [(1, 2), (2, 0), (0, 1)][axis - dim]
    turn[first, first] = turn[second, second] = np.cos(by)
    turn[second, first], turn[first, second] = np.sin(by), -np.sin(by)
    return Pose(position, turn[:dim, :dim] @ pose.rotation, pose.scale)


def _is_identity(matrix: Any) -> bool:
    count = matrix.shape[0]
    is_square = matrix.shape == (count, count) and matrix.nnz == count
    return bool(is_square and np.array_equal(matrix.indices, np.arange(count)) and (matrix.data == 1.0).all())
