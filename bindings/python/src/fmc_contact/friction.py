"""Steps with friction: what is carried from one to the next."""

from __future__ import annotations

from ctypes import byref

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view
from ._core import Core
from ._library import library


class FrictionSteps:
    """Friction of a contact, which counts slip from the start of a step.

    With friction ``begin_step`` comes before the first evaluation, and ``commit_step`` after every step that is accepted,
    with the coordinates that were accepted, never within an iteration. A step may be tried as often as one likes: nothing
    has to be undone.

    Errors: those of ``Contact.evaluate``; ``NoStepError`` before ``begin_step``. Nothing has changed then.
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def begin_step(self, coords: ArrayLike) -> None:
        """Begins a step at ``coords``, with the obstacles where they are. Elastic slip carried so far stays; there is
        none at first. With friction, what touches here is measured: a facet that touches later counts its slip from then
        on. Errors are then those of ``evaluate``."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_begin_step, byref(view.struct))

    def commit_step(self, coords: ArrayLike) -> None:
        """Accepts the step that ends at ``coords``, and begins the next one there."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_commit_step, byref(view.struct))

    def freeze(self, coords: ArrayLike) -> None:
        """Freezes the facets on which friction acts and their pressure as they are at ``coords``, until the step ends or
        ``release``: friction is then the gradient of a convex potential, and its tangent symmetric and positive
        semidefinite. Repeated at what was found until nothing changes, this leads to the solution with the current
        pressure."""
        view = coords_view(coords, self._core.dim)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_freeze_friction, byref(view.struct))

    def release(self) -> None:
        """Takes the pressure of the coordinates at hand again."""
        with self._core.handle:
            self._core.handle.call(library.fmc_context_freeze_friction, None)

    @property
    def slip(self) -> np.ndarray:
        """The elastic slip carried into the step, (facets, dim): that of every facet against what it faces, in
        the order of ``Mesh.boundary_facets``. With the
        coordinates and poses at which the step began it is all that a restart needs: ``begin_step`` there, then set it."""
        found = np.empty((self._core.facet_count, self._core.dim))
        with self._core.handle:
            self._core.handle.call(library.fmc_context_slip, found, found.size)
        return found

    @slip.setter
    def slip(self, slip: ArrayLike) -> None:
        values = np.ascontiguousarray(slip, dtype=np.float64)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_slip, values, values.size)
