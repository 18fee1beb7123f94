"""The tangent of a contact on the unknowns of the spaces, and its entries in the rows of this rank."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from fmc_contact import Contact
from fmc_contact.skin import Triplets

from .entries import add_entries
from .in_parts import InParts
from .replicated import Replicated
from .space import Displacement
from .together import together
from .versions import held_dofs


class Linearised:
    """The derivative of a contact's forces, in matrices of PETSc."""

    comm: Any
    dim: int
    contact: Contact
    _fields: list[Displacement]
    _shows: Replicated | InParts

    def tangent(self, *displacements: Any, semidefinite: bool = False, symmetric: bool = False) -> Triplets:
        """Tangent stiffness: minus the derivative of the forces, the same on every rank.

        With friction it is UNSYMMETRIC: solve with LU or GMRES, not with Cholesky or conjugate gradients.

        Parameters
        ----------
        *displacements
            One for every space: a function, a PETSc vector, or an array of this rank's unknowns. Ghosts are not read.
        semidefinite : bool
            Whether to leave out terms that can be negative, for use far from a solution.
        symmetric : bool
            Whether to return the symmetric part, with which Newton's method takes more iterations under friction.

        Returns
        -------
        Triplets
            Rows, columns and values. Row and column are ``node * dim + axis``, with the nodes of the spaces one after another as gathered.

        Raises
        ------
        UnsupportedError
            For a law or an estimator without a tangent.
        FmcError
            As ``Contact.evaluate`` raises, on all ranks.
        """
        coords = self.coords(*displacements)  # type: ignore[attr-defined]

        def parts() -> Any:
            return self.contact.tangent_parts(coords, semidefinite, symmetric=symmetric).triplets()

        return self._shows.between_points(Triplets(*together(self.comm, parts)))

    def unknowns(self) -> np.ndarray:
        """The unknown of every row of the last ``tangent``, over all ranks, in its own space.

        Returns
        -------
        ndarray of int
            Numbers of the unknowns.
        """
        return self._shows.points.unknowns(self.dim)

    def spaces(self) -> np.ndarray:
        """The space of every row of the last ``tangent``.

        Returns
        -------
        ndarray of int
            Its place among the spaces.
        """
        return self._shows.points.spaces(self.dim)

    def add_tangent(self, matrix: Any, tangent: Triplets, bcs: Sequence[Any] = (), scale: float = 1.0) -> None:
        """Adds a tangent to this rank's rows of an assembled PETSc matrix, and assembles it again.

        Contact couples unknowns that no cell couples, so the matrix takes entries at new places.

        Parameters
        ----------
        matrix : PETSc.Mat, or list of lists of such
            A square array of blocks for several spaces.
        tangent : Triplets
            As from ``tangent``.
        bcs : sequence of DirichletBC
            Rows and columns of unknowns that they hold are left alone.
        scale : float
            Factor.
        """
        from petsc4py import PETSc

        blocks = matrix if isinstance(matrix, (list, tuple)) else [[matrix]]
        (rows, cols, values), space_of, unknown = self._own_entries(tangent, bcs)
        for i, line in enumerate(blocks):
            for j, block in enumerate(line):
                here = (space_of[rows] == i) & (space_of[cols] == j)
                add_entries(PETSc, block, unknown[rows[here]], unknown[cols[here]], scale * values[here])

    def touched(self, tangent: Triplets, bcs: Sequence[Any] = ()) -> np.ndarray:
        """Unknowns of one space that this rank owns and that feel contact.

        Parameters
        ----------
        tangent : Triplets
            As from ``tangent``.
        bcs : sequence of DirichletBC
            Unknowns that they hold are left out.

        Returns
        -------
        ndarray of int
            As PETSc numbers them over all ranks, ascending.
        """
        entries, _, unknown = self._own_entries(tangent, bcs)
        return np.unique(unknown[entries.rows])

    def _own_entries(self, tangent: Triplets, bcs: Sequence[Any]) -> tuple[Triplets, np.ndarray, np.ndarray]:
        """Entries that stand in rows that this rank owns and nothing holds; the space, and the number in it, of every row."""
        # Others may be shown since the tangent was made.
        points = getattr(tangent.rows, "points", None) or self._shows.points
        rows, cols, values = map(np.asarray, tangent)
        held = points.gather([self._held(field, bcs).astype(float) for field in self._fields]).ravel() > 0
        mine = np.repeat(points.is_owned(), self.dim)
        use = mine[rows] & ~held[rows] & ~held[cols]
        return Triplets(rows[use], cols[use], values[use]), points.spaces(self.dim), points.unknowns(self.dim)

    def held(self, bcs: Sequence[Any]) -> list[np.ndarray]:
        """Which unknowns of this rank boundary conditions hold.

        Parameters
        ----------
        bcs : sequence of DirichletBC
            Boundary conditions of all spaces.

        Returns
        -------
        list of ndarray of bool, (owned blocks, dim)
            One for every space.
        """
        return [self._held(field, bcs) for field in self._fields]

    def _held(self, field: Displacement, bcs: Sequence[Any]) -> np.ndarray:
        """Whether an unknown that this rank owns is held, (owned, dim)."""
        count = field.owned * self.dim
        held = np.zeros(count, bool)
        for bc in bcs:
            if holds_part_of(field.space, bc.function_space):
                dofs = held_dofs(bc)
                held[dofs[dofs < count]] = True
        return held.reshape(-1, self.dim)


def holds_part_of(space: Any, other: Any) -> bool:
    """Whether ``other`` is ``space``, or a component of it; wrappers do not count."""
    space, other = (getattr(one, "_cpp_object", one) for one in (space, other))
    return space is other or space == other or bool(space.contains(other))
