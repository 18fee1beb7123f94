"""The system of all spaces: residual and matrix in the numbering of all unknowns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import dolfinx.fem.petsc as fpetsc
import numpy as np
from petsc4py import PETSc
from scipy.sparse import csr_matrix, vstack

from .adapter import DolfinxContact
from .linearised import holds_part_of
from .together import together
from .versions import create_vector, vector_of


class System:
    """Of bodies without contact, a form for every space. All methods are collective."""

    def __init__(
        self, us: Sequence[Any], residuals: Sequence[Any], jacobians: Sequence[Any], bcs: Sequence[Any], contact: DolfinxContact
    ) -> None:
        self.us, self.residuals, self.jacobians, self.bcs, self.contact = us, residuals, jacobians, bcs, contact
        self.unknowns = contact.numbering()
        self._matrices = [fpetsc.create_matrix(one) for one in jacobians]

    def by_space(self, x: np.ndarray) -> list[np.ndarray]:
        """Unknowns that this rank owns, one array for every space."""
        return self.unknowns.by_space(x[self.unknowns.own])

    def _of(self, space: Any) -> list[Any]:
        return [bc for bc in self.bcs if holds_part_of(space, bc.function_space)]

    def start(self) -> np.ndarray:
        """The displacements now: all unknowns, (size,)."""
        return self._gathered([vector_of(u).array for u in self.us])

    def prescribed(self) -> np.ndarray:
        """The same, moved by the boundary conditions."""
        found = []
        for u in self.us:
            moved = vector_of(u).copy()
            fpetsc.set_bc(moved, self._of(u.function_space))
            found.append(moved.array.copy())
            moved.destroy()
        return self._gathered(found)

    def held(self) -> np.ndarray:
        """Whether an unknown is held, (size,)."""
        return self._gathered([one.ravel() for one in self.contact.held(self.bcs)])

    def _gathered(self, owned: Sequence[np.ndarray]) -> np.ndarray:
        return self.unknowns.gather(np.concatenate(owned))

    def take(self, x: np.ndarray) -> None:
        """Puts all unknowns, (size,), into the displacements."""
        for u, values in zip(self.us, self.by_space(x)):
            u.x.array[: values.size] = values
            u.x.scatter_forward()

    def forces(self) -> np.ndarray:
        """The residual at the displacements, at all unknowns, those that are held too, (size,)."""
        return self._gathered([self._residual(u, form) for u, form in zip(self.us, self.residuals)])

    def _residual(self, u: Any, form: Any) -> np.ndarray:
        vector = create_vector(form, u.function_space)
        with vector.localForm() as local:
            local.set(0.0)
        together(self.contact.comm, lambda: fpetsc.assemble_vector(vector, form))
        vector.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
        found = vector.array.copy()
        vector.destroy()
        return found

    def stiffness(self) -> csr_matrix:
        """Its derivative: rows of the unknowns of this rank, (count, size)."""
        blocks = []
        for space, (form, matrix) in enumerate(zip(self.jacobians, self._matrices)):
            matrix.zeroEntries()
            fpetsc.assemble_matrix(matrix, form)
            matrix.assemble()
            starts, columns, values = matrix.getValuesCSR()
            columns = self.unknowns.numbers(space, columns.astype(np.int64))
            blocks.append(csr_matrix((values, columns, starts), (len(starts) - 1, self.unknowns.size)))
        found = blocks[0] if len(blocks) == 1 else vstack(blocks, format="csr")
        found.sort_indices()
        return found
