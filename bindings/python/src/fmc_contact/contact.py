"""Contact of a mesh, for repeated evaluations."""

from __future__ import annotations

from ctypes import byref, c_size_t
from typing import TYPE_CHECKING, Callable

import numpy as np
from numpy.typing import ArrayLike

from . import mesh
from ._arrays import View, coords_view, forces_view
from ._library import library
from ._signatures import LOG
from ._structs import fmc_result
from .boundary import BoundaryFacets, boundary_facets
from .fields import ContactPoints, NodalContact, contact_points, nodal_contact
from .friction import Steps
from .gaps import GapConstraints, gap_constraints
from .linearised import Linearised
from .multipliers import Multipliers
from .options import changed, defaults, described
from .pair_options import PairOptions
from . import basis
from .points import PointWeights, point_weights
from .ranks import Shared
from .result import Result, gather

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Options


class Contact(PairOptions, Steps, Multipliers, Linearised, Shared):
    """Boundary, search trees and obstacles of a mesh, kept between evaluations.

    ``coords`` are the coordinates of all nodes of the host, used or not: float64, (n, dim), or (n, 3) in 2D, or
    (dim, n), read in place. ``conn`` are node numbers, (m, nodes per cell), of cells of one ``cell_type``:
    ``"triangle"``, ``"quad"``, ``"tetra"``, ``"hexahedron"``, ``"wedge"`` or ``"pyramid"``, or of second order
    ``"triangle6"``, ``"quad8"``, ``"quad9"``, ``"tetra10"``, ``"hexahedron20"``, ``"hexahedron27"``, ``"wedge15"`` or
    ``"pyramid13"``, in meshio's node order, or the mirrored one, as VTK defines its wedge; or, without a cell type, a list of
    ``(cell type, node numbers)`` for a mixed mesh. ``bodies``, one integer for every cell counted over the list, says which
    body a cell belongs to; ``None``: bodies are the connected components by faces. ``stiffness`` is k > 0 of the law (see ``suggest_fiber_stiffness`` and ``suggest_stiffness``); the other keywords are those of ``Options``.

    Errors: those of ``fmc_contact.errors`` for the mesh and the options; ``TypeError`` and ``ValueError`` for arrays of
    another dtype or shape. After any error a contact is as it was before the call.

    Threads: contacts share nothing, so different ones may be used by different threads at once; the GIL is released
    during an evaluation. Concurrent calls on one contact raise ``BusyError``.
    """

    dim: int
    """Number of axes, 2 or 3."""
    node_count: int
    """Number of nodes of ``coords``."""
    facet_count: int
    """Number of boundary facets; a quadrilateral face in 3D counts as four triangles. Of second order an edge counts as two, a
    triangle as four, a quadrilateral as sixteen."""
    body_count: int
    """Number of bodies."""

    def __init__(
        self,
        coords: ArrayLike,
        conn: mesh.Cells,
        cell_type: str | None = None,
        *,
        stiffness: float,
        bodies: ArrayLike | None = None,
        **options: Unpack[Options],
    ) -> None:
        self._options = changed(defaults(), {"stiffness": stiffness, **options})
        self._begin(mesh.from_cells(coords, conn, cell_type, bodies, self._options))

    @classmethod
    def from_facets(
        cls,
        coords: ArrayLike,
        facets: mesh.Cells,
        facet_type: str | None = None,
        *,
        stiffness: float,
        bodies: ArrayLike | None = None,
        **options: Unpack[Options],
    ) -> Contact:
        """From the boundary of closed bodies: edges (m, 2) in 2D, the body on their left; triangles (m, 3) in 3D,
        counter-clockwise seen from outside. With a ``facet_type`` of ``"line"``, ``"triangle"``, ``"quad"``, or of second
        order ``"line3"`` (2D), ``"triangle6"``, ``"quad8"``, ``"quad9"``, facets of that type in meshio's node order; or,
        without one, a list of ``(facet type, node numbers)`` for a mixed surface. ``bodies``, one integer for every facet
        counted over the list; ``None``: bodies are the connected components by nodes. Errors: also ``OpenSurfaceError``, ``InconsistentOrientationError``,
        ``InvertedSurfaceError``."""
        contact = cls.__new__(cls)
        contact._options = changed(defaults(), {"stiffness": stiffness, **options})
        contact._begin(mesh.from_facets(coords, facets, facet_type, bodies, contact._options))
        return contact

    def _begin(self, start: mesh.Start) -> None:
        self._handle, self.dim, self._is_columns = start
        counts = [c_size_t() for _ in range(3)]
        self._handle.call(library.fmc_context_counts, *map(byref, counts))
        self.node_count, self.facet_count, self.body_count = (count.value for count in counts)
        self.unknown_count = self.node_count

    def boundary_facets(self) -> BoundaryFacets:
        """The boundary facets that were found, in the order of ``slip``: cell, face of the cell, nodes and body of each."""
        with self._handle:
            return boundary_facets(self._handle, self.facet_count, self.dim)

    def point_weights(self) -> PointWeights:
        """The points of which ``boundary_facets``, ``contact_points`` and ``gap_constraints`` tell, as combinations of nodes:
        with cells of second order more than the nodes, else the nodes themselves."""
        with self._handle:
            return point_weights(self._handle, self.unknown_count, self._options.index_base)

    def set_basis(self, matrix: Any | None) -> None:
        """Has the nodes of the mesh moved by unknowns of your own, such as control points of splines or coefficients of
        hierarchical shape functions: nodes = ``matrix`` @ unknowns. ``matrix``, (nodes, unknowns), is a ``scipy.sparse`` matrix
        or an array; ``None``: nodes move by themselves again.

        Coordinates are from then on those of the unknowns, (unknowns, dim), and so are forces, tangents, masses and the columns
        of gap constraints and ``point_weights``. The mesh and its coordinates without deformation stay, and so do the nodes of
        ``nodal_contact`` and ``set_symmetry_nodes``. Errors: ``ValueError`` for another shape, ``OverflowError`` of
        ``fmc_contact.errors`` for an entry that is not finite; nothing changes then."""
        rows = basis.compressed(matrix, self.node_count, self._options.index_base)
        with self._handle:
            self._handle.call(library.fmc_context_set_basis, *rows)
            self.unknown_count = self.node_count if matrix is None else rows[0]

    @property
    def options(self) -> dict[str, object]:
        """All options, including defaults."""
        return described(self._options)

    def set_options(self, **options: Unpack[Options]) -> None:
        """Changes some options, ``stiffness`` too; the others stay, and those of single pairs (``set_pair``). They apply
        from the next evaluation on."""
        with self._handle:
            replaced = changed(self._options, options)
            self._handle.call(library.fmc_context_set_options, byref(replaced))
            self._options = replaced

    def evaluate(self, coords: ArrayLike, out: np.ndarray | None = None, add: bool = False) -> Result:
        """Contact forces at ``coords``, the current coordinates of all nodes, laid out in any way of the class.

        ``out``, a float64 array in any such layout, receives the forces in place of a new one; with ``add`` they are
        added to its values. A third column in 2D is not changed, nor is the array after an error.

        Errors: ``LengthError``, ``NonFiniteCoordinateError``, ``InvertedCellError``, ``ZeroMeasureError``,
        ``UnsupportedError``, ``SignedDistanceError``, ``UnfinishedLinesError``, ``TooManyFibersError``,
        ``TooManyPiecesError``, ``RangeError``, ``BufferTooSmallError``, ``StrideError``, ``BusyError``, and exceptions
        raised by a signed distance function.
        """
        view = coords_view(coords, self.dim)
        forces, flags = self._forces(view, out, add)
        target, found = forces_view(forces, self.dim), fmc_result()
        with self._handle:
            self._handle.call(
                library.fmc_context_evaluate, byref(view.struct), byref(target.struct), flags, byref(found)
            )
            return gather(self._handle, forces, found, self.dim)

    def nodal_contact(self, coords: ArrayLike) -> NodalContact:
        """Pressure, gap, area and normal at every node at ``coords``, and whether it touches. Errors: those of
        ``evaluate``."""
        view = coords_view(coords, self.dim)
        with self._handle:
            return nodal_contact(self._handle, view, self.node_count, self.dim)

    def contact_points(self, coords: ArrayLike) -> ContactPoints:
        """The points where the laws ``"fiber"`` and ``"depth"`` press at ``coords``, with both sides of each; none with
        the law ``"volume"``. Errors: those of ``evaluate``."""
        view = coords_view(coords, self.dim)
        with self._handle:
            return contact_points(self._handle, view, self.dim)

    def gap_constraints(self, coords: ArrayLike, reach: float) -> GapConstraints:
        """Weighted gaps at ``coords`` of all nodes that have a facet nearer than ``reach`` (length) to a partner, apart or
        overlapping, with their derivative: what an augmented Lagrangian, an interior point method or a preconditioner
        asks for. They depend on no law and no estimator; a body has no gaps over itself. Errors: those of ``evaluate``;
        ``NotPositiveError`` for ``reach``."""
        view = coords_view(coords, self.dim)
        with self._handle:
            return gap_constraints(self._handle, view, reach)

    def keep_patches(self, coords: ArrayLike) -> int:
        """Finds the patches of the law ``"fiber"`` at ``coords`` and keeps direction and spacing of their lines, so
        that a solver's forces are the gradient of one energy; call it at the start of a load step. Patches of pairs
        that do not overlap there are not kept. Returns the number of directions kept, 0 with other laws. Errors: those
        of ``evaluate``."""
        return self._patches(coords_view(coords, self.dim))

    def release_patches(self) -> None:
        """Releases kept patches: they are found at every evaluation again."""
        self._patches(None)

    def _patches(self, view: View | None) -> int:
        count = c_size_t()
        with self._handle:
            coords = None if view is None else byref(view.struct)
            self._handle.call(library.fmc_context_keep_patches, coords, byref(count))
        return count.value

    def set_reference(self, coords: ArrayLike) -> None:
        """Sets the coordinates of all nodes without deformation, from which the law ``"depth"`` has its depths; those
        with which the contact was made are the default."""
        view = coords_view(coords, self.dim)
        with self._handle:
            self._handle.call(library.fmc_context_set_reference, byref(view.struct))

    def set_symmetry_nodes(self, nodes: ArrayLike) -> None:
        """Names the nodes that lie in planes of symmetry: for the law ``"depth"`` a face all of whose nodes are named is
        no surface, since the body goes on behind it; of second order those in the middle of its edges, and its own, are
        named too. Replaces what was named before; an empty list names none, and flush
        faces are not warned of."""
        numbers = np.ascontiguousarray(nodes if np.size(nodes) else [], dtype=np.int64).reshape(-1)
        with self._handle:
            self._handle.call(library.fmc_context_set_symmetry_nodes, numbers, len(numbers))

    def set_log(self, function: Callable[[str], None] | None) -> None:
        """Calls ``function`` with a sentence for every warning of an evaluation; ``None``: no calls.

        ``Result.warnings`` has them in any case. Exceptions of the function are raised by the evaluation.
        """
        callback = LOG() if function is None else LOG(self._handle.message_callback(function))
        with self._handle:
            self._handle.call(library.fmc_context_set_log, callback, None)
            self._handle.keep("log", callback)
