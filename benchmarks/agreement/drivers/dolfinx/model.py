"""The bodies of a case in dolfinx: one mesh and one space, with the quadrature of the reference host."""

from __future__ import annotations

from typing import Any

import numpy as np
import ufl
from dolfinx import fem, mesh
from fmc_agreement.faces import loads
from fmc_agreement.problem import Problem
from fmc_contact_dolfinx.space import Displacement
from fmc_contact_dolfinx.surface import owned_faces
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI
from petsc4py import PETSc

# One point in simplices, two along every axis of the others; of second order three in triangles, four in tetrahedra, three along
# every axis of the others.
DEGREES = {"triangle": 1, "tetra": 1, "triangle6": 2, "tetra10": 2, "quad9": 5, "hexahedron27": 5}


class Model:
    """Forms of the internal forces and of the load, and what is held."""

    def __init__(self, problem: Problem, comm: Any = MPI.COMM_WORLD) -> None:
        self.problem, self.dim = problem, problem.dim
        conn = np.concatenate([body.conn for body in problem.bodies])
        self.mesh = mesh_from_cells(comm, problem.coords, conn, problem.cell_type)
        self.space = vector_space(self.mesh, problem.order)
        self.displacement = Displacement(self.space)
        cells = self.mesh.topology.index_map(self.dim)
        self.body_of_cell = problem.body_of_cell[self.mesh.topology.original_cell_index]
        assert len(self.body_of_cell) == cells.size_local + cells.num_ghosts
        degree = DEGREES.get(problem.cell_type, 3)
        self.dx = ufl.dx(domain=self.mesh, metadata={"quadrature_degree": degree})
        self.u, self.v = fem.Function(self.space), ufl.TestFunction(self.space)
        self.input_number = np.asarray(self.mesh.geometry.input_global_indices)
        self.energy, self.internal = self._energy()
        self.load = self._load()
        self.bcs = self._held()

    def of_cells(self, name: str) -> Any:
        """A number of the material at every cell."""
        space = self._constants()
        function = fem.Function(space)
        values = np.array([getattr(body.material, name) for body in self.problem.bodies])
        table = space.dofmap.list
        table = np.asarray(table.array if hasattr(table, "array") else table).ravel()
        function.x.array[table] = values[self.body_of_cell]
        return function

    def _constants(self) -> Any:
        make = fem.functionspace if hasattr(fem, "functionspace") else fem.FunctionSpace
        return make(self.mesh, ("DG", 0))

    def _energy(self) -> tuple[Any, Any]:
        """Strain energy and its derivative."""
        (law,) = {body.material.law for body in self.problem.bodies}
        u = self.u
        shear = self.of_cells("shear")
        if law == "linear-elastic":
            lame, strain = self.of_cells("lame"), ufl.sym(ufl.grad(u))
            density = 0.5 * lame * ufl.tr(strain) ** 2 + shear * ufl.inner(strain, strain)
        else:
            f = ufl.Identity(self.dim) + ufl.grad(u)
            j, i1 = ufl.det(f), ufl.inner(f, f) + (3 - self.dim)
            density = 0.5 * shear * (j ** (-2.0 / 3.0) * i1 - 3.0) + 0.5 * self.of_cells("bulk") * (j - 1.0) ** 2
        energy = density * self.dx
        return energy, ufl.derivative(energy, u, self.v)

    def _load(self) -> Any:
        """Work of the tractions; ``None`` without loads."""
        faces = owned_faces(self.displacement)
        number = {tuple(sorted(f)): k for k, f in enumerate(self.input_number[faces.corners].tolist())}
        total = None
        for nodes, traction in loads(self.problem):
            here = [(number.get(tuple(sorted(face))), t) for face, t in zip(nodes.tolist(), traction)]
            for direction in np.unique(np.round(traction, 12), axis=0):
                facets = [faces.facets[k] for k, t in here if k is not None and np.allclose(t, direction, atol=1e-11)]
                facets = np.sort(np.array(facets, np.int32))
                tags = mesh.meshtags(self.mesh, self.dim - 1, facets, np.ones(len(facets), np.int32))
                ds = ufl.Measure("ds", self.mesh, subdomain_data=tags, metadata={"quadrature_degree": 3})
                pull = fem.Constant(self.mesh, PETSc.ScalarType(tuple(direction)))
                part = ufl.inner(pull, self.v) * ds(1)
                total = part if total is None else total + part
        return total

    def _held(self) -> list[Any]:
        """A boundary condition for every component and value that is prescribed."""
        blocks = np.empty(len(self.input_number), np.int32)
        of_cells = self.displacement.node_blocks()
        blocks[self.displacement.given_geometry(len(of_cells)).ravel()] = of_cells.ravel()
        held, values = self.problem.held[self.input_number], self.problem.prescribed[self.input_number]
        conditions = []
        for axis in range(self.dim):
            for value in np.unique(self.problem.prescribed[self.problem.held[:, axis], axis]):
                here = held[:, axis] & (values[:, axis] == value)
                dofs = np.sort(blocks[here] * self.dim + axis).astype(np.int32)
                conditions.append(fem.dirichletbc(PETSc.ScalarType(value), dofs, self.space.sub(axis)))
        return conditions

    def assembled(self, form: Any) -> np.ndarray:
        """What this rank owns of an assembled vector."""
        from dolfinx.fem.petsc import assemble_vector

        vector = assemble_vector(form)
        vector.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
        return vector.array.copy()
