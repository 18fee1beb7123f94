"""Five problems of contact between neo-Hookean bodies, with any number of cells along the side of contact.

Bodies are pressed together by 0.1 in load steps that grow, the first by 0.0016; the press fit is one load step. Lengths
in units of the disc's radius or the block's width.
"""

from dataclasses import dataclass

import numpy as np
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementHex1, ElementTriP1, ElementVector, MeshHex, MeshTri
from solid import Solid


def growing(steps):
    """Displacements after so many load steps. As their squares grow, so does the width of contact of a disc: evenly."""
    return [-0.1 * (step / steps) ** 2 for step in range(1, steps + 1)]


PUSHES = growing(8)
_ELEMENTS = {MeshTri: ElementTriP1, MeshHex: ElementHex1}


@dataclass
class Problem:
    """Bodies, what is held, and how far it is moved."""

    solid: Solid
    held: np.ndarray
    """Unknowns that are prescribed."""
    moved: np.ndarray
    """Those of them that a load step moves."""
    pushes: list
    """Displacement of ``moved`` after each load step."""
    young: float
    """Young's modulus of the softer body."""
    facet: float
    """Size of the facets in contact."""
    symmetry: np.ndarray
    """Nodes in planes of symmetry, counted over all meshes."""

    @property
    def free(self):
        return np.setdiff1d(np.arange(self.solid.offsets[-1]), self.held)

    def contact(self, stiffness, **options):
        """Contact of all bodies; ``stiffness`` by Young's modulus and the size of a facet."""
        pairs = list(zip(self.solid.bases, self.solid.offsets))
        found = SkfemContact(pairs, stiffness=stiffness * self.young / self.facet, **options)
        found.contact.mesh.set_symmetry_nodes(self.symmetry)
        return found


def _problem(lower, upper, youngs, planes, pushes, facet, symmetry=None):
    """``planes``: where nodes are held, bottom of the lower and top of the upper body, as functions of coordinates."""
    meshes = [lower, upper]
    bases = [Basis(mesh, ElementVector(_ELEMENTS[type(mesh)]())) for mesh in meshes]
    solid = Solid(bases, youngs)
    dofs = [basis.nodal_dofs + start for basis, start in zip(bases, solid.offsets)]
    ends = [unknowns[:, plane(mesh.p)] for unknowns, plane, mesh in zip(dofs, planes, meshes)]
    held = [end.ravel() for end in ends]
    nodes = np.zeros(0, int)
    if symmetry:
        nodes = np.flatnonzero(symmetry(np.concatenate([mesh.p for mesh in meshes], axis=1)))
        held += [unknowns[0, symmetry(mesh.p)] for unknowns, mesh in zip(dofs, meshes)]
    return Problem(solid, np.unique(np.concatenate(held)), ends[1][-1], pushes, min(youngs), facet, nodes)


def _grid(kind, counts, low, high):
    return kind.init_tensor(*(np.linspace(a, b, n + 1) for n, a, b in zip(counts, low, high)))


def _below(height):
    return lambda x: x[-1] < height + 1e-9


def _above(height):
    return lambda x: x[-1] > height - 1e-9


def punch(count, kind=MeshTri, dim=2):
    """A flat punch with sharp corners on a block twice as wide."""
    side = dim - 1
    block = _grid(kind, [count] * dim, [0] * dim, [1] * dim)
    above = _grid(kind, [5 * count // 8] * dim, [0.25] * side + [1], [0.75] * side + [1.5])
    return _problem(block, above, [1e6, 1e6], [_below(0), _above(1.5)], PUSHES, 1 / count)


def punch_hex8(count):
    """The same in 3D."""
    return punch(count, MeshHex, 3)


def column(count):
    """A column, one wide and two high, ``count`` cells across, on a block three wide and as soft, of which no node is below one of
    its own. Its load step has a push of its own."""
    lower = _grid(MeshTri, (3 * count, 2 * count), (0, 0), (3, 2))
    upper = _grid(MeshTri, (count, 2 * count), (1.1, 2), (2.1, 4))
    return _problem(lower, upper, [1.0, 1.0], [_below(0), _above(4)], [], 1 / count)


def half_disc(count):
    """A half-disc with its flat side up on a softer block: one half of both, beside their plane of symmetry."""
    disc = MeshTri.init_circle(round(np.log2(count))).translated((0.0, 1.0))
    middles = disc.p[:, disc.t].mean(axis=1)
    quarter = disc.restrict(np.flatnonzero((middles[0] > 0) & (middles[1] < 1)))
    block = _grid(MeshTri, (count, count // 2), (0, -0.75), (1.5, 0))
    planes = [_below(-0.75), _above(1.0)]
    return _problem(block, quarter, [2e2, 1e3], planes, PUSHES, 1.5 / count, lambda x: np.abs(x[0]) < 1e-9)


def disc(count):
    """A whole disc, held at its top, on a softer block."""
    whole = MeshTri.init_circle(round(np.log2(count)) - 1).translated((0.0, 1.0))
    block = _grid(MeshTri, (count, count // 4), (-1.25, -0.625), (1.25, 0))
    return _problem(block, whole, [2e2, 1e3], [_below(-0.625), _above(1.9)], PUSHES, 2.5 / count)


def press_fit(count, interference=0.01):
    """A ring in another that is too small for it. Held are the nodes on the axes, across them."""
    rings = [_ring(count, 0.5, 1 + interference), _ring(5 * count // 4, 1.0, 2.0)]
    solved = _problem(*rings, [2e5, 2e5], [lambda x: x[0] > 9] * 2, [0.0], 2 * np.pi / (5 * count // 4))
    dofs = [basis.nodal_dofs + start for basis, start in zip(solved.solid.bases, solved.solid.offsets)]
    axes = [[np.abs(ring.p[1 - a]) < 1e-9 for a in (0, 1)] for ring in rings]
    solved.held = np.concatenate([d[1 - a, on[a]] for d, on in zip(dofs, axes) for a in (0, 1)])
    return solved


def _ring(count, inner, outer):
    layers = max(2, round(count * (outer - inner) / np.pi / (inner + outer)))
    angle, radius = np.arange(count) * 2 * np.pi / count, np.linspace(inner, outer, layers + 1)
    p = np.array([np.outer(radius, np.cos(angle)).ravel(), np.outer(radius, np.sin(angle)).ravel()])
    first = (np.arange(layers)[:, None] * count + np.arange(count)).ravel()
    then = (np.arange(layers)[:, None] * count + (np.arange(count) + 1) % count).ravel()
    return MeshTri(p, np.hstack([[first, first + count, then], [then, first + count, then + count]]))


ALL = {"punch": punch, "half-disc": half_disc, "press fit": press_fit, "punch Hex8": punch_hex8, "disc": disc}
