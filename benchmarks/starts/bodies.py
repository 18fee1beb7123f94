"""Elastic bodies on bases of scikit-fem, linear or neo-Hookean, with cells of any order: internal forces, tangent and loads.

Strain energy of a neo-Hookean body by volume of the undeformed body: μ/2 (tr FᵀF − dim − 2 ln J) + λ/2 ln² J, J = det F.
Bodies in 2D are in plane strain.
"""

import numpy as np
from scipy.sparse import block_diag, csr_matrix
from skfem import Basis, ElementHex1, ElementQuad1, ElementTetP1, ElementTriP1, ElementVector, FacetBasis, LinearForm
from skfem.models.elasticity import lame_parameters

# Degree to which the integrals of each element are exact; 4 for all of second order.
_DEGREE = {ElementTriP1: 2, ElementTetP1: 2, ElementQuad1: 3, ElementHex1: 3}


class _Body:
    """One neo-Hookean body. Arrays have the axes node of the cell, component, cell, quadrature point."""

    def __init__(self, basis, young, poisson):
        element = basis.elem.elem
        scalar = Basis(basis.mesh, element, intorder=_DEGREE.get(type(element), 4))
        self.gradients = np.array([shape[0].grad for shape in scalar.basis])
        self.weights = scalar.dx
        self.dim, self.size = basis.mesh.dim(), basis.N
        self.dofs = basis.element_dofs.reshape(len(scalar.basis), self.dim, -1)
        self.la, self.mu = lame_parameters(young, poisson)

    def _state(self, u):
        """Deformation gradient, gradients of the shape functions in the deformed body, and ln J."""
        deformation = np.einsum("nieq,njeq->eqij", u[self.dofs][..., None], self.gradients, optimize=True) + np.eye(self.dim)
        with np.errstate(all="ignore"):
            log = np.log(np.linalg.det(deformation))
        turned = np.einsum("eqji,njeq->nieq", np.linalg.inv(deformation), self.gradients, optimize=True)
        return deformation, turned, log

    def forces(self, u):
        deformation, turned, log = self._state(u)
        own = self.mu * np.einsum("eqij,njeq->nieq", deformation, self.gradients, optimize=True)
        found = np.einsum("nieq,eq->nie", own + (self.la * log - self.mu) * turned, self.weights)
        return np.bincount(self.dofs.ravel(), found.ravel(), self.size)

    def tangent(self, u):
        _, turned, log = self._state(u)
        w, by = self.weights, "eq,naeq,mbeq->"
        found = self.la * np.einsum(by + "nambe", w, turned, turned, optimize=True)
        found += np.einsum(by + "nbmae", (self.mu - self.la * log) * w, turned, turned, optimize=True)
        plain = self.mu * np.einsum("eq,njeq,mjeq->nme", w, self.gradients, self.gradients, optimize=True)
        found += np.einsum("nme,ab->nambe", plain, np.eye(self.dim))
        rows, cols = np.broadcast_arrays(self.dofs[:, :, None, None], self.dofs[None, None])
        return csr_matrix((found.ravel(), (rows.ravel(), cols.ravel())), shape=(self.size, self.size))


class Bodies:
    """Bodies of a problem, one after the other in one vector of unknowns.

    ``young`` and ``poisson`` are one number for all bodies or one for each.
    """

    def __init__(self, meshes, cells, young, poisson, is_linear=True):
        cells = cells if isinstance(cells, (list, tuple)) else [cells] * len(meshes)
        self.meshes, self.dim = meshes, meshes[0].dim()
        self.bases = [Basis(mesh, ElementVector(one.element())) for mesh, one in zip(meshes, cells)]
        self.offsets = np.cumsum([0] + [basis.N for basis in self.bases])
        self.size = int(self.offsets[-1])
        self.pairs = [(basis, int(offset)) for basis, offset in zip(self.bases, self.offsets)]
        values = [np.broadcast_to(value, len(meshes)) for value in (young, poisson)]
        self._each = [_Body(*one) for one in zip(self.bases, *values)]
        # Without deformation the two materials have the same tangent.
        self.stiffness = self._tangent(np.zeros(self.size))
        self._is_linear = is_linear

    def _parts(self, u):
        return zip(self._each, np.split(u, self.offsets[1:-1]))

    def _tangent(self, u):
        return block_diag([body.tangent(part) for body, part in self._parts(u)], "csr")

    def host(self, load=0.0):
        """Residual and tangent of the bodies under a load, as a function of the displacement."""
        if self._is_linear:
            return lambda u: (self.stiffness @ u - load, self.stiffness)
        return lambda u: (np.concatenate([body.forces(part) for body, part in self._parts(u)]) - load, self._tangent(u))

    def unknowns(self, body, where, axis=None):
        """Unknowns of a body at the places where a function of the undeformed coordinates holds, of one axis or of all."""
        basis, found = self.bases[body], []
        at = where(basis.doflocs)
        for dofs in (basis.nodal_dofs, basis.edge_dofs, basis.facet_dofs, basis.interior_dofs):
            for one in range(self.dim) if axis is None else [axis % self.dim]:
                if dofs is not None and len(dofs):
                    found.append(dofs[one :: self.dim].ravel())
        numbers = np.unique(np.concatenate(found))
        return numbers[at[numbers]] + self.offsets[body]

    def weight(self, by_volume, axis=-1, bodies=None):
        """Forces of a weight by volume against an axis, of some bodies or of all."""
        found = np.zeros(self.size)
        for body in range(len(self.bases)) if bodies is None else bodies:
            form = LinearForm(lambda v, w: -by_volume * v[axis % self.dim])
            found[self._place(body)] = form.assemble(self.bases[body])
        return found

    def traction(self, body, where, values):
        """Forces of a traction on the faces of a body whose middles fulfil a condition."""
        mesh = self.meshes[body]
        basis = FacetBasis(mesh, self.bases[body].elem, facets=mesh.facets_satisfying(where, boundaries_only=True))
        found = np.zeros(self.size)
        found[self._place(body)] = LinearForm(lambda v, w: sum(value * v[a] for a, value in enumerate(values))).assemble(basis)
        return found

    def free(self, held):
        """Unknowns but the held ones."""
        return np.setdiff1d(np.arange(self.size), np.concatenate([np.ravel(one) for one in held]) if held else [])

    def _place(self, body):
        return slice(self.offsets[body], self.offsets[body + 1])
