"""Two neo-Hookean bodies that slide over one another, in GetFEM: rays from the last body find the first."""

from __future__ import annotations

import getfem as gf
import numpy as np
from fmc_agreement.problem import Problem

from .solid import Solid
from .solution import Clock, Solution

RELEASE = 1.0 / 3.0
"""How long rays are at most, by the smaller body's height: they must not reach its far side."""

LEAST_STEPS = 4
"""Of a stage: GetFEM halves none by itself, and the punch in one step turns cells at its edge inside out."""

FORMULATIONS = {"rays from the last body": True, "rays from the first body": False}
"""Whether the last body carries the multipliers."""


def strain_energy(name: str) -> str:
    """W = G/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2 in plane strain, in GetFEM's language."""
    gradient = f"(Id(2)+Grad_{name})"
    return f"(G{name}/2)*(pow(Det{gradient},-2/3)*(Norm_sqr{gradient}+1)-3)+(K{name}/2)*sqr(Det{gradient}-1)"


def add_body(model: gf.Model, solid: Solid) -> None:
    """Its displacement and its strain energy."""
    name, material = solid.variable, solid.body.material
    model.add_fem_variable(name, solid.space)
    model.add_initialized_data("G" + name, [material.shear])
    model.add_initialized_data("K" + name, [material.bulk])
    model.add_nonlinear_term(solid.quadrature, strain_energy(name))


def faces_towards(solid: Solid, up: bool, number: int) -> None:
    """Makes a region of what lies opposite the held side and may be touched: the whole upper side of a body below; of one
    above, all but its own upper side and its vertical sides."""
    top, near = solid.coords[:, 1].max(), 1e-9 * np.ptp(solid.coords)
    if up:
        solid.region(number, lambda x: (x[:, 1] > top - near).all())
        return

    def wanted(x: np.ndarray) -> bool:
        is_upper, is_side = (x[:, 1] > top - near).all(), np.ptp(x[:, 0]) < near and np.ptp(x[:, 1]) > near
        return not (is_upper or is_side)

    solid.region(number, wanted)


def _before(solid: Solid) -> str:
    """Name of its displacement at the end of the last load step."""
    return "before_" + solid.variable


def solve(problem: Problem, formulation: str, clock: Clock) -> Solution:
    """Stage after stage, in the case's load steps or some more. Slip is that of a load step."""
    friction = problem.raw["contact"].get("friction_coefficient", 0.0)
    solids = [Solid(problem, body, f"u{number}") for number, body in enumerate(problem.bodies)]
    model = gf.Model("real")
    for solid, up in zip(solids, (True, False)):
        add_body(model, solid)
        solid.hold(model, problem, np.zeros_like(problem.prescribed))
        faces_towards(solid, up, 1)
    slave, master = solids[::-1] if FORMULATIONS[formulation] else solids
    model.add_initialized_data("r", [min(body.material.young for body in problem.bodies)])
    model.add_filtered_fem_variable("pressure", slave.space, 1)
    height = min(np.ptp(solid.coords[:, 1]) for solid in solids)
    # GetFEM takes velocities: displacements less those of the step before, by a time of 1.
    names, before_slave, before_master = [], [], []
    if friction > 0:
        names = ["friction", "rate"]
        for name, value in zip(names, (friction, 1.0)):
            model.add_initialized_data(name, [value])
        for solid in solids:
            model.add_fem_data(_before(solid), solid.space)
        before_slave, before_master = [_before(slave)], [_before(master)]
    contact = model.add_integral_large_sliding_contact_brick_raytracing("r", RELEASE * height, *names)
    model.add_slave_contact_boundary_to_large_sliding_contact_brick(
        contact, slave.contact_quadrature, 1, slave.variable, "pressure", *before_slave
    )
    model.add_master_contact_boundary_to_large_sliding_contact_brick(
        contact, master.contact_quadrature, 1, master.variable, *before_master
    )
    clock.lap("model")
    iterations, history = 0, []
    steps = problem.raw["load_steps"]
    stages = [problem.prescribed, *problem.then]
    before = np.zeros_like(problem.prescribed)
    for stage, (count, goal) in enumerate(zip([steps["count"], *steps.get("then", [])], stages)):
        count = max(count, LEAST_STEPS)
        for step in range(1, count + 1):
            for solid in solids:
                solid.move(model, before + (goal - before) * step / count)
            done, converged = model.solve(
                "max_res", 1e-6, "max_iter", 60, "lsearch", "simplest", "alpha min", 0.2
            )[:2]
            iterations += done
            if not converged:
                raise RuntimeError(f"{formulation}: no equilibrium in stage {stage}, step {step}")
            if friction > 0:
                for solid in solids:
                    model.set_variable(_before(solid), model.variable(solid.variable))
            history.append([stage, step / count, *_force(model, problem, solids[-1])])
        before = goal
    displacement, inner = np.zeros_like(problem.coords), np.zeros_like(problem.coords)
    for solid in solids:
        displacement[solid.nodes] = solid.displacement(model)
        inner[solid.nodes] = solid.inner_force(model, strain_energy(solid.variable))
    clock.lap("solution")
    return Solution(displacement, inner, iterations, history)


def _force(model: gf.Model, problem: Problem, solid: Solid) -> np.ndarray:
    """Of the contact on a body that is held along the last axis at its top: what its inner forces sum up to elsewhere."""
    inner = solid.inner_force(model, strain_energy(solid.variable))
    return np.where(problem.held[solid.nodes], 0.0, inner).sum(axis=0)
