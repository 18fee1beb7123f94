"""Cells of ``fmc_contact`` and of GetFEM: the same nodes, in another order."""

from __future__ import annotations

import getfem as gf
import numpy as np
from fmc_contact._cells import face_numbers
from fmc_contact.second_order import MIDDLES

_SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
_TRIANGLE = [(0, 0), (1, 0), (0, 1)]


def _prism(around: list[tuple[int, int]]) -> list[tuple[int, ...]]:
    return [(*place, z) for z in (0, 1) for place in around]


# Corners of GetFEM's reference cells, in VTK's order: around the bottom, then around the top.
_CORNERS: dict[str, list[tuple[int, ...]]] = {
    "triangle": list(_TRIANGLE),
    "quad": list(_SQUARE),
    "tetra": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "hexahedron": _prism(_SQUARE),
    "wedge": _prism(_TRIANGLE),
    "pyramid": [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 1)],
}

_NAMES = {
    "triangle": ("GT_PK(2,1)", "FEM_PK(2,1)"),
    "quad": ("GT_QK(2,1)", "FEM_QK(2,1)"),
    "tetra": ("GT_PK(3,1)", "FEM_PK(3,1)"),
    "hexahedron": ("GT_QK(3,1)", "FEM_QK(3,1)"),
    "wedge": ("GT_PRISM(3,1)", "FEM_PK_PRISM(3,1)"),
    "pyramid": ("GT_PYRAMID(1)", "FEM_PYRAMID_QK(1)"),
    "triangle6": ("GT_PK(2,2)", "FEM_PK(2,2)"),
    "quad8": ("GT_Q2_INCOMPLETE(2)", "FEM_Q2_INCOMPLETE(2)"),
    "quad9": ("GT_QK(2,2)", "FEM_QK(2,2)"),
    "tetra10": ("GT_PK(3,2)", "FEM_PK(3,2)"),
    "hexahedron20": ("GT_Q2_INCOMPLETE(3)", "FEM_Q2_INCOMPLETE(3)"),
    "hexahedron27": ("GT_QK(3,2)", "FEM_QK(3,2)"),
}

SAME = 1e-12
"""Distance of places in a reference cell, of size 1, that are one."""


def _places() -> dict[str, np.ndarray]:
    """Places of the nodes of every cell type in the reference cell, (nodes, dim)."""
    found = {name: np.array(corners, float) for name, corners in _CORNERS.items()}
    for name, middles in MIDDLES.items():
        corners = found[name.rstrip("0123456789")]
        found[name] = np.concatenate([corners, [corners[list(ends)].mean(axis=0) for ends in middles]])
    return found


_PLACES = _places()

TYPES = tuple(_PLACES)
"""Cell types that GetFEM has elements for."""


def reference_places(cell_type: str) -> np.ndarray:
    """Places of the nodes of a cell type in GetFEM's reference cell, (nodes, dim)."""
    return _PLACES[cell_type].copy()


def nearest(wanted: np.ndarray, places: np.ndarray) -> tuple[np.ndarray, bool]:
    """Which of the ``places`` (n, dim) each of those ``wanted`` (m, dim) is, (m,), and whether all of them are there."""
    apart = np.abs(wanted[:, None] - places[None]).sum(axis=2)
    return apart.argmin(axis=1), bool(apart.min(axis=1).max() < SAME)


def of_places(places: np.ndarray) -> tuple[str, np.ndarray] | None:
    """The cell type with nodes at these places of GetFEM's reference cell, and which of them is each of its nodes; ``None`` where
    there is no such type."""
    for name, wanted in _PLACES.items():
        if wanted.shape == places.shape:
            order, all_there = nearest(wanted, places)
            if all_there:
                return name, order
    return None


def face_number(kind: str, transform: gf.GeoTrans, structure: tuple, face: int) -> int:
    """Number that ``fmc_contact`` gives a face of cells with these corners, which GetFEM counts by their structure."""
    of_cell = structure[0][0] if isinstance(structure[0], (list, tuple)) else structure[0]
    corners, _ = nearest(_PLACES[kind], transform.pts().T)
    return int(face_numbers(kind, np.isin(corners, of_cell.facepts(face))[None])[0])


def element(cell_type: str) -> gf.Fem:
    """The element with the nodes of a cell type, for ``MeshFem.set_fem``."""
    return gf.Fem(_NAMES[cell_type][1])


def mesh_from_cells(coords: np.ndarray, conn: np.ndarray, cell_type: str) -> gf.Mesh:
    """A mesh with these nodes, (nodes, dim), and cells of one type in VTK's order, curved where they are of second order: nodes and
    cells keep their numbers. Errors: ``ValueError`` where two nodes are at one place, which GetFEM takes for one."""
    coords = np.asarray(coords, np.float64)
    mesh, transform = gf.Mesh("empty", coords.shape[1]), gf.GeoTrans(_NAMES[cell_type][0])
    if not np.array_equal(mesh.add_point(coords.T), np.arange(len(coords))):
        raise ValueError("two nodes are at one place: bodies in contact need a mesh each")
    order, _ = nearest(transform.pts().T, _PLACES[cell_type])
    mesh.add_convex(transform, coords[np.asarray(conn)[:, order]].transpose(2, 1, 0))
    return mesh
