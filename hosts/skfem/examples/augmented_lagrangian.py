"""An elastic disc on a rigid plane without penetration: an augmented Lagrangian with nothing but the weighted gaps."""

import numpy as np
from fmc_contact import Contact
from scipy.sparse import csr_matrix, diags
from scipy.sparse.linalg import spsolve
from skfem import Basis, ElementTriP1, ElementVector, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

R, E, NU, DOWN = 1.0, 1e3, 0.3, 0.02
mesh = MeshTri.init_circle(6).translated((0, R))
basis = Basis(mesh, ElementVector(ElementTriP1()))
K, x = linear_elasticity(*lame_parameters(E, NU)).assemble(basis), mesh.p.T
dofs, u, pressure = basis.nodal_dofs.T.ravel(), np.zeros(basis.N), np.zeros(mesh.nvertices)
free = np.setdiff1d(dofs, basis.nodal_dofs[:, x[:, 1] > R])  # The upper half is moved as one.
u[basis.nodal_dofs[1]] = -DOWN
contact, penalty = Contact(x, mesh.t.T, "triangle", stiffness=1.0), 10 * E / mesh.param()
contact.obstacles.add_half_space((0, 0), (0, 1))
for update in range(1, 11):
    for _ in range(20):
        gaps = contact.gap_constraints(x + u[dofs].reshape(x.shape), reach=0.1 * R)
        rows = csr_matrix((gaps.data, dofs[gaps.indices], gaps.indptr), shape=(len(gaps), basis.N))
        p = np.maximum(0, pressure[gaps.node] - penalty * gaps.gap / gaps.area)
        residual = (K @ u - rows.T @ p)[free]
        if np.abs(residual).max() < 1e-10 * E * R:
            break
        pressed = rows[p > 0]
        tangent = K + pressed.T @ diags(penalty / gaps.area[p > 0]) @ pressed
        u[free] -= spsolve(tangent.tocsc()[free][:, free], residual)
    pressure[:] = 0
    pressure[gaps.node] = p
    penetration = max(0.0, -(gaps.gap / gaps.area).min())
    if penetration <= 1e-6 * R:
        break
force = (rows.T @ p)[basis.nodal_dofs[1]].sum()
width = np.sqrt(4 * force * R * (1 - NU**2) / (np.pi * E))  # Hertz, half
hertz = 2 * force / np.pi / width * np.sqrt(np.maximum(0, 1 - (x[gaps.node, 0] / width) ** 2))
error = np.abs(p - hertz)[p > 0].mean() / hertz.max()
print(f"{update} updates, penetration {penetration:.1e}, force {force:.3f}, mean error of the pressure {error:.1%}")
assert penetration <= 1e-6 * R and error < 0.06
