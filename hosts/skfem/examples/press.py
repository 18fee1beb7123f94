"""A block is pressed into a larger one and lifted by half: meshes that do not match, and nothing to choose.

Checked: when the push is halved, so is the force, up to the penetration; the same program in seven other hosts finds the same states
(``benchmarks/press``).
"""

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementHex1, ElementVector, MeshHex, asm
from skfem.models.elasticity import lame_parameters, linear_elasticity

# 1. Two blocks of hexahedra in one mesh. They touch from the start.
lower = MeshHex.init_tensor(*[np.linspace(0, 1, 5)] * 3)
upper = MeshHex.init_tensor(*[np.linspace(0.2, 0.8, 4)] * 2, np.linspace(1.0, 1.6, 4))
mesh = MeshHex(np.hstack([lower.p, upper.p]), np.hstack([lower.t, upper.t + lower.nvertices]))

# 2. The bodies without contact: internal forces at displacements u, and their derivative.
basis = Basis(mesh, ElementVector(ElementHex1()))
K = asm(linear_elasticity(*lame_parameters(1e6, 0.3)), basis)
host = lambda u: (K @ u, K)

# 3. The contact.
contact = SkfemContact(basis)

# 4. Bottom and top are held, and the top is moved: two load steps, the second from the end of the first.
bottom, top = (basis.get_dofs(lambda x: np.isclose(x[2], at)) for at in (0.0, 1.6))
u, free = np.zeros(basis.N), np.setdiff1d(np.arange(basis.N), np.r_[bottom.all(), top.all()])
forces = []
for push in (0.01, 0.005):
    goal = np.zeros(basis.N)
    goal[top.all("u^3")] = -push
    step = find_equilibrium(host, contact, u, free, goal)
    u = step.x
    forces.append(step.result.bodies[1].force[2])
    print(f"pushed by {push}: force {forces[-1]:.6f}, {step.iterations} linear solves, {step.warnings or 'no warnings'}")
assert abs(2 * forces[1] / forces[0] - 1) < 2e-3
