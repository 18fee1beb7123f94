"""A problem: what its file says, and the arrays that every code is given."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import tomllib

from . import grids
from .references import reference

FOLDER = Path(__file__).resolve().parent.parent / "problems"


def names() -> list[str]:
    """Of all problems, in the order of the table."""
    return sorted(path.stem for path in FOLDER.glob("*.toml"))


@dataclass(frozen=True, eq=False)
class Problem:
    """One file of ``problems/``. Points, unknowns and facets of all bodies are numbered one after another."""

    name: str
    raw: dict[str, Any]

    @classmethod
    def load(cls, name: str) -> Problem:
        return cls(name, tomllib.loads((FOLDER / f"{name}.toml").read_text()))

    @cached_property
    def bodies(self) -> list[grids.Body]:
        return [grids.body(raw) for raw in self.raw["bodies"]]

    @cached_property
    def firsts(self) -> np.ndarray:
        """Number of the first point of every body, and of all points."""
        return np.cumsum([0, *(len(body.points) for body in self.bodies)])

    @cached_property
    def points(self) -> np.ndarray:
        return np.concatenate([body.points for body in self.bodies])

    @property
    def dim(self) -> int:
        return int(self.points.shape[1])

    @property
    def steps(self) -> list[float]:
        """Parts of the whole load at the ends of the load steps."""
        return list(self.raw.get("steps", [1.0]))

    @property
    def tied(self) -> bool:
        return bool(self.raw["contact"].get("tied", False))

    @property
    def friction(self) -> float:
        return float(self.raw["contact"].get("friction", 0.0))

    def facets(self, body: int, side: str) -> np.ndarray:
        return np.asarray(self.bodies[body].sides[side] + self.firsts[body])

    def nodes(self, body: int, side: str) -> np.ndarray:
        """Points of a side, or those that two sides share: ``x-&y-``."""
        first, *others = [np.unique(self.facets(body, one)) for one in side.split("&")]
        for other in others:
            first = np.intersect1d(first, other)
        return first

    @cached_property
    def pairs(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Facets that may touch: the side of the finer mesh, which most codes want as the slave, and the other one."""
        return [(self.facets(a, s), self.facets(b, t)) for (a, s), (b, t) in self.raw["contact"]["pairs"]]

    @cached_property
    def fixed(self) -> np.ndarray:
        """Whether a displacement is prescribed, (n, dim)."""
        found = np.zeros(self.points.shape, bool)
        for one in self.raw["supports"]:
            found[np.ix_(self.nodes(one["body"], one["side"]), self._axes(one))] = True
        return found

    @cached_property
    def symmetry(self) -> np.ndarray:
        """Numbers of the points in planes of symmetry."""
        planes = [self.nodes(one["body"], one["side"]) for one in self.raw["supports"] if one.get("symmetry")]
        return np.unique(np.concatenate(planes)) if planes else np.empty(0, int)

    @cached_property
    def prescribed(self) -> np.ndarray:
        """Displacements at the ends of the load steps, (steps, n, dim), zero where they are free."""
        found = np.zeros((len(self.steps), *self.points.shape))
        for one in self.raw["supports"]:
            where = np.ix_(self.nodes(one["body"], one["side"]), self._axes(one))
            for step, part in enumerate(self._parts(one)):
                found[step][where] += part * one.get("by", 0.0)
        return found

    @cached_property
    def loads(self) -> np.ndarray:
        """Forces on the points at the ends of the load steps, (steps, n, dim)."""
        found = np.zeros((len(self.steps), *self.points.shape))
        for one in self.raw.get("loads", []):
            load = self._equal(one) if "force" in one else self._traction(one)
            for step, part in enumerate(self._parts(one)):
                found[step] += part * load
        return found

    def _parts(self, one: dict[str, Any]) -> list[float]:
        parts = list(one.get("parts", self.steps))
        if len(parts) != len(self.steps):
            raise ValueError(f"{self.name}: {len(parts)} parts for {len(self.steps)} steps")
        return parts

    def _axes(self, one: dict[str, Any]) -> np.ndarray:
        return np.array([grids.AXES.index(axis) for axis in one["axes"]])

    def _traction(self, one: dict[str, Any]) -> np.ndarray:
        """A uniform traction, or a pressure on edges: every facet gives equal shares to its corners, which is exact if its sides are parallel."""
        found, facets = np.zeros_like(self.points), self.facets(one["body"], one["side"])
        if "pressure" in one:
            along = self.points[facets[:, 1]] - self.points[facets[:, 0]]
            forces = -one["pressure"] * np.stack([along[:, 1], -along[:, 0]], 1)
        else:
            forces = areas(self.points, facets)[:, None] * np.array(one["traction"])
        for corner in facets.T:
            np.add.at(found, corner, forces / facets.shape[1])
        return np.where(self.fixed, 0.0, found)

    def _equal(self, one: dict[str, Any]) -> np.ndarray:
        """A force in equal parts on all points of a side."""
        found, nodes = np.zeros_like(self.points), self.nodes(one["body"], one["side"])
        found[nodes] = np.array(one["force"]) / len(nodes)
        return found

    @cached_property
    def reference(self) -> float:
        return reference(self.raw["reference"])

    def arrays(self) -> dict[str, np.ndarray]:
        """What a runner is given, and nothing else."""
        found = {"points": self.points, "firsts": self.firsts, "fixed": self.fixed, "prescribed": self.prescribed, "loads": self.loads}
        found |= {"symmetry": self.symmetry, "friction": np.array(self.friction), "tied": np.array(self.tied)}
        found["overlaps"] = np.array(bool(self.raw["contact"].get("overlaps", False)))
        found["materials"] = np.array([[raw["young"], raw["poisson"]] for raw in self.raw["bodies"]])
        for number, one in enumerate(self.bodies):
            found[f"cells_{number}"] = one.cells + self.firsts[number]
        for number, (slave, master) in enumerate(self.pairs):
            found[f"slave_{number}"], found[f"master_{number}"] = slave, master
        return found


def areas(points: np.ndarray, facets: np.ndarray) -> np.ndarray:
    """Lengths of edges, or areas of quadrilaterals."""
    corner = points[facets]
    if facets.shape[1] == 2:
        return np.asarray(np.linalg.norm(corner[:, 1] - corner[:, 0], axis=1))
    across = np.cross(corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1])
    return np.asarray(np.linalg.norm(across, axis=1) / 2)
