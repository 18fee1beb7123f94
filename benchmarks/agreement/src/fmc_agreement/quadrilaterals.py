"""A case as a table of numbers, for a program that reads no JSON: bodies of quadrilaterals, with half-spaces.

nodes N         x y of each
cells M         body, then four nodes around
held H          node, axis and displacement of each at the end
materials B     1 for linear elastic or 0 for neo-Hookean, Lame's lambda, shear and bulk modulus
contact 1       law (0 volume, 1 fiber, 2 depth), stiffness
half_spaces K   a point and the outward normal of each
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from .faces import loads
from .problem import Problem

LAWS = {"volume": 0, "fiber": 1, "depth": 2}


def write(problem: Problem, displacement: np.ndarray, path: Path) -> None:
    """Writes the table; numbers are read back bit for bit. Loaded nodes are held where ``displacement`` (nodes, dim), that of the
    reference host, has them, so that a body which only a first touch holds needs no more than Newton's method."""
    kinds, shapes = {body.cell_type for body in problem.bodies}, {one["shape"] for one in problem.raw["obstacles"]}
    if kinds != {"quad"} or shapes - {"half-space"}:
        raise ValueError(f"'{problem.name}' is not of bodies of quadrilaterals and half-spaces alone")
    contact = problem.contact_options()
    cells = [[number, *nodes] for number, body in enumerate(problem.bodies) for nodes in body.conn.tolist()]
    held = [[node, axis, problem.prescribed[node, axis]] for node, axis in np.argwhere(problem.held).tolist()]
    loaded = np.unique(np.concatenate([faces.ravel() for faces, _ in loads(problem)] or [np.zeros(0, int)]))
    held += [[node, axis, displacement[node, axis]] for node in loaded.tolist() for axis in range(2) if not problem.held[node, axis]]
    tables = {
        "nodes": problem.coords.tolist(),
        "cells": cells,
        "held": [[node, axis, float(value)] for node, axis, value in held],
        "materials": [
            [int(of.law == "linear-elastic"), of.lame, of.shear, of.bulk] for of in (body.material for body in problem.bodies)
        ],
        "contact": [[LAWS[contact["law"]], contact["stiffness"]]],
        "half_spaces": [
            [*one.get("position", [0.0, 0.0]), *one.get("axis", [0.0, 1.0])] for one in problem.raw["obstacles"]
        ],
    }
    lines = []
    for name, rows in tables.items():
        lines += [f"{name} {len(rows)}", *(" ".join(map(repr, row)) for row in rows)]
    path.write_text("\n".join(lines) + "\n")
