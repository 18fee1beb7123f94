"""An elastic block on a rigid plane, pressed down and pulled along: it sticks, and slides at mu times what presses it."""

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementTriP1, ElementVector, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

E, NU, MU, DOWN, CELL = 1e3, 0.3, 0.3, 0.01, 0.125
mesh = MeshTri.init_tensor(np.linspace(0, 2, 17), np.linspace(0, 1, 9))
basis = Basis(mesh, ElementVector(ElementTriP1()))
K = linear_elasticity(*lame_parameters(E, NU)).assemble(basis)
contact = SkfemContact(basis, stiffness=10 * E / CELL, friction_coefficient=MU)
contact.contact.obstacles.add_half_space((0, 0), (0, 1))
held = basis.nodal_dofs[:, mesh.p[1] > 1 - 1e-9]
free, u = np.setdiff1d(np.arange(basis.N), held), np.zeros(basis.N)
contact.begin_step(u)
ratios = []
for pull in np.linspace(0, 0.02, 11):
    end = u.copy()
    end[held[0]], end[held[1]] = pull, -DOWN
    step = find_equilibrium(lambda u: (K @ u, K), contact, u, free, end)
    u, plane, friction = step.x, step.result.obstacles[0], step.result.friction
    ratios.append(plane.friction[0] / (plane.friction - plane.force)[1])
    areas = f"{friction.stick_area:.2f} sticks, {friction.slip_area:.2f} slides"
    print(f"pulled by {pull:.3f}: {ratios[-1]:.4f} of the normal force, {areas}, {step.iterations} iterations")
    assert friction.dissipation >= 0
    contact.commit_step(u)
assert np.all(np.diff(ratios) > 0) and abs(ratios[-1] - MU) < 1e-4 * MU
