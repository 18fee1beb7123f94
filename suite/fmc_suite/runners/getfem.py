"""GetFEM's own contact: augmented Lagrangian in the integral over meshes that do not match; with friction, rays (large sliding)."""

from __future__ import annotations

from typing import Any

import getfem as gf
import numpy as np

from . import common

ITERATIONS, SUNK = 100, 1e-5


class Body:
    """A mesh of GetFEM with its displacement ``u0``, ``u1``, ... on it."""

    def __init__(self, model: common.Model, number: int, brick: Any, degree: int) -> None:
        begin, end = model.firsts[number : number + 2]
        self.points, self.dim, self.name = model.points[begin:end], model.dim, f"u{number}"
        cells = model.cells[number] - begin
        order = [0, 1, 3, 2] if self.dim == 2 else [0, 1, 3, 2, 4, 5, 7, 6]
        self.mesh = gf.Mesh("empty", self.dim)
        self.mesh.add_convex(gf.GeoTrans(f"GT_QK({self.dim},1)"), self.points[cells[:, order]].transpose(2, 1, 0))
        self.space, self.scalar = gf.MeshFem(self.mesh, self.dim), gf.MeshFem(self.mesh, 1)
        for one in (self.space, self.scalar):
            one.set_fem(gf.Fem(f"FEM_QK({self.dim},1)"))
        self.quadrature, self.contact_quadrature = (
            gf.MeshIm(self.mesh, gf.Integ(f"IM_GAUSS_PARALLELEPIPED({self.dim},{degree})")) for degree in (3, degree)
        )
        # Places of GetFEM's unknowns among the points.
        places = self.space.basic_dof_nodes()[:, :: self.dim].T
        self.order = np.array([int(np.argmin(((self.points - at) ** 2).sum(axis=1))) for at in places])
        young, poisson = model.materials[number]
        brick.add_fem_variable(self.name, self.space)
        brick.add_initialized_data("la" + self.name, [young * poisson / ((1 + poisson) * (1 - 2 * poisson))])
        brick.add_initialized_data("mu" + self.name, [young / (2 * (1 + poisson))])
        brick.add_isotropic_linearized_elasticity_brick(self.quadrature, self.name, "la" + self.name, "mu" + self.name)
        self.outer = self.mesh.outer_faces()
        self.rows = slice(begin, end)
        self.regions, self.load = 0, 0
        self.held: list[tuple[int, np.ndarray]] = []

    def region(self, facets: np.ndarray) -> int:
        """A region of the faces that are facets, by their middles."""
        middles = self.points[facets].mean(axis=1)
        size = np.ptp(self.points, axis=0).max()
        chosen = []
        for number in range(self.outer.shape[1]):
            corners = self.mesh.pts(self.mesh.pid_in_faces(self.outer[:, [number]])).mean(axis=1)
            if np.abs(middles - corners).max(axis=1).min() < 1e-9 * size:
                chosen.append(number)
        self.regions += 1
        self.mesh.set_region(self.regions, self.outer[:, chosen])
        return self.regions

    def moved(self, values: np.ndarray) -> np.ndarray:
        """Values of the points, (n, dim), in the order of GetFEM's unknowns."""
        return np.asarray(values[self.rows][self.order].ravel())


def _add_contact(model: common.Model, bodies: list[Body], brick: Any, number: int, uses_rays: bool) -> None:
    slave, master = model.pairs[number]
    one, two = bodies[model.body_of(slave)], bodies[model.body_of(master)]
    at, on = one.region(slave - one.rows.start), two.region(master - two.rows.start)
    multiplier = f"pressure{number}"
    if model.tied:
        brick.add_filtered_fem_variable(multiplier, one.space, at)
        brick.add_interpolate_transformation_from_expression(f"to{number}", one.mesh, two.mesh, "X")
        jump = f"({one.name}-Interpolate({two.name},to{number}))"
        brick.add_nonlinear_term(one.contact_quadrature, f"{multiplier}.{jump}", at)
    elif uses_rays:
        brick.add_filtered_fem_variable(multiplier, one.space, at)
        contact = brick.add_integral_large_sliding_contact_brick_raytracing("r", _release(model), "friction", "rate")
        brick.add_slave_contact_boundary_to_large_sliding_contact_brick(
            contact, one.contact_quadrature, at, one.name, multiplier, "before_" + one.name
        )
        brick.add_master_contact_boundary_to_large_sliding_contact_brick(contact, two.contact_quadrature, on, two.name, "before_" + two.name)
    else:
        brick.add_filtered_fem_variable(multiplier, one.scalar, at)
        brick.add_integral_contact_between_nonmatching_meshes_brick(one.contact_quadrature, one.name, two.name, multiplier, "r", at, on, 1)


def _release(model: common.Model) -> float:
    """How far rays go: a third of the smallest body's height."""
    heights = [np.ptp(model.points[a:b, -1]) for a, b in zip(model.firsts, model.firsts[1:])]
    return float(min(heights) / 3)


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    gf.util("trace level", 0)
    gf.util("warning level", 0)
    brick = gf.Model("real")
    brick.add_initialized_data("r", [float(model.materials[:, 0].min())])
    brick.add_initialized_data("friction", [model.friction])
    brick.add_initialized_data("rate", [1.0])
    degree = 3 if variant == "default" else 13
    bodies = [Body(model, number, brick, degree) for number in range(len(model.cells))]
    for body in bodies:
        for axis in range(model.dim):
            held = body.moved(model.fixed)[axis :: model.dim]
            if held.any():
                _hold(brick, body, axis, held)
    uses_rays = bool(model.friction) or variant == "rays"
    for body in bodies if uses_rays else []:
        brick.add_fem_data("before_" + body.name, body.space)
    for number in range(len(model.pairs)):
        _add_contact(model, bodies, brick, number, uses_rays)
    for body in bodies:
        body.load = brick.add_explicit_rhs(body.name, np.zeros(body.space.nbdof()))
    _sink(model, bodies, brick)
    found: list[np.ndarray] = []
    iterations = 0
    for prescribed, loads in zip(model.prescribed, model.loads):
        for body in bodies:
            brick.set_private_rhs(body.load, body.moved(loads))
            for axis, held in body.held:
                brick.set_variable(f"goal{body.name}{axis}", body.moved(prescribed)[axis :: model.dim][held])
        done, converged = brick.solve("max_res", 1e-9, "max_iter", ITERATIONS, "lsearch", "simplest", "alpha min", 0.2 if uses_rays else 0.5)[:2]
        iterations += done
        if not converged:
            raise common.Failed(f"no equilibrium in {ITERATIONS} iterations in step {len(found) + 1}")
        step = np.zeros_like(model.points)
        for body in bodies:
            step[body.rows][body.order] = np.reshape(brick.variable(body.name), (-1, model.dim))
            if uses_rays:
                brick.set_variable("before_" + body.name, brick.variable(body.name))
        found.append(step)
    return np.array(found), iterations


def _hold(brick: Any, body: Body, axis: int, held: np.ndarray) -> None:
    """Displacements along an axis by multipliers, one for each held unknown."""
    rows = np.flatnonzero(held)
    matrix = gf.Spmat("empty", len(rows), body.space.nbdof())
    for row, node in enumerate(rows):
        matrix.add(row, int(node) * body.dim + axis, 1.0)
    name = f"held{body.name}{axis}"
    brick.add_variable(name, len(rows))
    brick.add_initialized_data(f"goal{body.name}{axis}", np.zeros(len(rows)))
    brick.add_constraint_with_multipliers(body.name, name, matrix, f"goal{body.name}{axis}")
    body.held.append((axis, held))


def _sink(model: common.Model, bodies: list[Body], brick: Any) -> None:
    """Bodies that contact alone holds begin a little in the one below them; without this GetFEM finds no equilibrium."""
    down, height = np.zeros_like(model.points), np.ptp(model.points[:, -1])
    order = sorted(bodies, key=lambda body: float(body.points[:, -1].mean()))
    for below, body in zip(order, order[1:]):
        if model.tied or model.fixed[body.rows, -1].any():
            continue
        top = (model.points + down)[below.rows, -1].max()
        gap = max(0.0, body.points[:, -1].min() - top)
        down[body.rows, -1] = -gap - SUNK * height
        brick.set_variable(body.name, body.moved(down))


if __name__ == "__main__":
    common.main(solve)
