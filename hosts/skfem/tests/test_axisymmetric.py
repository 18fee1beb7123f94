"""Axisymmetry in whole problems: a ball on a plane by Hertz, and two tubes that are pressed into one another by Lamé."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import spsolve
from skfem import Basis, BilinearForm, ElementQuad1, ElementVector, MeshQuad

YOUNG, NU = 1.0, 0.3


def stiffness(points: np.ndarray, quads: np.ndarray) -> csr_matrix:
    """Of whole rings, with the strain u_r / r of hoops; unknown ``2 * node + axis``."""
    lame, shear = YOUNG * NU / ((1 + NU) * (1 - 2 * NU)), YOUNG / (2 * (1 + NU))

    @BilinearForm
    def energy(u, v, w):
        r = w.x[0]
        strains = [(f.grad[0, 0], f.grad[1, 1], f[0] / r, f.grad[0, 1] + f.grad[1, 0]) for f in (u, v)]
        (rr, zz, tt, rz), (ss, yy, hh, sy) = strains
        volumetric = lame * (rr + zz + tt) * (ss + yy + hh)
        return 2 * np.pi * r * (volumetric + 2 * shear * (rr * ss + zz * yy + tt * hh) + shear * rz * sy)

    basis = Basis(MeshQuad(points.T.copy(), quads.T.copy()), ElementVector(ElementQuad1()))
    matrix = energy.assemble(basis)
    dofs = basis.nodal_dofs.T.ravel()
    return matrix[dofs][:, dofs].tocsr()


def grid(r: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    points = np.stack(np.meshgrid(r, z), axis=-1).reshape(-1, 2)
    nodes = np.arange(len(points)).reshape(len(z), len(r))
    corners = nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]
    return points, np.stack(corners, axis=-1).reshape(-1, 4)


def graded(fine: float, to: float, end: float, growth: float = 1.12) -> np.ndarray:
    """Lines from 0 on, ``fine`` apart up to ``to``, then ever farther apart."""
    lines = list(np.linspace(0, to, round(to / fine) + 1))
    while lines[-1] < end:
        lines.append(lines[-1] + growth * (lines[-1] - lines[-2]))
    return np.array(lines)


def solve(contact: Contact, points: np.ndarray, matrix: csr_matrix, fixed: np.ndarray, u: np.ndarray):
    """Newton's method from the displacement ``u``, whose ``fixed`` entries stay."""
    free, u = np.flatnonzero(~fixed), u.copy()
    for _ in range(30):
        result, tangent = contact.evaluate_tangent(points + u.reshape(-1, 2))
        residual = (result.forces.ravel() - matrix @ u)[free]
        if np.abs(residual).max() < 1e-8 * max(np.abs(result.forces).max(), 1e-300):
            return u, result
        u[free] += spsolve((matrix + tangent)[free][:, free].tocsc(), residual)
    raise AssertionError(f"no solution: {np.abs(residual).max()}")


@pytest.mark.parametrize("law", ["depth", "fiber"])
def test_a_ball_on_a_plane(law: str) -> None:
    """F = 4/3 E* sqrt(R) d^1.5. The ball is cut off where it moves as under a force at a point (Boussinesq), to the third
    power of the contact's radius by the distance; its surface is the parabola of Hertz' theory."""
    radius, a = 1.0, 0.04
    modulus, d = YOUNG / (1 - NU**2), a**2 / radius
    force = 4 / 3 * modulus * np.sqrt(radius) * d**1.5
    lines = graded(a / 24, 1.25 * a, 15 * a)
    points, quads = grid(lines, lines)
    far = (points[:, 0] == lines[-1]) | (points[:, 1] == lines[-1])
    r, z = points.T
    rho = np.maximum(np.hypot(r, z), a)
    boussinesq = np.stack([r * z / rho**3 - (1 - 2 * NU) * r / (rho * (rho + z)), 2 * (1 - NU) / rho + z**2 / rho**3])
    moved = (force * (1 + NU) / (2 * np.pi * YOUNG) * boussinesq).T - [0, d]
    matrix = stiffness(points, quads)
    fixed = np.repeat(far, 2)
    fixed[0::2] |= r == 0
    # Newton's method starts with the circle of contact on the plane, as deep in it as the pressure of Hertz asks for.
    middle = 2 / np.pi * modulus * a / radius
    stiff = 400 * middle / d
    inside = (z == 0) & (r < a)
    sunk = -(r**2) / (2 * radius) - middle * np.sqrt(np.maximum(1 - r**2 / a**2, 0)) / stiff
    start = np.where(fixed, (moved * np.stack([r > 0, r > -1], axis=1)).ravel(), 0.0)
    start[1::2][inside] = sunk[inside]
    held = fixed.copy()
    held[1::2] |= inside
    start[~held] = spsolve(matrix[~held][:, ~held].tocsc(), -(matrix @ start)[~held])
    start = start.reshape(-1, 2)
    # The shape is in the coordinates of the contact only: the theory is that of a half-space.
    shape = points + np.stack([0 * r, r**2 / (2 * radius)], axis=1)
    contact = Contact(shape, quads, "quad", stiffness=stiff, law=law, estimator="exact", axisymmetric=True)
    contact.obstacles.add_half_space((0, 0), (0, 1))
    if law == "fiber":
        contact.patches.keep(shape + start)
    _u, result = solve(contact, shape, matrix, fixed, start.ravel())
    found = result.obstacles[0].force[1]
    assert abs(-found / force - 1) < 0.01


@pytest.mark.parametrize("law", ["depth", "volume"])
def test_a_press_fit(law: str) -> None:
    """Two long tubes, held along the axis: p from the radial displacements of both by Lamé."""
    inner, middle, outer, interference = 1.0, 1.5, 2.5, 1e-4
    height = 0.4
    tubes = [
        grid(np.linspace(inner, middle + interference / 2, 15), np.linspace(0, height, 6)),
        grid(np.linspace(middle - interference / 2, outer, 24), np.linspace(0, height, 9)),
    ]
    count = len(tubes[0][0])
    points, quads = np.vstack([t[0] for t in tubes]), np.vstack([tubes[0][1], tubes[1][1] + count])
    plane_young, plane_nu = YOUNG / (1 - NU**2), NU / (1 - NU)
    give = [
        (middle**2 + inner**2) / (middle**2 - inner**2) - plane_nu,
        (outer**2 + middle**2) / (outer**2 - middle**2) + plane_nu,
    ]
    pressure = interference / (middle / plane_young * sum(give))
    if law == "volume":
        # One pressure for all: that of the law, which then gives way until there is overlap left.
        options = {"stiffness": pressure * 50 / (2 * np.pi * middle * height * interference), "exponent": 2.0}
    else:
        options = {"stiffness": 200 * pressure / interference}
    contact = Contact(points, quads, "quad", law=law, estimator="exact", axisymmetric=True, **options)
    ends = (points[:, 1] == 0) | (points[:, 1] == height)
    contact.mesh.set_symmetry_nodes(np.flatnonzero(ends))
    fixed = np.zeros(points.size, bool)
    fixed[1::2] = ends
    _u, result = solve(contact, points, stiffness(points, quads), fixed, np.zeros(points.size))
    assert not result.warnings
    area = 2 * np.pi * middle * height
    # What both tubes are pressed by, on the inner and the outer one: less by what the penalty gives way.
    gives = 1 - result.pairs[0].penetration / interference
    for body, sign in ((slice(0, count), -1), (slice(count, None), 1)):
        found = sign * result.forces[body, 0].sum() / area
        assert abs(found / (pressure * gives) - 1) < 5e-3
