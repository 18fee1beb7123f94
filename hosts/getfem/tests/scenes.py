"""Two blocks that overlap, of every element that the adapter reads, in a model of two variables."""

from typing import NamedTuple

import getfem as gf
import numpy as np
from fmc_contact_getfem import GetfemContact

gf.util("trace level", 0)
gf.util("warning level", 0)

TRIANGLES, SQUARES = "GT_PK(2,1)", "GT_QK(2,1)"
TETRAHEDRA, CUBES = "GT_PK(3,1)", "GT_QK(3,1)"
ELEMENTS = {
    "FEM_PK(2,1)": TRIANGLES,
    "FEM_PK(2,2)": TRIANGLES,
    "FEM_QK(2,1)": SQUARES,
    "FEM_QK(2,2)": SQUARES,
    "FEM_Q2_INCOMPLETE(2)": SQUARES,
    "FEM_PK(3,1)": TETRAHEDRA,
    "FEM_PK(3,2)": TETRAHEDRA,
    "FEM_QK(3,1)": CUBES,
    "FEM_QK(3,2)": CUBES,
    "FEM_Q2_INCOMPLETE(3)": CUBES,
    "FEM_PK_PRISM(3,1)": "GT_PRISM(3,1)",
    "FEM_PYRAMID_QK(1)": "GT_PYRAMID(3,1)",
}
OPTIONS = dict(stiffness=1e4, estimator="exact", momentum_correction=False)


class Scene(NamedTuple):
    """What has to live together."""

    model: gf.Model
    spaces: list[gf.MeshFem]
    meshes: list[gf.Mesh]
    contact: GetfemContact

    def regions(self) -> None:
        """Bottom of the lower body and top of the upper one: region 1 of their meshes."""
        for mesh, of in zip(self.meshes, (np.min, np.max)):
            height = mesh.pts()[-1]
            mesh.set_region(1, mesh.faces_from_pid(np.flatnonzero(np.abs(height - of(height)) < 1e-9)))

    def supports(self, push):
        """Unknowns that are held, and what they are at the end, in the state of the model."""
        self.regions()
        values, held = np.zeros(self.model.nbdof()), []
        for name, move in (("u", 0.0), ("v", push)):
            dofs = self.contact.dofs[self.contact.nodes(name, 1)]
            values[dofs[:, -1]] = move
            held.append(dofs.ravel())
        return np.concatenate(held), values


def grid(transform, cells, low, high):
    """A block of cells of one kind."""
    kind = {"PK": "regular simplices", "QK": "cartesian", "PY": "pyramidal", "PR": "prismatic"}[transform[3:5]]
    if kind != "prismatic":
        return gf.Mesh(kind, *_ticks(cells, low, high))
    mesh = gf.Mesh(kind, gf.Mesh("regular simplices", *_ticks(cells[:2], low[:2], high[:2])), cells[2])
    mesh.transform(np.diag([1.0, 1.0, high[2] - low[2]]))
    mesh.translate([0.0, 0.0, low[2]])
    return mesh


def _ticks(cells, low, high):
    return [np.linspace(a, b, n + 1) for n, a, b in zip(cells, low, high)]


def touching(element, **options):
    """One block below, a narrower one above that reaches into it by 0.02."""
    dim = 3 if "3" in ELEMENTS[element] else 2
    below = grid(ELEMENTS[element], (3, 2, 2)[:dim], (0.0,) * dim, (1.0,) * dim)
    low = (0.23, 0.98) if dim == 2 else (0.23, 0.21, 0.98)
    above = grid(ELEMENTS[element], (2, 2, 2)[:dim], low, tuple(x + (0.4 if n < dim - 1 else 0.6) for n, x in enumerate(low)))
    model, spaces = gf.Model("real"), []
    for name, mesh in (("u", below), ("v", above)):
        space = gf.MeshFem(mesh, dim)
        space.set_fem(gf.Fem(element))
        model.add_fem_variable(name, space)
        spaces.append(space)
    contact = GetfemContact(model, ["u", "v"], **{**OPTIONS, **options})
    return Scene(model, spaces, [below, above], contact)


def with_materials(scene, nonlinear=False):
    """Elastic bodies, linear or neo-Hookean."""
    model, spaces = scene.model, scene.spaces
    model.add_initialized_data("lame", [1e3])
    model.add_initialized_data("shear", [1e3])
    for name, space in zip(("u", "v"), spaces):
        quadrature = gf.MeshIm(space.mesh(), 3)
        if nonlinear:
            f = f"(Id({space.qdim()})+Grad_{name})"
            energy = f"(shear/2)*(Norm_sqr{f}-2*log(Det{f}))+(lame/2)*sqr(log(Det{f}))"
            model.add_nonlinear_term(quadrature, energy)
        else:
            model.add_isotropic_linearized_elasticity_brick(quadrature, name, "lame", "shear")


def moved(model, size=0.003, seed=1):
    """A state that is not symmetric in anything."""
    state = size * np.random.default_rng(seed).standard_normal(model.nbdof())
    model.to_variables(state)
    return state



def add_supports(scene, push):
    """The same by multipliers: the bottom held, the top moved down."""
    scene.regions()
    for name, mesh, space, move in zip("uv", scene.meshes, scene.spaces, (0.0, push)):
        value = np.zeros(space.qdim())
        value[-1] = move
        scene.model.add_initialized_data("move_" + name, value)
        quadrature = gf.MeshIm(mesh, 3)
        scene.model.add_Dirichlet_condition_with_multipliers(quadrature, name, space, 1, "move_" + name)
