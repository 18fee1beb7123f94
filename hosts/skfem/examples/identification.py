"""Young's modulus and the coefficient of friction from a noisy curve: what a block is pulled with along a plane on which it is pressed.

Checked: both are found to 2 % from a start that is wrong by half, with 3 % of noise, in 10 curves; each of their points has one gradient.
"""

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.optimize import least_squares
from skfem import Basis, ElementTriP1, ElementVector, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

TRUE, START, mesh = np.array([1e3, 0.3]), np.array([1.5e3, 0.15]), MeshTri.init_tensor(np.linspace(0, 2, 13), np.linspace(0, 1, 7))
basis = Basis(mesh, ElementVector(ElementTriP1()))
K = linear_elasticity(*lame_parameters(1.0, 0.3)).assemble(basis)
held = basis.nodal_dofs[:, mesh.p[1] > 1 - 1e-9]
pulls, along, zero = np.linspace(0.001, 0.02, 12), np.tile([1.0, 0.0], (mesh.nvertices, 1)), np.zeros(basis.N)


def pulled(factors):
    """Forces along the plane, one load step from rest for each pull, and their derivatives by both factors of the truth."""
    (young, friction), forces, slopes = factors * TRUE, [], []
    contact = SkfemContact(basis, stiffness=6e4, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space((0, 0), (0, 1))
    contact.begin_step(zero)
    for pull in pulls:
        end = np.zeros(basis.N)
        end[held[0]], end[held[1]] = pull, -0.01
        step = find_equilibrium(lambda u: (young * (K @ u), young * K), contact, zero, basis.complement_dofs(held.ravel()), end)
        found = step.adjoint(zero, along, by=["friction"])
        forces.append(step.result.forces[:, 0].sum())
        slopes.append([-found.balance @ (K @ step.x), found.gradients.pairs[0].friction] * TRUE)
    return np.array(forces), np.array(slopes)


measured = pulled(1.0)[0] * (1 + 0.03 * np.random.default_rng(0).standard_normal(len(pulls)))
off, slopes = (lambda factors: pulled(factors)[0] / measured - 1), (lambda factors: pulled(factors)[1] / measured[:, None])
found = least_squares(off, START / TRUE, slopes)
print(f"E {found.x[0]:.3f} and the coefficient {found.x[1]:.3f} of what they are, in {found.nfev} curves")
assert np.abs(found.x - 1).max() < 0.02 and found.nfev <= 10
