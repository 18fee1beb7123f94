"""A deformable tip, ten times as stiff as the block into which it is pressed, linear and neo-Hookean.

    python tips.py [half angles [law [recipe]]]

Five stages: 0.03, 0.06 and 0.1 deep with k = 1e5, then k = 1e6 and 1e7, where a cell of the block is 0.01 wide and its Young's
modulus 500. The last three are told, with the force on the block, or how the stage ended. Recipes: "two-level", and "plain".
"""

import sys

import numpy as np
from fmc_contact import FmcError, find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, BilinearForm, ElementTriP1, ElementVector, MeshTri
from skfem.helpers import ddot, eye, sym_grad, trace
from solid import Solid

STAGES = [(0.03, 1e5), (0.06, 1e5), (0.1, 1e5), (0.1, 1e6), (0.1, 1e7)]
BLOCK, TIP = 500.0, 5000.0


def _graded(length, finest, coarsest):
    """Places from 0 to a length, from finest to coarsest."""
    places, step = [0.0], finest
    while places[-1] < length:
        places.append(places[-1] + step)
        step = min(1.25 * step, coarsest)
    return np.array(places) * (length / places[-1])


def _block():
    side = _graded(1.0, 0.01, 0.2)
    across = np.unique(np.concatenate([-side[1:], side]))
    # Off the middle, so that nothing is symmetric.
    across = across + 0.0037 * (1 - np.abs(across))
    return MeshTri.init_tensor(across, -_graded(1.0, 0.01, 0.2)[::-1])


def _tip(half_angle):
    """Rows of nodes, one more in each, up to a height of 0.8."""
    heights, width = _graded(0.8, 0.02, 0.1), np.tan(np.radians(half_angle))
    p, t, first = [(0.0, 0.0)], [], 0
    for number, height in enumerate(heights[1:], 1):
        above = len(p)
        p += [(width * height * (2 * k / number - 1), height) for k in range(number + 1)]
        for k in range(number):
            t.append((first + k, above + k + 1, above + k))
            if k + 1 < number:
                t.append((first + k, first + k + 1, above + k + 1))
        first = above
    return MeshTri(np.array(p).T, np.array(t).T)


class _Linear:
    """Linear elasticity in plane strain."""

    def __init__(self, bases, youngs, poisson=0.3):
        parts = []
        for basis, young in zip(bases, youngs):
            la, mu = young * poisson / (1 + poisson) / (1 - 2 * poisson), young / 2 / (1 + poisson)

            @BilinearForm
            def energy(u, v, _):
                strain = sym_grad(u)
                return ddot(la * eye(trace(strain), 2) + 2 * mu * strain, sym_grad(v))

            parts.append(energy.assemble(basis))
        self.matrix = block_diag(parts, "csr")

    def forces(self, u):
        return self.matrix @ u

    def stiffness(self, _):
        return self.matrix


def stages(half_angle, material, law="depth", two_level=True, **options):
    """Force and number of linear solves of the last three stages, or the error with which one ended."""
    meshes = [_block(), _tip(half_angle)]
    bases = [Basis(mesh, ElementVector(ElementTriP1()), intorder=2) for mesh in meshes]
    solid = (_Linear if material == "linear" else Solid)(bases, [BLOCK, TIP])
    size = [basis.N for basis in bases]
    contact = SkfemContact([(bases[0], 0), (bases[1], size[0])], stiffness=1.0, law=law, check_cells=False, **options)
    bottom = bases[0].nodal_dofs[:, meshes[0].p[1] < -1 + 1e-9]
    top = bases[1].nodal_dofs[:, meshes[1].p[1] > 0.8 - 1e-9] + size[0]
    free = np.setdiff1d(np.arange(sum(size)), np.concatenate([bottom.ravel(), top.ravel()]))
    u, found = np.zeros(sum(size)), []
    for depth, stiffness in STAGES:
        contact.contact.set_options(stiffness=stiffness)
        prescribed = u.copy()
        prescribed[top[1]] = -depth
        try:
            host = lambda u: (solid.forces(u), solid.stiffness(u))
            end = find_equilibrium(host, contact, u, free, prescribed, max_iterations=40, two_level=two_level)
            u = end.x
            found.append((-end.reactions[top[1]].sum(), end.iterations))
        except FmcError as error:
            found.append(str(error))
    return found[2:]


def main(half_angle="45,15", law="depth", recipe="two-level"):
    for angle in map(float, half_angle.split(",")):
        for material in ("linear", "neo-Hookean"):
            for (_, stiffness), end in zip(STAGES[2:], stages(angle, material, law, recipe == "two-level")):
                told = end if isinstance(end, str) else f"{end[0]:.4f} in {end[1]} iterations"
                print(f"{angle:g} degrees, {material:11}, {law}, k = {stiffness:.0e}: {told}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
