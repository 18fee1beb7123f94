"""An elastic disc pressed onto a rigid plane without penetration, by an augmented Lagrangian.

The library gives nothing but the weighted gaps and their derivative (``Contact.gap_constraints``); the pressures on the nodes,
their updates and the solver are here.

    python augmented_lagrangian.py
"""

import numpy as np
from fmc_contact import Contact
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import spsolve
from skfem import Basis, ElementTriP1, ElementVector, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

RADIUS, MODULUS, RATIO, DOWN = 1.0, 1e3, 0.3, 0.02


def solve(refinements=5, tolerance=1e-6, updates=10):
    """Displacements, pressures by node, outer updates used, and the deepest mean gap of a node below the plane."""
    mesh = MeshTri.init_circle(refinements).translated((0, RADIUS))
    basis = Basis(mesh, ElementVector(ElementTriP1()))
    stiffness = linear_elasticity(*lame_parameters(MODULUS, RATIO)).assemble(basis)
    x, u, pressure = mesh.p.T, np.zeros(basis.N), np.zeros(mesh.nvertices)
    dofs = basis.nodal_dofs.T.ravel()  # Of node and axis, as the library counts them.
    held = basis.nodal_dofs[:, x[:, 1] > RADIUS].ravel()
    free = np.setdiff1d(np.arange(basis.N), held)
    u[basis.nodal_dofs[1]] = -DOWN
    contact = Contact(x, mesh.t.T, "triangle", stiffness=1.0)
    contact.add_half_space((0, 0), (0, 1))
    penalty = 10 * MODULUS / mesh.param()
    for update in range(1, updates + 1):
        for _ in range(20):
            found = contact.gap_constraints(x + u[dofs].reshape(x.shape), reach=0.1 * RADIUS)
            rows = csr_array((found.data, dofs[found.indices], found.indptr), shape=(len(found), basis.N))
            trial = np.maximum(0, pressure[found.node] - penalty * found.gap / found.area)
            residual = (stiffness @ u - rows.T @ trial)[free]
            if np.abs(residual).max() < 1e-10 * MODULUS * RADIUS:
                break
            active = rows[trial > 0]
            tangent = stiffness + active.T @ diags_array(penalty / found.area[trial > 0]) @ active
            u[free] -= spsolve(csr_array(tangent)[free][:, free].tocsc(), residual)
        pressure[:] = 0
        pressure[found.node] = trial
        penetration = max(0.0, -(found.gap / found.area).min())
        if penetration <= tolerance * RADIUS:
            break
    return mesh, u, pressure, update, penetration, (rows.T @ trial)[basis.nodal_dofs[1]].sum()


if __name__ == "__main__":
    mesh, u, pressure, updates, penetration, force = solve()
    half_width = np.sqrt(4 * force * RADIUS * (1 - RATIO**2) / (np.pi * MODULUS))
    print(f"{updates} updates, penetration {penetration:.1e} R, force {force:.4f}, peak pressure {pressure.max():.2f}")
    print(f"Hertz at this force: half-width {half_width:.4f}, peak pressure {2 * force / (np.pi * half_width):.2f}")
