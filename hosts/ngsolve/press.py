"""A block is pressed into a larger one and lifted by half, in NGSolve: meshes that do not match, and nothing to choose."""

import ngsolve as ngs
import numpy as np
from fmc_contact import Contact, OnUnknowns, find_equilibrium
from netgen.meshing import Element3D, FaceDescriptor, Mesh, MeshPoint
from ngsolve.meshes import MakeStructured3DMesh
from scipy.sparse import csr_matrix

# 1. Two blocks of hexahedra in one mesh. They touch from the start.
both = Mesh(dim=3)
both.Add(FaceDescriptor(bc=1))
for n, size, corner in ((4, 1.0, (0, 0, 0)), (3, 0.6, (0.2, 0.2, 1.0))):
    block = MakeStructured3DMesh(True, n, n, n, mapping=lambda *p: tuple(size * np.array(p) + corner))
    number = {vertex.nr: both.Add(MeshPoint(vertex.point)) for vertex in block.vertices}
    for cell in block.Elements():
        both.Add(Element3D(1, [number[vertex.nr] for vertex in cell.vertices]))
mesh = ngs.Mesh(both)
points = np.array([vertex.point for vertex in mesh.vertices])
cells = np.array([[vertex.nr for vertex in cell.vertices] for cell in mesh.Elements()])

# 2. The bodies without contact: internal forces at displacements u, and their derivative.
V = ngs.VectorH1(mesh, order=1)
trial, test = V.TnT()
strain, mu, lam = ngs.Sym(ngs.Grad(trial)), 1e6 / 2.6, 0.3e6 / (1.3 * 0.4)
stress = 2 * mu * strain + lam * ngs.Trace(strain) * ngs.Id(3)
form = ngs.BilinearForm(ngs.InnerProduct(stress, ngs.Grad(test)) * ngs.dx).Assemble()
K = csr_matrix(form.mat.CSR())
host = lambda u: (K @ u, K)

# 3. The contact. NGSolve has all displacements along x first, then along y, then along z.
unknowns = np.arange(V.ndof).reshape(3, -1).T
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
