"""Pressure on the contact surface from nodal forces, in one way for every program."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from fmc_agreement.faces import boundary_faces, face_normals
from fmc_agreement.problem import Problem

TOUCHING = 1e-6
"""Nodes with less than this part of the largest pressure are not in contact: rounding."""


@dataclass(frozen=True, eq=False)
class Profile:
    """Nodes of the side in contact: place undeformed (x, or the distance from the axis), pressure along the last axis per
    undeformed area, and area."""

    place: np.ndarray
    pressure: np.ndarray
    area: np.ndarray

    @property
    def half_width(self) -> float:
        return float(self.place[self.pressure > TOUCHING * self.pressure.max()].max())

    def until(self, place: float) -> np.ndarray:
        """Place and pressure, (places, 2)."""
        near = self.place <= place
        return np.column_stack([self.place, self.pressure])[near]

    def distance(self, other: Profile) -> float:
        """Root mean square of the difference over the area, by that of the other; the tip, singular, left out."""
        weight = self.area * (self.place > 0.0)
        off, size = ((weight * square).sum() for square in ((self.pressure - other.pressure) ** 2, other.pressure**2))
        return float(np.sqrt(off / size))


def profile(problem: Problem, body: int, force: np.ndarray) -> Profile:
    """Of a body that is pressed along the last axis; ``force`` (nodes, >= dim) on every node."""
    faces = boundary_faces(problem.bodies[body])
    normals = face_normals(problem.coords, faces)
    up = force[:, problem.dim - 1]
    nodes = problem.bodies[body].nodes
    sense = np.sign(up[nodes[~problem.held[nodes, -1]]].sum())
    # Within 60 degrees of the axis.
    towards = -sense * normals[:, -1] > 0.5 * np.linalg.norm(normals, axis=1)
    area = np.zeros(len(up))
    for face, normal in zip(faces[towards], normals[towards]):
        area[face] += abs(normal[-1]) / len(face)
    (touched,) = np.nonzero(area)
    place = np.linalg.norm(problem.coords[touched, :-1], axis=1)
    order = np.argsort(place, kind="stable")
    touched, place = touched[order], place[order]
    return Profile(place, np.maximum(sense * up[touched] / area[touched], 0.0), area[touched])
