"""Two blocks between smooth side walls are pressed together, in NGSolve: a uniform pressure, which is known in closed form."""

import netgen.occ as occ
import ngsolve as ngs
import numpy as np
import scipy.sparse
from fmc_contact import Contact, find_equilibrium

# 1. Two unit squares, one upon the other, with meshes that do not match; E and nu of plane strain; k = 10 E / h.
young, nu, k = 1e3, 0.3, 1e5
blocks = [occ.MoveTo(0, y).Rectangle(1, 1).Face() for y in (0, 1)]
for block, h in zip(blocks, (0.15, 0.1)):
    block.faces.maxh = h
    block.edges.Min(occ.X).name = block.edges.Max(occ.X).name = "side"
blocks[0].edges.Min(occ.Y).name, blocks[1].edges.Max(occ.Y).name = "bottom", "top"
mesh = ngs.Mesh(occ.OCCGeometry(occ.Compound(blocks), dim=2).GenerateMesh())

# 2. Elasticity in NGSolve, which numbers all displacements along x before those along y; the contact goes node by node.
V = ngs.VectorH1(mesh, order=1, dirichletx="side", dirichlety="bottom|top")
u, v = V.TnT()
strain, mu, lam = ngs.Sym(ngs.Grad(u)), young / (2 + 2 * nu), young * nu / ((1 + nu) * (1 - 2 * nu))
stress = 2 * mu * strain + lam * ngs.Trace(strain) * ngs.Id(2)
form = ngs.BilinearForm(ngs.InnerProduct(stress, ngs.Grad(v)) * ngs.dx).Assemble()
by_node = np.arange(V.ndof).reshape(2, -1).T.ravel()
K = scipy.sparse.csr_matrix(form.mat.CSR())[by_node][:, by_node]
free = np.array(V.FreeDofs())[by_node]

# 3. The contact: coordinates and triangles; at the side walls, planes of symmetry, the blocks go on.
nodes = np.array([vertex.point for vertex in mesh.vertices])
contact = Contact(nodes, [[p.nr for p in cell.vertices] for cell in mesh.Elements()], "triangle", stiffness=k)
contact.mesh.set_symmetry_nodes(np.flatnonzero((nodes[:, 0] < 1e-9) | (nodes[:, 0] > 1 - 1e-9)))

# 4. The equilibrium: the top goes down by a thousandth.
top, bottom = nodes[:, 1] > 2 - 1e-9, nodes[:, 1] < 1e-9
prescribed = nodes - 1e-3 * np.outer(top, (0, 1))
step = find_equilibrium(lambda x: (K @ (x - nodes).ravel(), K), contact, nodes, free, prescribed)

# 5. The checks: blocks and contact are springs in series, the pressure is the same everywhere, the forces balance.
expected = 1e-3 / (2 / (2 * mu + lam) + 1 / k)
pressure = contact.nodal_contact(step.x).pressure[abs(nodes[:, 1] - 1) < 1e-9]
pressed, carried = step.reactions[top, 1].sum(), step.reactions[bottom, 1].sum()
print(f"carried {carried:.6f}, closed form {expected:.6f}, out of balance by {abs(pressed + carried):.0e}")
print(f"pressure at the {len(pressure)} nodes in contact: {pressure.min():.6f} to {pressure.max():.6f}")
print(f"penetration {step.result.penetration:.4e}, closed form {expected / k:.4e}; {step.iterations} iterations")
assert abs(pressed + carried) < 1e-9 * carried
# Up to the strain and to the penetration, by the size of a facet: both are below 1e-3.
assert abs(carried / expected - 1) < 1e-4 and abs(pressure / expected - 1).max() < 1e-3
