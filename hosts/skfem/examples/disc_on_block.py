"""A half-disc is pressed into a block by 0.1: two bodies, two meshes that do not match, and no supermesh.

Checked: what the disc's top is pressed with is what the block's bottom carries.
"""

import numpy as np
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementTriP1, ElementVector, MeshTri, asm, condense, solve
from skfem.models.elasticity import lame_parameters, linear_elasticity

# 1. The disc above y = 0, of 1 000 Pa, and the block below it, of 200 Pa; each with a basis of its own.
disc = MeshTri.init_circle(4).translated((0.0, 1.0)).with_boundaries({"top": lambda x: x[1] > 1.9})
block = MeshTri.init_tensor(np.linspace(-2, 2, 41), np.linspace(-1, 0, 11)).with_defaults()
bases = [Basis(mesh, ElementVector(ElementTriP1())) for mesh in (disc, block)]
stiffness = block_diag([asm(linear_elasticity(*lame_parameters(e, 0.3)), b) for e, b in zip((1e3, 2e2), bases)])

# 2. The unknowns of the block follow those of the disc.
offset = bases[0].N
contact = SkfemContact([(bases[0], 0), (bases[1], offset)], stiffness=1e4, estimator="exact")

# 3. Newton's method; the top of the disc goes down, the bottom of the block is held.
top, bottom = bases[0].get_dofs("top"), bases[1].get_dofs("bottom")
held = np.concatenate([top.all(), bottom.all() + offset])
u = np.zeros(contact.size)
u[bases[0].get_dofs(elements=True).all("u^2")] = -0.1  # all of it at first, its top for good
for iteration in range(30):
    residual = stiffness @ u - contact.force(u)
    size = np.linalg.norm(np.delete(residual, held)) / np.linalg.norm(residual)
    print(f"iteration {iteration}: residual {size:.1e}")
    if size < 1e-10:
        break
    u += solve(*condense(stiffness + contact.tangent(u, semidefinite=size > 0.1), -residual, D=held))

# 4. The check.
pressed, carried = residual[top.all("u^2")].sum(), residual[bottom.all("u^2") + offset].sum()
print(f"pressed with {-pressed:.6f}, carried {carried:.6f}")
assert size < 1e-10 and carried > 1 and abs(pressed + carried) < 1e-6 * carried
