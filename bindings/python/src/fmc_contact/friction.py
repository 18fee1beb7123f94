"""Steps with friction, and the state that they carry."""

from __future__ import annotations

from ctypes import byref, c_size_t

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, floats, shape_error
from ._core import Core
from ._library import library
from .errors import LengthError

# Numbers in a row of the slip.
WIDTH = 8


def rows_of(slip: ArrayLike, name: str) -> np.ndarray:
    """Rows of a slip. Errors: ``LengthError``."""
    values = np.ascontiguousarray(floats(slip, name))
    if values.ndim != 2 or values.shape[1] != WIDTH:
        raise LengthError(str(shape_error(name, values.shape, f"(rows, {WIDTH})")))
    return values


class FrictionSteps:
    """Steps with friction, which count slip from their start.

    Call ``begin_step`` before the first evaluation with friction. Call ``commit_step`` after every step that is accepted, with the accepted
    coordinates, and never within an iteration. You may repeat a step any number of times: nothing has to be undone.

    Examples
    --------
    >>> contact.set_options(friction_coefficient=0.3)
    >>> contact.friction.begin_step(coords)
    >>> result = contact.evaluate(coords + 0.001)
    >>> contact.friction.commit_step(coords + 0.001)
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def begin_step(self, coords: ArrayLike) -> None:
        """Begins a step, with the obstacles where they are.

        Accumulated elastic slip is kept; there is none at first. A facet that touches later counts its slip from then on.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes at the start of the step.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises. The contact is then unchanged.

        Examples
        --------
        >>> contact.friction.begin_step(coords)
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_begin_step, byref(view.struct))

    def commit_step(self, coords: ArrayLike) -> None:
        """Accepts the step, and begins the next one at its end.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes at the end of the step.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises. The contact is then unchanged.

        Examples
        --------
        >>> contact.friction.begin_step(coords)
        >>> contact.friction.commit_step(coords + 0.001)
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_commit_step, byref(view.struct))

    def freeze(self, coords: ArrayLike) -> None:
        """Freezes the facets on which friction acts, and their pressure, until the step ends or ``release`` is called.

        Frozen friction is the gradient of a convex potential. Its tangent is symmetric and positive semidefinite. If you freeze,
        solve, and freeze again until nothing changes, you get the solution with the current pressure.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Raises
        ------
        NoStepError
            If no step has begun.
        FmcError
            As ``Contact.evaluate`` raises.

        Examples
        --------
        >>> contact.set_options(friction_coefficient=0.3)
        >>> contact.friction.begin_step(coords)
        >>> contact.friction.freeze(coords)
        """
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_freeze_friction, byref(view.struct))

    def release(self) -> None:
        """Takes the pressure of the current coordinates again.

        Raises
        ------
        BusyError
            If the contact is in use by another call.

        Examples
        --------
        >>> contact.friction.release()
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_freeze_friction, None)

    @property
    def slip(self) -> np.ndarray:
        """Elastic slip carried into the step: a row for each facet and each body or obstacle that it faced, (rows, 8).

        The first column is the facet, by its place in ``contact.mesh.boundary_facets()``. Then follow 0 if it faces a body, 1 if an obstacle;
        the index of this partner; 1 if the facet's body is the second of the pair, else 0. The last four are three of the slip (length), in 2D
        the last 0; and the slip since it rested, with ``static_coefficient``, else 0. A restart needs it, and the coordinates and poses at which
        the step began: call ``begin_step`` there, then set the slip.

        Raises
        ------
        NoStepError
            If no step has begun.
        LengthError
            If the shape is not (rows, 8).
        IndexOutOfRangeError
            If a row names a facet, a body or an obstacle that does not exist, occurs twice, or is invalid.
        NonFiniteSlipError
            If an entry of the slip is not finite. The slip is then unchanged.

        Examples
        --------
        >>> contact.friction.begin_step(coords)
        >>> contact.friction.slip.shape
        (0, 8)
        >>> contact.friction.slip = np.zeros((0, 8))
        """
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_slip, None, 0, byref(count))
            found = np.empty((count.value // WIDTH, WIDTH))
            self._core.handle.call(library.fmc_context_slip, found, found.size, None)
        return found

    @slip.setter
    def slip(self, slip: ArrayLike) -> None:
        values = rows_of(slip, "slip")
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_slip, values, values.size)

    @property
    def history(self) -> np.ndarray:
        """History of your own laws of friction after the committed steps.

        For each row of ``slip``, in its order, there are as many numbers as the law of the pair has; none without a law. Set it for a restart
        after ``slip``, with the rows that it belongs to.

        Raises
        ------
        NoStepError
            Before ``begin_step``.
        LengthError
            If there are more or fewer numbers.
        NotPositiveError
            If a number is not finite. The history is then unchanged.

        Examples
        --------
        >>> contact.friction.begin_step(coords)
        >>> contact.friction.history.shape
        (0,)
        >>> contact.friction.history = []
        """
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_friction_history, None, 0, byref(count))
            found = np.empty(count.value)
            self._core.handle.call(library.fmc_context_friction_history, found, found.size, None)
        return found

    @history.setter
    def history(self, history: ArrayLike) -> None:
        values = np.ascontiguousarray(floats(history, "history")).ravel()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_friction_history, values, values.size)
