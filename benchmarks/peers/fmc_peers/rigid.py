"""A linear elastic body on a rigid wedge, cone or plane, in GetFEM: nodes or points of integration may not pass its surface."""

from __future__ import annotations

from typing import Callable

import getfem as gf
import numpy as np
from fmc_agreement.problem import Problem

from .solid import Solid
from .solution import Clock, Solution

FORMULATIONS = {
    "nodal": ("nodal", 2),
    "nodal, unsymmetric": ("nodal", 1),
    "integral": ("integral", 2),
}
"""Bricks and their option: 1 is GetFEM's first, 2 its symmetric augmented Lagrangian."""

NEAR = 0.2
"""Part of the body's width in which contact is looked for."""


def distance(problem: Problem, places: np.ndarray) -> tuple[str, np.ndarray]:
    """Distance from the rigid shape as a formula, and at places (n, dim): a plane through the origin, below the body, or a tip there that
    opens upwards."""
    (shape,) = problem.raw["obstacles"]
    if shape["shape"] == "half-space":
        return "xyz"[problem.dim - 1], places[:, -1]
    if shape["shape"] == "polygon":
        (x, y), across, formula = shape["points"][1], places[:, 0], "x"
        slope = y / x
    elif shape["shape"] == "cone":
        slope = 2.0 * shape["half_height"] / shape["radius"]
        # The root is not differentiable on the axis.
        across, formula = np.hypot(*places.T[:2]), "sqrt(x*x+y*y+1e-14)"
    else:
        raise ValueError(f"no distance from a {shape['shape']}")
    up, size = "xyz"[problem.dim - 1], np.hypot(slope, 1.0)
    return f"({slope!r}*{formula}-{up})/{size!r}", (slope * across - places[:, -1]) / size


def may_touch(problem: Problem, solid: Solid) -> Callable[[np.ndarray], bool]:
    """Whether a face of these corners (corners, dim) may: near the last axis, on the upper side or of a ball below its flat ones."""
    near = NEAR * np.ptp(solid.coords[:, 0])
    if problem.raw["figures"]["kind"] != "balls":
        top = solid.coords[:, -1].max()
        return lambda x: (x[:, -1] > top - 1e-9).all() and (np.linalg.norm(x[:, :-1], axis=1) < near).all()
    # Of a quarter of a ball, which is as wide as its radius and lies on the origin.
    radius = np.ptp(solid.coords[:, 0])
    middle = np.array([0.0, 0.0, radius])

    def is_round_and_near(x: np.ndarray) -> bool:
        off = np.abs(np.linalg.norm(x - middle, axis=1) - radius)
        return (off < 1e-9 * radius).all() and (np.linalg.norm(x[:, :-1], axis=1) < 2.0 * near).all()

    return is_round_and_near


def solve(problem: Problem, formulation: str, clock: Clock) -> Solution:
    """From rest, in one step, to a residual of 1e-9."""
    kind, option = FORMULATIONS[formulation]
    (body,) = problem.bodies
    solid = Solid(problem, body)
    formula, at_dofs = distance(problem, solid.scalar.basic_dof_nodes().T)
    solid.region(1, may_touch(problem, solid))
    model = gf.Model("real")
    model.add_fem_variable("u", solid.space)
    model.add_initialized_data("lame", [body.material.lame])
    model.add_initialized_data("shear", [body.material.shear])
    model.add_isotropic_linearized_elasticity_brick(solid.quadrature, "u", "lame", "shear")
    solid.hold(model, problem, problem.prescribed)
    model.add_initialized_data("r", [body.material.young])
    if kind == "nodal":
        model.add_variable("pressure", len(solid.scalar.basic_dof_on_region(1)))
        model.add_nodal_contact_with_rigid_obstacle_brick(
            solid.contact_quadrature, "u", "pressure", "r", 1, formula, option
        )
    else:
        model.add_initialized_fem_data("distance", solid.scalar, at_dofs)
        model.add_filtered_fem_variable("pressure", solid.scalar, 1)
        model.add_integral_contact_with_rigid_obstacle_brick(
            solid.contact_quadrature, "u", "pressure", "distance", "r", 1, option
        )
    clock.lap("model")
    iterations, converged = model.solve("max_res", 1e-9, "max_iter", 40, "lsearch", "simplest", "alpha min", 0.5)[:2]
    displacement = solid.displacement(model)
    clock.lap("solution")
    if not converged:
        raise RuntimeError(f"{formulation}: no equilibrium in {iterations} iterations")
    unit = f"Id({problem.dim})"
    work = f"(lame*Trace(Grad_u)*{unit}+shear*(Grad_u+Grad_u')):Grad_Test_u"
    return Solution(displacement, solid.inner_force(model, work), iterations)
