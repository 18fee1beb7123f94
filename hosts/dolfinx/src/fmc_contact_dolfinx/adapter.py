"""Contact of the bodies that one or several spaces of displacements describe."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from fmc_contact import Contact, NodalContact, Result
from fmc_contact.skin import Skin, Triplets

from .space import Displacement, LayoutError
from .surface import Shown, boundary, whole
from .together import together
from .versions import held_dofs


class DolfinxContact:
    """Contact between all bodies of one space or of several, with the obstacles that are added to ``contact``.

    ``spaces``: a space of displacements, Lagrange of order 1 or 2 or another continuous element (Lagrange of higher order on
    triangles, quadrilaterals and hexahedra, serendipity of second order), or a list of such, each on a mesh of its own.
    ``stiffness`` and the other keywords are those of ``fmc_contact.Contact``. ``bodies``: a number for every cell of
    this rank, ghosts included, or a list of such, one for every space; default: bodies are the connected components.

    ``whole_mesh``: whether all nodes are gathered and the cells handed over, so that the forces have the bits of any
    other host, and inverted cells are reported; or, for first order, the nodes of the boundary only, which is less to
    send, with the default law ``"fiber"``: depth is that of cells. Default: the whole, but for first order with the
    estimator ``"fibers"`` the boundary. Prisms and pyramids, whose faces are of two shapes, are passed whole, and so are
    cells of second order, with all their nodes; a mesh of second order may be curved.

    The ranks share the work of the contact, and each takes the forces on what it owns; what is gathered is numbered by input
    numbers, so that nothing depends on the number of ranks. All methods are collective, and so is all that evaluates in
    ``contact``; ``share_work=False``: every rank does all, and ``contact`` may be evaluated on one. An error on one rank is raised
    on all.

    Errors: ``LayoutError`` for a space of another kind; those of ``fmc_contact.errors``.
    """

    contact: Contact
    """The contact below, the same on every rank, for its obstacles (``add_half_space``, ...), options and the like."""

    def __init__(
        self,
        spaces: Any,
        *,
        stiffness: float,
        bodies: Any = None,
        whole_mesh: bool | None = None,
        share_work: bool = True,
        **options: Any,
    ) -> None:
        listed = list(spaces) if isinstance(spaces, (list, tuple)) else [spaces]
        if not listed:
            raise ValueError("there is no space")
        given = bodies if isinstance(bodies, (list, tuple)) else [bodies] * len(listed)
        if len(given) != len(listed):
            raise ValueError(f"bodies has {len(given)} entries, one for each of the {len(listed)} spaces is wanted")
        self.comm = _comm(listed[0])
        fields = together(self.comm, lambda: [Displacement(space) for space in listed])
        has_boundary = all(field.order == 1 and not field.has_faces_of_two_shapes for field in fields)
        if whole_mesh is None:
            whole_mesh = options.get("estimator") != "fibers" or not has_boundary
        if not whole_mesh and any(field.order > 1 for field in fields):
            raise ValueError("the boundary alone is for first order: cells of second order are passed whole")
        numbers = [None if one is None else np.asarray(one, np.int64) for one in given]
        if whole_mesh:
            self._shown = [whole(field, number) for field, number in zip(fields, numbers)]
        else:
            self._shown = [boundary(field, number) for field, number in zip(fields, numbers)]
        self._first = np.cumsum([0] + [shown.replica.count for shown in self._shown])
        self._first_nodes = np.cumsum([0] + [len(shown.undeformed) for shown in self._shown])
        self._undeformed = np.concatenate([shown.undeformed for shown in self._shown])
        self._skin: Skin | None = None
        options = {"stiffness": stiffness, **({} if whole_mesh else {"law": "fiber"}), **options}
        self.contact = together(self.comm, lambda: self._made(whole_mesh, options))
        if share_work and self.comm.size > 1:
            # Its messages are kept apart from the host's.
            self.contact.set_communicator(self.comm.Dup())
        self.dim = self.contact.dim
        self._frame = 0
        if any(shown.matrix is not None for shown in self._shown):
            together(self.comm, self._set_basis)

    def _made(self, whole_mesh: bool, options: dict) -> Contact:
        bodies = [shown.body for shown in self._shown]
        ids = None if bodies[0] is None else np.concatenate(bodies)
        if whole_mesh:
            blocks = [
                (shown.displacement.cell_type, shown.cells + first)
                for shown, first in zip(self._shown, self._first_nodes)
            ]
            return Contact(self._undeformed, blocks, bodies=ids, **options)
        self._skin = Skin([shown.trace for shown in self._shown])
        return Contact.from_facets(self._skin.points(self._undeformed), self._skin.facets, bodies=ids, **options)

    def _set_basis(self) -> None:
        """Has the nodes moved by unknowns: x = X + B u. The undeformed X are held by the unit vectors of the axes, the first
        unknowns that the contact is shown."""
        from scipy.sparse import block_diag, csr_matrix, hstack, identity

        self._frame = self.dim
        parts = [identity(len(s.undeformed), format="csr") if s.matrix is None else s.matrix for s in self._shown]
        self._matrix = csr_matrix(block_diag(parts, format="csr"))
        self.contact.set_basis(csr_matrix(hstack([csr_matrix(self._undeformed), self._matrix], format="csr")))

    def coords(self, *displacements: Any) -> np.ndarray:
        """Coordinates that the contact is shown, (points, dim), the same on every rank. Where unknowns of a space are not
        nodes: the unit vectors of the axes, then displacements, of every unknown, (dim + unknowns, dim). One displacement for every
        space: a function, a PETSc vector, or an array of this rank's unknowns; ghosts are not read."""
        if len(displacements) != len(self._shown):
            raise ValueError(f"{len(displacements)} displacements for {len(self._shown)} spaces")
        owned = together(
            self.comm,
            lambda: [s.displacement.owned_values(u) for s, u in zip(self._shown, displacements)],
        )
        moved = [shown.replica.gather(values) for shown, values in zip(self._shown, owned)]
        if self._frame:
            return np.concatenate([np.eye(self._frame), *moved])
        at_nodes = self._undeformed + (moved[0] if len(moved) == 1 else np.concatenate(moved))
        return at_nodes if self._skin is None else self._skin.points(at_nodes)

    def evaluate(self, *displacements: Any) -> Result:
        """All that ``fmc_contact`` says: energy, resultants, warnings; forces on the points of ``coords``. The same on
        every rank. Errors: those of ``Contact.evaluate``, on all ranks."""
        coords = self.coords(*displacements)
        return together(self.comm, lambda: self.contact.evaluate(coords))

    def nodal_contact(self, *displacements: Any) -> NodalContact:
        """Pressure, gap, area and normal on the points of ``coords``, the same on every rank. Errors: those of
        ``Contact.evaluate``, on all ranks."""
        coords = self.coords(*displacements)
        return together(self.comm, lambda: self.contact.nodal_contact(coords))

    def function(self, values: np.ndarray, name: str = "contact") -> Any:
        """An array of ``nodal_contact`` as a function for output, zero inside; a list of such for several spaces.

        Numbers, (points,), on the scalar space below the displacement's; vectors, (points, dim), on that itself. Ghosts
        are up to date. Collective.
        """
        from dolfinx import fem

        if self._frame:
            raise LayoutError("the unknowns of a space are no nodes: there is no function of it with these values at nodes")
        values = np.asarray(values, float)
        is_scalar = values.ndim == 1
        rows = np.zeros((len(values), self.dim))
        rows[:, : 1 if is_scalar else self.dim] = values[:, None] if is_scalar else values
        on_nodes = rows if self._skin is None else self._skin.at_nodes(rows)
        found = []
        for shown, first in zip(self._shown, self._first):
            function = fem.Function(shown.displacement.space, name=name)
            shown.replica.add_rows(function.x.array, on_nodes.take(first + shown.replica.rows, axis=0))
            function.x.scatter_forward()
            if is_scalar:
                function = function.sub(0).collapse()
                function.name = name
            found.append(function)
        return found[0] if len(found) == 1 else found

    def begin_step(self, *displacements: Any) -> None:
        """Begins a step with friction. See ``Contact.begin_step``."""
        coords = self.coords(*displacements)
        together(self.comm, lambda: self.contact.begin_step(coords))

    def commit_step(self, *displacements: Any) -> None:
        """Accepts the step with friction that ends here, and begins the next. See ``Contact.commit_step``."""
        coords = self.coords(*displacements)
        together(self.comm, lambda: self.contact.commit_step(coords))

    def freeze_friction(self, *displacements: Any) -> None:
        """Freezes friction as it is at the displacements. See ``Contact.freeze_friction``."""
        coords = self.coords(*displacements)
        together(self.comm, lambda: self.contact.freeze_friction(coords))

    def keep_patches(self, *displacements: Any) -> int:
        """Keeps the directions of the law ``"fiber"``, so that forces are the gradient of one energy: for the start
        of a load step. See ``Contact.keep_patches``."""
        coords = self.coords(*displacements)
        return together(self.comm, lambda: self.contact.keep_patches(coords))

    def add_forces(self, vectors: Any, result: Result, scale: float = 1.0, bcs: Sequence[Any] = ()) -> None:
        """Adds ``scale`` times the forces of ``evaluate`` to what this rank owns of a PETSc vector or an array, or of a
        list of them, one for every space. -1 for a residual of internal less external forces.

        To be called after contributions of ghosts were added up. Unknowns that ``bcs`` hold are left alone.
        """
        targets = list(vectors) if isinstance(vectors, (list, tuple)) else [vectors]
        on_nodes = self._on_nodes(result.forces)
        for shown, first, target in zip(self._shown, self._first, targets):
            mine = on_nodes.take(first + shown.replica.rows, axis=0)
            if scale != 1.0:
                mine *= scale
            if bcs:
                mine[self._held(shown, bcs)[shown.replica.local]] = 0.0
            array = target if isinstance(target, np.ndarray) else target.array
            shown.replica.add_rows(array, mine)

    def force(self, *displacements: Any) -> Any:
        """Contact forces on what this rank owns, (owned unknowns,); a list of such for several spaces."""
        return self.on_unknowns(self.evaluate(*displacements).forces)

    def on_unknowns(self, forces: np.ndarray) -> Any:
        """Forces of ``evaluate`` on what this rank owns, (owned unknowns,); a list of such for several spaces."""
        found = [np.zeros(shown.displacement.owned * self.dim) for shown in self._shown]
        on_nodes = self._on_nodes(forces)
        for shown, first, target in zip(self._shown, self._first, found):
            shown.replica.add_rows(target, on_nodes.take(first + shown.replica.rows, axis=0))
        return found[0] if len(found) == 1 else found

    def _on_nodes(self, forces: np.ndarray) -> np.ndarray:
        if self._frame:
            return forces[self._frame :]
        return forces if self._skin is None else self._skin.to_nodes(forces)

    def _held(self, shown: Shown, bcs: Sequence[Any]) -> np.ndarray:
        """Whether an unknown that this rank owns is held, (owned, dim)."""
        count = shown.displacement.owned * self.dim
        held = np.zeros(count, bool)
        for bc in bcs:
            if _holds_part_of(shown.displacement.space, bc.function_space):
                dofs = held_dofs(bc)
                held[dofs[dofs < count]] = True
        return held.reshape(-1, self.dim)

    def tangent(self, *displacements: Any, semidefinite: bool = False, symmetric: bool = False) -> Triplets:
        """Minus the derivative of the forces, the same on every rank: row and column ``node * dim + axis``, nodes of
        the spaces one after another as they are gathered. UNSYMMETRIC with friction: solve with LU or GMRES, not with
        Cholesky or conjugate gradients, or ask for ``symmetric``, which takes more iterations."""
        coords = self.coords(*displacements)

        def parts() -> Any:
            return self.contact.tangent_parts(coords, semidefinite, symmetric=symmetric).triplets()

        found = together(self.comm, parts)
        if self._frame:
            held, (rows, cols, values) = self._frame * self.dim, found
            free = (rows >= held) & (cols >= held)
            return Triplets(rows[free] - held, cols[free] - held, values[free])
        tangent = Triplets(*found)
        return tangent if self._skin is None else self._skin.tangent_to_nodes(tangent, self.dim)

    def unknowns(self) -> np.ndarray:
        """The unknown, over all ranks, of every row of ``tangent``; that of its own space."""
        numbers = [shown.replica.blocks[:, None] * self.dim + np.arange(self.dim) for shown in self._shown]
        return np.concatenate([of_space.ravel() for of_space in numbers])

    def add_tangent(self, matrix: Any, tangent: Triplets, bcs: Sequence[Any] = (), scale: float = 1.0) -> None:
        """Adds ``tangent`` to what this rank owns of an assembled PETSc matrix, and assembles it again; for several
        spaces a square list of lists of matrices. Contact couples unknowns that no cell does, so the matrix takes
        entries at new places. Rows and columns of unknowns that ``bcs`` hold are left alone."""
        from petsc4py import PETSc

        blocks = matrix if isinstance(matrix, (list, tuple)) else [[matrix]]
        use, space_of, unknown = self._own_entries(tangent, bcs)
        rows, cols, values = tangent.rows[use], tangent.cols[use], scale * tangent.values[use]
        for i, line in enumerate(blocks):
            for j, block in enumerate(line):
                here = (space_of[rows] == i) & (space_of[cols] == j)
                _add(PETSc, block, unknown[rows[here]], unknown[cols[here]], values[here])

    def touched(self, tangent: Triplets, bcs: Sequence[Any] = ()) -> np.ndarray:
        """Unknowns of one space that this rank owns and that feel contact, as PETSc numbers them over all ranks, ascending: the
        rows of ``tangent`` but for those that ``bcs`` hold. Collective."""
        use, _, unknown = self._own_entries(tangent, bcs)
        return np.unique(unknown[tangent.rows[use]])

    def _own_entries(self, tangent: Triplets, bcs: Sequence[Any]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Which entries stand in rows that this rank owns and nothing holds; the space, and the number in it, of every row."""
        held = np.concatenate([s.replica.gather(self._held(s, bcs).astype(float)) for s in self._shown]).ravel() > 0
        space_of = np.repeat(np.arange(len(self._shown)), np.diff(self._first) * self.dim)
        unknown = self.unknowns()
        mine = np.zeros(len(held), bool)
        for shown, first in zip(self._shown, self._first):
            mine.reshape(-1, self.dim)[first + shown.replica.rows] = True
        return mine[tangent.rows] & ~held[tangent.rows] & ~held[tangent.cols], space_of, unknown


def _add(petsc: Any, matrix: Any, rows: np.ndarray, cols: np.ndarray, values: np.ndarray) -> None:
    """Adds entries, row by row; collective."""
    matrix.setOption(petsc.Mat.Option.NEW_NONZERO_ALLOCATION_ERR, False)
    matrix.setOption(petsc.Mat.Option.NEW_NONZERO_LOCATIONS, True)
    order = np.argsort(rows, kind="stable")
    rows, cols, values = rows[order], cols[order].astype(petsc.IntType), values[order]
    distinct, start = np.unique(rows, return_index=True)
    ends = np.append(start, len(rows)).astype(petsc.IntType)
    if len(distinct):
        matrix.setValuesIJV(ends, cols, values, addv=petsc.InsertMode.ADD, rowmap=distinct.astype(petsc.IntType))
    matrix.assemble()


def _comm(space: Any) -> Any:
    mesh = getattr(space, "mesh", None)
    if mesh is None or not hasattr(mesh, "comm"):
        raise LayoutError(f"a function space is wanted, this is a {type(space).__name__}")
    return mesh.comm


def _holds_part_of(space: Any, other: Any) -> bool:
    """Whether ``other`` is ``space``, or a component of it; wrappers do not count."""
    space, other = (getattr(one, "_cpp_object", one) for one in (space, other))
    return space is other or space == other or bool(space.contains(other))
