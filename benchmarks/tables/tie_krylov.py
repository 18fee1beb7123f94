"""Iterations of conjugate gradients for two tied blocks, beside those for one block.

    python benchmarks/tables/tie_krylov.py [EDGES]

The lower unit cube has EDGES³ hexahedra (24), the upper one has 9/8 of the edges; nu = 0.3. The one block has the cells of the lower one everywhere.
The lowest face is held, and a constant body force acts. The tie is a penalty of a multiple of E / h: 10 is the suggested one, 165 is the one of
find_equilibrium. Or its equations eliminate the unknowns of one side. Tolerance 1e-8; PETSc's GAMG with rigid motions, incomplete Cholesky
factors, or GAMG with the tie solved directly (FilteredMultigrid). Needs petsc4py, dolfinx, scipy, fmc_contact and fmc_contact_dolfinx; the suite
makes the matrices. Five minutes.
"""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from fmc_contact import Contact
from fmc_contact_dolfinx import FilteredMultigrid
from petsc4py import PETSc
from scipy.sparse import block_diag, csr_matrix, identity, kron, vstack

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "suite"))
from fmc_suite import elastic, grids

YOUNG, POISSON = 1.0, 0.3
RATIOS = (0.1, 1.0, 10.0, 165.0)


def block(edges, low, high):
    """With cubes of that many edges along the unit square."""
    along = {"from": 0, "to": 1, "cells": edges}
    return grids.body({"x": along, "y": along, "z": {"from": low, "to": high, "cells": edges * (high - low)}})


def operator(matrix, points):
    matrix.sort_indices()
    parts = matrix.indptr.astype(PETSc.IntType), matrix.indices.astype(PETSc.IntType), matrix.data
    made = PETSc.Mat().createAIJ(matrix.shape, 3, csr=parts, comm=PETSc.COMM_SELF)
    coords = PETSc.Vec().createWithArray(points.ravel().copy(), bsize=3, comm=PETSc.COMM_SELF)
    made.setNearNullSpace(PETSc.NullSpace().createRigidBody(coords))
    made.setOption(PETSc.Mat.Option.SPD, True)
    return made


def iterations(made, force, precondition):
    """Of conjugate gradients to 1e-8."""
    solver = PETSc.KSP().create(PETSc.COMM_SELF)
    solver.setOperators(made)
    solver.setType("cg")
    solver.setTolerances(rtol=1e-8, max_it=5000)
    precondition(solver.getPC())
    x, right = made.createVecs()
    right.setArray(force)
    solver.solve(right, x)
    if solver.getConvergedReason() < 0:
        raise RuntimeError(f"KSP {solver.getConvergedReason()}")
    return solver.getIterationNumber()


def filtered(points, touched, bodies):
    """GAMG on levels of the bodies without the tie, and the tie solved directly. Of a space it asks for places and counts."""
    index_map = SimpleNamespace(size_local=len(points), size_global=len(points))
    mesh = SimpleNamespace(comm=PETSc.COMM_SELF, geometry=SimpleNamespace(dim=3))
    space = SimpleNamespace(mesh=mesh, dofmap=SimpleNamespace(index_map=index_map), tabulate_dof_coordinates=lambda: points)
    return FilteredMultigrid(space, lambda: touched, lambda: bodies)


class Bodies:
    """Blocks, their matrix without what is held, and the force."""

    def __init__(self, blocks):
        self.points = np.concatenate([one.points for one in blocks])
        starts = np.cumsum([0] + [len(one.points) for one in blocks])
        self.cells = np.concatenate([one.cells + start for one, start in zip(blocks, starts)])
        self.matrix = block_diag([elastic.stiffness(one.points, one.cells, YOUNG, POISSON) for one in blocks], format="csr")
        volume = elastic.gradients(self.points, self.cells)[1].sum(axis=1) / 8
        share = np.zeros(len(self.points))
        for corner in self.cells.T:
            np.add.at(share, corner, volume)
        self.force = np.outer(share, (0.3, 0.2, -1.0)).ravel()
        self.free = np.flatnonzero(self.points[:, 2] > 1e-9)

    def counts(self, added=None, to_all=None):
        """Iterations with each preconditioner: of the matrix with something added, or with unknowns eliminated."""
        points = self.points[self.free if to_all is None else self.kept]
        unknowns = (self.free[:, None] * 3 + np.arange(3)).ravel()
        bodies, force = self.matrix[unknowns][:, unknowns], self.force[unknowns]
        matrix = bodies if added is None else bodies + added[unknowns][:, unknowns]
        if to_all is not None:
            matrix, force = to_all.T @ matrix @ to_all, to_all.T @ force
        made = operator(matrix.tocsr(), points)
        found = [iterations(made, force, lambda pc, kind=kind: pc.setType(kind)) for kind in ("gamg", "icc")]
        if added is not None:
            touched = np.flatnonzero(np.diff(added[unknowns][:, unknowns].tocsr().indptr))
            found.append(iterations(made, force, filtered(points, touched, operator(bodies, points)).attach))
        return found


def eliminated(bodies, contact):
    """All free unknowns by those that are kept: the nodes that hold follow from their equations, which are the same along every axis."""
    rows = contact.tie_constraints()
    every = csr_matrix((rows.data, rows.indices, rows.indptr), (len(rows), 3 * len(bodies.points)))
    equations = every[::3][:, ::3]
    out = contact.tie_nodes(bodies.points).node
    bodies.kept = np.setdiff1d(bodies.free, out)
    weights = -np.linalg.solve(equations[:, out].toarray(), equations[:, bodies.kept].toarray())
    order = np.argsort(np.concatenate([bodies.kept, out]))
    return kron(vstack([identity(len(bodies.kept)), csr_matrix(weights)], format="csr")[order], identity(3), format="csr")


def main(edges):
    one = Bodies([block(edges, 0, 2)])
    reference = one.counts()
    two = Bodies([block(edges, 0, 1), block(edges * 9 // 8, 1, 2)])
    print(f"{one.force.size} and {two.force.size} unknowns; iterations with GAMG, by one block, with incomplete Cholesky, by one block, filtered")

    def show(name, found):
        """Both with their ratios, then the third."""
        ratios = [f"{count}, {count / of:.2f}" for count, of in zip(found, reference)]
        print(f"{name}: {', '.join([*ratios, *map(str, found[2:])])}", flush=True)

    show("one block", reference)
    contact = Contact(two.points, two.cells, "hexahedron", stiffness=edges * YOUNG)
    contact.pairs.set(0, 1, interface="tied")
    tangent = contact.tangent(two.points)
    unit = csr_matrix((tangent.data, tangent.indices, tangent.indptr), two.matrix.shape)
    for ratio in RATIOS:
        show(f"penalty {ratio:g} E/h", two.counts(ratio * unit))
    show("equations", two.counts(to_all=eliminated(two, contact)))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 24)
