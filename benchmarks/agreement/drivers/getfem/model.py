"""The bodies of a case in a model of GetFEM: each has a mesh and a variable of its own, since GetFEM takes nodes at one place for
one. Quadrature is that of the reference host."""

from __future__ import annotations

import getfem as gf
import numpy as np
from fmc_agreement.faces import loads
from fmc_agreement.problem import Problem
from fmc_contact_getfem.cells import element, mesh_from_cells
from fmc_contact_getfem.system import is_linear, residual_and_tangent
from scipy.sparse import csr_matrix

# One point in triangles and tetrahedra, two along every axis of the others; of second order three in triangles, four in
# tetrahedra, three along every axis of the others.
QUADRATURE = {
    "triangle": "IM_TRIANGLE(1)",
    "quad": "IM_GAUSS_PARALLELEPIPED(2,3)",
    "tetra": "IM_TETRAHEDRON(1)",
    "hexahedron": "IM_GAUSS_PARALLELEPIPED(3,3)",
    "triangle6": "IM_TRIANGLE(2)",
    "quad9": "IM_GAUSS_PARALLELEPIPED(2,5)",
    "tetra10": "IM_TETRAHEDRON(2)",
    "hexahedron27": "IM_GAUSS_PARALLELEPIPED(3,5)",
}


def neo_hookean(variable: str, dim: int) -> str:
    """W = G/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2, in plane strain where there are two axes, in GetFEM's language."""
    f = f"(Id({dim})+Grad_{variable})"
    return f"(shear_{variable}/2)*(pow(Det{f},-2/3)*(Norm_sqr{f}+{3 - dim})-3)+(bulk_{variable}/2)*sqr(Det{f}-1)"


class Model:
    """A model without supports, loads and contact. Displacements and forces of its functions are (nodes, dim), in the case's
    numbering, matrices have the unknown ``node * dim + axis``."""

    def __init__(self, problem: Problem) -> None:
        gf.util("trace level", 0)
        gf.util("warning level", 0)
        self.problem, self.model = problem, gf.Model("real")
        self.variables = [f"u{number}" for number in range(len(problem.bodies))]
        self.meshes, self.spaces, self.quadratures, self.energies = [], [], [], []
        for variable, body in zip(self.variables, problem.bodies):
            mesh = mesh_from_cells(problem.coords[body.nodes], np.searchsorted(body.nodes, body.conn), body.cell_type)
            space = gf.MeshFem(mesh, problem.dim)
            space.set_fem(element(body.cell_type))
            quadrature = gf.MeshIm(mesh, gf.Integ(QUADRATURE[body.cell_type]))
            self.model.add_fem_variable(variable, space)
            material = body.material
            for name in ("lame", "shear", "bulk"):
                self.model.add_initialized_data(f"{name}_{variable}", [getattr(material, name)])
            if material.law == "linear-elastic":
                self.model.add_isotropic_linearized_elasticity_brick(
                    quadrature, variable, f"lame_{variable}", f"shear_{variable}"
                )
                strain = f"Sym(Grad_{variable})"
                energy = f"(lame_{variable}/2)*sqr(Trace({strain}))+shear_{variable}*Norm_sqr({strain})"
            else:
                energy = neo_hookean(variable, problem.dim)
                self.model.add_nonlinear_term(quadrature, energy)
            for kept, one in zip((self.meshes, self.spaces, self.quadratures, self.energies), (mesh, space, quadrature, energy)):
                kept.append(one)
        self._in_body, self._of_body = self._numbered()
        self.loaded = self._loads()
        """Regions of loaded faces: variable, number, and name of the data with the traction."""
        self._linear = residual_and_tangent(self.model, True)[1] if is_linear(self.model) else None

    def _numbered(self) -> tuple[np.ndarray, np.ndarray]:
        """Unknowns of every node in its variable, (nodes, dim), and its body; nodes and points of a mesh have the same numbers."""
        in_body, of_body = np.empty(self.problem.coords.shape, int), np.empty((len(self.problem.coords), 1), int)
        for number, (space, mesh, body) in enumerate(zip(self.spaces, self.meshes, self.problem.bodies)):
            points = mesh.pid_from_cvid()[0].reshape(len(body.conn), -1)
            in_body[body.nodes[points]] = space.basic_dof_from_cvid()[0].reshape(*points.shape, self.problem.dim)
            of_body[body.nodes] = number
        return in_body, of_body

    @property
    def dofs(self) -> np.ndarray:
        """Unknowns of the state, (nodes, dim), which move where the model gets another variable."""
        first = np.array([self.interval(variable)[0] for variable in self.variables])
        return first[self._of_body] + self._in_body

    def state(self, u: np.ndarray) -> np.ndarray:
        """From (nodes, dim) to the state of the model."""
        found = np.zeros(self.model.nbdof())
        found[self.dofs] = u
        return found

    def displacement(self) -> np.ndarray:
        """That of the model, (nodes, dim)."""
        return self.model.from_variables()[self.dofs]

    def _loads(self) -> list[tuple[str, int, str]]:
        found = []
        for one, (faces, traction) in zip(self.problem.raw["loads"], loads(self.problem)):
            if np.ptp(traction, axis=0).max() > 1e-12 * np.abs(traction).max():
                raise NotImplementedError("a load on faces that are not in one plane")
            number, data = 1 + len(found), f"traction{1 + len(found)}"
            self.meshes[one["body"]].set_region(number, self._of_surface(one["body"], faces))
            self.model.add_initialized_data(data, traction[0])
            found.append((self.variables[one["body"]], number, data))
        return found

    def _of_surface(self, number: int, wanted: np.ndarray) -> np.ndarray:
        """Faces of a body as GetFEM names them, by cell and number in it, (2, faces), from their corners in the case."""
        body, mesh = self.problem.bodies[number], self.meshes[number]
        outer, points = mesh.outer_faces(), mesh.pid_from_cvid()[0].reshape(len(body.conn), -1)
        local = [np.isin(points[0], mesh.pid_in_faces([[0], [face]])) for face in range(outer[1].max() + 1)]
        keys = {frozenset(face) for face in wanted.tolist()}
        corners = np.isin(np.arange(len(self.problem.coords)), wanted)
        chosen = []
        for cell, face in outer.T:
            nodes = body.nodes[points[cell][local[face]]]
            # Middles of faces of second order are in none of those that are wanted.
            chosen.append(frozenset(nodes[corners[nodes]].tolist()) in keys)
        chosen = outer[:, chosen]
        if chosen.shape[1] != len(keys):
            raise ValueError("a loaded face is not of the surface")
        return chosen

    def add_loads(self) -> None:
        """The tractions, as bricks, for a model that GetFEM solves by itself."""
        for variable, region, data in self.loaded:
            quadrature = self.quadratures[self.variables.index(variable)]
            self.model.add_source_term_brick(quadrature, variable, data, region)

    def add_supports(self) -> None:
        """What is held, at the end of the first stage, by multipliers, for the same."""
        for variable, body in zip(self.variables, self.problem.bodies):
            first, count = self.interval(variable)
            held = self.problem.held[body.nodes]
            rows = gf.Spmat("empty", int(held.sum()), count)
            for row, dof in enumerate(self.dofs[body.nodes][held] - first):
                rows.add([row], [int(dof)], 1.0)
            self.model.add_variable(f"support_{variable}", int(held.sum()))
            values = self.problem.prescribed[body.nodes][held]
            self.model.add_constraint_with_multipliers(variable, f"support_{variable}", rows, values)

    def interval(self, variable: str) -> tuple[int, int]:
        """First unknown of a variable in the state, and how many it has."""
        first, count = (int(number) for number in self.model.interval_of_variable(variable))
        return first, count

    def load(self) -> np.ndarray:
        """Forces of the tractions on faces."""
        total = np.zeros(self.model.nbdof())
        for variable, region, data in self.loaded:
            quadrature = self.quadratures[self.variables.index(variable)]
            total += gf.asm_generic(quadrature, 1, f"{data}.Test_{variable}", region, self.model)
        return total[self.dofs]

    def mass(self) -> np.ndarray:
        """Lumped mass of every unknown of the state."""
        total = np.zeros(self.model.nbdof())
        for variable, quadrature, body in zip(self.variables, self.quadratures, self.problem.bodies):
            every = ",".join([repr(body.material.density)] * self.problem.dim)
            total += gf.asm_generic(quadrature, 1, f"[{every}].Test_{variable}", -1, self.model)
        return total

    def elastic(self, state: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces on the state, and strain energy; not finite where a cell is inverted."""
        self.model.to_variables(state)
        if self._linear is not None:
            force = self._linear @ state
            return force, float(0.5 * force @ state)
        self.model.assembly("build_rhs")
        each = zip(self.quadratures, self.energies)
        energy = sum(gf.asm_generic(quadrature, 0, energy, -1, self.model) for quadrature, energy in each)
        return -self.model.rhs(), float(energy)

    def internal(self, u: np.ndarray) -> tuple[np.ndarray, float]:
        """Internal forces and strain energy at displacements of nodes."""
        force, energy = self.elastic(self.state(u))
        return force[self.dofs], energy

    def stiffness(self, u: np.ndarray) -> csr_matrix:
        """Derivative of the internal forces."""
        dofs, matrix = self.dofs.ravel(), self._linear
        if matrix is None:
            self.model.to_variables(self.state(u))
            matrix = residual_and_tangent(self.model, False)[1]
        return matrix[dofs][:, dofs]

    def stresses_along(self, u: np.ndarray, axis: int) -> np.ndarray:
        """Normal stress of linear elastic bodies along an axis, the mean of every cell."""
        self.model.to_variables(self.state(u))
        found = []
        for variable, mesh, quadrature in zip(self.variables, self.meshes, self.quadratures):
            cells = gf.MeshFem(mesh, 1)
            cells.set_classical_discontinuous_fem(0)
            stress = f"lame_{variable}*Trace(Grad_{variable})+2*shear_{variable}*Grad_{variable}({axis + 1},{axis + 1})"
            over = [
                gf.asm_generic(quadrature, 1, f"({what})*Test_mean", -1, self.model, "mean", 1, cells, np.zeros(cells.nbdof()))
                for what in (stress, "1")
            ]
            found.append((over[0] / over[1])[-cells.nbdof() :])
        return np.concatenate(found)
