"""What implicit and explicit solvers ask for beside the forces: the tangent, and the time step that it allows."""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t
from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike

from . import result, tangent
from ._arrays import View, coords_view, forces_view, vector
from ._library import library
from .contact_step import ContactStep, contact_step
from ._structs import FMC_ADD, FMC_SEMIDEFINITE, FMC_SYMMETRIC, fmc_result
from .obstacles import Obstacles
from .tangent import Tangent


class Linearised(Obstacles):
    """The part of ``Contact`` that deals with the second derivative of its energy."""

    unknown_count: int

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
        the translations of the obstacles, as nodes after the last, and, with ``set_obstacle_rotations``, their rotations. For the law ``"volume"`` all nodes of a pair are
        coupled: see ``tangent_parts`` for large ones.

        With the law ``"fiber"``, ``keep_patches`` and ``momentum_correction=False`` it is the derivative of the forces; the
        momentum correction (``momentum_correction=True``), which is small, is not differentiated.

        Errors: those of ``evaluate``; ``UnsupportedError`` for a law or an estimator without tangent.
        """
        view = coords_view(coords, self.dim)
        with self._handle:
            return tangent.matrix(self._handle, self._linearise(view, semidefinite, symmetric), obstacles, self.dim, blocks)

    def tangent_parts(
        self, coords: ArrayLike, semidefinite: bool = False, obstacles: bool = False, symmetric: bool = False
    ) -> Tangent:
        """The same as separate entries and terms of rank one, for other matrix formats and as a linear operator."""
        view = coords_view(coords, self.dim)
        with self._handle:
            return tangent.gather(self._handle, self._linearise(view, semidefinite, symmetric), obstacles)

    def _linearise(self, view: View, semidefinite: bool, symmetric: bool) -> int:
        """Number of terms of rank one of the tangent, which the library then keeps."""
        parts = c_size_t()
        flags = (FMC_SEMIDEFINITE if semidefinite else 0) | (FMC_SYMMETRIC if symmetric else 0)
        self._handle.call(library.fmc_context_tangent, byref(view.struct), flags, None, byref(parts))
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
    ) -> tuple[result.Result, Any]:
        """``evaluate`` and ``tangent`` in one, with the same bits, in little more than the time of the second."""
        view = coords_view(coords, self.dim)
        forces, flags = self._forces(view, out, add)
        target, found, parts = forces_view(forces, self.dim), fmc_result(), c_size_t()
        flags |= (FMC_SEMIDEFINITE if semidefinite else 0) | (FMC_SYMMETRIC if symmetric else 0)
        views = byref(view.struct), flags, byref(target.struct)
        with self._handle:
            self._handle.call(library.fmc_context_evaluate_tangent, *views, byref(found), None, byref(parts))
            matrix = tangent.matrix(self._handle, parts.value, obstacles, self.dim, blocks)
            return result.gather(self._handle, forces, found, self.dim), matrix

    def _forces(self, view: View, out: np.ndarray | None, add: bool) -> tuple[np.ndarray, int]:
        """The array for the forces, and the flags."""
        if out is not None:
            return out, FMC_ADD if add else 0
        if add:
            raise ValueError("add is for forces that are there already: give the array as out")
        return np.empty((self.dim, self.unknown_count) if view.is_columns else (self.unknown_count, self.dim)), 0

    def set_obstacle_rotations(self, on: bool) -> None:
        """Whether tangents with ``obstacles`` have their rotations, too, after the translations, from the next one on; they
        have not at first. The rotation of obstacle o of m is node n + m + o: a rotation vector about the position of its
        pose, which moves along; in 2D its first entry is the angle, and the second has only zeros. It is the second
        derivative of the energy: the moment M about the position changes by -K dtheta + dtheta x M / 2. Not with friction
        nor with the law ``"fiber"``: the tangent then raises ``UnsupportedError``."""
        with self._handle:
            self._handle.call(library.fmc_context_set_obstacle_rotations, int(bool(on)))

    def keep_pattern(self) -> None:
        """Keeps the pattern of the tangent's entries: from the last tangent on it only grows, and places that have no
        entry any more hold zeros. As long as ``nnz`` of a matrix without terms of rank one stays the same, so does its
        pattern, and with it a symbolic factorisation. For a load step."""
        with self._handle:
            self._handle.call(library.fmc_context_keep_pattern, 1)

    def release_pattern(self) -> None:
        """Releases a kept pattern: every tangent has its own."""
        with self._handle:
            self._handle.call(library.fmc_context_keep_pattern, 0)

    def contact_step(
        self,
        coords: ArrayLike,
        freedoms: ArrayLike,
        stiffness: ArrayLike,
        residual: ArrayLike,
        held: ArrayLike = (),
        place: Callable[[np.ndarray, np.ndarray], None] | None = None,
        **options: float,
    ) -> ContactStep:
        """The displacement d of some degrees of freedom for which ``stiffness @ d + residual - forces(coords + d) = 0``: equilibrium of
        the contact with bodies that are condensed on these.

        ``freedoms``, (m,), the list: degrees of freedom ``node * dim + axis``, ascending; best those of the tangent's pattern that may
        move. ``held``: others, which do not move, on which contact may act, ascending. ``stiffness``, (m, m), symmetric, and
        ``residual``, (m,), internal less external forces at ``coords`` without contact: those of the bodies, condensed.
        ``place(displacement, coords)`` moves the nodes that follow in ``coords``, (n, dim), to which the displacement was added on the
        list; it is needed where bodies move by more than a part of a cell. ``options``: ``tolerance`` (1e-10, residual by the
        forces), ``goal`` (0, a residual, a force), ``full_below`` (0.1), ``most_iterations`` (80), ``most_trials`` (12).
        ``penetration`` (0: that of the law): the largest mean penetration of a node that is wanted, by an augmented Lagrangian
        from the law's equilibrium on, for gaps within ``reach`` (0: a twentieth of the bodies' extent) and in at most
        ``most_updates`` (20).

        With the law ``"fiber"`` after ``keep_patches``. Friction with the current pressure, or frozen. Look at the ``state``
        of what is returned. What is kept of the last evaluation stays.

        Errors: those of ``tangent``; ``FreedomOutOfRangeError``, ``RepeatedFreedomError``, ``NonFiniteStiffnessError``;
        ``SingularStiffnessError`` and ``IndefiniteStiffnessError`` for bodies and contact together; ``TypeError`` for an option that
        there is not; exceptions of ``place``."""
        view = coords_view(coords, self.dim)
        with self._handle:
            return contact_step(self._handle, view, self.dim, freedoms, stiffness, residual, held, place, options)

    def stable_step(self, coords: ArrayLike, masses: ArrayLike) -> float:
        """Largest time step of central differences (leapfrog) for the contact alone, from the tangent at ``coords``;
        up to 3 % below the limit. ``masses``, (n,), are lumped masses of the nodes: positive where a node feels contact,
        infinite for nodes that are held. Obstacles are held. ``inf`` where nothing touches.

        A solver whose own limit is h is stable with the step s, 1/s**2 = 1/h**2 + 1/stable_step**2. The limit is that of
        the motion linearised at ``coords``: contact that begins within a step is not in it.

        Errors: those of ``tangent``; ``NotPositiveMassError``, which names the node.
        """
        view, step = coords_view(coords, self.dim), c_double()
        masses = vector(masses, self.unknown_count, "masses")
        with self._handle:
            self._handle.call(library.fmc_context_stable_step, byref(view.struct), masses, byref(step))
        return step.value
