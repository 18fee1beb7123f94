"""A search that the host ends by an error: the contact is as it was before."""

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementQuad1, ElementVector, LinearForm, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity


def test_nothing_stays_of_a_search_that_an_error_ends():
    # A plank that bends over two supports: friction is frozen, and softer, on the way.
    corners = [((-2, 0), (2, 0.3), (24, 4)), ((-1.7, -0.5), (-1.4, 0), (3, 4)), ((1.4, -0.5), (1.7, 0), (4, 4))]
    meshes = [MeshQuad.init_tensor(*(np.linspace(a, b, n + 1) for a, b, n in zip(*corner))) for corner in corners]
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in meshes]
    matrix = block_diag([linear_elasticity(*lame_parameters(1e6, 0.3)).assemble(basis) for basis in bases], "csr")
    places = np.concatenate([basis.doflocs[1] for basis in bases])
    contact = SkfemContact(list(zip(bases, np.cumsum([0] + [basis.N for basis in bases[:-1]]))), friction_coefficient=0.3)
    load, free = np.zeros(len(places)), np.flatnonzero(places > -0.5 + 1e-9)
    load[: bases[0].N] = LinearForm(lambda v, w: -1e2 * v[1]).assemble(bases[0])
    calls, limit = 0, np.inf

    def host(u):
        nonlocal calls
        calls += 1
        if calls == limit:
            raise KeyError(limit)
        return matrix @ u - load, matrix

    found = find_equilibrium(host, contact, np.zeros(len(load)), free)
    contact.begin_step(np.zeros(len(load)))
    near = found.x + 1e-5 * (np.arange(len(load)) % 2)
    wanted, limit, ends = contact.force(near), 0, 0
    for limit in range(1, 1000):
        calls = 0
        try:
            find_equilibrium(host, contact, np.zeros(len(load)), free)
            break
        except KeyError:
            ends += 1
        assert np.array_equal(contact.force(near), wanted), limit
    assert ends > 20
