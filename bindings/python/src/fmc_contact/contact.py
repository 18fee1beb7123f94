"""Contact of a mesh, for repeated evaluations."""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t
from typing import TYPE_CHECKING, Any, Callable

import numpy as np
from numpy.typing import ArrayLike

from . import creation, result, tangent
from ._arrays import View, coords_view, forces_view, vector
from ._constants import FMC_ADD, FMC_SEMIDEFINITE, FMC_SYMMETRIC
from ._core import Core
from ._library import library
from ._structs import fmc_log_callback, fmc_options, fmc_result
from .contact_step import ContactStep, contact_step
from .fields import ContactPoints, NodalContact, contact_points, nodal_contact
from .friction import FrictionSteps
from .gaps import GapConstraints, gap_constraints
from .mesh import Mesh
from .multipliers import Multipliers
from .obstacles import Obstacles
from .options import changed, defaults, described
from .pairs import Pairs
from .patches import Patches
from .pattern import Pattern
from .ranks import Ranks
from .result import Result
from .tangent import Tangent

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Options


class Contact:
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

    mesh: Mesh
    """Boundary facets, coordinates without deformation, planes of symmetry, and what moves the nodes."""
    obstacles: Obstacles
    """Rigid obstacles: added, moved, removed."""
    pairs: Pairs
    """Options of single pairs."""
    friction: FrictionSteps
    """Steps with friction, and the elastic slip that is carried from one to the next."""
    multipliers: Multipliers
    """How far surfaces are moved out, until they press without penetration."""
    patches: Patches
    """Patches of the law ``"fiber"`` that are kept for a load step."""
    pattern: Pattern
    """The pattern of the tangent, kept for a symbolic factorisation."""
    ranks: Ranks
    """Ranks that share the work."""

    def __init__(
        self,
        coords: ArrayLike,
        conn: creation.Cells,
        cell_type: str | None = None,
        *,
        stiffness: float,
        bodies: ArrayLike | None = None,
        **options: Unpack[Options],
    ) -> None:
        own = changed(defaults(), {"stiffness": stiffness, **options})
        self._take(creation.from_cells(coords, conn, cell_type, bodies, own), own)

    @classmethod
    def from_facets(
        cls,
        coords: ArrayLike,
        facets: creation.Cells,
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
        own = changed(defaults(), {"stiffness": stiffness, **options})
        contact._take(creation.from_facets(coords, facets, facet_type, bodies, own), own)
        return contact

    def _take(self, start: creation.Start, options: fmc_options) -> None:
        """Takes a context, and makes the parts."""
        self._core = core = Core(start.handle, options, start.dim, start.is_columns)
        self.mesh, self.obstacles, self.pairs = Mesh(core), Obstacles(core), Pairs(core)
        self.friction, self.multipliers = FrictionSteps(core), Multipliers(core)
        self.patches, self.pattern, self.ranks = Patches(core), Pattern(core), Ranks(core)

    @property
    def dim(self) -> int:
        """Number of axes, 2 or 3."""
        return self._core.dim

    @property
    def node_count(self) -> int:
        """Number of nodes of ``coords``."""
        return self._core.node_count

    @property
    def unknown_count(self) -> int:
        """Number of unknowns that move the nodes: the nodes themselves, unless ``mesh.set_basis`` named others."""
        return self._core.unknown_count

    @property
    def facet_count(self) -> int:
        """Number of boundary facets; a quadrilateral face in 3D counts as four triangles. Of second order an edge counts as
        two, a triangle as four, a quadrilateral as sixteen."""
        return self._core.facet_count

    @property
    def body_count(self) -> int:
        """Number of bodies."""
        return self._core.body_count

    @property
    def options(self) -> dict[str, object]:
        """All options, including defaults."""
        return described(self._core.options)

    def set_options(self, **options: Unpack[Options]) -> None:
        """Changes some options, ``stiffness`` too; the others stay, and those of single pairs (``pairs.set``). They apply
        from the next evaluation on."""
        with self._core.handle:
            replaced = changed(self._core.options, options)
            self._core.handle.call(library.fmc_context_set_options, byref(replaced))
            self._core.options = replaced

    def stiffen(self, factor: float) -> None:
        """Multiplies the stiffness of the law, and of those that pairs have of their own, by a factor; what surfaces that are moved out
        press with where they just touch stays. Where an update of the multipliers leaves more than a part of the penetration, a
        quarter say, this helps more than another one. Errors: ``NotPositiveError``."""
        with self._core.handle:
            self._core.handle.call(library.fmc_context_stiffen, c_double(factor))
            self._core.options.stiffness *= factor

    def evaluate(self, coords: ArrayLike, out: np.ndarray | None = None, add: bool = False) -> Result:
        """Contact forces at ``coords``, the current coordinates of all nodes, laid out in any way of the class.

        ``out``, a float64 array in any such layout, receives the forces in place of a new one; with ``add`` they are
        added to its values. A third column in 2D is not changed, nor is the array after an error.

        Errors: ``LengthError``, ``NonFiniteCoordinateError``, ``InvertedCellError``, ``ZeroMeasureError``,
        ``UnsupportedError``, ``SignedDistanceError``, ``UnfinishedLinesError``, ``TooManyFibersError``,
        ``TooManyPiecesError``, ``RangeError``, ``BufferTooSmallError``, ``StrideError``, ``BusyError``, and exceptions
        raised by a signed distance function.
        """
        view = coords_view(coords, self._core.dim)
        forces, flags = self._forces(view, out, add)
        target, found = forces_view(forces, self._core.dim), fmc_result()
        with self._core.handle:
            self._core.handle.call(
                library.fmc_context_evaluate, byref(view.struct), byref(target.struct), flags, byref(found)
            )
            return result.gather(self._core.handle, forces, found, self._core.dim)

    def tangent(
        self,
        coords: ArrayLike,
        semidefinite: bool = False,
        obstacles: bool = False,
        blocks: bool = False,
        symmetric: bool = False,
    ) -> Any:
        """Second derivative of the contact energy, which is minus the derivative of the forces, to be added to a
        stiffness matrix.

        UNSYMMETRIC with friction, unless that is frozen: solve with LU or GMRES, or ask for ``symmetric``, with which
        Newton's method takes more iterations. Symmetric without friction.

        A ``scipy.sparse.csr_matrix``, (n dim, n dim), row and column ``node * dim + axis``; with ``blocks`` a
        ``bsr_matrix`` of blocks (dim, dim). Without scipy ``(rows, cols, values)``, where duplicate entries are summed.
        ``semidefinite`` leaves out the terms that can be indefinite, for use far from a solution. ``obstacles`` appends
        the translations of the obstacles, as nodes after the last, and, with ``obstacles.set_rotations``, their rotations. For the law ``"volume"`` all nodes of a pair are
        coupled: see ``tangent_parts`` for large ones.

        With the law ``"fiber"``, ``patches.keep`` and ``momentum_correction=False`` it is the derivative of the forces; the
        momentum correction (``momentum_correction=True``), which is small, is not differentiated.

        Errors: those of ``evaluate``; ``UnsupportedError`` for a law or an estimator without tangent.
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return tangent.matrix(self._core.handle, self._linearise(view, semidefinite, symmetric), obstacles, self._core.dim, blocks)

    def tangent_parts(
        self, coords: ArrayLike, semidefinite: bool = False, obstacles: bool = False, symmetric: bool = False
    ) -> Tangent:
        """The same as separate entries and terms of rank one, for other matrix formats and as a linear operator."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return tangent.gather(self._core.handle, self._linearise(view, semidefinite, symmetric), obstacles)

    def _linearise(self, view: View, semidefinite: bool, symmetric: bool) -> int:
        """Number of terms of rank one of the tangent, which the library then keeps."""
        parts = c_size_t()
        flags = (FMC_SEMIDEFINITE if semidefinite else 0) | (FMC_SYMMETRIC if symmetric else 0)
        self._core.handle.call(library.fmc_context_tangent, byref(view.struct), flags, None, byref(parts))
        return parts.value

    def evaluate_tangent(
        self,
        coords: ArrayLike,
        out: np.ndarray | None = None,
        add: bool = False,
        semidefinite: bool = False,
        obstacles: bool = False,
        blocks: bool = False,
        symmetric: bool = False,
    ) -> tuple[Result, Any]:
        """``evaluate`` and ``tangent`` in one, with the same bits, in little more than the time of the second."""
        view = coords_view(coords, self._core.dim)
        forces, flags = self._forces(view, out, add)
        target, found, parts = forces_view(forces, self._core.dim), fmc_result(), c_size_t()
        flags |= (FMC_SEMIDEFINITE if semidefinite else 0) | (FMC_SYMMETRIC if symmetric else 0)
        views = byref(view.struct), flags, byref(target.struct)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_evaluate_tangent, *views, byref(found), None, byref(parts))
            matrix = tangent.matrix(self._core.handle, parts.value, obstacles, self._core.dim, blocks)
            return result.gather(self._core.handle, forces, found, self._core.dim), matrix

    def _forces(self, view: View, out: np.ndarray | None, add: bool) -> tuple[np.ndarray, int]:
        """The array for the forces, and the flags."""
        if out is not None:
            return out, FMC_ADD if add else 0
        if add:
            raise ValueError("add is for forces that are there already: give the array as out")
        return np.empty((self._core.dim, self._core.unknown_count) if view.is_columns else (self._core.unknown_count, self._core.dim)), 0

    def nodal_contact(self, coords: ArrayLike) -> NodalContact:
        """Pressure, gap, area and normal at every node at ``coords``, and whether it touches. Errors: those of
        ``evaluate``."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return nodal_contact(self._core.handle, view, self._core.node_count, self._core.dim)

    def contact_points(self, coords: ArrayLike) -> ContactPoints:
        """The points where the laws ``"fiber"`` and ``"depth"`` press at ``coords``, with both sides of each; none with
        the law ``"volume"``. Errors: those of ``evaluate``."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return contact_points(self._core.handle, view, self._core.dim)

    def gap_constraints(self, coords: ArrayLike, reach: float) -> GapConstraints:
        """Weighted gaps at ``coords`` of all nodes that have a facet nearer than ``reach`` (length) to a partner, apart or
        overlapping, with their derivative: what an augmented Lagrangian, an interior point method or a preconditioner
        asks for. They depend on no law and no estimator; a body has no gaps over itself. Errors: those of ``evaluate``;
        ``NotPositiveError`` for ``reach``."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return gap_constraints(self._core.handle, view, reach)

    def contact_step(
        self,
        coords: ArrayLike,
        dofs: ArrayLike,
        stiffness: ArrayLike,
        residual: ArrayLike,
        held: ArrayLike = (),
        place: Callable[[np.ndarray, np.ndarray], None] | None = None,
        **options: float,
    ) -> ContactStep:
        """The displacement d of some degrees of freedom for which ``stiffness @ d + residual - forces(coords + d) = 0``: equilibrium of
        the contact with bodies that are condensed on these.

        ``dofs``, (m,), the list: degrees of freedom ``node * dim + axis``, ascending; best those of the tangent's pattern that may
        move. ``held``: others, which do not move, on which contact may act, ascending. ``stiffness``, (m, m), symmetric, and
        ``residual``, (m,), internal less external forces at ``coords`` without contact: those of the bodies, condensed.
        ``place(displacement, coords)`` moves the nodes that follow in ``coords``, (n, dim), to which the displacement was added on the
        list; it is needed where bodies move by more than a part of a cell. ``options``: ``tolerance`` (1e-10, residual by the
        forces), ``goal`` (0, a residual, a force), ``full_below`` (0.1), ``most_iterations`` (80), ``most_trials`` (12).
        ``penetration`` (0: that of the law): the largest mean penetration of a node that is wanted, by an augmented Lagrangian
        from the law's equilibrium on, for gaps within ``reach`` (0: a twentieth of the bodies' extent) and in at most
        ``most_updates`` (20).

        With the law ``"fiber"`` after ``patches.keep``. Friction with the current pressure, or frozen. Look at the ``state``
        of what is returned. What is kept of the last evaluation stays.

        Errors: those of ``tangent``; ``FreedomOutOfRangeError``, ``RepeatedFreedomError``, ``NonFiniteStiffnessError``;
        ``SingularStiffnessError`` and ``IndefiniteStiffnessError`` for bodies and contact together; ``TypeError`` for an option that
        there is not; exceptions of ``place``."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return contact_step(self._core.handle, view, self._core.dim, dofs, stiffness, residual, held, place, options)

    def stable_step(self, coords: ArrayLike, masses: ArrayLike) -> float:
        """Largest time step of central differences (leapfrog) for the contact alone, from the tangent at ``coords``;
        up to 3 % below the limit. ``masses``, (n,), are lumped masses of the nodes: positive where a node feels contact,
        infinite for nodes that are held. Obstacles are held. ``inf`` where nothing touches.

        A solver whose own limit is h is stable with the step s, 1/s**2 = 1/h**2 + 1/stable_step**2. The limit is that of
        the motion linearised at ``coords``: contact that begins within a step is not in it.

        Errors: those of ``tangent``; ``NotPositiveMassError``, which names the node.
        """
        view, step = coords_view(coords, self._core.dim), c_double()
        masses = vector(masses, self._core.unknown_count, "masses")
        with self._core.handle:
            self._core.handle.call(library.fmc_context_stable_step, byref(view.struct), masses, byref(step))
        return step.value

    def set_log(self, function: Callable[[str], None] | None) -> None:
        """Calls ``function`` with a sentence for every warning of an evaluation; ``None``: no calls.

        ``Result.warnings`` has them in any case. Exceptions of the function are raised by the evaluation.
        """
        guarded = None if function is None else self._core.handle.message_callback(function)
        callback = fmc_log_callback() if guarded is None else fmc_log_callback(guarded)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_log, callback, None)
            self._core.handle.keep("log", callback)
