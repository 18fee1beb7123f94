"""Solids of revolution: what is found without a number to choose is the same in every unit."""

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, BilinearForm, ElementQuad1, ElementVector, FacetBasis, LinearForm, MeshQuad, asm
from skfem.helpers import ddot, sym_grad, trace

YOUNG, POISSON, PRESSURE = 1e6, 0.3, 1e3


@BilinearForm
def solid(u, v, w):
    r = w.x[0]
    shear = YOUNG / (2 * (1 + POISSON))
    bulk = 2 * shear * POISSON / (1 - 2 * POISSON)
    hoops = u[0] / r, v[0] / r
    volumes = trace(sym_grad(u)) + hoops[0], trace(sym_grad(v)) + hoops[1]
    return 2 * np.pi * r * (bulk * volumes[0] * volumes[1] + 2 * shear * (ddot(sym_grad(u), sym_grad(v)) + hoops[0] * hoops[1]))


@LinearForm
def pressed(v, w):
    return -2 * np.pi * w.x[0] * PRESSURE * v[1]


@pytest.mark.parametrize("inner", [0.0, 0.5])
@pytest.mark.parametrize("length", [1e-6, 1e-3, 1.0, 1e3])
def test_a_stack_of_rings_is_shortened_as_much_in_every_unit(length: float, inner: float) -> None:
    heights = [(0.0, 1.0, 4), (1.0, 1.7, 5)]
    meshes = [MeshQuad.init_tensor(length * np.linspace(inner, 1, n + 1), length * np.linspace(low, high, 5)) for low, high, n in heights]
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in meshes]
    starts = [0, bases[0].N]
    contact = SkfemContact(list(zip(bases, starts)), axisymmetric=True)
    K = block_diag([asm(solid, basis) for basis in bases], "csr")
    x = contact.nodes(np.zeros(K.shape[0]))
    top = np.isclose(x[:, 1], 1.7 * length, rtol=1e-9)
    held = np.stack([x[:, 0] == 0, x[:, 1] == 0], 1).ravel()
    load = np.zeros(K.shape[0])
    faces = meshes[1].facets_satisfying(lambda x: np.isclose(x[1], 1.7 * length, rtol=1e-9))
    load[starts[1] :] = asm(pressed, FacetBasis(meshes[1], bases[1].elem, facets=faces))
    found = find_equilibrium(lambda u: (K @ u - load, K), contact, np.zeros(K.shape[0]), np.flatnonzero(~held))
    # Uniaxial stress; what is left of the penetration shortens it too, by the 1e-4 of the load's work that a search may leave.
    assert found.x[1::2][top] == pytest.approx(-1.7 * length * PRESSURE / YOUNG, rel=1e-4)
    assert not found.warnings
    assert found.iterations <= 4
