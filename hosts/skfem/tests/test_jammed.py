"""A disc that jams between two planks: what friction's tangent leaves out makes Newton's steps alone go too far for ever."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag, diags
from skfem import Basis, ElementQuad1, ElementTriP1, ElementVector, LinearForm, MeshQuad, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity

MU, WEIGHT = 0.3, 5e3


def plank(corners: list[np.ndarray]) -> MeshQuad:
    """12 by 4 cells between corners, anticlockwise."""
    mesh = MeshQuad.init_tensor(np.linspace(0, 1, 13), np.linspace(0, 1, 5))
    s, t = mesh.p
    parts = [(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t]
    return MeshQuad(sum(part * corner[:, None] for part, corner in zip(parts, corners)), mesh.t)


SERIES = (1, 1.1, 1.2, 1.5, 2)


# The tangent of friction leaves terms out: steps of Newton's method alone came to rest with stiff planks, or not, by the last bits of the
# bodies' matrix. They are changed by rounding in some of the cases.
@pytest.mark.parametrize(
    ("young", "loads", "rounding"),
    [(2e7, (1, 2), None), (2e7, SERIES, 1), (2e8, SERIES, None), (2e9, SERIES, None), (2e9, SERIES, 1), (2e9, SERIES, 2), (2e9, SERIES, 3)],
)
def test_a_disc_in_a_trough_of_planks_comes_to_rest(young: float, loads: tuple[float, ...], rounding: int | None) -> None:
    """A disc of radius 1, three tenths of a facet above planks at 45° that are held along their backs: both bear the same."""
    disc = MeshTri.init_circle(3)
    ends = disc.p[:, disc.facets[:, disc.boundary_facets()]]
    gap = 0.3 * np.linalg.norm(ends[:, 0] - ends[:, 1], axis=0).mean()
    along, across = np.array([1, 1]) / np.sqrt(2), np.array([1, -1]) / np.sqrt(2)
    foot = np.array([0, -(1 + gap) * np.sqrt(2)])
    right = [foot + a * along + b * across for a, b in ((0.2, 0.6), (2, 0.6), (2, 0), (0.2, 0))]
    left = [right[k] * [-1, 1] for k in (1, 0, 3, 2)]
    meshes = [disc, plank(right), plank(left)]
    bases = [Basis(mesh, ElementVector(ElementTriP1() if mesh is disc else ElementQuad1())) for mesh in meshes]
    first = np.cumsum([0] + [basis.N for basis in bases])
    matrix = block_diag([linear_elasticity(*lame_parameters(young, 0.3)).assemble(basis) for basis in bases], "csr")
    if rounding is not None:
        scales = diags(1 + np.random.default_rng(rounding).normal(0, 1e-14, first[-1]))
        matrix = (scales @ matrix @ scales).tocsr()
    contact = SkfemContact(list(zip(bases, first)), friction_coefficient=MU)
    depth = (1 + gap) * np.sqrt(2) + 0.6 * np.sqrt(2)
    back = [bases[k].get_dofs(lambda x, k=k: (3 - 2 * k) * x[0] - x[1] > depth - 1e-6).all() + first[k] for k in (1, 2)]
    free = np.setdiff1d(np.arange(first[-1]), np.concatenate(back))
    weight = np.zeros(first[-1])
    weight[: first[1]] = LinearForm(lambda v, w: -WEIGHT * v[1]).assemble(bases[0])
    u, whole = np.zeros(first[-1]), -weight.sum()
    contact.begin_step(u)
    for load in loads:
        found = find_equilibrium(lambda u, load=load: (matrix @ u - load * weight, matrix), contact, u, free)
        forces = [found.result.bodies[k].force / (load * whole) for k in (1, 2)]
        assert forces[0] + forces[1] == pytest.approx([0, -1], abs=1e-8)
        assert forces[0] == pytest.approx(forces[1] * [-1, 1], abs=1e-3)
        # The disc is so coarse that it touches a plank within a facet, which is told.
        others = [said for said in found.warnings if "within single facets" not in said]
        assert found.iterations <= 10 and not others
        u = found.x
        contact.commit_step(u)
