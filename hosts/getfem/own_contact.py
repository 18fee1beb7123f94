"""The same cases by GetFEM's own contact: an augmented Lagrangian, at nodes or in the integral, without a law and with no penetration."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import getfem as gf
import numpy as np
from fmc_agreement import figures
from fmc_agreement.problem import Problem
from fmc_peers import pair
from fmc_peers.solution import Clock
from model import Model

NEAR = 0.1
"""Part of the disc's height in which contact is looked for."""

SUNK = 0.05
"""Part of that by which it begins below the surface."""


@dataclass(frozen=True, eq=False)
class Own:
    """What GetFEM found: displacement, and forces that balance stresses and loads where nothing is held, (nodes, dim)."""

    displacement: np.ndarray
    force: np.ndarray
    iterations: int


def on_plane(kind: str) -> Callable[[Problem], Own]:
    """A body on the plane y = 0, by contact of a kind."""

    def solve(problem: Problem) -> Own:
        bodies = Model(problem)
        model, (variable,), (mesh,) = bodies.model, bodies.variables, bodies.meshes
        bodies.add_supports()
        bodies.add_loads()
        outer = mesh.outer_faces()
        height = NEAR * np.ptp(mesh.pts()[1])
        low = [mesh.pts(mesh.pid_in_faces(face[:, None]))[1].max() < height for face in outer.T]
        region = 1 + len(bodies.loaded)
        mesh.set_region(region, outer[:, low])
        scalar = gf.MeshFem(mesh, 1)
        scalar.set_classical_fem(1)
        fine = gf.MeshIm(mesh, gf.Integ("IM_TRIANGLE(4)"))
        model.add_initialized_data("r", [problem.bodies[0].material.young])
        if kind == "nodal":
            model.add_variable("pressure", len(scalar.basic_dof_on_region(region)))
            model.add_nodal_contact_with_rigid_obstacle_brick(fine, variable, "pressure", "r", region, "y", 2)
        else:
            model.add_initialized_fem_data("distance", scalar, scalar.basic_dof_nodes()[1])
            model.add_filtered_fem_variable("pressure", scalar, region)
            model.add_integral_contact_with_rigid_obstacle_brick(fine, variable, "pressure", "distance", "r", region, 2)
        # Where it touches nothing, nothing holds the body.
        model.to_variables(bodies.state(np.full_like(problem.coords, -SUNK * height) * [0.0, 1.0]))
        iterations = _solved(model)
        displacement = bodies.displacement()
        inner, _ = Model(problem).internal(displacement)
        return Own(displacement, inner - bodies.load(), iterations)

    return solve


def _solved(model: gf.Model) -> int:
    """Iterations to a residual of 1e-9."""
    iterations, converged = model.solve("max_res", 1e-9, "max_iter", 60, "lsearch", "simplest", "alpha min", 0.2)[:2]
    if not converged:
        raise RuntimeError(f"GetFEM's contact: no equilibrium in {iterations} iterations")
    return iterations


def by_rays(problem: Problem) -> Own:
    """Two bodies, large sliding: rays from the last look for the first. Of benchmarks/peers, which steps by itself."""
    found = pair.solve(problem, "rays from the last body", Clock())
    return Own(found.displacement, found.inner_force, found.iterations)


FORMULATIONS = {
    "hertz": {"at nodes": on_plane("nodal"), "in the integral": on_plane("integral")},
    "punch": {"by rays": by_rays},
}
"""By the kind of the case."""


def beside(problem: Problem, displacement: np.ndarray, force: np.ndarray, own: Own) -> str:
    """How far GetFEM's own contact is from that of fmc_contact: at nodes, and the figure of the case."""
    # What is held stands against what holds it.
    forces = [np.where(problem.held, 0.0, one) for one in (force, own.force)]
    if problem.raw["figures"]["kind"] == "hertz":
        name, found = "peak pressure", [figures.hertz(problem, one)[0]["peak_pressure"] for one in forces]
    else:
        name, found = "force", [problem.force_along_last_axis(one, problem.about) for one in forces]
    apart = np.abs(own.displacement - displacement).max() / np.abs(displacement).max()
    return (
        f"displacement {apart:.1e} away, {name} {found[1]:.5g}, {100 * (found[1] / found[0] - 1.0):+.2f} % of {found[0]:.5g}, "
        f"{own.iterations} iterations"
    )
