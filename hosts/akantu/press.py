"""A block is pressed into a larger one and lifted by half, in Akantu: meshes that do not match, and nothing to choose."""

from tempfile import NamedTemporaryFile

import akantu as aka
import numpy as np
from fmc_contact import Contact, find_equilibrium
from scipy.sparse import csr_matrix


# 1. Two blocks of hexahedra in one mesh. They touch from the start.
def block(low, high, n, first):
    points = np.stack(np.meshgrid(*np.linspace(low, high, n + 1).T, indexing="ij"), -1).reshape(-1, 3)
    k = np.arange(first, first + len(points)).reshape([n + 1] * 3)
    corners = [(i, j, m) for m in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return points, np.stack([k[i : n + i, j : n + j, m : n + m].ravel() for i, j, m in corners], 1)


blocks = block((0, 0, 0), (1, 1, 1), 4, 0), block((0.2, 0.2, 1.0), (0.8, 0.8, 1.6), 3, 125)
points, cells = (np.vstack(both) for both in zip(*blocks))
mesh = aka.Mesh(3)
access = aka.MeshAccessor(mesh)
mesh.addConnectivityType(aka._hexahedron_8)
access.resizeConnectivity(len(cells), aka._hexahedron_8)
access.resizeNodes(len(points))
mesh.getConnectivity(aka._hexahedron_8)[:] = cells
mesh.getNodes()[:] = points
access.makeReady()

# 2. The bodies without contact: internal forces at coordinates x, and their derivative.
with NamedTemporaryFile("w") as file:
    print("material elastic [\n name = both\n rho = 1\n E = 1e6\n nu = 0.3\n]", file=file, flush=True)
    aka.parseInput(file.name)
model = aka.SolidMechanicsModel(mesh)
model.initFull(_analysis_method=aka._static)


def host(x):
    model.getDisplacement()[:] = x - points
    model.assembleInternalForces()
    model.assembleStiffnessMatrix()
    K = aka.AkantuSparseMatrix(model.getDOFManager().getMatrix("K"))
    return -model.getInternalForce(), csr_matrix(K)


# 3. The contact. Akantu has its unknowns in the contact's order, node * 3 + axis.
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
