"""fmc-contact in FEniCSx: its adapter and its search, nothing chosen."""

from __future__ import annotations

from typing import Any

import dolfinx.fem.petsc as fpetsc
import numpy as np
import ufl
from dolfinx import fem
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, by_input_number, find_equilibrium, set_by_input_number
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI
from petsc4py import PETSc
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu

from . import common


class Body:
    """A mesh of dolfinx, its displacement, its form, and what holds it."""

    def __init__(self, model: common.Model, number: int) -> None:
        begin, end = model.firsts[number : number + 2]
        self.rows, self.dim = slice(begin, end), model.dim
        kind = "quad" if model.dim == 2 else "hexahedron"
        self.space = vector_space(mesh_from_cells(MPI.COMM_WORLD, model.points[begin:end], model.cells[number] - begin, kind))
        self.u, self.density = fem.Function(self.space), fem.Function(self.space)
        dx = ufl.dx(self.space.mesh, metadata={"quadrature_degree": 3})
        u, v, trial = self.u, ufl.TestFunction(self.space), ufl.TrialFunction(self.space)
        young, poisson = model.materials[number]
        lame, shear = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))
        strain = lambda one: ufl.sym(ufl.grad(one))
        stress = 2 * shear * strain(u) + lame * ufl.tr(strain(u)) * ufl.Identity(model.dim)
        self.residual = ufl.inner(stress, strain(v)) * dx - ufl.inner(self.density, v) * dx
        mass = fpetsc.assemble_matrix(fem.form(ufl.inner(trial, v) * dx))
        mass.assemble()
        self._mass = splu(csr_matrix(mass.getValuesCSR()[::-1]).tocsc())
        # Points by the number of their block of unknowns, and back.
        named = fem.Function(self.space)
        set_by_input_number(named, np.repeat(np.arange(end - begin, dtype=float)[:, None], model.dim, axis=1))
        self.points = named.x.array.reshape(-1, model.dim)[:, 0].round().astype(int)
        self.blocks = np.argsort(self.points)
        self.held: list[tuple[Any, np.ndarray]] = []
        self.bcs = [self._hold(model, axis, nodes) for axis in range(model.dim) for nodes in self._moved_alike(model, axis)]

    def _moved_alike(self, model: common.Model, axis: int) -> list[np.ndarray]:
        """Held points in groups with one displacement along an axis in every step."""
        nodes = np.flatnonzero(model.fixed[self.rows, axis])
        _, group = np.unique(model.prescribed[:, self.rows, axis][:, nodes], axis=1, return_inverse=True)
        return [nodes[group.ravel() == one] for one in range(group.max() + 1 if len(nodes) else 0)]

    def _hold(self, model: common.Model, axis: int, nodes: np.ndarray) -> Any:
        value = fem.Constant(self.space.mesh, PETSc.ScalarType(0.0))
        self.held.append((value, model.prescribed[:, self.rows, axis][:, nodes[0]]))
        unknowns = np.sort(self.blocks[nodes] * self.dim + axis).astype(np.int32)
        return fem.dirichletbc(value, unknowns, self.space.sub(axis))

    def set_step(self, model: common.Model, step: int) -> None:
        """Forms have no forces at points: the density is the one whose integral with every shape function is the force there."""
        for value, parts in self.held:
            value.value = parts[step]
        self.density.x.array[:] = self._mass.solve(model.loads[step, self.rows][self.points].ravel())


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    bodies = [Body(model, number) for number in range(len(model.cells))]
    options: dict[str, Any] = {"friction_coefficient": model.friction} if model.friction else {}
    contact = DolfinxContact([body.space for body in bodies], **options)
    if variant == "smooth surfaces":
        contact.set_surface_smoothing(30.0)
    if len(model.symmetry):
        contact.set_symmetry_blocks(*(body.blocks[_inside(model.symmetry, body.rows)] for body in bodies))
    for slave, master in model.pairs if model.tied else []:
        contact.contact.pairs.set(model.body_of(slave), model.body_of(master), interface="tied")
    us = [body.u for body in bodies]
    problem = ContactProblem([body.residual for body in bodies], us, [bc for body in bodies for bc in body.bcs], contact)
    found, iterations = [], 0
    for number in range(model.steps):
        for body in bodies:
            body.set_step(model, number)
        if model.friction:
            contact.begin_step(*us)
        step = find_equilibrium(problem)
        iterations += step.iterations
        model.warnings += [*step.warnings, *(one.text for one in step.result.warnings)]
        if model.friction:
            contact.commit_step(*us)
        found.append(np.concatenate([by_input_number(u) for u in us]))
    return np.array(found), iterations


def _inside(points: np.ndarray, rows: slice) -> np.ndarray:
    """Points of a body, counted from its first."""
    return points[(points >= rows.start) & (points < rows.stop)] - rows.start


if __name__ == "__main__":
    common.main(solve)
