"""A case as a table of numbers, for a program that reads no JSON: bodies of quadrilaterals, with half-spaces.

nodes N         x y of each
cells M         body, then four nodes around
refined R       number of a cell that is to be divided into four
steps 1         number of load steps that are given
held H          node, axis and displacement of each at the end of every load step
materials B     1 for linear elastic or 0 for neo-Hookean, Lame's lambda, shear and bulk modulus
contact 1       law (0 volume, 1 fiber, 2 depth), stiffness, coefficient of friction
half_spaces K   a point and the outward normal of each
"""

from __future__ import annotations

from pathlib import Path
from typing import Callable

import numpy as np

from .faces import loads
from .problem import Problem

LAWS = {"volume": 0, "fiber": 1, "depth": 2}

Where = Callable[[np.ndarray], np.ndarray]
"""Of the middles of cells, (cells, 2), those where they are to be divided."""


def write(problem: Problem, displacements: np.ndarray, path: Path, is_refined: Where | None = None) -> None:
    """Writes the table; numbers are read back bit for bit. Loaded nodes are held where ``displacements`` (steps, nodes, 2), those of
    the reference host, have them, so that a body which only a first touch holds needs no more than Newton's method."""
    kinds, shapes = {body.cell_type for body in problem.bodies}, {one["shape"] for one in problem.raw["obstacles"]}
    if kinds != {"quad"} or shapes - {"half-space"}:
        raise ValueError(f"'{problem.name}' is not of bodies of quadrilaterals and half-spaces alone")
    contact = problem.contact_options()
    cells = [[number, *nodes] for number, body in enumerate(problem.bodies) for nodes in body.conn.tolist()]
    is_held = problem.held.copy()
    is_held[np.unique(np.concatenate([faces.ravel() for faces, _ in loads(problem)] or [np.zeros(0, int)]))] = True
    nodes_of_cells = np.array(cells)[:, 1:]
    refined = np.zeros(len(cells), bool)
    if is_refined:
        # A node in the middle of a held edge would have to be held as well.
        refined = is_refined(problem.coords[nodes_of_cells].mean(axis=1)) & ~is_held[nodes_of_cells].any(axis=(1, 2))
    tables = {
        "nodes": problem.coords.tolist(),
        "cells": cells,
        "refined": np.flatnonzero(refined)[:, None].tolist(),
        "steps": [[len(displacements)]],
        "held": [[node, axis, *displacements[:, node, axis].tolist()] for node, axis in np.argwhere(is_held).tolist()],
        "materials": [
            [int(of.law == "linear-elastic"), of.lame, of.shear, of.bulk] for of in (body.material for body in problem.bodies)
        ],
        "contact": [[LAWS[contact["law"]], contact["stiffness"], contact.get("friction_coefficient", 0.0)]],
        "half_spaces": [
            [*one.get("position", [0.0, 0.0]), *one.get("axis", [0.0, 1.0])] for one in problem.raw["obstacles"]
        ],
    }
    lines = []
    for name, rows in tables.items():
        lines += [f"{name} {len(rows)}", *(" ".join(map(repr, row)) for row in rows)]
    path.write_text("\n".join(lines) + "\n")
