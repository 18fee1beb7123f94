"""fmc-contact in scikit-fem: its adapter and its search, nothing chosen."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag, csr_matrix
from skfem import Basis, ElementHex1, ElementQuad1, ElementVector, MeshHex, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

from . import common

_HEX = [0, 3, 6, 2, 1, 5, 7, 4]
"""Corner of VTK's hexahedron for every corner of scikit-fem's, inverted: of its meshio reader."""


def _basis(points: np.ndarray, cells: np.ndarray) -> Basis:
    if points.shape[1] == 2:
        return Basis(MeshQuad(points.T.copy(), cells.T.copy()), ElementVector(ElementQuad1()), intorder=3)
    order = [_HEX.index(corner) for corner in range(8)]
    return Basis(MeshHex(points.T.copy(), cells[:, order].T.copy()), ElementVector(ElementHex1()), intorder=3)


def _residual(matrix: csr_matrix, load: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, csr_matrix]:
    return matrix @ u - load, matrix


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    bases, matrices, unknowns, first = [], [], [], 0
    for number, cells in enumerate(model.cells):
        begin, end = model.firsts[number : number + 2]
        basis = _basis(model.points[begin:end], cells - begin)
        bases.append((basis, first))
        matrices.append(linear_elasticity(*lame_parameters(*model.materials[number])).assemble(basis))
        unknowns.append(basis.nodal_dofs.T + first)
        first += basis.N
    at, matrix = np.concatenate(unknowns), block_diag(matrices, format="csr")
    options: dict[str, Any] = {"friction_coefficient": model.friction} if model.friction else {}
    contact = SkfemContact(bases, **options)
    if variant == "smooth surfaces":
        contact.set_surface_smoothing(30.0)
    if len(model.symmetry):
        contact.contact.mesh.set_symmetry_nodes(model.symmetry)
    for slave, master in model.pairs if model.tied else []:
        contact.contact.pairs.set(model.body_of(slave), model.body_of(master), interface="tied")
    free = at[~model.fixed]
    u, found, iterations = np.zeros(contact.size), [], 0
    for prescribed, loads in zip(model.prescribed, model.loads):
        goal, load = np.zeros(contact.size), np.zeros(contact.size)
        goal[at.ravel()], load[at.ravel()] = prescribed.ravel(), loads.ravel()
        if model.friction:
            contact.begin_step(u)
        step = find_equilibrium(partial(_residual, matrix, load), contact, u, free, goal)
        u, iterations = step.x, iterations + step.iterations
        model.warnings += [*step.warnings, *(one.text for one in step.result.warnings)]
        if model.friction:
            contact.commit_step(u)
        found.append(u[at])
    return np.array(found), iterations


if __name__ == "__main__":
    common.main(solve)
