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
}
OPTIONS = dict(stiffness=1e4, estimator="exact", momentum_correction=False)


class Scene(NamedTuple):
    """What has to live together."""

    model: gf.Model
    spaces: list[gf.MeshFem]
    meshes: list[gf.Mesh]
    contact: GetfemContact


def grid(transform, cells, low, high):
    """A block of cells of one kind."""
    mesh = gf.Mesh("regular simplices" if "PK" in transform else "cartesian", *_ticks(cells, low, high))
    if "PRISM" in transform:
        mesh = gf.Mesh("prismatic", gf.Mesh("regular simplices", *_ticks(cells[:2], low[:2], high[:2])), cells[2])
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

