"""Neo-Hookean bodies on bases of scikit-fem: internal forces and their derivative.

Energy by volume of the undeformed bodies: μ/2 (tr FᵀF − dim − 2 ln J) + λ/2 ln² J, J = det F.
"""

import numpy as np
from scipy.sparse import block_diag, csr_matrix
from skfem import Basis


class _Body:
    """One body. Arrays have the axes node of the cell, component, cell, quadrature point."""

    def __init__(self, basis, young, poisson):
        scalar = Basis(basis.mesh, basis.elem.elem, intorder=2)
        self.gradients = np.array([shape[0].grad for shape in scalar.basis])
        self.weights = scalar.dx
        self.dofs = basis.nodal_dofs[:, basis.mesh.t].swapaxes(0, 1)
        self.size = basis.N
        self.la, self.mu = young * poisson / (1 + poisson) / (1 - 2 * poisson), young / 2 / (1 + poisson)

    def _state(self, u):
        """Gradients of the shape functions with and without deformation, F, and ln J."""
        deformation = np.einsum("nieq,njeq->eqij", u[self.dofs][..., None], self.gradients, optimize=True)
        deformation = deformation + np.eye(self.gradients.shape[1])
        turned = np.einsum("eqji,njeq->nieq", np.linalg.inv(deformation), self.gradients, optimize=True)
        with np.errstate(invalid="ignore"):
            return turned, deformation, np.log(np.linalg.det(deformation))

    def forces(self, u):
        turned, deformation, log = self._state(u)
        own = self.mu * np.einsum("eqij,njeq->nieq", deformation, self.gradients, optimize=True)
        found = np.einsum("nieq,eq->nie", own + (self.la * log - self.mu) * turned, self.weights)
        return np.bincount(self.dofs.ravel(), found.ravel(), self.size)

    def stiffness(self, u):
        turned, _, log = self._state(u)
        w, by = self.weights, "eq,naeq,mbeq->"
        found = self.la * np.einsum(by + "nambe", w, turned, turned, optimize=True)
        found += np.einsum(by + "nbmae", (self.mu - self.la * log) * w, turned, turned, optimize=True)
        plain = self.mu * np.einsum("eq,njeq,mjeq->nme", w, self.gradients, self.gradients, optimize=True)
        found += np.einsum("nme,ab->nambe", plain, np.eye(found.shape[1]))
        rows, cols = np.broadcast_arrays(self.dofs[:, :, None, None], self.dofs[None, None])
        return csr_matrix((found.ravel(), (rows.ravel(), cols.ravel())), shape=(self.size, self.size))


class Solid:
    """Bodies, a basis of first order and Young's modulus each, whose unknowns follow one another."""

    def __init__(self, bases, youngs, poisson=0.3):
        self.bases = bases
        self.offsets = np.cumsum([0] + [basis.N for basis in bases])
        self._bodies = [_Body(basis, young, poisson) for basis, young in zip(bases, youngs)]

    def _each(self, u):
        return zip(self._bodies, np.split(u, self.offsets[1:-1]))

    def forces(self, u):
        """Internal forces, (size,); not numbers where a cell is inverted."""
        return np.concatenate([body.forces(part) for body, part in self._each(u)])

    def stiffness(self, u):
        """Their derivative, (size, size)."""
        return block_diag([body.stiffness(part) for body, part in self._each(u)], "csr")
