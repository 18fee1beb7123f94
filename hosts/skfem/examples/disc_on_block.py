"""A disc is pressed into a block by 0.1: two bodies, two meshes that do not match, and no supermesh.

Checked: what the disc's top is pressed with is what the block's bottom carries, in at most 8 iterations a load step.
"""

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementTriP1, ElementVector, MeshTri, asm
from skfem.models.elasticity import lame_parameters, linear_elasticity

# 1. The disc above y = 0, of 1 000 Pa, and the block below it, of 200 Pa; each with a basis of its own.
disc = MeshTri.init_circle(4).translated((0.0, 1.0)).with_boundaries({"top": lambda x: x[1] > 1.9})
block = MeshTri.init_tensor(np.linspace(-2, 2, 41), np.linspace(-1, 0, 11)).with_defaults()
bases = [Basis(mesh, ElementVector(ElementTriP1())) for mesh in (disc, block)]
bodies = block_diag([asm(linear_elasticity(*lame_parameters(e, 0.3)), b) for e, b in zip((1e3, 2e2), bases)], "csr")

# 2. The unknowns of the block follow those of the disc; k = 10 E / h of the softer body.
offset = bases[0].N
contact = SkfemContact([(bases[0], 0), (bases[1], offset)], stiffness=2e4, law="depth", estimator="auto")

# 3. The equilibrium; the top of the disc goes down, the bottom of the block is held.
top, bottom = bases[0].get_dofs("top"), bases[1].get_dofs("bottom")
free = np.setdiff1d(np.arange(contact.size), np.concatenate([top.all(), bottom.all() + offset]))
u = np.zeros(contact.size)
for push in (0.01, 0.04, 0.1):
    prescribed = u.copy()
    prescribed[top.all("u^2")] = -push
    step = find_equilibrium(lambda u: (bodies @ u, bodies), contact, u, free, prescribed)
    u = step.x
    print(f"pushed by {push}: {step.iterations} iterations, residual {step.residuals[-1]:.1e}")
    assert step.iterations <= 8

# 4. The check.
pressed, carried = step.reactions[top.all("u^2")].sum(), step.reactions[bottom.all("u^2") + offset].sum()
print(f"pressed with {-pressed:.6f}, carried {carried:.6f}")
assert carried > 1 and abs(pressed + carried) < 1e-6 * carried
