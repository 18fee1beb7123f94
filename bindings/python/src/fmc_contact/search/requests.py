"""A search of the library for an equilibrium, and the answers to its requests."""

from __future__ import annotations

import weakref
from ctypes import addressof, byref, c_double, create_string_buffer
from typing import Any, Optional

import numpy as np

from .._arrays import numbers
from .._constants import FMC_EQUILIBRIUM_REQUEST_KIND, FMC_EQUILIBRIUM_WAY
from .._library import check, library
from .._structs import (
    fmc_equilibrium,
    fmc_equilibrium_answer,
    fmc_equilibrium_options,
    fmc_equilibrium_problem,
    fmc_equilibrium_request,
    fmc_equilibrium_result,
)
from .bodies import CondensedSteps
from .host import Host, Refused
from .together import together
from .unknowns import Moved


def _free(pointer: fmc_equilibrium) -> None:
    library.fmc_equilibrium_free(byref(pointer))


def _copied(address: int, count: int) -> np.ndarray:
    """A copy of numbers of the library."""
    found = np.zeros(count)
    if count:
        # By value: an array of ctypes has a type of its own, which mpi4py does not know.
        found[:] = np.ctypeslib.as_array((c_double * count).from_address(address))
    return found


class Search:
    """A load step under way."""

    def __init__(
        self,
        bodies: Host,
        unknowns: Moved,
        x: np.ndarray,
        solved_for: np.ndarray,
        prescribed: Optional[np.ndarray],
        options: dict[str, Any],
        steps: Optional[CondensedSteps],
    ) -> None:
        self.bodies, self.unknowns, self.solved_for, self.steps, self.size = bodies, unknowns, solved_for, steps, unknowns.size
        self.handle = unknowns.inner._core.handle
        self.refusal = ""
        """Why the host has refused a state, the last time."""
        base = np.ascontiguousarray(unknowns.coords(np.zeros(self.size)), np.float64)
        first = unknowns.inner.options["index_base"]
        of_coordinate = numbers(unknowns.of_coordinate, "of_coordinate", None, self.handle.index)
        of_coordinate = np.where(of_coordinate < 0, of_coordinate, of_coordinate + first).astype(self.handle.index)
        free = np.zeros(self.size, np.uint8)
        free[solved_for] = 1
        start = np.ascontiguousarray(x.ravel(), np.float64)
        problem = fmc_equilibrium_problem()
        check(library.fmc_equilibrium_problem_init(byref(problem)))
        problem.unknown_count, problem.row_count = self.size, len(base)
        problem.unknown_of_coordinate = of_coordinate.ctypes.data
        problem.base, problem.free, problem.x = base.ctypes.data, free.ctypes.data, start.ctypes.data
        if prescribed is not None:
            problem.prescribed = prescribed.ctypes.data
        asked = fmc_equilibrium_options()
        check(library.fmc_equilibrium_options_init(byref(asked)))
        for name, value in options.items():
            setattr(asked, name, value)
        asked.condensed = 0 if steps is None else 2 if steps.is_wanted else 1
        self.pointer = fmc_equilibrium()
        self.handle.call(library.fmc_equilibrium_new, byref(problem), byref(asked), byref(self.pointer))
        weakref.finalize(self, _free, self.pointer).atexit = False

    def run(self) -> None:
        """Answers until the search has ended. If the host ends it by an error, the contact is restored."""
        try:
            self._answer()
        except BaseException:
            library.fmc_equilibrium_abandon(self.handle.pointer, self.pointer)
            raise

    def _answer(self) -> None:
        request, answer = fmc_equilibrium_request(), None
        while True:
            together(self.bodies.comm, lambda: self.handle.call(library.fmc_equilibrium_next, self.pointer, answer, byref(request)))
            kind = FMC_EQUILIBRIUM_REQUEST_KIND[request.kind]
            if kind in ("found", "refused"):
                return
            answer, _arrays = self._answered(kind, request)

    def _answered(self, kind: str, request: fmc_equilibrium_request) -> tuple[Any, Any]:
        """The answer to a request, and the arrays that it points to."""
        answer = fmc_equilibrium_answer()
        check(library.fmc_equilibrium_answer_init(byref(answer)))
        try:
            vector, energy, is_definite = together(self.bodies.comm, lambda: self._asked(kind, request))
        except Refused as refused:
            if kind == "forces":
                self.refusal = str(refused)
            why = create_string_buffer(str(refused).encode())
            answer.refusal = addressof(why)
            return byref(answer), (answer, why)
        vector = np.ascontiguousarray(vector, np.float64)
        held = c_double(0.0 if energy is None else energy)
        answer.vector, answer.definite = vector.ctypes.data, int(is_definite)
        if energy is not None:
            answer.energy = addressof(held)
        return byref(answer), (answer, vector, held)

    def _asked(self, kind: str, request: fmc_equilibrium_request) -> tuple[np.ndarray, Optional[float], bool]:
        """The requested vector, an energy, and whether bodies were found to be supported without contact. Errors: ``Refused``."""
        bodies = self.bodies
        if kind == "forces":
            return (*bodies.forces(self._array(request.x), bool(request.matrix)), False)
        if kind == "product":
            return bodies.product(self._array(request.vector), bool(request.magnitudes)), None, False
        if kind == "diagonal":
            return bodies.diagonal(), None, False
        if kind == "solve":
            right = self._array(request.vector)
            return bodies.solve(self._array(request.x), request.tangent_flags, request.shift, right), None, False
        assert self.steps is not None
        x, moved, forces = (self._array(one) for one in (request.x, request.vector, request.forces))
        step, is_definite = self.steps.step(x, moved, forces, request.tolerance, request.absolute_tolerance)
        return step, None, is_definite

    def _array(self, address: int) -> np.ndarray:
        return _copied(address, self.size)

    def ended(self) -> tuple[fmc_equilibrium_result, str, list[str]]:
        """Its result, the way to it, and its texts."""
        result = fmc_equilibrium_result()
        check(library.fmc_equilibrium_found(self.pointer, byref(result)))
        texts = [library.fmc_equilibrium_text(self.pointer, number).decode() for number in range(result.text_count)]
        return result, FMC_EQUILIBRIUM_WAY[result.way], texts

    def array_of(self, address: int, count: int) -> np.ndarray:
        """A copy of an array of the result."""
        return _copied(address, count)
