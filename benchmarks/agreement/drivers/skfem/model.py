"""The bodies of a case in scikit-fem: one mesh and one basis, with the quadrature of the reference host."""

from __future__ import annotations

import numpy as np
import second_order
import skfem
from fmc_agreement.faces import loads
from fmc_agreement.problem import Problem
from fmc_contact_skfem.field import mesh_from_cells
from neo_hookean import NeoHookean
from scipy.sparse import csr_matrix
from skfem import Basis, BilinearForm, ElementVector, FacetBasis, LinearForm, asm
from skfem.helpers import ddot, div, dot, grad, sym_grad, trace

ELEMENTS = {
    "triangle": skfem.ElementTriP1,
    "quad": skfem.ElementQuad1,
    "tetra": skfem.ElementTetP1,
    "hexahedron": skfem.ElementHex1,
    "triangle6": skfem.ElementTriP2,
    "quad9": skfem.ElementQuad2,
    "tetra10": skfem.ElementTetP2,
    "hexahedron27": skfem.ElementHex2,
}

# One point in simplices, two along every axis of the others; of second order three in triangles, four in tetrahedra, three along
# every axis of the others.
DEGREES = {"triangle": 1, "tetra": 1, "triangle6": 2, "tetra10": 2, "quad9": 5, "hexahedron27": 5}


class Model:
    """Masses, loads, internal forces and their derivative, in scikit-fem's order of unknowns."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        kind = problem.cell_type
        conn = np.concatenate([body.conn for body in problem.bodies])
        if problem.order == 2:
            self.mesh, number = second_order.mesh(problem.coords, conn, kind)
        else:
            self.mesh, number = mesh_from_cells(problem.coords, conn, kind), np.arange(len(problem.coords))
        self.element = ElementVector(ELEMENTS[kind]())
        self.basis = Basis(self.mesh, self.element, intorder=DEGREES.get(kind, 3))
        # Every place has its components one after another.
        self.dofs = number[:, None] * problem.dim + np.arange(problem.dim)
        laws = {body.material.law for body in problem.bodies}
        (self.law,) = laws
        self._linear = self._stiffness() if self.law == "linear-elastic" else None

    def _of_cells(self, name: str) -> np.ndarray:
        """A number of the material at every cell, (cells, 1)."""
        values = np.array([getattr(body.material, name) for body in self.problem.bodies])
        return values[self.problem.body_of_cell][:, None]

    def on_dofs(self, at_nodes: np.ndarray) -> np.ndarray:
        """From (nodes, dim) to unknowns."""
        found = np.empty(self.basis.N, at_nodes.dtype)
        found[self.dofs] = at_nodes
        return found

    def mass(self) -> np.ndarray:
        """Lumped mass of every unknown."""
        density = self._of_cells("density")
        form = LinearForm(lambda v, w: density * sum(v[axis] for axis in range(self.problem.dim)))
        return asm(form, self.basis)

    def load(self) -> np.ndarray:
        """Forces of the tractions on faces."""
        total = np.zeros(self.basis.N)
        node = np.empty(self.basis.N, int)
        node[self.dofs[:, 0]] = np.arange(len(self.dofs))
        corners = node[self.basis.nodal_dofs[0]]
        number = {tuple(sorted(nodes)): facet for facet, nodes in enumerate(corners[self.mesh.facets].T.tolist())}
        for faces, traction in loads(self.problem):
            facets = np.array([number[tuple(sorted(face))] for face in faces.tolist()])
            basis = FacetBasis(self.mesh, self.element, facets=facets, intorder=3)
            pull = traction.T[:, :, None]
            total += asm(LinearForm(lambda v, w: dot(pull, v)), basis)
        return total

    def _stiffness(self) -> csr_matrix:
        lame, shear = self._of_cells("lame"), self._of_cells("shear")
        form = BilinearForm(lambda u, v, w: lame * div(u) * div(v) + 2.0 * shear * ddot(sym_grad(u), sym_grad(v)))
        return asm(form, self.basis)

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces and strain energy."""
        if self._linear is not None:
            force = self._linear @ u
            return force, float(0.5 * force @ u)
        state = self._state(u)
        force = asm(LinearForm(lambda v, w: ddot(state.stress, grad(v))), self.basis)
        return force, float((state.energy * self.basis.dx).sum())

    def tangent(self, u: np.ndarray) -> csr_matrix:
        """Derivative of the internal forces."""
        if self._linear is not None:
            return self._linear
        state = self._state(u)
        return asm(BilinearForm(lambda u, v, w: ddot(state.derivative(grad(u)), grad(v))), self.basis)

    def _state(self, u: np.ndarray) -> NeoHookean:
        return NeoHookean(self.basis.interpolate(u).grad, self._of_cells("shear"), self._of_cells("bulk"))

    def elastic(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces (nodes, dim) and strain energy at displacements (nodes, dim)."""
        force, energy = self.internal(self.on_dofs(u))
        return force[self.dofs], energy

    def stiffness(self, u: np.ndarray) -> csr_matrix:
        """Their derivative; unknowns are ``node * dim + axis``."""
        dofs = self.dofs.ravel()
        return self.tangent(self.on_dofs(u))[dofs][:, dofs]

    def stresses_along(self, u: np.ndarray, axis: int) -> np.ndarray:
        """Normal stress along an axis, the mean of every cell."""
        gradient = self.basis.interpolate(u).grad
        lame, shear = self._of_cells("lame"), self._of_cells("shear")
        stress = lame * trace(gradient) + 2.0 * shear * gradient[axis, axis]
        return (stress * self.basis.dx).sum(axis=1) / self.basis.dx.sum(axis=1)
