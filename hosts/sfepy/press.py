"""A block is pressed into a larger one and lifted by half, in SfePy: meshes that do not match, and nothing to choose."""

import numpy as np
from fmc_contact import Contact, find_equilibrium
from sfepy.base.base import output
from sfepy.discrete import Equation, Equations, FieldVariable, Integral, Material, Problem
from sfepy.discrete.fem import FEDomain, Field, Mesh
from sfepy.mechanics.matcoefs import stiffness_from_youngpoisson
from sfepy.mesh.mesh_generators import gen_block_mesh
from sfepy.terms import Term

# 1. Two blocks of hexahedra in one mesh. They touch from the start.
output.set_output(quiet=True)
blocks = [gen_block_mesh(*of, verbose=False) for of in ([[1] * 3, [5] * 3, [0.5] * 3], [[0.6] * 3, [4] * 3, [0.5, 0.5, 1.3]])]
points = np.vstack([block.coors for block in blocks])
cells = np.vstack([blocks[0].get_conn("3_8"), blocks[1].get_conn("3_8") + blocks[0].n_nod])
domain = FEDomain("both", Mesh.from_data("both", points, None, [cells], [np.zeros(len(cells), np.int32)], ["3_8"]))

# 2. The bodies without contact: internal forces at coordinates x, and their derivative.
omega = domain.create_region("Omega", "all")
field = Field.from_args("u", np.float64, "vector", omega, approx_order=1)
u, v = FieldVariable("u", "unknown", field), FieldVariable("v", "test", field, primary_var_name="u")
material = Material("m", D=stiffness_from_youngpoisson(3, 1e6, 0.3))
term = Term.new("dw_lin_elastic(m.D, v, u)", Integral("i", order=2), omega, m=material, v=v, u=u)
problem = Problem("bodies", equations=Equations([Equation("balance", term)]))
problem.time_update()
problem.update_materials()
K = problem.equations.evaluate(mode="weak", dw_mode="matrix", asm_obj=0 * problem.mtx_a)
host = lambda x: (K @ (x - points).ravel(), K)

# 3. The contact. SfePy has its unknowns in the contact's order, node * 3 + axis.
contact = Contact(points, cells, "hexahedron")

# 4. Bottom and top are held, and the top is moved: two load steps, the second from the end of the first.
height, x = points[:, 2], points
free = np.repeat((height > 0) & (height < 1.599), 3)
for push in (0.01, 0.005):
    goal = points - push * np.outer(height > 1.599, (0, 0, 1))
    step = find_equilibrium(host, contact, x, free, goal)
    x = step.x
    force = step.result.bodies[1].force[2]
    print(f"pushed by {push}: force {force:.6f}, {step.iterations} linear solves, {step.warnings or 'no warnings'}")
