"""The punch with an interface that neither opens nor slides, in GetFEM: block and punch have the same nodes there, one
body of two materials.

No contact is looked for, so what comes out depends on no law and no search. What may be compared with contact without
friction is the force and the pressure away from the edge; at the edge the two are singular in ways of their own.
"""

from __future__ import annotations

from dataclasses import dataclass

import getfem as gf
import numpy as np
from fmc_agreement.problem import Problem

from .pair import strain_energy

STEPS = 4


@dataclass(frozen=True, eq=False)
class Interface:
    """Of the half that is modelled: places of its nodes, the force on the punch along y at each, and the part of the
    interface that each has."""

    place: np.ndarray
    force: np.ndarray
    length: np.ndarray


def solve(problem: Problem, cells: int) -> Interface:
    """``cells`` over the half width of the interface; finer towards its edge, where the pressure is singular."""
    block, punch = problem.bodies
    block_size, punch_size = (np.ptp(problem.coords[body.nodes], axis=0) for body in problem.bodies)
    half = punch_size[0]
    inside = half - _ticks(half, cells, 8.0)[::-1]
    outside = half + _ticks(block_size[0] - half, cells, 40.0)[1:]
    down, up = -_ticks(block_size[1], 2 * cells, 40.0)[::-1], _ticks(punch_size[1], 2 * cells, 30.0)
    mesh = gf.Mesh("empty", 2)
    transform = gf.GeoTrans("GT_QK(2,1)")
    # The second finds the nodes of the first at the interface.
    parts = [
        mesh.add_convex(transform, _grid(np.concatenate([inside, outside]), down)),
        mesh.add_convex(transform, _grid(inside, up)),
    ]
    space = gf.MeshFem(mesh, 2)
    space.set_fem(gf.Fem("FEM_QK(2,1)"))
    quadrature = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,3)"))
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    works = []
    for number, (part, material) in enumerate(zip(parts, (block.material, punch.material)), 1):
        mesh.set_region(number, np.array([part]))
        work = strain_energy("u")
        for name, value in (("Gu", material.shear), ("Ku", material.bulk)):
            model.add_initialized_data(f"{name}{number}", [value])
            work = work.replace(name, f"{name}{number}")
        model.add_nonlinear_term(quadrature, work, number)
        works.append(work)
    x, y = space.basic_dof_nodes()[:, ::2]
    near = 1e-9 * half
    bottom, top = y < -block_size[1] + near, y > punch_size[1] - near
    held = [(node, 0, 0.0) for node in np.flatnonzero((x < near) | bottom)]
    held += [(node, 1, 0.0) for node in np.flatnonzero(bottom)]
    held += [(node, 1, problem.prescribed.min()) for node in np.flatnonzero(top)]
    rows = gf.Spmat("empty", len(held), space.nbdof())
    for row, (node, axis, _) in enumerate(held):
        rows.add([row], [2 * int(node) + axis], 1.0)
    values = np.array([value for *_, value in held])
    model.add_variable("support", len(held))
    brick = model.add_constraint_with_multipliers("u", "support", rows, 0.0 * values)
    for step in range(1, STEPS + 1):
        model.set_private_rhs(brick, values * step / STEPS)
        # The residual rises from the first displacement on; a line search that forbids it would stand still.
        options = ("lsearch", "simplest", "alpha max ratio", 1e9, "alpha min", 0.2)
        if not model.solve("max_res", 1e-8, "max_iter", 40, *options)[1]:
            raise RuntimeError(f"no equilibrium in step {step}")
    inner = gf.asm_generic(quadrature, 1, works[1], 2, model)
    first, _ = model.interval_of_variable("u")
    line = np.flatnonzero((abs(y) < near) & (x < half + near))
    line = line[np.argsort(x[line])]
    gaps = np.diff(x[line])
    length = 0.5 * np.concatenate([[gaps[0]], gaps[1:] + gaps[:-1], [gaps[-1]]])
    return Interface(x[line], inner[first + 2 * line + 1], length)


def _ticks(length: float, cells: int, growth: float) -> np.ndarray:
    """From 0 to ``length``, the last cell ``growth`` times the first."""
    sizes = growth ** (np.arange(cells) / (cells - 1))
    return length * np.concatenate([[0.0], np.cumsum(sizes) / sizes.sum()])


def _grid(across: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Corners of all cells in GetFEM's order, (2, 4, cells)."""
    i, j = (index.ravel() for index in np.meshgrid(range(len(across) - 1), range(len(along) - 1), indexing="ij"))
    return np.array([[across[i + a] for b in (0, 1) for a in (0, 1)], [along[j + b] for b in (0, 1) for a in (0, 1)]])
