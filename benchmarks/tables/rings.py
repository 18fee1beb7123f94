"""Round faces in contact: a press fit of two rings beside Lamé, and a pin in a hole that is larger by a clearance.

    python benchmarks/tables/rings.py [fit | pin | coarse]

Radii 0.5, 1 and 1.5, E = 1, ν = 0.3, plane strain, k = 10 E/h with the facets of the inner ring; quarter models. Of the press fit: the force
by Lamé's, and the L2 error of the radial stress; of coarse faces also α⁴ R/90 by the mean penetration, the least and largest pressure at a
point by Lamé's, and whether there is a warning. Of the pin: the force by that of the finest mesh. Needs scikit-fem and fmc_contact_skfem.
"""

import sys

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementQuad1, ElementQuad2, ElementTriP2, ElementVector, Functional, MeshQuad, MeshQuad2, MeshTri, MeshTri2, asm
from skfem.helpers import sym_grad, trace
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNG, POISSON, INNER, RADIUS, OUTER = 1.0, 0.3, 0.5, 1.0, 1.5
LAME, SHEAR = lame_parameters(YOUNG, POISSON)
PLANES = [((0, 0), (1, 0)), ((0, 0), (0, 1))]
KINDS = {
    "Quad9": (MeshQuad, MeshQuad2, ElementQuad2),
    "Tri6": (MeshTri, MeshTri2, ElementTriP2),
    "Quad4": (MeshQuad, None, ElementQuad1),
}


def ring(kind, inner, outer, around, angle=np.pi / 2):
    """A basis on a sector, with so many cells around a full circle."""
    first, second, element = KINDS[kind]
    cells = round(around * angle / (2 * np.pi))
    layers = max(2, round((outer - inner) * around / (2 * np.pi * RADIUS)))
    mesh = first.init_tensor(np.linspace(inner, outer, layers + 1), np.linspace(0, angle, cells + 1))
    places = mesh.p if second is None else second.from_mesh(mesh).doflocs
    places = places[0] * np.stack([np.cos(places[1]), np.sin(places[1])])
    return Basis(first(places, mesh.t) if second is None else second(places, second.from_mesh(mesh).t), ElementVector(element()), intorder=5)


class Pair:
    """Two rings with the matrix of both; the cut faces are planes of symmetry."""

    def __init__(self, kind, counts, radii, smoothed):
        inner, outer = (ring(kind, *ends, count) for ends, count in zip(radii, counts))
        self.bases, self.first = (inner, outer), inner.N
        self.matrix = block_diag([asm(linear_elasticity(LAME, SHEAR), basis) for basis in self.bases], "csr")
        self.contact = SkfemContact([(inner, 0), (outer, inner.N)], stiffness=10 * YOUNG * counts[0] / (2 * np.pi * RADIUS))
        self.contact.contact.mesh.set_symmetry_planes(PLANES)
        if smoothed:
            self.contact.set_surface_smoothing(40.0)
        self.places = np.concatenate([basis.doflocs for basis in self.bases], axis=1)
        self.axis = np.concatenate([np.arange(basis.N) % 2 for basis in self.bases])

    def solve(self, held, prescribed=None):
        free = np.setdiff1d(np.arange(len(self.axis)), held)
        return find_equilibrium(lambda u: (self.matrix @ u, self.matrix), self.contact, np.zeros(len(self.axis)), free, prescribed)


def lame(interference):
    """Pressure of the fit: all of one material."""
    flexible = sum((b**2 + a**2) / (b**2 - a**2) for a, b in ((INNER, RADIUS), (RADIUS, OUTER)))
    return YOUNG / (1 - POISSON**2) * interference / RADIUS / flexible


@Functional
def radial(w):
    """The square of the error of the radial stress, of a body that is pressed from outside, or from inside."""
    r = np.hypot(*w.x)
    strain = sym_grad(w.u)
    n = w.x / r
    stress = LAME * trace(strain) + 2 * SHEAR * sum(n[i] * strain[i, j] * n[j] for i in range(2) for j in range(2))
    return (stress - w.sign * w.pressure * (1 - (w.free / r) ** 2) / (1 - (w.free / RADIUS) ** 2)) ** 2


def fit(kind, counts, interference, smoothed=False):
    """Force by Lamé's, error of the stress, and the contact at the nodes."""
    pair = Pair(kind, counts, ((INNER, RADIUS + interference), (RADIUS, OUTER)), smoothed)
    held = np.flatnonzero(np.abs(pair.places[pair.axis, np.arange(len(pair.axis))]) < 1e-9)
    found = pair.solve(held)
    field, pressure = pair.contact.nodal_contact(found.x), lame(interference)
    on = field.area > 0
    force = (field.pressure * field.area)[on].sum() / 2 / (pressure * RADIUS * np.pi / 2)
    errors, norms = 0.0, 0.0
    for basis, u, free in zip(pair.bases, np.split(found.x, [pair.first]), (INNER, OUTER)):
        args = {"pressure": pressure, "free": free, "sign": -1.0}
        errors += radial.assemble(basis, u=basis.interpolate(u), **args)
        norms += radial.assemble(basis, u=basis.interpolate(0 * u), **args)
    points = pair.contact.contact.contact_points(pair.contact.nodes(found.x))
    is_warned = any(one.kind == "coarse_faces" for one in found.result.warnings)
    return force, (errors / norms) ** 0.5, points.pressure / pressure, is_warned


def pin(kind, counts, smoothed=False, clearance=1e-3, move=3e-3):
    """Force on a pin that is moved along x from the middle of its hole; the half above the axis."""
    pair = Pair(kind, counts, ((INNER, RADIUS - clearance), (RADIUS, OUTER)), smoothed)
    x, y = pair.places
    r = np.hypot(x, y)
    core, rim = np.isclose(r, INNER), np.isclose(r, OUTER)
    held = np.flatnonzero(core | rim | (np.abs(y) < 1e-9) & (pair.axis == 1))
    prescribed = np.where(core & (pair.axis == 0), move, 0.0)
    return pair.solve(held, prescribed).result.bodies[1].force[0]


def main(which=None):
    if which in (None, "fit"):
        for kind, counts, smoothed in (
            ("Quad9", (32, 44), False), ("Quad9", (64, 84), False), ("Quad9", (128, 164), False), ("Tri6", (64, 84), False),
            ("Quad4", (64, 84), True), ("Quad4", (128, 164), True), ("Quad4", (64, 84), False), ("Quad4", (128, 164), False),
        ):
            row = [f"{force:.3f}, {error:.3f}" for force, error, *_ in (fit(kind, counts, one, smoothed) for one in (1e-2, 1e-3, 2e-4))]
            print(kind, *counts, "smoothed" if smoothed else "", " | ".join(row), flush=True)
    if which in (None, "pin"):
        finest = pin("Quad9", (160, 212))
        for kind, counts, smoothed in (
            ("Quad9", (32, 44), False), ("Quad9", (64, 84), False),
            ("Quad4", (64, 84), True), ("Quad4", (64, 84), False), ("Quad4", (128, 164), True), ("Quad4", (128, 164), False),
        ):
            print(kind, *counts, "smoothed" if smoothed else "", f"{pin(kind, counts, smoothed) / finest:.3f}", flush=True)
    if which in (None, "coarse"):
        for counts in ((16, 20), (32, 44), (64, 84)):
            for interference in (1e-2, 1e-3, 2e-4):
                force, _, pressures, is_warned = fit("Quad9", counts, interference)
                stiffness = 10 * YOUNG * counts[0] / (2 * np.pi * RADIUS)
                error = (2 * np.pi / counts[0]) ** 4 * RADIUS / 90 / (force * lame(interference) / stiffness)
                found = f"{error:.3g} | {force:.3f} | {pressures.min():.2f} to {pressures.max():.2f}"
                print(*counts, interference, found, "warning" if is_warned else "", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
