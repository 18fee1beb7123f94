"""Contact as bricks of the model: explicit right-hand sides and matrices, brought up to date before every solve."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import getfem as gf
import numpy as np
from fmc_contact import Result

from .adapter import GetfemContact
from .system import is_linear, residual_and_tangent, to_getfem


class Bricks:
    """Contact as bricks of the model, by ``add_explicit_rhs`` and ``add_explicit_matrix`` for every variable and every pair.

    One ``model.solve`` of one iteration after ``update`` is then one iteration of Newton's method, whatever else the model has. GetFEM does not call
    back, so a longer ``solve`` uses contact linearised at the last ``update``. It has the stiffness of the contact.

    Parameters
    ----------
    contact : GetfemContact
        The contact.

    Attributes
    ----------
    force : ndarray, (size,)
        Contact forces of the last ``update``.

    Examples
    --------
    >>> bricks = Bricks(contact)
    >>> while bricks.update() and bricks.relative(bricks.residual()) > 1e-9:
    ...     model.solve("max_iter", 1)
    """

    def __init__(self, contact: GetfemContact) -> None:
        self.contact, model = contact, contact.model
        self.force = np.zeros(contact.size)
        """Contact forces of the last ``update``, (size,)."""
        counts = {name: contact.interval(name)[1] for name in contact.variables}
        self._sides = {name: model.add_explicit_rhs(name, np.zeros(count)) for name, count in counts.items()}
        self._matrices = {}
        for row, rows in counts.items():
            for col, cols in counts.items():
                empty = gf.Spmat("empty", rows, cols)
                self._matrices[row, col] = model.add_explicit_matrix(row, col, empty, False, False)

    @property
    def numbers(self) -> list[int]:
        """Numbers of the bricks in the model."""
        return [int(brick) for brick in (*self._sides.values(), *self._matrices.values())]

    def update(self, semidefinite: bool = False) -> Result:
        """Linearises the contact at the state of the model.

        Parameters
        ----------
        semidefinite : bool
            Whether to leave out terms of the tangent that can be negative.

        Returns
        -------
        Result
            The contact at this state.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises. The bricks are then as they were.
        """
        contact, model = self.contact, self.contact.model
        state = model.from_variables()
        result, matrix = contact.evaluate(state), contact.tangent(state, semidefinite)
        self.force = contact.on_dofs(result.forces)
        # A matrix counts as T u in the balance of GetFEM, so that F is what stands there at u.
        side = self.force + matrix @ state
        slices = {}
        for name in contact.variables:
            first, count = contact.interval(name)
            slices[name] = slice(first, first + count)
            model.set_private_rhs(self._sides[name], side[slices[name]])
        for (row, col), brick in self._matrices.items():
            model.set_private_matrix(brick, to_getfem(matrix[slices[row], slices[col]]))
        return result

    def residual(self, linear: bool | None = None) -> np.ndarray:
        """Internal minus external forces, including contact, after ``update``.

        Parameters
        ----------
        linear : bool, optional
            Whether all bricks of the model are linear. Default: that is found out.

        Returns
        -------
        ndarray, (size,)
            The residual.
        """
        model = self.contact.model
        return residual_and_tangent(model, is_linear(model) if linear is None else linear)[0]

    def relative(self, residual: np.ndarray) -> float:
        """A residual divided by the forces of the bodies or of the contact, whichever are larger.

        Parameters
        ----------
        residual : ndarray, (size,)
            As from ``residual``.

        Returns
        -------
        float
            The ratio of the norms; 0 without forces.
        """
        size = max(np.linalg.norm(self.force), np.linalg.norm(residual + self.force))
        return float(np.linalg.norm(residual) / size) if size > 0.0 else 0.0

    @contextmanager
    def left_out(self) -> Iterator[None]:
        """The model without these bricks, as a context manager.

        Returns
        -------
        context manager
            The bricks are enabled again at its end.
        """
        self.contact.model.disable_bricks(self.numbers)
        try:
            yield
        finally:
            self.contact.model.enable_bricks(self.numbers)
