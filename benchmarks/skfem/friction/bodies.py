"""Linear elastic bodies that are loaded, held and dragged, with friction: what the problems of this folder share."""

from __future__ import annotations

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag, csr_matrix, identity
from skfem import Basis, ElementHex1, ElementQuad1, ElementVector, MeshHex, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

LIMIT = 40
"""Iterations of Newton's method after which a step has failed."""

LAWS = {"depth": {"law": "depth", "estimator": "auto"}, "fiber": {"law": "fiber", "estimator": "exact"}}
_ELEMENTS = {MeshQuad: ElementQuad1, MeshHex: ElementHex1}


def grid(*axes, place=None):
    """A mesh of quadrilaterals or hexahedra, one array of coordinates for each axis, moved to ``place(p)``."""
    mesh = {2: MeshQuad, 3: MeshHex}[len(axes)].init_tensor(*axes)
    return mesh if place is None else type(mesh)(np.ascontiguousarray(place(mesh.p)), mesh.t)


class Bodies:
    """One mesh, Young's modulus and Poisson's ratio for each body; plane strain in 2D.

    The unknowns z say how everything moves: u = motion z. At first they are the displacements u themselves, those of the
    nodes of one body after those of another.
    """

    def __init__(self, meshes, youngs, poisson, stiffness, law="depth", **options):
        self.meshes, self.dim, self.law = meshes, meshes[0].dim(), law
        # Two points along every axis; the default for hexahedra is four.
        bases = [Basis(mesh, ElementVector(_ELEMENTS[type(mesh)]()), intorder=3) for mesh in meshes]
        self.offsets = np.cumsum([0] + [basis.N for basis in bases])
        elastic = [linear_elasticity(*lame_parameters(young, poisson)).assemble(basis) for basis, young in zip(bases, youngs)]
        self.stiffness = block_diag(elastic, "csr")
        """Of the bodies, and of what the problem adds: springs, arms. By the unknowns z."""
        self.contact = SkfemContact(list(zip(bases, self.offsets)), stiffness=stiffness, **{**LAWS[law], **options})
        self.size = self.offsets[-1]
        self.motion = identity(self.size, format="csr")
        self.load = np.zeros(self.size)
        self.z = np.zeros(self.size)
        self.straight_slip = False
        self.result = None
        """Of the last evaluation."""

    def dofs(self, where, body=0):
        """Unknowns (dim, n) of the nodes of a body at which ``where(p)`` is true."""
        nodes = np.flatnonzero(where(self.meshes[body].p))
        return self.offsets[body] + self.dim * nodes + np.arange(self.dim)[:, None]

    def move_as_one(self, groups):
        """All unknowns of each group become one, after the others. Returns the numbers of the new ones, and of the old
        ones that stay."""
        joined = np.concatenate(groups)
        single = np.setdiff1d(np.arange(self.size), joined)
        new = len(single) + np.arange(len(groups))
        cols = np.concatenate([np.arange(len(single)), np.repeat(new, [len(group) for group in groups])])
        rows = np.concatenate([single, joined])
        self.motion = csr_matrix((np.ones(len(cols)), (rows, cols)), (self.size, len(single) + len(groups)))
        self.stiffness = (self.motion.T @ self.stiffness @ self.motion).tocsr()
        self.z = np.zeros(self.motion.shape[1])
        return new, single

    @property
    def u(self):
        return self.motion @ self.z

    @property
    def reactions(self):
        """What holds the unknowns z: inner forces less loads and contact, at the last evaluation."""
        return self.stiffness @ self.z - self.motion.T @ (self.load + self.contact.on_dofs(self.result.forces))

    def begin_friction(self, coefficient):
        """Friction from here on: nothing is carried."""
        self.contact.contact.set_options(friction_coefficient=coefficient)
        self.contact.begin_step(self.u)

    def solve(self, held, prescribed=0.0, tolerance=1e-9, penetration=None):
        """Equilibrium with these values of the unknowns ``held``; number of linear solves. What is prescribed moves with the
        first of them."""
        free = np.setdiff1d(np.arange(len(self.z)), held)
        end = self.z.copy()
        end[held] = prescribed
        if self.law == "fiber":
            self.contact.keep_patches(self.u)
        # The residual is measured by the loads, too, where they are larger than what contact bears.
        pushed = 0.0 if self.result is None else np.linalg.norm(self.result.forces)
        tolerance *= max(1.0, np.linalg.norm(self.load) / pushed) if pushed else 1.0
        found = find_equilibrium(
            self._host, _OnUnknowns(self), self.z, free, end, tolerance=tolerance,
            max_iterations=LIMIT, two_level=False, penetration=penetration, straight_slip=self.straight_slip,
        )  # fmt: skip
        self.z, self.result = found.x, found.result
        return found.iterations

    def _host(self, z):
        return self.stiffness @ z - self.motion.T @ self.load, self.stiffness

    def commit(self):
        self.contact.commit_step(self.u)


class _OnUnknowns:
    """The contact by the unknowns z, as ``fmc_contact.find_equilibrium`` wants it."""

    def __init__(self, bodies):
        self.bodies, self.contact = bodies, bodies.contact.contact

    def evaluate(self, z):
        return self.bodies.contact.evaluate(self.bodies.motion @ z)

    def coords(self, z):
        return self.bodies.contact.coords(self.bodies.motion @ z)

    def on_dofs(self, forces):
        return self.bodies.motion.T @ self.bodies.contact.on_dofs(forces)

    def tangent(self, z, **kinds):
        motion = self.bodies.motion
        return csr_matrix(motion.T @ self.bodies.contact.tangent(motion @ z, **kinds) @ motion)
