"""A case as ``fmc mesh`` writes it: the same nodes, cells, held nodes and loaded faces for every host."""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import dataclass, field
from typing import Any

import numpy as np


def fmc() -> str:
    """The command ``fmc``: the path in the environment variable ``FMC``, or the one the shell knows."""
    return os.environ.get("FMC", "fmc")


@dataclass(frozen=True)
class Material:
    """``law`` is ``"linear-elastic"`` or ``"neo-hookean"``; Pa and kg/m^3."""

    law: str
    young: float
    poisson: float
    density: float

    @property
    def shear(self) -> float:
        return self.young / (2.0 * (1.0 + self.poisson))

    @property
    def lame(self) -> float:
        return self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))

    @property
    def bulk(self) -> float:
        return self.young / (3.0 * (1.0 - 2.0 * self.poisson))


@dataclass(frozen=True, eq=False)
class Body:
    name: str
    cell_type: str
    conn: np.ndarray
    """(cells, corners) in VTK's order, in the numbering of the whole problem."""
    material: Material
    velocity: np.ndarray

    @property
    def nodes(self) -> np.ndarray:
        return np.unique(self.conn)


@dataclass(frozen=True, eq=False)
class Problem:
    """A case. Arrays of nodes are (nodes, dim)."""

    raw: dict[str, Any]
    coords: np.ndarray
    bodies: list[Body]
    held: np.ndarray
    """Whether a component is prescribed, (nodes, dim)."""
    prescribed: np.ndarray
    """Its value, (nodes, dim), at the end of the first stage of the load steps."""
    then: list[np.ndarray] = field(default_factory=list)
    """Its value at the end of every further stage."""

    @property
    def name(self) -> str:
        return self.raw["case"]

    @property
    def dim(self) -> int:
        return self.raw["dimension"]

    @property
    def has_friction(self) -> bool:
        """Whether contact resists sliding."""
        return any(self.raw["contact"].get(key, 0.0) > 0.0 for key in ("friction_coefficient", "cohesion"))

    @property
    def is_static(self) -> bool:
        return self.raw["load_steps"] is not None

    @property
    def about(self) -> int:
        """Number of the body that the figures are about."""
        return [body.name for body in self.bodies].index(self.raw["figures"]["body"])

    def force_along_last_axis(self, forces: np.ndarray, body: int) -> float:
        """Size of the force on a body, all its copies by symmetry included, from ``forces`` (nodes, dim)."""
        return float(self.raw["figures"]["copies"] * abs(forces[self.bodies[body].nodes, -1].sum()))

    @property
    def cell_type(self) -> str:
        """Type of all cells."""
        (kind,) = {body.cell_type for body in self.bodies}
        return kind

    @property
    def order(self) -> int:
        """Order of the cells: second where they have nodes beside their corners."""
        return 2 if any(body.cell_type[-1].isdigit() for body in self.bodies) else 1

    @property
    def stages(self) -> list[tuple[int, np.ndarray]]:
        """Load steps and prescribed values of every stage."""
        plan = self.raw["load_steps"]
        return list(zip([plan["count"], *plan.get("then", [])], [self.prescribed, *self.then]))

    @property
    def body_of_cell(self) -> np.ndarray:
        """Body of every cell, bodies one after another."""
        return np.repeat(np.arange(len(self.bodies)), [len(body.conn) for body in self.bodies])

    def contact_options(self) -> dict[str, Any]:
        """Keywords of ``fmc_contact.Contact``, as the reference host chooses them."""
        given = self.raw["contact"]
        law, estimator = given["law"], given["estimator"]
        if given.get("linearised"):
            raise ValueError(f"the contact of '{self.name}' is linearised, which only the reference host does")
        options: dict[str, Any] = {
            "stiffness": given["stiffness"],
            "law": "fiber" if law == "fiber-linear" else law,
            "estimator": estimator,
            "self_contact": given["self_contact"],
            "check_cells": given["check_cells"],
        }
        if law == "volume":
            options["exponent"] = given["exponent"]
        elif "smoothing_length" in given:
            options["smoothing_length"] = given["smoothing_length"]
        if estimator == "fibers":
            options |= {key: given[key] for key in ("pattern", "weights", "seed", "momentum_correction", "spacing") if key in given}
            if self.is_static and law != "volume":
                options["momentum_correction"] = False
        if self.has_friction:
            friction = ("friction_coefficient", "friction_stiffness", "cohesion", "shear_limit")
            options |= {key: given[key] for key in friction if key in given}
        return options

    def add_obstacles(self, contact: Any) -> None:
        """Adds the rigid partners of the case to a contact."""
        # Programs that bring contact of their own read cases too, without the module.
        from fmc_contact import Pose

        up = np.eye(self.dim)[-1]
        for one in self.raw["obstacles"]:
            position, axis = one.get("position", np.zeros(self.dim)), one.get("axis", up)
            shape = one["shape"].replace("-", "_")
            if shape == "half_space":
                contact.obstacles.add_half_space(position, axis)
                continue
            if shape == "polygon":
                corner = np.arange(len(one["points"]))
                edges = np.column_stack([corner, np.roll(corner, -1)])
                contact.obstacles.add_polytope(np.array(one["points"]), edges, pose=Pose.along(position, axis))
                continue
            sizes = [one[key] for key in ("half_extents", "radius", "half_height") if key in one]
            if shape in ("cylinder", "cone", "capsule"):
                sizes = [one["radius"], one["half_height"]]
            getattr(contact.obstacles, f"add_{shape}")(*sizes, pose=Pose.along(position, axis))


def load(case: str, variant: str | None = None, overrides: tuple[str, ...] = ()) -> Problem:
    """A case by its name or by the path of its file."""
    command = [fmc(), "mesh", case]
    command += [] if variant is None else ["--variant", variant]
    for change in overrides:
        command += ["--override", change]
    found = subprocess.run(command, capture_output=True, text=True)
    if found.returncode != 0:
        raise RuntimeError(found.stderr)
    return from_json(json.loads(found.stdout))


def from_json(raw: dict[str, Any]) -> Problem:
    """A case from what ``fmc mesh`` wrote."""
    coords = np.array(raw["coords"], float)
    dim = raw["dimension"]
    bodies = [
        Body(
            body["name"],
            body["cell_type"],
            np.array(body["conn"], np.int64),
            Material(**body["material"]),
            np.array(body["initial_velocity"] or [0.0] * dim, float),
        )
        for body in raw["bodies"]
    ]
    held = np.zeros(coords.shape, bool)
    stages = [np.zeros(coords.shape) for _ in (raw["supports"], *raw["supports_then"])]
    for supports, values in zip((raw["supports"], *raw["supports_then"]), stages):
        for node, axis, value in supports:
            held[node, axis], values[node, axis] = True, value
    problem = Problem(raw, coords, bodies, held, stages[0], stages[1:])
    if problem.has_friction and not problem.is_static:
        raise ValueError(f"the case '{problem.name}' moves with friction, which only the reference host follows")
    return problem
