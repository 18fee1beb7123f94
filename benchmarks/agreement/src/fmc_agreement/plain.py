"""A case as a table of numbers, for programs that read no JSON: bodies of linear elastic triangles on half-spaces.

dimension 2
nodes N             x y of each
triangles M         three nodes of each
held H              node, axis and displacement of each
faces F             two nodes and the traction of each
materials 1         Lame's lambda and mu
contact 1           stiffness, tolerance of the residual by the forces
half_spaces K       a point and the outward normal of each
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np

from .faces import loads
from .problem import Problem


def write(problem: Problem, path: Path) -> None:
    """Writes the table; numbers are read back bit for bit."""
    kinds = {(body.cell_type, body.material.law) for body in problem.bodies}
    shapes = {one["shape"] for one in problem.raw["obstacles"]}
    if kinds != {("triangle", "linear-elastic")} or len(problem.bodies) != 1 or shapes - {"half-space"}:
        raise ValueError(f"'{problem.name}' is no single body of linear elastic triangles on half-spaces")
    material, contact = problem.bodies[0].material, problem.contact_options()
    held = np.argwhere(problem.held)
    lines = [f"dimension {problem.dim}"]

    def table(name: str, rows: Iterable) -> None:
        # Number by number, so that node numbers stay whole.
        rows = [" ".join(repr(x.item() if isinstance(x, np.generic) else x) for x in row) for row in rows]
        lines.append(f"{name} {len(rows)}")
        lines.extend(rows)

    table("nodes", problem.coords)
    table("triangles", problem.bodies[0].conn)
    table("held", [[node, axis, problem.prescribed[node, axis]] for node, axis in held])
    table("faces", [[*nodes, *pull] for faces, traction in loads(problem) for nodes, pull in zip(faces, traction)])
    table("materials", [[material.lame, material.shear]])
    tolerance = problem.raw["load_steps"]["tolerance"]
    table("contact", [[contact["stiffness"], tolerance]])
    up = [0.0, 1.0]
    table("half_spaces", [[*one.get("position", [0.0, 0.0]), *one.get("axis", up)] for one in problem.raw["obstacles"]])
    path.write_text("\n".join(lines) + "\n")
