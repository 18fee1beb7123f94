"""A block is pressed into a larger one and lifted by half, in MFEM: meshes that do not match, and nothing to choose."""

import mfem.ser as mfem
import numpy as np
from fmc_contact import Contact, OnUnknowns, find_equilibrium
from scipy.sparse import csr_matrix

# 1. Two blocks of hexahedra in one mesh. They touch from the start.
blocks = [mfem.Mesh.MakeCartesian3D(n, n, n, mfem.Element.HEXAHEDRON, s, s, s) for n, s in ((4, 1.0), (3, 0.6))]
points = np.vstack([np.array(block.GetVertexArray()) + at for block, at in zip(blocks, ((0, 0, 0), (0.2, 0.2, 1.0)))])
cells = [block.GetElementVertices(e) for block in blocks for e in range(block.GetNE())]
cells = np.array(cells) + np.where(np.arange(len(cells)) < 64, 0, 125)[:, None]
mesh = mfem.Mesh(3, len(points), len(cells))
for point in points:
    mesh.AddVertex(*point)
for cell in cells:
    mesh.AddHex([int(node) for node in cell])
mesh.FinalizeHexMesh(1)

# 2. The bodies without contact: internal forces at displacements u, and their derivative.
space = mfem.FiniteElementSpace(mesh, mfem.H1_FECollection(1, 3), 3)
form = mfem.BilinearForm(space)
mu, lam = (mfem.ConstantCoefficient(value) for value in (1e6 / 2.6, 0.3e6 / (1.3 * 0.4)))
form.AddDomainIntegrator(mfem.ElasticityIntegrator(lam, mu))
form.Assemble()
form.Finalize()
K = form.SpMat()
K = csr_matrix((K.GetDataArray(), K.GetJArray(), K.GetIArray()))
host = lambda u: (K @ u, K)

# 3. The contact. MFEM has all displacements along x first, then along y, then along z.
unknowns = np.arange(K.shape[0]).reshape(3, -1).T
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
