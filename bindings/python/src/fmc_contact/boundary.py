"""The boundary facets that the library found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ._handle import Handle
from ._library import library
from ._structs import fmc_boundary_facet


@dataclass(frozen=True, eq=False)
class BoundaryFacets:
    """The m boundary facets, in the order of ``FrictionSteps.slip``: edges in 2D, triangles in 3D, body after body. A quadrilateral
    face is four of them, one on each of its edges; a face of second order is divided first, an edge in two, a triangle or
    quadrilateral in four parts."""

    cell: np.ndarray
    """Cell of every facet, counted over all blocks, (m,); -1 without cells."""
    local_face: np.ndarray
    """Number of its face among those of the cell, as VTK counts them, (m,); -1 without cells. Nodes of face 0, 1, ... by
    their place in the cell: triangle 01, 12, 20; quadrilateral 01, 12, 23, 30; tetrahedron 013, 123, 203, 021; hexahedron
    0473, 1265, 0154, 3762, 0321, 4567; wedge 012, 354, 0341, 1452, 2530; pyramid 0321, 014, 124, 234, 304; of cells of
    second order the same, by their corners."""
    nodes: np.ndarray
    """Nodes of the face, (m, 2) in 2D, (m, 4) in 3D, where the last of a triangle is -1. In 2D the body lies on the left, in
    3D they run counter-clockwise seen from outside. Of four, the facet is the triangle of the first two and the mean of
    all. Of a face of second order they are those of the part in which the facet lies, points of the division: rows of
    ``Mesh.point_weights``."""
    body: np.ndarray
    """Index of its body in ``Result.bodies``, (m,)."""
    given: np.ndarray
    """Its number among the facets given to ``Contact.from_facets``, (m,); -1 where cells were given."""

    def __len__(self) -> int:
        return len(self.cell)


def boundary_facets(handle: Handle, count: int, dim: int) -> BoundaryFacets:
    """Asks for them."""
    found = (fmc_boundary_facet * count)()
    handle.call(library.fmc_context_boundary_facets, found, count)
    facets = np.frombuffer(found, np.dtype(fmc_boundary_facet))
    columns = 2 if dim == 2 else 4
    return BoundaryFacets(
        facets["cell"].copy(),
        facets["local_face"].copy(),
        facets["nodes"][:, :columns].copy(),
        facets["body"].astype(np.int64),
        facets["given"].copy(),
    )
