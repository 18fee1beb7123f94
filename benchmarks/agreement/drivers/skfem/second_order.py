"""Curved cells of second order in scikit-fem, and the unknowns of their nodes."""

from __future__ import annotations

import numpy as np
import skfem
from fmc_contact.second_order import MIDDLES
from fmc_contact_skfem.field import mesh_from_cells

_KINDS = {
    "triangle6": ("triangle", 3, skfem.MeshTri2),
    "quad9": ("quad", 4, skfem.MeshQuad2),
    "tetra10": ("tetra", 4, skfem.MeshTet2),
    "hexahedron27": ("hexahedron", 8, skfem.MeshHex2),
}


def mesh(coords: np.ndarray, conn: np.ndarray, cell_type: str) -> tuple[skfem.Mesh, np.ndarray]:
    """The mesh with these nodes, (nodes, dim), and cells in VTK's order, and the number of every node among its places,
    which are those of the unknowns of a field of one component. Its vertices keep their order."""
    straight, corner_count, kind = _KINDS[cell_type]
    vertices, corners = np.unique(conn[:, :corner_count], return_inverse=True)
    flat = kind.from_mesh(mesh_from_cells(coords[vertices], corners.reshape(-1, corner_count), straight))
    # Cell by cell, since bodies that touch have places in common.
    places = flat.dofs.element_dofs
    number, moved = np.empty(len(coords), int), flat.doflocs.copy()
    for local, ends in enumerate([*([corner] for corner in range(corner_count)), *MIDDLES[cell_type]]):
        middles = coords[conn[:, list(ends)]].mean(axis=1)
        far = np.linalg.norm(flat.doflocs[:, places] - middles.T[:, None], axis=0)
        nearest = far.argmin(axis=0)
        found = places[nearest, np.arange(len(conn))]
        number[conn[:, local]], moved[:, found] = found, coords[conn[:, local]].T
    assert len(np.unique(number)) == len(coords), "two nodes have one place"
    return kind(moved, flat.t), number
