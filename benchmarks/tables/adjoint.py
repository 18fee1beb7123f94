"""What the derivative of an equilibrium costs, beside finding it.

    python benchmarks/tables/adjoint.py

Two blocks of 10³ and 9³ hexahedra, pressed and moved along each other, and a block of 128 × 64 quadrilaterals on a plane. Processor time, on one
core (OMP_NUM_THREADS=1). Needs scikit-fem and fmc_contact_skfem; a minute.
"""

import time

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementHex1, ElementQuad1, ElementVector, MeshHex, MeshQuad, asm
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNG = 100.0


def problem(meshes, element, h, friction, on_plane=False):
    """Bodies one on the other, the lowest held or on a plane, the top moved by 0.02 down and 0.005 along."""
    bases = [Basis(mesh, ElementVector(element)) for mesh in meshes]
    first = np.cumsum([0] + [basis.N for basis in bases])
    matrix = block_diag([asm(linear_elasticity(*lame_parameters(YOUNG, 0.3)), basis) for basis in bases], "csr")
    contact = SkfemContact(list(zip(bases, first)), stiffness=10 * YOUNG / h, friction_coefficient=friction)
    top = bases[-1].get_dofs(lambda x: np.isclose(x[-1], meshes[-1].p[-1].max()))
    held = [first[-2] + top.all()]
    if on_plane:
        contact.contact.obstacles.add_half_space(np.zeros(2), np.array([0.0, 1.0]))
    else:
        held.append(bases[0].get_dofs(lambda x: np.isclose(x[-1], meshes[0].p[-1].min())).all())
    prescribed = np.zeros(first[-1])
    prescribed[first[-2] + top.all(f"u^{len(meshes[0].p)}")] = -0.02
    prescribed[first[-2] + top.all("u^1")] = 0.005 if friction else 0.0
    free = np.setdiff1d(np.arange(first[-1]), np.concatenate(held))
    return (lambda u: (matrix @ u, matrix)), contact, np.zeros(first[-1]), free, prescribed


def blocks():
    lower = MeshHex.init_tensor(*[np.linspace(-0.1, 1.1, 11)] * 2, np.linspace(-1, 0, 11))
    return [lower, MeshHex.init_tensor(*[np.linspace(0, 1, 10)] * 2, np.linspace(0, 1, 10))], ElementHex1(), 1 / 9


def plate():
    return [MeshQuad.init_tensor(np.linspace(0, 2, 129), np.linspace(0, 1, 65))], ElementQuad1(), 1 / 64


def main():
    for name, (meshes, element, h), friction, on_plane, penetration in (
        ("block on block, 3D, law alone", blocks(), 0.0, False, None),
        ("the same, with multipliers", blocks(), 0.0, False, 1e-8),
        ("block on block, 3D, friction", blocks(), 0.3, False, None),
        ("block on plane, 2D, friction", plate(), 0.3, True, None),
    ):
        arguments = problem(meshes, element, h, friction, on_plane)
        contact, size = arguments[1], len(arguments[2])
        if friction:
            contact.begin_step(arguments[2])
        start = time.process_time()
        found = find_equilibrium(*arguments, penetration=penetration, max_updates=200, max_iterations=2000)
        found_at = time.process_time()
        adjoint = found.adjoint(np.random.default_rng(5).standard_normal(size), by=["positions"] if on_plane else [])
        end = time.process_time()
        sizes = f"{size} unknowns, {len(contact.contact.multipliers.values)} multipliers"
        print(f"{name}: {sizes}, find {found_at - start:.2f} s, adjoint {end - found_at:.2f} s", adjoint.warnings, flush=True)


if __name__ == "__main__":
    main()
