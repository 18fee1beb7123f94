"""Contact of the bodies that one or several spaces of displacements describe."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from fmc_contact import Contact, NodalContact, Result
from fmc_contact._arrays import numbers
from fmc_contact.smoothing import SmoothesSurfaces

from .in_parts import InParts, whole_because
from .linearised import Linearised
from .points import Points, at_points, points_of
from .replicated import Replicated
from .space import LayoutError, displacements
from .symmetry import tagged_faces
from .together import together
from .unknowns import Unknowns


class DolfinxContact(Linearised, SmoothesSurfaces):
    """Contact between all bodies of one space or of several, and with the obstacles that are added to ``contact``.

    On more than one rank the mesh is in parts: each rank has its own cells, and the cells of other ranks that may be in contact. If that is not
    possible, every rank has the whole mesh, and ``whole_because`` is the reason. First-order meshes with the estimator ``"fibers"`` are passed as
    their boundary, on every rank. The ranks share the work, and each takes the forces on its unknowns. Results do not depend on the number of ranks,
    and errors on one rank are raised on all. All methods are collective, and so is all that evaluates in ``contact``.

    Parameters
    ----------
    spaces : FunctionSpace or list of FunctionSpace
        Displacements, each on a separate mesh: Lagrange of order 1 or 2 (curved meshes too), or another continuous element. Examples are Lagrange of
        higher order on triangles, quadrilaterals and hexahedra, and serendipity of second order.
    stiffness : float, optional
        Stiffness of the law: pressure per length for the default law. Default 0: ``find_equilibrium`` finds one from the bodies' matrix, and
        every rank has the whole mesh. Until then an evaluation raises ``NoStiffnessError``.
    bodies : array_like of int or list of such, optional
        Body of every cell of this rank, ghosts included; one array for every space. Default: bodies are the connected components.
    whole_mesh : bool, optional
        True: every rank has all nodes and cells. False: the nodes of the boundary only, for first order and the law ``"fiber"``.
    in_parts : bool, optional
        True: the mesh is in parts, also on one rank; ``ValueError`` gives the reason if that is impossible. False: every rank has the whole mesh.
    share_work : bool
        False: every rank has the whole mesh and does all the work, so that ``contact`` may be evaluated on one rank.
    **options : OtherOptions
        As for ``fmc_contact.Contact``.

    Attributes
    ----------
    contact : Contact
        The contact below, the same on every rank, for its obstacles (``contact.obstacles.add_half_space``, ...), options and so on. If
        the mesh is in parts it is a ``PartitionedContact``, whose nodes, facets and cells are those gathered.
    whole_because : str
        Why every rank has the whole mesh, or its boundary; empty if the mesh is in parts.

    Raises
    ------
    LayoutError
        For a space of another kind or another dimension, and for two spaces on one mesh.
    FmcError
        As ``fmc_contact.Contact`` raises.

    Examples
    --------
    >>> contact = DolfinxContact(V)
    >>> find_equilibrium(ContactProblem(residual_form, u, bcs, contact)).iterations
    """

    contact: Contact
    """The contact below, the same on every rank, for its obstacles (``contact.obstacles.add_half_space``, ...), options
    and the like. With the mesh in parts a ``PartitionedContact``, whose nodes, facets and cells are those gathered."""
    whole_because: str
    """Why every rank has the whole mesh, or boundary; empty where it is in parts."""

    def __init__(
        self,
        spaces: Any,
        *,
        stiffness: float = 0.0,
        bodies: Any = None,
        whole_mesh: bool | None = None,
        in_parts: bool | None = None,
        share_work: bool = True,
        **options: Any,
    ) -> None:
        listed = list(spaces) if isinstance(spaces, (list, tuple)) else [spaces]
        if not listed:
            raise ValueError("there is no space")
        given = bodies if isinstance(bodies, (list, tuple)) else [bodies] * len(listed)
        if len(given) != len(listed):
            raise ValueError(f"bodies has {len(given)} entries, expected one for each of the {len(listed)} spaces")
        self.comm = _comm(listed[0])
        self._fields = fields = together(self.comm, lambda: displacements(listed))
        ids = together(self.comm, lambda: [None if one is None else numbers(one, "bodies") for one in given])
        self.whole_because = whole_because(fields, ids, whole_mesh, share_work)
        has_boundary = all(field.order == 1 and not field.has_faces_of_two_shapes for field in fields)
        if in_parts is None and not self.whole_because:
            if options.get("estimator") == "fibers" and has_boundary:
                self.whole_because = "with the estimator 'fibers' the boundary alone is passed, unless in_parts=True"
            elif self.comm.size == 1:
                self.whole_because = "there is one rank"
            elif not stiffness:
                self.whole_because = "find_equilibrium needs the whole mesh on every rank to find a stiffness"
        if in_parts is False:
            self.whole_because = "in_parts=False was asked for"
        if in_parts and self.whole_because:
            raise ValueError(f"the mesh cannot be in parts: {self.whole_because}")
        self._shows = self._shown(ids, whole_mesh, has_boundary, {"stiffness": stiffness, **options})
        self.contact = self._shows.contact
        if self.whole_because and share_work and self.comm.size > 1:
            # Its messages are kept apart from the host's.
            self.contact.ranks.set_communicator(self.comm.Dup())
        self.dim = self.contact.dim

    def _shown(self, bodies: list, whole_mesh: bool | None, has_boundary: bool, options: dict) -> Replicated | InParts:
        if not self.whole_because:
            return InParts(self.comm, self._fields, bodies, options)
        if whole_mesh is None:
            whole_mesh = options.get("estimator") != "fibers" or not has_boundary
        if not whole_mesh and any(field.order > 1 for field in self._fields):
            raise ValueError("the boundary alone is for first order: cells of second order are passed whole")
        return Replicated(self.comm, self._fields, bodies, whole_mesh, {**({} if whole_mesh else {"law": "fiber"}), **options})

    @property
    def space_count(self) -> int:
        """Number of spaces."""
        return len(self._fields)

    def numbering(self) -> Unknowns:
        """Numbers of the unknowns of all spaces over all ranks. Collective.

        Returns
        -------
        Unknowns
            The numbers.
        """
        return Unknowns(self.comm, self._fields)

    @property
    def received_cell_count(self) -> int:
        """Cells of other ranks that this rank has; 0 where the boundary alone is passed."""
        return self._shows.received_cell_count

    def coords(self, *displacements: Any) -> np.ndarray:
        """Coordinates to pass to ``contact``, the same on every rank.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Returns
        -------
        ndarray, (points, dim)
            If the mesh is in parts, coordinates of the nodes gathered. If unknowns of a space are no nodes: the unit vectors of the axes,
            then the displacement of every unknown, (dim + unknowns, dim).

        Raises
        ------
        ValueError
            If there is not one displacement for every space.
        """
        if len(displacements) != len(self._fields):
            raise ValueError(f"{len(displacements)} displacements for {len(self._fields)} spaces")
        owned = together(
            self.comm, lambda: [field.owned_values(u) for field, u in zip(self._fields, displacements)]
        )
        return self._shows.coords(owned)

    def set_symmetry_boundaries(self, tags: Any, *values: int) -> None:
        """Names the boundaries that lie in planes of symmetry, and replaces earlier planes. Collective.

        See ``Mesh.set_symmetry_facets``, which is told of all facets with these tags. A boundary may have several planes.

        Parameters
        ----------
        tags : MeshTags or list of such
            Tags of facets, as ``dolfinx.mesh.meshtags`` or a reader of Gmsh files returns them; one for every space, ``None`` for a space without.
        *values : int
            Tags of these boundaries. Without a value there is no plane of symmetry.

        Raises
        ------
        ValueError
            If there are not tags for every space, for tags of another mesh or of no facets, for a value that no facet has, if the boundary alone is
            passed, and as ``Mesh.set_symmetry_facets`` raises.
        UnsupportedError
            If a body would have no surface left.

        Examples
        --------
        >>> contact.set_symmetry_boundaries(facet_tags, 1, 2)
        """
        listed = list(tags) if isinstance(tags, (list, tuple)) else [tags]
        if len(listed) != len(self._fields):
            raise ValueError(f"tags of {len(listed)} spaces, and there are {len(self._fields)}")
        self._shows.name_faces(tagged_faces(self.comm, self._fields, listed, values))

    def set_symmetry_blocks(self, *blocks: Any) -> None:
        """Names the nodes that lie in planes of symmetry, and replaces earlier planes. Collective. See ``Mesh.set_symmetry_nodes``.

        In a slice one cell thick use ``set_symmetry_boundaries``: all nodes lie in the planes of the slice.

        Parameters
        ----------
        *blocks : array_like of int
            Blocks of this rank, as ``dolfinx.fem.locate_dofs_geometrical`` returns them; one array for every space.

        Raises
        ------
        ValueError
            If there is not one array for every space.
        """
        if len(blocks) != len(self._fields):
            raise ValueError(f"blocks of {len(blocks)} spaces, and there are {len(self._fields)}")
        marks = [np.zeros((field.owned, self.dim)) for field in self._fields]
        for mark, named in zip(marks, together(self.comm, lambda: [numbers(one, "blocks") for one in blocks])):
            mark[named[named < len(mark)]] = 1.0
        self._shows.name(marks)

    def evaluate(self, *displacements: Any) -> Result:
        """Result of the contact, the same on every rank; forces are those on the points of ``coords``.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Returns
        -------
        Result
            Energy, forces, resultants, pairs and warnings.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)
        result = together(self.comm, lambda: self.contact.evaluate(coords))
        return replace(result, forces=self._known(result.forces))

    def nodal_contact(self, *displacements: Any) -> NodalContact:
        """Pressure, gap, area, normal and friction on the points of ``coords``, the same on every rank.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Returns
        -------
        NodalContact
            Arrays over the points.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)
        found = together(self.comm, lambda: self.contact.nodal_contact(coords))
        return replace(found, **{name: self._known(values) for name, values in vars(found).items()})

    def _known(self, values: np.ndarray) -> np.ndarray:
        """An array over points, which knows them where others may be shown before it is used."""
        return values if self.whole_because else at_points(values, self._shows.points)

    def function(self, values: np.ndarray, name: str = "contact") -> Any:
        """An array of ``nodal_contact`` as a function for output, zero inside. Ghosts are up to date.

        Parameters
        ----------
        values : ndarray, (points,) or (points, dim)
            The array.
        name : str
            Name of the function.

        Returns
        -------
        Function or list of Function
            Scalars on the scalar space below the displacement's, vectors on the space itself; a list for several spaces.

        Raises
        ------
        LayoutError
            If the unknowns of a space are no nodes.
        """
        from dolfinx import fem

        if self._shows.frame:
            raise LayoutError("the unknowns of a space are no nodes: there is no function of it with these values at nodes")
        points = points_of(self._shows.at_nodes(values), self._shows.points)
        values = np.asarray(self._shows.at_nodes(values), float)
        is_scalar = values.ndim == 1
        rows = np.zeros((len(values), self.dim))
        rows[:, : 1 if is_scalar else self.dim] = values[:, None] if is_scalar else values
        found = []
        for field, (replica, owned) in zip(self._fields, points.owned()):
            function = fem.Function(field.space, name=name)
            replica.add_rows(function.x.array, rows.take(owned, axis=0))
            function.x.scatter_forward()
            if is_scalar:
                function = function.sub(0).collapse()
                function.name = name
            found.append(function)
        return found[0] if len(found) == 1 else found

    def begin_step(self, *displacements: Any) -> None:
        """Begins a step with friction. See ``FrictionSteps.begin_step``.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)
        together(self.comm, lambda: self.contact.friction.begin_step(coords))

    def commit_step(self, *displacements: Any) -> None:
        """Accepts the step with friction, and begins the next one at its end. See ``FrictionSteps.commit_step``.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)
        together(self.comm, lambda: self.contact.friction.commit_step(coords))

    def freeze_friction(self, *displacements: Any) -> None:
        """Freezes friction as it is at the displacements. See ``FrictionSteps.freeze``.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)
        together(self.comm, lambda: self.contact.friction.freeze(coords))

    def keep_patches(self, *displacements: Any) -> int:
        """Keeps the patches of the law ``"fiber"``, so that forces are the gradient of one energy. See ``Patches.keep``.

        Call it at the start of a load step.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Returns
        -------
        int
            Number of directions that are kept; 0 with other laws.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)
        return together(self.comm, lambda: self.contact.patches.keep(coords))

    def add_forces(self, vectors: Any, result: Result, scale: float = 1.0, bcs: Sequence[Any] = ()) -> None:
        """Adds ``scale`` times the forces of ``evaluate`` to the unknowns of this rank.

        Call it after contributions of ghosts were added up.

        Parameters
        ----------
        vectors : PETSc.Vec, ndarray, or list of such
            One for every space.
        result : Result
            As from ``evaluate``.
        scale : float
            -1 for a residual of internal minus external forces.
        bcs : sequence of DirichletBC
            Unknowns that they hold are left alone.
        """
        targets = list(vectors) if isinstance(vectors, (list, tuple)) else [vectors]
        on_points, points = self._on_points(result.forces)
        for field, (replica, owned), target in zip(self._fields, points.owned(), targets):
            mine = on_points.take(owned, axis=0)
            if scale != 1.0:
                mine *= scale
            if bcs:
                mine[self._held(field, bcs)[replica.local]] = 0.0
            replica.add_rows(target if isinstance(target, np.ndarray) else target.array, mine)

    def force(self, *displacements: Any) -> Any:
        """Contact forces on the unknowns of this rank.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.

        Returns
        -------
        ndarray, (owned unknowns,), or list of such
            One for every space.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        return self.on_unknowns(self.evaluate(*displacements).forces)

    def on_unknowns(self, forces: np.ndarray) -> Any:
        """Transfers the forces of ``evaluate`` to the unknowns of this rank.

        Parameters
        ----------
        forces : ndarray, (points, dim)
            ``Result.forces``.

        Returns
        -------
        ndarray, (owned unknowns,), or list of such
            One for every space.
        """
        found = [np.zeros(field.owned * self.dim) for field in self._fields]
        on_points, points = self._on_points(forces)
        for (replica, owned), target in zip(points.owned(), found):
            replica.add_rows(target, on_points.take(owned, axis=0))
        return found[0] if len(found) == 1 else found

    def _on_points(self, forces: np.ndarray) -> tuple[np.ndarray, Points]:
        on_points = self._shows.on_points(forces)
        return np.asarray(on_points), points_of(on_points, self._shows.points)


def _comm(space: Any) -> Any:
    mesh = getattr(space, "mesh", None)
    if mesh is None or not hasattr(mesh, "comm"):
        raise LayoutError(f"expected a function space, not a {type(space).__name__}")
    return mesh.comm
