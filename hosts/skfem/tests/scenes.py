"""Two blocks one on the other, of meshes that do not match, with a displacement that makes them overlap."""

import numpy as np
import skfem
from skfem import Basis, ElementVector

ELEMENTS = {
    "P1": skfem.ElementTriP1, "P2": skfem.ElementTriP2, "Q1": skfem.ElementQuad1, "Q2": skfem.ElementQuad2,
    "P1 3D": skfem.ElementTetP1, "P2 3D": skfem.ElementTetP2, "Q1 3D": skfem.ElementHex1, "Q2 3D": skfem.ElementHex2,
    "Q S2": skfem.ElementQuadS2, "Q S2 3D": skfem.ElementHexS2,
}  # fmt: skip
MESHES = {
    "P": {2: skfem.MeshTri, 3: skfem.MeshTet},
    "Q": {2: skfem.MeshQuad, 3: skfem.MeshHex},
}


def blocks(element, lower=3, upper=2):
    """Bases of a unit block and of another above it, 0.02 into it."""
    dim = 3 if element.endswith("3D") else 2
    kind = MESHES[element[0]][dim]
    bases = []
    for count, height in ((lower, 0.0), (upper, 0.98)):
        sides = [np.linspace(0.1 if height else 0.0, 0.9 if height else 1.0, count + 1)] * (dim - 1)
        mesh = kind.init_tensor(*sides, np.linspace(height, height + 1.0, count + 1))
        bases.append(Basis(mesh, ElementVector(ELEMENTS[element]())))
    return bases


def displacement(bases, size=3e-3, seed=1, bulge=0.3):
    """A smooth displacement of all unknowns, the bases one after another, with a little noise; the second block bulges
    towards the first, so that they touch in the middle and not at their walls, where the law "fiber" has steps."""
    noise = np.random.default_rng(seed)
    parts = []
    for number, basis in enumerate(bases):
        x = basis.doflocs
        u = size * np.sin(3.0 * x[0] + 2.0 * x[-1]) + 0.05 * size * noise.standard_normal(basis.N)
        if number == 1:
            up = by_axis(basis)[-1]
            u[up] += bulge * ((x[:-1, up] - 0.5) ** 2).sum(axis=0)
        parts.append(u)
    return np.concatenate(parts)


def by_axis(basis):
    """Unknowns of every component."""
    everything = basis.get_dofs(elements=True)
    return [everything.all(f"u^{axis + 1}") for axis in range(basis.mesh.dim())]


def joined(bases):
    """The bases with their offsets."""
    return [(basis, offset) for basis, offset in zip(bases, np.cumsum([0] + [b.N for b in bases]))]
