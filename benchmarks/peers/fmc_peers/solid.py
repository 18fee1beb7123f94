"""A body of a case in GetFEM: its mesh, its unknowns, what is held, and the order of nodes."""

from __future__ import annotations

from typing import Callable

import getfem as gf
import numpy as np
from fmc_agreement.problem import Body, Problem

# Geometry, element, integration of the stresses and of the contact, and the order of a cell's corners in GetFEM, by VTK's.
# One point in a triangle gives the same stresses, but on the wedge GetFEM then takes twice the time.
_CELLS = {
    "triangle": ("GT_PK(2,1)", "FEM_PK(2,1)", "IM_TRIANGLE(2)", "IM_TRIANGLE(4)", [0, 1, 2]),
    "quad": (
        "GT_QK(2,1)",
        "FEM_QK(2,1)",
        "IM_GAUSS_PARALLELEPIPED(2,3)",
        "IM_GAUSS_PARALLELEPIPED(2,5)",
        [0, 1, 3, 2],
    ),
    "tetra": ("GT_PK(3,1)", "FEM_PK(3,1)", "IM_TETRAHEDRON(2)", "IM_TETRAHEDRON(2)", [0, 1, 2, 3]),
}


class Solid:
    """A body with displacement `variable` in a model."""

    def __init__(self, problem: Problem, body: Body, variable: str = "u"):
        transform, element, quadrature, fine, order = _CELLS[body.cell_type]
        self.variable, self.body, self.dim = variable, body, problem.dim
        self.nodes = body.nodes
        """Numbers of its nodes in the case, ascending; here they count from 0."""
        self.coords = problem.coords[self.nodes]
        conn = np.searchsorted(self.nodes, body.conn)[:, order]
        self.mesh = gf.Mesh("empty", self.dim)
        self.mesh.add_point(self.coords.T)
        self.mesh.add_convex(gf.GeoTrans(transform), self.coords[conn].transpose(2, 1, 0))
        self.space = gf.MeshFem(self.mesh, self.dim)
        self.space.set_fem(gf.Fem(element))
        self.scalar = gf.MeshFem(self.mesh, 1)
        self.scalar.set_fem(gf.Fem(element))
        self.quadrature = gf.MeshIm(self.mesh, gf.Integ(quadrature))
        self.contact_quadrature = gf.MeshIm(self.mesh, gf.Integ(fine))
        corners = self.mesh.pid_from_cvid()[0].reshape(len(conn), -1)
        dofs = self.space.basic_dof_from_cvid()[0].reshape(len(conn), -1, self.dim)
        self.dofs = np.zeros(self.coords.shape, int)
        """Unknown of every component of every node, (nodes, dim)."""
        self.dofs[corners] = dofs
        self.outer = self.mesh.outer_faces()
        """Cell and number of every face of the surface, (2, faces)."""
        local = [
            [list(corners[0]).index(point) for point in self.mesh.pid_in_faces([[0], [face]])]
            for face in range(self.outer[1].max() + 1)
        ]
        self.face_nodes = corners[self.outer[0][:, None], np.array(local)[self.outer[1]]]
        """Nodes of these faces, (faces, corners)."""

    def region(self, number: int, wanted: Callable[[np.ndarray], bool]) -> None:
        """Makes a region of the outer faces whose corners (corners, dim) are wanted."""
        chosen = [wanted(self.coords[nodes]) for nodes in self.face_nodes]
        self.mesh.set_region(number, self.outer[:, chosen])

    def hold(self, model: gf.Model, problem: Problem, prescribed: np.ndarray, first_region: int = 100) -> None:
        """Adds the supports, by multipliers. Faces are held whole: along all axes, or across one to which they are
        normal. `prescribed` (nodes, dim) of the case may be set again by :meth:`move`."""
        held = problem.held[self.nodes]
        axes_of_face = held[self.face_nodes].all(axis=1)
        # In a corner of the body nodes are held by the faces beside, too.
        extent = np.ptp(self.coords[self.face_nodes], axis=1)
        partly = ~axes_of_face.all(axis=1)
        axes_of_face[partly] &= extent[partly] < 1e-9 * np.ptp(self.coords)
        self.supports = []
        for number, axes in enumerate(np.unique(axes_of_face[axes_of_face.any(axis=1)], axis=0)):
            chosen = (axes_of_face == axes).all(axis=1)
            region, data = first_region + number, f"{self.variable}_held{number}"
            self.mesh.set_region(region, self.outer[:, chosen])
            nodes = np.unique(self.face_nodes[chosen])
            self.supports.append((data, nodes, axes))
            model.add_initialized_data(data, self._value(prescribed, nodes, axes))
            if axes.all():
                model.add_Dirichlet_condition_with_multipliers(
                    self.quadrature, self.variable, self.space, region, data
                )
            else:
                model.add_normal_Dirichlet_condition_with_multipliers(
                    self.quadrature, self.variable, 1, region, data
                )

    def move(self, model: gf.Model, prescribed: np.ndarray) -> None:
        """Sets the displacement of what is held."""
        for data, nodes, axes in self.supports:
            model.set_variable(data, self._value(prescribed, nodes, axes))

    def _value(self, prescribed: np.ndarray, nodes: np.ndarray, axes: np.ndarray) -> np.ndarray:
        value = prescribed[self.nodes[nodes]][:, axes]
        if np.ptp(value, axis=0).any():
            raise ValueError("a face is not held alike everywhere")
        if axes.all():
            return value[0]
        if axes.sum() != 1:
            raise ValueError("a face is held along some axes but not across one alone")
        axis = int(np.flatnonzero(axes)[0])
        place = self.coords[nodes, axis]
        # Along the outward normal.
        return value[0] * (1.0 if place[0] > self.coords[:, axis].mean() else -1.0)

    def displacement(self, model: gf.Model) -> np.ndarray:
        """(nodes, dim)."""
        return model.variable(self.variable)[self.dofs]

    def inner_force(self, model: gf.Model, work: str) -> np.ndarray:
        """Nodal forces that balance the stresses, (nodes, dim): of the contact, where nothing else acts. `work` is the
        strain energy or its variation in GetFEM's language."""
        found = gf.asm_generic(self.quadrature, 1, work, -1, model)
        first, _ = model.interval_of_variable(self.variable)
        return found[first + self.dofs]
