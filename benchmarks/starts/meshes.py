"""Meshes of the problems, with any cells of first or second order."""

from dataclasses import dataclass

import numpy as np
from skfem import (
    ElementHex1,
    ElementQuad1,
    ElementQuad2,
    ElementTetP1,
    ElementTetP2,
    ElementTriP1,
    ElementTriP2,
    MeshHex,
    MeshQuad,
    MeshTet,
    MeshTri,
)


@dataclass(frozen=True)
class Cells:
    """A kind of cell: the mesh and the element of scikit-fem."""

    mesh: type
    element: type

    @property
    def dim(self):
        return 3 if self.mesh in (MeshHex, MeshTet) else 2


QUAD4, QUAD9 = Cells(MeshQuad, ElementQuad1), Cells(MeshQuad, ElementQuad2)
TRI3, TRI6 = Cells(MeshTri, ElementTriP1), Cells(MeshTri, ElementTriP2)
HEX8 = Cells(MeshHex, ElementHex1)
TET4, TET10 = Cells(MeshTet, ElementTetP1), Cells(MeshTet, ElementTetP2)

BY_NAME = {"Quad4": QUAD4, "Quad9": QUAD9, "Tri3": TRI3, "Tri6": TRI6, "Hex8": HEX8, "Tet4": TET4, "Tet10": TET10}


def grid(kind, low, high, counts):
    """A box of cells, from corner to corner."""
    return kind.init_tensor(*(np.linspace(a, b, n + 1) for a, b, n in zip(low, high, counts)))


def disc(radius, refinements, centre):
    """A disc of triangles, 4 · 2^refinements around."""
    mesh = MeshTri.init_circle(refinements)
    return MeshTri(radius * mesh.p + np.array(centre)[:, None], mesh.t)


def ring(inner, outer, layers, around, turned=0.0):
    """A ring of quadrilaterals about the origin."""
    angles = np.linspace(0, 2 * np.pi, around, endpoint=False) + turned
    return _polar(angles, np.linspace(inner, outer, layers + 1), is_closed=True)


def sector(inner, outer, first, last, layers, along):
    """A piece of a ring between two angles."""
    return _polar(np.linspace(first, last, along + 1), np.linspace(inner, outer, layers + 1), is_closed=False)


def _polar(angles, radii, is_closed):
    points = np.array([np.outer(np.cos(angles), radii).ravel(), np.outer(np.sin(angles), radii).ravel()])
    row, count = len(radii), len(angles)
    this = np.arange(count if is_closed else count - 1)
    then = (this + 1) % count
    cells = [[i * row + j, i * row + j + 1, k * row + j + 1, k * row + j] for i, k in zip(this, then) for j in range(row - 1)]
    return MeshQuad(points, np.array(cells).T)
