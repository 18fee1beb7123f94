"""Boundary faces of a mesh and the degrees of freedom of their nodes, for displacements of second order."""

from __future__ import annotations

from typing import Any

import numpy as np
from fmc_contact.trace import Trace

from .field import Field, LayoutError


def outward(corners: np.ndarray, x: np.ndarray, cell_middles: np.ndarray) -> np.ndarray:
    """The faces (m, corners) of cells with these middles, turned to be seen from outside; ``x`` (nodes, dim)."""
    at = x[corners]
    if x.shape[1] == 2:
        along = at[:, 1] - at[:, 0]
        normal = np.column_stack([along[:, 1], -along[:, 0]])
    else:
        normal = np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0])
    inward = np.einsum("ij,ij->i", normal, at.mean(axis=1) - cell_middles) < 0
    turned = corners.copy()
    turned[inward] = corners[inward, ::-1]
    return turned


class Boundary:
    """All boundary faces of a field: their trace, and where the unknowns of its nodes are."""

    trace: Trace
    dofs: np.ndarray
    """Degrees of freedom of the nodes of the trace, (nodes, dim), offset included."""
    coords: np.ndarray
    """Undeformed coordinates of these nodes, (nodes, dim)."""
    cells: np.ndarray
    """Cell of every flat facet."""

    def __init__(self, field: Field, divisions: int | None) -> None:
        basis, mesh = field.basis, field.basis.mesh
        if field.cell_type == "wedge":
            raise LayoutError("the faces of wedges are of two shapes and cannot be divided: leave out divisions")
        faces = mesh.boundary_facets()
        cells = mesh.f2t[0, faces]
        x = mesh.p.T
        middles = x[field.conn[cells]].mean(axis=1)
        corners = outward(np.ascontiguousarray(mesh.facets[:, faces].T), x, middles)
        self.trace = trace = Trace(corners, field.order, divisions)
        self.cells = cells[trace.face_of_facet]
        dofs = [basis.nodal_dofs[:, trace.corner_ids]]
        if field.order == 2:
            ends = trace.corner_ids[trace.middles]
            if mesh.dim() == 2:
                dofs.append(basis.facet_dofs[:, _find(mesh.facets, ends)])
            else:
                dofs.append(basis.edge_dofs[:, _find(mesh.edges, ends)])
            if corners.shape[1] == 4:
                dofs.append(basis.facet_dofs[:, faces])
        local = np.concatenate(dofs, axis=1).T
        self.dofs = local + field.offset
        # Curved cells of second order have their middles off the straight edge.
        self.coords = basis.doflocs[:, local[:, 0]].T.copy()
        self.coords[: len(trace.corner_ids)] = x[trace.corner_ids]


def _find(pairs: np.ndarray, wanted: np.ndarray) -> Any:
    """Columns of ``pairs``, (2, n), that hold the rows of ``wanted``, (m, 2), whichever way round."""
    base = int(pairs.max()) + 1
    keys = pairs.min(axis=0).astype(np.int64) * base + pairs.max(axis=0)
    order = np.argsort(keys)
    sought = wanted.min(axis=1).astype(np.int64) * base + wanted.max(axis=1)
    return order[np.searchsorted(keys[order], sought)]
