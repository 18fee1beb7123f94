"""Krylov iterations of two elastic blocks in contact, by stiffness of contact, size and ranks.

    mpirun -n 4 python large_blocks.py [cells along an edge, 14] [--plain]

The upper block is pressed into the lower one, of which the mesh does not match. k h / E says how much stiffer the contact is than
a layer of cells: k is the stiffness of contact, h the size of a cell, E Young's modulus. Linear systems of the
search for the equilibrium are solved by conjugate gradients to 1e-8. `--plain`: multigrid without the direct solve on the contact, for comparison.
"""

import sys

import numpy as np
import ufl
from dolfinx import fem, mesh
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, FilteredMultigrid, find_equilibrium
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI

comm = MPI.COMM_WORLD
numbers = [int(word) for word in sys.argv[1:] if word.isdigit()]
count, is_plain = (numbers or [14])[0], "--plain" in sys.argv
young, poisson, down = 1.0, 0.3, 0.002


def block(count, low, high):
    """Nodes and tetrahedra of a cuboid."""
    ticks = [np.linspace(low[a], high[a], count + 1) for a in range(3)]
    x = np.stack(np.meshgrid(*ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    number = np.arange(len(x)).reshape([count + 1] * 3)
    at = lambda *s: number[tuple(slice(k, k + count) for k in s)].ravel()
    around = ((0, 0), (1, 0), (1, 1), (0, 1))
    cells = np.stack([at(*corner, k) for k in (0, 1) for corner in around], axis=1)
    paths = ([0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6])
    return x, np.concatenate([cells[:, path] for path in paths])


x, cells = block(count, (0, 0, 0), (1, 1, 1))
y, more = block(max(count - 2, 2), (0.1, 0.1, 1.0 - down), (0.9, 0.9, 1.8 - down))
domain = mesh_from_cells(comm, np.concatenate([x, y]), np.concatenate([cells, more + len(x)]), "tetra")
space = vector_space(domain, 1)
unknown_count = 3 * space.dofmap.index_map.size_global


def elastic(u, v):
    """Virtual work of Hooke's law."""
    shear, lame = young / 2 / (1 + poisson), young * poisson / (1 + poisson) / (1 - 2 * poisson)
    strain = ufl.sym(ufl.grad(u))
    return ufl.inner(2 * shear * strain + lame * ufl.tr(strain) * ufl.Identity(3), ufl.sym(ufl.grad(v))) * ufl.dx


def held(height, value):
    facets = mesh.locate_entities_boundary(domain, 2, lambda x: np.isclose(x[2], height))
    dofs = fem.locate_dofs_topological(space, 2, facets)
    return fem.dirichletbc(np.array([0.0, 0.0, value]), dofs, space)


bcs = [held(0.0, 0.0), held(1.8 - down, -down)]
for ratio in (1, 10, 100, 1000):
    u = fem.Function(space)
    contact = DolfinxContact(space, stiffness=ratio * young * count, law="fiber", in_parts=False)
    contact.keep_patches(u)
    problem = ContactProblem(elastic(u, ufl.TestFunction(space)), u, bcs, contact)
    solver = problem.iterative_solver()
    if is_plain:
        FilteredMultigrid(space, lambda: problem.touched, problem.bodies, filtered=False).attach(solver.getPC())
    krylov = []
    solver.setMonitor(lambda ksp, iteration, _: krylov.append(iteration))
    steps = find_equilibrium(problem, solver, tolerance=1e-8).iterations
    each = [n for n, after in zip(krylov, krylov[1:] + [0]) if after == 0]
    touched = comm.allreduce(len(problem.touched))
    force = contact.evaluate(u).bodies[1].force[2]
    if comm.rank == 0:
        kind = "multigrid" if is_plain else "filtered"
        print(f"| {unknown_count} | {comm.size} | {kind} | {ratio} | {touched} | {steps} | {max(each)} | {force:.9g} |", flush=True)
