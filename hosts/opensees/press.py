"""A block is pressed into a larger one and lifted by half, in OpenSees: meshes that do not match, and nothing to choose."""

import numpy as np
import openseespy.opensees as ops
from fmc_contact import Contact, OnUnknowns, find_equilibrium


# 1. Two blocks of hexahedra. They touch from the start.
def block(low, high, n, first):
    points = np.stack(np.meshgrid(*np.linspace(low, high, n + 1).T, indexing="ij"), -1).reshape(-1, 3)
    k = np.arange(first, first + len(points)).reshape([n + 1] * 3)
    corners = [(i, j, m) for m in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return points, np.stack([k[i : n + i, j : n + j, m : n + m].ravel() for i, j, m in corners], 1)


blocks = block((0, 0, 0), (1, 1, 1), 4, 0), block((0.2, 0.2, 1.0), (0.8, 0.8, 1.6), 3, 125)
points, cells = (np.vstack(both) for both in zip(*blocks))

# 2. The bodies without contact. Their matrix, and the equation of every displacement, are known after one step without loads.
ops.wipe()
ops.model("basic", "-ndm", 3, "-ndf", 3)
ops.nDMaterial("ElasticIsotropic", 1, 1e6, 0.3)
for node, point in enumerate(points):
    ops.node(node, *point.tolist())
for number, cell in enumerate(cells):
    ops.element("stdBrick", number, *cell.tolist(), 1)
ops.constraints("Plain"), ops.numberer("RCM"), ops.system("FullGeneral")
ops.algorithm("Linear"), ops.integrator("LoadControl", 0.0), ops.analysis("Static", "-noWarnings"), ops.analyze(1)
K = np.array(ops.printA("-ret")).reshape(ops.systemSize(), -1)
host = lambda u: (K @ u, K)

# 3. The contact, on the equations of OpenSees.
unknowns = np.array([ops.nodeDOFs(node) for node in range(len(points))])
contact = OnUnknowns(Contact(points, cells, "hexahedron"), points, unknowns)

# 4. Bottom and top are held, and the top is moved: two load steps, the second from the end of the first.
height, u = points[:, 2], np.zeros(contact.size)
free = unknowns[(height > 0) & (height < 1.599)].ravel()
for push in (0.01, 0.005):
    goal = np.zeros(contact.size)
    goal[unknowns[height > 1.599, 2]] = -push
    step = find_equilibrium(host, contact, u, free, goal)
    u = step.x
    force = step.result.bodies[1].force[2]
    print(f"pushed by {push}: force {force:.6f}, {step.iterations} linear solves, {step.warnings or 'no warnings'}")
