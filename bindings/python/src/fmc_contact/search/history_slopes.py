"""Derivatives of forces and transferred slip by the parameters of a step of a history: differences, many columns at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ..contact import Contact
from ..errors import UnsupportedError
from ..pose import Pose
from .at_equilibrium import STEP, moved_pose, off_axis, poses_of, set_poses
from .coloured import slopes

if TYPE_CHECKING:
    from .history_step import Begun

SLIP = slice(4, 7)
"""Columns of the slip in a row."""


class StepSlopes:
    """Forces F and slip s of a step, by its end x, its start and the poses of obstacles at both.

    Sliders are the facets on which friction acts at the end."""

    def __init__(self, contact: Contact, begun: Begun, coords: np.ndarray, forces: np.ndarray) -> None:
        """``forces`` are those that the search has found. Errors: ``UnsupportedError`` where it has counted slip from elsewhere."""
        from scipy.sparse import csr_matrix

        self.contact, self.begun, self.coords, self.dim = contact, begun, coords, contact.dim
        self.poses = poses_of(contact)
        extent = float(np.ptp(coords, axis=0).max())
        self.step, self.edges = STEP * extent, 0
        self._begin(begun.coords, begun.poses, self.poses)
        if not np.array_equal(contact.evaluate(coords).forces, forces):
            raise UnsupportedError("the derivative of a step whose slip counts from where bodies came to rest, not from its start")
        known = contact.vjp(coords, np.zeros(coords.shape), by=["slip"]).slip
        assert known is not None
        self.sliders = known
        self._place = {tuple(row): place for place, row in enumerate(known[:, :4].tolist())}
        self.tangent = csr_matrix(contact.tangent(coords))
        # Slip in the unit of forces, so that one measure tells an edge in both.
        self.scale = float(abs(self.tangent).max()) if self.tangent.nnz else 1.0

    def _begin(self, coords: np.ndarray, start: list[Optional[Pose]], end: list[Optional[Pose]]) -> None:
        """Begins the step at coordinates and poses, and moves obstacles to the end."""
        contact, has_moved = self.contact, start is not end
        if has_moved:
            set_poses(contact, start)
        contact.friction.begin_step(coords)
        contact.friction.slip = self.begun.slip
        if has_moved:
            set_poses(contact, end)

    def _values(self, coords: np.ndarray) -> np.ndarray:
        """Forces and slip of a step that has begun, which ends with that."""
        forces = self.contact.evaluate(coords).forces.ravel()
        self.contact.friction.commit_step(coords)
        return np.concatenate([forces, self.scale * self.rows(self.contact.friction.slip)])

    def rows(self, slip: np.ndarray) -> np.ndarray:
        """Slip of the sliders, one after the other; zeros where no row names one."""
        found = np.zeros((len(self.sliders), self.dim))
        for row in slip:
            place = self._place.get(tuple(row[:4].tolist()))
            if place is not None:
                found[place] = row[SLIP][: self.dim]
        return found.ravel()

    def _at_end(self, x: np.ndarray) -> np.ndarray:
        found = self._values(x.reshape(self.coords.shape))
        self._begin(self.begun.coords, self.begun.poses, self.poses)
        return found

    def _at_start(self, x: np.ndarray) -> np.ndarray:
        self._begin(x.reshape(self.coords.shape), self.begun.poses, self.poses)
        return self._values(self.coords)

    def by_coords(self) -> tuple[Any, Any]:
        """Derivatives of forces and slip by the coordinates at the end."""
        pattern = _stacked(_ones(self.tangent), self._of_sliders(self.tangent))
        pattern = off_axis(pattern, self.contact, self.coords, self.step)
        return self._split(slopes(self._at_end, self.coords.ravel(), pattern, self.step, self.scale))

    def by_start(self) -> tuple[Any, Any]:
        """By the coordinates at the start."""
        from scipy.sparse import csr_matrix

        self._begin(self.begun.coords, self.begun.poses, self.begun.poses)
        before = csr_matrix(self.contact.tangent(self.begun.coords))
        # What bears at the start decides how much of the step counts.
        columns = _ones(self._of_sliders(self.tangent) + self._of_sliders(before))
        pattern = _stacked(_ones(self._of_sliders(self.tangent).T @ columns), columns)
        pattern = off_axis(pattern, self.contact, self.begun.coords, self.step)
        found = self._split(slopes(self._at_start, self.begun.coords.ravel(), pattern, self.step, self.scale))
        self._begin(self.begun.coords, self.begun.poses, self.poses)
        return found

    def _split(self, found: tuple[Any, np.ndarray]) -> tuple[Any, Any]:
        both, edges = found
        rows, count = both.tocsr(), self.coords.size
        self.edges += len(edges)
        return rows[:count], rows[count:] / self.scale

    def _of_sliders(self, tangent: Any) -> Any:
        """Columns on which a slider may depend: the tangent's columns in the rows of its facet."""
        from scipy.sparse import csr_matrix

        nodes = self.contact.mesh.boundary_facets().nodes.astype(np.int64) - self.contact.options["index_base"]
        of_facet = nodes[self.sliders[:, 0].astype(np.int64)][:, : self.dim]
        dofs = (of_facet[:, :, None] * self.dim + np.arange(self.dim)).reshape(len(of_facet), self.dim**2)
        wide = np.repeat(dofs, self.dim, axis=0)
        rows = np.repeat(np.arange(len(wide)), wide.shape[1])
        facets = csr_matrix((np.ones(wide.size), (rows, wide.ravel())), (len(wide), self.coords.size))
        return _ones(facets @ _ones(tangent))

    def by_poses(self, on_nodes: np.ndarray, of_slip: np.ndarray, names: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
        """Derivatives of F and s along these by positions and rotations of obstacles at the end and at the start, (m, dim + 3) each."""
        along = np.concatenate([on_nodes, of_slip / self.scale])
        found = np.zeros((2, len(self.poses), self.dim + 3))
        axes = [axis for axis in range(self.dim + 3) if ("positions" if axis < self.dim else "rotations") in names]
        for place in np.ndindex(2, len(self.poses)):
            if self.poses[place[1]] is None:
                continue
            # In the plane the only axis is the third.
            for axis in (axis for axis in axes if self.dim == 3 or axis not in (2, 3)):
                found[(*place, axis)] = self._by_pose(place, axis) @ along
        self._begin(self.begun.coords, self.begun.poses, self.poses)
        return found[0], found[1]

    def _by_pose(self, place: tuple[int, ...], axis: int) -> np.ndarray:
        ends, step = [], self.step if axis < self.dim else STEP
        for by in (step, -step):
            poses = [list(self.poses), list(self.begun.poses)]
            when, obstacle = place
            moved = poses[when][obstacle]
            assert moved is not None
            poses[when][obstacle] = moved_pose(moved, axis, by)
            self._begin(self.begun.coords, poses[1], poses[0])
            ends.append(self._values(self.coords))
        rate: np.ndarray = (ends[0] - ends[1]) / (2 * step)
        return rate


def _ones(matrix: Any) -> Any:
    """The pattern of a matrix, entries of any value."""
    found = matrix.tocsr().copy()
    found.data = np.ones(len(found.data))
    return found


def _stacked(above: Any, below: Any) -> Any:
    from scipy.sparse import vstack

    return vstack([above, below], "csr")


