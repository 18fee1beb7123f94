"""The mesh of a contact."""

from __future__ import annotations

from typing import Any

import numpy as np
from ctypes import byref
from numpy.typing import ArrayLike

from . import basis
from ._arrays import coords_view
from ._core import Core
from ._library import library
from .boundary import BoundaryFacets, boundary_facets
from .points import PointWeights, point_weights


class Mesh:
    """The mesh of a contact: its boundary, its coordinates without deformation, its planes of symmetry, and what moves its nodes."""

    def __init__(self, core: Core) -> None:
        self._core = core

    def boundary_facets(self) -> BoundaryFacets:
        """The boundary facets that were found, in the order of ``FrictionSteps.slip``: cell, face of the cell, nodes and body of
        each."""
        core = self._core
        with core.handle:
            return boundary_facets(core.handle, core.facet_count, core.dim)

    def point_weights(self) -> PointWeights:
        """The points of which ``boundary_facets``, ``contact_points`` and ``gap_constraints`` tell, as combinations of nodes:
        with cells of second order more than the nodes, else the nodes themselves."""
        core = self._core
        with core.handle:
            return point_weights(core.handle, core.unknown_count, core.options.index_base)

    def set_basis(self, matrix: Any | None) -> None:
        """Has the nodes of the mesh moved by unknowns of your own, such as control points of splines or coefficients of
        hierarchical shape functions: nodes = ``matrix`` @ unknowns. ``matrix``, (nodes, unknowns), is a ``scipy.sparse`` matrix
        or an array; ``None``: nodes move by themselves again.

        Coordinates are from then on those of the unknowns, (unknowns, dim), and so are forces, tangents, masses and the columns
        of gap constraints and ``point_weights``. The mesh and its coordinates without deformation stay, and so do the nodes of
        ``nodal_contact`` and ``set_symmetry_nodes``. Errors: ``ValueError`` for another shape, ``RangeError`` for an entry that
        is not finite; nothing changes then."""
        core = self._core
        rows = basis.compressed(matrix, core.node_count, core.options.index_base)
        with core.handle:
            core.handle.call(library.fmc_context_set_basis, *rows)
            core.unknown_count = core.node_count if matrix is None else rows[0]

    def set_reference(self, coords: ArrayLike) -> None:
        """Sets the coordinates of all nodes without deformation, from which the law ``"depth"`` has its depths; those
        with which the contact was made are the default."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_reference, byref(view.struct))

    def set_symmetry_nodes(self, nodes: ArrayLike) -> None:
        """Names the nodes that lie in planes of symmetry: for the law ``"depth"`` a face all of whose nodes are named is
        no surface, since the body goes on behind it; of second order those in the middle of its edges, and its own, are
        named too. Replaces what was named before; an empty list names none, and flush
        faces are not warned of."""
        numbers = np.ascontiguousarray(nodes if np.size(nodes) else [], dtype=np.int64).reshape(-1)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_symmetry_nodes, numbers, len(numbers))
