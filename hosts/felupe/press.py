"""A block is pressed into a larger one and lifted by half, in FElupe: meshes that do not match, and nothing to choose."""

import felupe as fem
import numpy as np
from fmc_contact import Contact, find_equilibrium

# 1. Two blocks of hexahedra in one mesh. They touch from the start.
mesh = fem.mesh.concatenate([fem.Cube(n=5), fem.Cube(a=(0.2, 0.2, 1.0), b=(0.8, 0.8, 1.6), n=4)])
points, cells = mesh.points, mesh.cells

# 2. The bodies without contact: internal forces at coordinates x, and their derivative.
field = fem.FieldContainer([fem.Field(fem.RegionHexahedron(mesh), dim=3)])
bodies = fem.SolidBody(fem.LinearElastic(E=1e6, nu=0.3), field)


def host(x):
    field[0].values[:] = x - points
    return bodies.assemble.vector(field).toarray(), bodies.assemble.matrix(field)


# 3. The contact. FElupe has its unknowns in the contact's order, node * 3 + axis.
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
