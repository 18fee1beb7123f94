"""Contact of a mesh, for repeated evaluations."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import byref, c_double, c_size_t
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import creation, result, tangent
from ._arrays import View, coords_view, finite, forces_view, vector
from ._constants import FMC_EVALUATE_ADD, FMC_TANGENT_SEMIDEFINITE, FMC_TANGENT_SYMMETRIC
from ._core import Core
from ._library import library
from ._structs import fmc_log_callback, fmc_options, fmc_result, fmc_step_limit
from ._unpack import Unpack
from .added_ties import Ties
from .cohesive import CohesiveInterfaces
from .contact_step import ContactStep, contact_step
from .fields import ContactPoints, NodalContact, contact_points, nodal_contact
from .flux import Conductance, ContactFlux, FrictionHeat, flux, friction_heat
from .forward import Rates, Slopes, slopes
from .friction import FrictionSteps, rows_of
from .gaps import GapConstraints, gap_constraints
from .gradients import Gradients, PairGradient, gradients, names_of
from .laws import InterfaceLaws
from .mesh import Mesh
from .multipliers import Multipliers
from .obstacles import Obstacles
from .options import Options, OtherOptions, changed, defaults, described
from .pairs import Pairs
from .patches import Patches
from .pattern import Pattern
from .ranks import Ranks
from .result import Result
from .step_limit import StepLimit
from .tangent import Tangent
from .ties import TieConstraints, TieNodes, tie_constraints, tie_nodes
from .wear import Wear


class Contact:
    """Contact of a mesh, for repeated evaluations: keeps its boundary, search trees and obstacles.

    Coordinates include all nodes, used or not. float64 arrays are read in place, in any layout; other real numbers are converted. An error leaves
    a contact unchanged.

    Contacts share nothing, so different threads may use different contacts at once; the GIL is released during an evaluation.
    Concurrent calls on one contact raise ``BusyError``.

    Parameters
    ----------
    coords : array_like, (n, dim), or (n, 3) in 2D, or (dim, n)
        Undeformed coordinates of all nodes.
    conn : array_like of int, (m, nodes per cell), or list of (cell type, array)
        Nodes of every cell, in the order of meshio and VTK; cells may also be mirrored. Without ``cell_type`` a list of
        ``(cell type, nodes)``, for a mixed mesh.
    cell_type : str, optional
        ``"triangle"``, ``"quad"``, ``"tetra"``, ``"hexahedron"``, ``"wedge"``, ``"pyramid"``; of second order ``"triangle6"``,
        ``"quad8"``, ``"quad9"``, ``"tetra10"``, ``"hexahedron20"``, ``"hexahedron27"``, ``"wedge15"``, ``"pyramid13"``.
    stiffness : float
        Stiffness k > 0 of the law: for the default law ten times Young's modulus, divided by the size of a facet, is a good start.
    bodies : array_like of int, (cells,), optional
        Body of every cell, counted over the list. Default: bodies are the connected components by faces.
    **options : OtherOptions
        See ``Options``.

    Attributes
    ----------
    mesh : Mesh
        Boundary facets, undeformed coordinates, planes of symmetry, and the unknowns that move the nodes.
    obstacles : Obstacles
        Rigid obstacles: added, moved, removed.
    pairs : Pairs
        Options of single pairs.
    ties : Ties
        Ties between named parts of surfaces, with a period or a jump.
    cohesive : CohesiveInterfaces
        Interfaces that break, and their damage.
    laws : InterfaceLaws
        Interfaces that follow your own laws, and their history.
    friction : FrictionSteps
        Steps with friction, and the elastic slip that is carried from one to the next.
    wear : Wear
        Wear by sliding.
    multipliers : Multipliers
        Multipliers of the augmented Lagrangian.
    patches : Patches
        Patches of the law ``"fiber"``, kept for a load step.
    pattern : Pattern
        Pattern of the tangent, kept for a symbolic factorisation.
    ranks : Ranks
        Ranks that share the work.

    Raises
    ------
    TypeError, ValueError
        For arrays of another dtype or shape. The message names the argument, and the actual and the expected shape.
    FmcError
        For a mesh or an option that cannot be: ``InvertedCellError``, ``NodeOutOfRangeError``, ``UnknownOptionError``, ...

    Examples
    --------
    Two unit squares that overlap by 0.1; other examples use these names.

    >>> import numpy as np
    >>> from fmc_contact import Contact
    >>> coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.9, -0.2], [1.9, -0.2], [1.9, 0.8], [0.9, 0.8]])
    >>> squares = [[0, 1, 2, 3], [4, 5, 6, 7]]
    >>> contact = Contact(coords, squares, "quad", stiffness=1000.0)
    >>> print(f"{contact.evaluate(coords).volume:.2f}")
    0.08
    """

    mesh: Mesh
    obstacles: Obstacles
    pairs: Pairs
    ties: Ties
    cohesive: CohesiveInterfaces
    laws: InterfaceLaws
    friction: FrictionSteps
    wear: Wear
    multipliers: Multipliers
    patches: Patches
    pattern: Pattern
    ranks: Ranks

    def __init__(
        self,
        coords: ArrayLike,
        conn: creation.Cells,
        cell_type: Optional[str] = None,
        *,
        stiffness: float = 0.0,
        bodies: Optional[ArrayLike] = None,
        **options: Unpack[OtherOptions],
    ) -> None:
        own = changed(defaults(), {"stiffness": stiffness, **options})
        self._take(creation.from_cells(coords, conn, cell_type, bodies, own), own)

    @classmethod
    def from_facets(
        cls,
        coords: ArrayLike,
        facets: creation.Cells,
        facet_type: Optional[str] = None,
        *,
        stiffness: float,
        bodies: Optional[ArrayLike] = None,
        **options: Unpack[OtherOptions],
    ) -> Contact:
        """A contact from the boundary of closed bodies. The law must be ``"fiber"`` or ``"volume"``: ``"depth"`` needs cells.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Undeformed coordinates of all nodes.
        facets : array_like of int, (m, nodes per facet), or list of (facet type, array)
            Nodes of every facet. In 2D the body lies on the left of an edge. In 3D corners run counter-clockwise, seen from outside.
        facet_type : str, optional
            ``"line"``, ``"triangle"``, ``"quad"``; of second order ``"line3"``, ``"triangle6"``, ``"quad8"``, ``"quad9"``. Without it,
            two columns are edges and three are triangles.
        stiffness : float
            Stiffness k > 0 of the law.
        bodies : array_like of int, (facets,), optional
            Body of every facet. Default: bodies are the connected components by nodes.
        **options : OtherOptions
            See ``Options``.

        Returns
        -------
        Contact
            The contact.

        Raises
        ------
        OpenSurfaceError, InconsistentOrientationError, InvertedSurfaceError
            If the facets do not bound bodies.
        FmcError
            As ``Contact`` raises.

        Examples
        --------
        >>> edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]]
        >>> Contact.from_facets(coords, edges, stiffness=1000.0, law="fiber").body_count
        2
        """
        contact = cls.__new__(cls)
        own = changed(defaults(), {"stiffness": stiffness, **options})
        contact._take(creation.from_facets(coords, facets, facet_type, bodies, own), own)
        return contact

    def _take(self, start: creation.Start, options: fmc_options) -> None:
        """Takes a context, and makes the parts."""
        self._core = core = Core(start.handle, options, start.dim, start.is_columns)
        self.mesh, self.obstacles, self.pairs = Mesh(core), Obstacles(core), Pairs(core)
        self.ties, self.laws = Ties(core), InterfaceLaws(core)
        self.cohesive, self.friction, self.multipliers = CohesiveInterfaces(core), FrictionSteps(core), Multipliers(core)
        self.wear = Wear(core)
        self.patches, self.pattern, self.ranks = Patches(core), Pattern(core), Ranks(core)

    @property
    def dim(self) -> int:
        """Number of axes, 2 or 3."""
        return self._core.dim

    @property
    def node_count(self) -> int:
        """Number of nodes."""
        return self._core.node_count

    @property
    def unknown_count(self) -> int:
        """Number of unknowns that move the nodes: the nodes themselves, unless ``mesh.set_basis`` named others."""
        return self._core.unknown_count

    @property
    def facet_count(self) -> int:
        """Number of boundary facets.

        A quadrilateral face counts as four triangles. Of second order an edge counts as two facets, a triangle as four, and a
        quadrilateral as sixteen.
        """
        return self._core.facet_count

    @property
    def body_count(self) -> int:
        """Number of bodies."""
        return self._core.body_count

    @property
    def options(self) -> dict[str, Any]:
        """All options in force, including defaults, by the names of ``Options``."""
        return described(self._core.options)

    def set_options(self, **options: Unpack[Options]) -> None:
        """Changes some options, from the next evaluation on. All other options stay, and so do options of single pairs.

        Parameters
        ----------
        **options : Options
            The options that change.

        Raises
        ------
        UnknownOptionError, BadValueError, OptionsConflictError
            If there is no such option or value, or it would have no effect.
        NotPositiveError
            If a value must be positive and is not.

        Examples
        --------
        >>> contact.set_options(stiffness=2000.0, threads=2)
        """
        with self._core.handle:
            replaced = changed(self._core.options, options)
            self._core.handle.call(library.fmc_context_set_options, byref(replaced))
            self._core.options = replaced

    def stiffen(self, factor: float) -> None:
        """Multiplies the stiffness of the law, and of every pair with a separate law, by a factor.

        The pressure of the multipliers does not change. Call it instead of another update of the multipliers if the last update reduced the
        penetration to more than a quarter.

        Parameters
        ----------
        factor : float
            Positive factor.

        Raises
        ------
        NotPositiveError
            If the factor is not positive.

        Examples
        --------
        >>> contact.stiffen(4.0)
        >>> contact.options["stiffness"]
        4000.0
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_stiffen, c_double(factor))
            self._core.renew_options()

    def evaluate(self, coords: ArrayLike, out: Optional[np.ndarray] = None, add: bool = False) -> Result:
        """Contact forces at the current coordinates.

        Parameters
        ----------
        coords : array_like, (n, dim), or (n, 3) in 2D, or (dim, n)
            Current coordinates of all nodes.
        out : ndarray of float64, optional
            Receives the forces in place of a new array, in any layout of ``coords``. A third column in 2D is not written.
        add : bool
            Whether forces are added to ``out``.

        Returns
        -------
        Result
            Forces, totals, resultants, pairs and warnings.

        Raises
        ------
        LengthError
            If the number of nodes differs from the mesh.
        NonFiniteCoordinateError, InvertedCellError, ZeroMeasureError
            For coordinates at which there are no bodies.
        UnsupportedError
            For a combination of law, estimator and shapes that is not supported.
        SignedDistanceError
            If a signed distance is not finite. Exceptions of the function itself are raised unchanged.
        UnfinishedLinesError, TooManyFibersError, TooManyPiecesError, RangeError
            If the overlap cannot be measured.
        StrideError, BufferTooSmallError, BusyError
            For an output that overlaps itself or is too short; for a contact in use by another call.

        Examples
        --------
        >>> result = contact.evaluate(coords)
        >>> print(f"{result.bodies[0].force[0]:.1f}")
        -75.0
        """
        view = coords_view(coords, self._core.dim)
        forces, flags = self._forces(view, out, add)
        target, found = forces_view(forces, self._core.dim), fmc_result()
        with self._core.handle:
            self._core.handle.call(
                library.fmc_context_evaluate, byref(view.struct), byref(target.struct), flags, byref(found)
            )
            return result.gather(self._core.handle, forces, found, self._core.dim)

    def evaluate_tangent(
        self,
        coords: ArrayLike,
        out: Optional[np.ndarray] = None,
        add: bool = False,
        semidefinite: bool = False,
        obstacles: bool = False,
        blocks: bool = False,
        symmetric: bool = False,
    ) -> tuple[Result, Any]:
        """``evaluate`` and ``tangent`` in one, in little more than the time of ``tangent``; bit-for-bit identical to the two.

        Parameters
        ----------
        coords, out, add
            As for ``evaluate``.
        semidefinite, obstacles, blocks, symmetric
            As for ``tangent``.

        Returns
        -------
        Result
            As from ``evaluate``.
        scipy.sparse matrix or tuple
            As from ``tangent``.

        Raises
        ------
        FmcError
            As ``evaluate`` and ``tangent`` raise.

        Examples
        --------
        >>> result, matrix = contact.evaluate_tangent(coords)
        """
        view = coords_view(coords, self._core.dim)
        forces, flags = self._forces(view, out, add)
        target, found, parts = forces_view(forces, self._core.dim), fmc_result(), c_size_t()
        views = byref(view.struct), flags | _flags(semidefinite, symmetric), byref(target.struct)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_evaluate_tangent, *views, byref(found), byref(parts))
            asked = obstacles, self._core.dim, blocks, self._core.options.index_base
            matrix = tangent.matrix(self._core.handle, parts.value, *asked)
            return result.gather(self._core.handle, forces, found, self._core.dim), matrix

    def _forces(self, view: View, out: Optional[np.ndarray], add: bool) -> tuple[np.ndarray, int]:
        """The array for the forces, and the flags."""
        if out is not None:
            return out, FMC_EVALUATE_ADD if add else 0
        if add:
            raise ValueError("add is for forces that are there already: give the array as out")
        shape = self._core.unknown_count, self._core.dim
        return np.empty(shape[::-1] if view.is_columns else shape), 0

    def tangent(
        self,
        coords: ArrayLike,
        semidefinite: bool = False,
        obstacles: bool = False,
        blocks: bool = False,
        symmetric: bool = False,
    ) -> Any:
        """Tangent stiffness: minus the derivative of the forces, to be added to a stiffness matrix.

        Without friction, and with frozen friction, it is symmetric. With friction it is UNSYMMETRIC: solve with LU or GMRES. With the
        law ``"volume"`` all nodes of a pair are coupled: see ``tangent_parts`` for large pairs. The momentum correction is
        not differentiated; with the law ``"fiber"`` keep patches and switch the correction off for an exact derivative.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        semidefinite : bool
            Whether to leave out terms that can be indefinite, for use far from a solution.
        obstacles : bool
            Whether to append the translations of the obstacles, as nodes after the last, and with ``obstacles.set_rotations`` their
            rotations.
        blocks : bool
            Whether to return blocks (dim, dim).
        symmetric : bool
            Whether to return the symmetric part, with which Newton's method takes more iterations under friction.

        Returns
        -------
        scipy.sparse.csr_matrix or bsr_matrix, (n dim, n dim)
            Row and column ``node * dim + axis``. Without scipy a tuple ``(rows, cols, values)``, whose duplicates are summed.

        Raises
        ------
        UnsupportedError
            For a law or an estimator without a tangent.
        FmcError
            As ``evaluate`` raises.

        Examples
        --------
        >>> contact.tangent(coords).shape
        (16, 16)
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            part_count = self._linearise(view, semidefinite, symmetric)
            asked = obstacles, self._core.dim, blocks, self._core.options.index_base
            return tangent.matrix(self._core.handle, part_count, *asked)

    def tangent_parts(
        self, coords: ArrayLike, semidefinite: bool = False, obstacles: bool = False, symmetric: bool = False
    ) -> Tangent:
        """The tangent as sparse entries and terms of rank one, for other matrix formats and linear operators.

        Parameters
        ----------
        coords, semidefinite, obstacles, symmetric
            As for ``tangent``.

        Returns
        -------
        Tangent
            The parts.

        Raises
        ------
        FmcError
            As ``tangent`` raises.

        Examples
        --------
        >>> contact.set_options(law="volume", exponent=2.0)
        >>> parts = contact.tangent_parts(coords)
        >>> len(parts.rank_one)
        1
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            part_count = self._linearise(view, semidefinite, symmetric)
            return tangent.gather(self._core.handle, part_count, obstacles, self._core.options.index_base)

    def _linearise(self, view: View, semidefinite: bool, symmetric: bool) -> int:
        """Number of terms of rank one of the tangent, which the library then keeps."""
        parts = c_size_t()
        flags = _flags(semidefinite, symmetric)
        self._core.handle.call(library.fmc_context_tangent, byref(view.struct), flags, byref(parts))
        return parts.value

    def nodal_contact(self, coords: ArrayLike) -> NodalContact:
        """Pressure, gap, area, normal and friction at every node, for output.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.

        Returns
        -------
        NodalContact
            Arrays over the nodes.

        Raises
        ------
        FmcError
            As ``evaluate`` raises.

        Examples
        --------
        >>> contact.nodal_contact(coords).touching
        array([ True,  True,  True, False,  True, False,  True,  True])
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return nodal_contact(self._core.handle, view, self._core.node_count, self._core.dim)

    def contact_points(self, coords: ArrayLike) -> ContactPoints:
        """Points where the laws ``"depth"`` and ``"fiber"`` press, with both sides of each. The law ``"volume"`` has none.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.

        Returns
        -------
        ContactPoints
            Arrays over the points.

        Raises
        ------
        FmcError
            As ``evaluate`` raises.

        Examples
        --------
        >>> points = contact.contact_points(coords)
        >>> len(points)
        4
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return contact_points(self._core.handle, view, self._core.dim)

    def flux(
        self,
        coords: ArrayLike,
        fields: ArrayLike,
        conductance: Union[float, Conductance],
        obstacles: Optional[ArrayLike] = None,
    ) -> ContactFlux:
        """Flux of scalar fields through contact, of heat or of charge: int N h (T - T_other) dA out of every node.

        T_other is the field at the facing point of the other side. The conductance h depends on the pressure of the law. Bodies that are tied, glued
        or do not separate conduct where they are held.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        fields : array_like, (n,) or (fields, n)
            Value at every node: temperature, potential.
        conductance : float or Conductance
            h, the same wherever surfaces touch, or its tables.
        obstacles : array_like, (m,) or (fields, m), optional
            The same for every obstacle. Default: no flux into obstacles.

        Returns
        -------
        ContactFlux
            The flux, and the derivative of it by the field.

        Raises
        ------
        NotPositiveError
            For a value that is not finite, a negative conductance, or a table that does not ascend.
        NoStepError, UnsupportedError
            With friction, if no step has begun; for a mesh in parts.
        FmcError
            As ``evaluate`` raises.

        Examples
        --------
        Squares at 0 and 1 touch with an area of 0.8.

        >>> found = contact.flux(coords, [0, 0, 0, 0, 1, 1, 1, 1], 10.0)
        >>> print(f"{found.flux[4:].sum():.1f} {abs(found.flux.sum()):.1f}")
        8.0 0.0
        """
        view = coords_view(coords, self._core.dim)
        counts = self._core.unknown_count, self.obstacles.count
        with self._core.handle:
            return flux(self._core.handle, view, fields, conductance, obstacles, counts, self._core.options.index_base)

    def friction_heat(self, coords: ArrayLike, effusivities: Optional[ArrayLike] = None) -> FrictionHeat:
        """Energy that friction has dissipated since the step began, as heat at nodes and obstacles; zeros without friction.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        effusivities : array_like, (bodies + obstacles,), optional
            Square root of conductivity times density times heat capacity of every body, then of every obstacle: each side of a pair takes
            a part of the heat by it. Default: halves.

        Returns
        -------
        FrictionHeat
            The heat, whose sum is the dissipated energy of the result.

        Raises
        ------
        NotPositiveError
            For an effusivity that is negative or not finite.
        NoStepError, UnsupportedError
            With friction, if no step has begun; for a mesh in parts.
        FmcError
            As ``evaluate`` raises.

        Examples
        --------
        >>> contact.set_options(friction_coefficient=0.3)
        >>> contact.friction.begin_step(coords)
        >>> contact.friction_heat(coords).nodes.shape
        (8,)
        """
        view = coords_view(coords, self._core.dim)
        counts = self._core.unknown_count, self._core.body_count, self.obstacles.count
        with self._core.handle:
            return friction_heat(self._core.handle, view, effusivities, counts)

    def tie_nodes(self, coords: ArrayLike) -> TieNodes:
        """Traction and jump of all ties, by pair and node of the side that holds, mostly that with the larger facets.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Returns
        -------
        TieNodes
            A row for each mean of the jump that a tie holds.

        Raises
        ------
        LengthError, NonFiniteCoordinateError
            If the coordinates do not fit the mesh.
        UntiedError
            As ``pairs.tie``.

        Examples
        --------
        >>> len(contact.tie_nodes(coords))
        0
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return tie_nodes(self._core.handle, view, self._core.dim)

    def tie_constraints(self) -> TieConstraints:
        """All ties as equations of the coordinates, for a host that eliminates unknowns or uses its own multipliers.

        Returns
        -------
        TieConstraints
            ``dim`` rows for each row of ``tie_nodes``.

        Raises
        ------
        UnsupportedError
            If a tie keeps a gap.
        UntiedError
            As ``pairs.tie``.

        Examples
        --------
        >>> len(contact.tie_constraints())
        0
        """
        with self._core.handle:
            return tie_constraints(self._core.handle, self._core.options.index_base)

    def vjp(
        self,
        coords: ArrayLike,
        adjoint: Optional[ArrayLike] = None,
        energy: float = 0.0,
        by: Iterable[str] = ("coords",),
        slip_adjoint: Optional[ArrayLike] = None,
    ) -> Gradients:
        """Derivatives of ``energy * w + (adjoint * forces).sum()``, w being the contact energy: exact, each with all else held.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        adjoint : array_like, (n, dim) or (dim, n), optional
            Factors of the nodal forces, friction included. Default: zeros.
        energy : float
            Factor of the contact energy, which does not include friction.
        by : iterable of str
            Variables of the derivatives; no others are computed. ``"coords"`` · ``"reference"``, the undeformed coordinates, from which the law
            ``"depth"`` measures its depths · ``"positions"`` and ``"rotations"`` of the obstacles · ``"stiffness"``, ``"gap_offset"`` and
            ``"friction"`` (coefficient) of the pairs · ``"slip"``, the elastic slip carried into the step.
        slip_adjoint : array_like, (rows, 8), optional
            Factors of the elastic slip that ``friction.commit_step(coords)`` would carry on, in rows as ``friction.slip`` has them: a term
            more. Default: zeros.

        Returns
        -------
        Gradients
            One array, or one number for each pair, for each requested derivative.

        Raises
        ------
        ValueError
            If a name in ``by`` is unknown.
        UnsupportedError
            For a derivative that the library does not have; docs/gradients.md lists them.
        FmcError
            As ``tangent`` raises.

        Examples
        --------
        >>> gradients = contact.vjp(coords, energy=1.0, by=["coords", "stiffness"])
        >>> gradients.coords.shape == coords.shape
        True
        """
        names = names_of(by)
        dim = self._core.dim
        view = coords_view(coords, dim)
        forces = None if adjoint is None else coords_view(adjoint, dim, "adjoint")
        count = self._core.obstacle_count
        of_slip = None if slip_adjoint is None else rows_of(slip_adjoint, "slip_adjoint")
        with self._core.handle:
            return gradients(self._core.handle, view, float(energy), forces, names, count, dim, of_slip)

    def jvp(
        self,
        coords: ArrayLike,
        motion: Optional[ArrayLike] = None,
        positions: Optional[ArrayLike] = None,
        rotations: Optional[ArrayLike] = None,
        stiffness: float = 0.0,
        gap_offset: float = 0.0,
        friction: float = 0.0,
        pairs: Iterable[PairGradient] = (),
        slip: Optional[ArrayLike] = None,
    ) -> Slopes:
        """Rates of energy and forces along rates of their variables: the forward counterpart of ``vjp``.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        motion : array_like, (n, dim), optional
            Rates of the coordinates.
        positions : array_like, (m, dim), optional
            Rates of the positions of the obstacles.
        rotations : array_like, (m, 3), optional
            Rates of a rotation vector of every obstacle about its position; in 2D the last entry counts.
        stiffness, gap_offset, friction : float
            Rates of the stiffness k, the gap offset and the coefficient of friction of every pair that touches.
        pairs : iterable of PairGradient
            Such rates of single pairs, in addition. A pair without contact has no effect.
        slip : array_like, (rows, 8), optional
            Rates of the elastic slip carried into the step, in rows as ``friction.slip`` has them.

        Returns
        -------
        Slopes
            The rates; all of them are summed.

        Raises
        ------
        TypeError, ValueError
            For arrays of another shape, and for rates that are not finite.
        UnsupportedError
            As ``vjp`` with an adjoint, for all variables with a rate.
        FmcError
            As ``tangent``; for pairs and rows of slip that do not exist.

        Examples
        --------
        >>> rates = contact.jvp(coords, motion=np.ones((8, 2)))
        >>> bool(abs(rates.energy) < 1e-9)
        True
        """
        rows, obstacles, dim = self._core.unknown_count, self._core.obstacle_count, self._core.dim
        shapes = {"motion": (rows, dim), "positions": (obstacles, dim), "rotations": (obstacles, 3)}
        given = {"motion": motion, "positions": positions, "rotations": rotations}
        moved = {name: None if rate is None else np.ascontiguousarray(finite(rate, name, shapes[name])) for name, rate in given.items()}
        of_all = {"stiffness": stiffness, "gap_offset": gap_offset, "friction": friction}
        numbers = {name: float(finite(rate, name, ())) for name, rate in of_all.items()}
        carried = None if slip is None else rows_of(slip, "slip")
        rates = Rates(moved, numbers, tuple(pairs), carried)
        view = coords_view(coords, dim)
        with self._core.handle:
            return slopes(self._core.handle, view, dim, rates)

    def gap_constraints(self, coords: ArrayLike, reach: float) -> GapConstraints:
        """Weighted gaps of all nodes near a partner, apart or overlapping, with their derivative.

        Use them for an augmented Lagrangian, an interior point method or a preconditioner. They depend on no law and no estimator.
        A body has no gaps to itself.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        reach : float
            Distance of a facet from its partner (length) up to which its nodes have gaps.

        Returns
        -------
        GapConstraints
            One row for every node and partner.

        Raises
        ------
        NotPositiveError
            If the reach is not positive.
        FmcError
            As ``evaluate`` raises.

        Examples
        --------
        >>> gaps = contact.gap_constraints(coords, 0.2)
        >>> print((gaps.gap / gaps.area).round(3))
        [-0.1 -0.1 -0.1 -0.1]
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            return gap_constraints(self._core.handle, view, reach, self._core.options.index_base)

    def contact_step(
        self,
        coords: ArrayLike,
        dofs: ArrayLike,
        stiffness: ArrayLike,
        residual: ArrayLike,
        held: ArrayLike = (),
        place: Optional[Callable[[np.ndarray, np.ndarray], None]] = None,
        **options: float,
    ) -> ContactStep:
        """Equilibrium of the contact with bodies that are condensed on some degrees of freedom.

        Finds the displacement d with ``stiffness @ d + residual - forces(coords + d) = 0``. With the law ``"fiber"`` keep patches
        first. Friction takes the current pressure, or is frozen. Look at the ``state`` of the result.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        dofs : array_like of int, (m,)
            Degrees of freedom ``node * dim + axis``, ascending: those in the tangent's pattern that may move.
        stiffness : array_like, (m, m)
            Symmetric stiffness of the bodies, condensed on ``dofs``.
        residual : array_like, (m,)
            Internal minus external forces at ``coords`` without contact, condensed.
        held : array_like of int, optional
            Other degrees of freedom on which contact may act and which do not move, ascending.
        place : callable, optional
            ``place(displacement, coords)`` moves the nodes that follow, in ``coords``, (n, dim), to which the displacement of ``dofs``
            was added. You need it if bodies move by more than a part of a cell.
        **options : float
            Fields of ``fmc_contact_step_options``: ``tolerance``, relative to the forces, ``max_iterations``, ...

        Returns
        -------
        ContactStep
            Displacement, state and counts.

        Raises
        ------
        DofOutOfRangeError, RepeatedDofError, NonFiniteStiffnessError
            For degrees of freedom or a matrix that cannot be.
        SingularStiffnessError, IndefiniteStiffnessError
            For bodies and contact together.
        TypeError
            If there is no such option.
        FmcError
            As ``tangent`` raises; exceptions of ``place`` are raised unchanged.

        Examples
        --------
        >>> held = [0, 1, 3, 5, 6, 7, *range(8, 16)]
        >>> step = contact.contact_step(coords, [2, 4], np.diag([1e4, 1e4]), [0.0, 0.0], held)
        >>> step.state
        'converged'
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            arguments = dofs, stiffness, residual, held, place, options, self._core.options.index_base
            return contact_step(self._core.handle, view, self._core.dim, *arguments)

    def stable_step(self, coords: ArrayLike, masses: ArrayLike) -> float:
        """Largest time step of central differences (leapfrog) for the contact alone; up to 3 % below the limit.

        If your bodies alone allow h, both together allow s with 1/s**2 = 1/h**2 + 1/stable_step**2. The limit holds for the motion linearised at
        ``coords``, without contact that begins within a step. Obstacles are held.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        masses : array_like, (n,)
            Lumped masses of the nodes: positive where a node feels contact, infinite for nodes that are held.

        Returns
        -------
        float
            The step (time); ``inf`` without contact.

        Raises
        ------
        NotPositiveMassError
            If the mass of a node in contact is not positive. The message names the node.
        FmcError
            As ``tangent`` raises.

        Examples
        --------
        >>> print(f"{contact.stable_step(coords, np.ones(8)):.2f}")
        0.08
        """
        view, step = coords_view(coords, self._core.dim), c_double()
        lumped = vector(masses, self._core.unknown_count, "masses")
        with self._core.handle:
            self._core.handle.call(library.fmc_context_stable_step, byref(view.struct), lumped, byref(step))
        return step.value

    def stiffness_from_masses(self, coords: ArrayLike, masses: ArrayLike, limit: float) -> None:
        """Finds the stiffness of every pair for explicit dynamics, in place of the option ``stiffness``.

        Contact of whole faces makes the time step a tenth shorter than the limit of your bodies without contact.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        masses : array_like, (n,)
            Lumped masses of the nodes; infinite for nodes that are held.
        limit : float
            Largest time step of your bodies without contact in central differences (time).

        Raises
        ------
        NotPositiveError, NotPositiveMassError
            For a limit or a mass that is not positive.
        UnsupportedError
            If every surface is held, or the option ``stiffness`` is given.

        Examples
        --------
        >>> free = Contact(coords, squares, "quad")
        >>> free.stiffness_from_masses(coords, np.ones(8), 0.01)
        >>> print(f"{free.stable_step(coords, np.ones(8)):.3f}")
        0.017
        """
        view = coords_view(coords, self._core.dim)
        lumped = vector(masses, self._core.unknown_count, "masses")
        with self._core.handle:
            self._core.handle.call(
                library.fmc_context_stiffness_from_masses, byref(view.struct), lumped, c_double(limit)
            )

    def step_limit(self, coords: ArrayLike, step: ArrayLike) -> StepLimit:
        """Part of a step in which no body passes through another.

        The overlap of surfaces grows by at most half a facet, and no body moves by more than half its thickness relative to another. Use it in your
        own iteration; ``find_equilibrium`` includes it.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Current coordinates of all nodes.
        step : array_like, (n, dim) or (dim, n)
            Motion of all nodes.

        Returns
        -------
        StepLimit
            Part of the step that may be taken, and part at which the first gap closes.

        Raises
        ------
        FmcError
            As ``gap_constraints`` raises.

        Examples
        --------
        >>> contact.step_limit(coords, np.zeros((8, 2))).part
        1.0
        """
        view, way = coords_view(coords, self._core.dim), coords_view(step, self._core.dim)
        found = fmc_step_limit()
        with self._core.handle:
            self._core.handle.call(
                library.fmc_context_step_limit, byref(view.struct), byref(way.struct), byref(found)
            )
        return StepLimit(found.part, found.first_touch)

    def set_log(self, function: Optional[Callable[[str], None]]) -> None:
        """Calls a function with a sentence for every warning of an evaluation. ``Result.warnings`` has them in any case.

        Parameters
        ----------
        function : callable or None
            Takes the sentence. The evaluation raises its exceptions. ``None``: no calls.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.set_log(print)
        """
        guarded = None if function is None else self._core.handle.message_callback(function)
        callback = fmc_log_callback() if guarded is None else fmc_log_callback(guarded)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_log, callback, None)
            self._core.handle.keep("log", callback)


def _flags(semidefinite: bool, symmetric: bool) -> int:
    """Flags of the tangent."""
    return (FMC_TANGENT_SEMIDEFINITE if semidefinite else 0) | (FMC_TANGENT_SYMMETRIC if symmetric else 0)
