"""Interfaces that follow your own law: its input points, its output, and a check by differences."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref, c_size_t
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import coords_view, floats, of_memory, shape_error, written
from ._core import Core
from ._handle import guarded
from ._index import integer
from ._library import check, library
from ._own_laws import history_count, sentences, with_fields
from ._structs import fmc_law_point, fmc_law_points, fmc_law_response, fmc_own_law, fmc_respond


@dataclass(frozen=True, eq=False)
class LawPoints:
    """All n points of a pair at which your own law is asked.

    Attributes
    ----------
    jump : ndarray, (n, dim)
        Opening beyond the initial gap, along the normal of the second body (length), negative in compression. Then the slip of the first body along
        the axes in the plane of the facet of the second.
    history : ndarray, (n, h)
        Numbers that the points carry, after the last committed step. 0 at first.
    time_step : float
        Duration of the step, from ``contact.cohesive.set_time_step``. 0: not set.
    position, reference : ndarray, (n, dim)
        Where the points are on the first body, now and undeformed.
    axes : ndarray, (n, dim, dim)
        Normal and tangential axes, by rows. In 2D the axis is the normal turned by +90°. In 3D the first axis is the x axis projected into the
        undeformed facet (the z axis, where the normal is within 0.1° of x), which moves along with the facet. The second is normal × first.
    area : ndarray, (n,)
        Tributary areas of the points, undeformed.
    bodies : tuple of int
        The pair, the lower one first.
    fields : ndarray, (n, 2, m)
        Values of ``contact.laws.set_fields``, at the point of the first body and at the point of the second.

    Examples
    --------
    >>> def springs(points):
    ...     return 100.0 * points.jump, np.broadcast_to(100.0 * np.eye(2), points.axes.shape)
    """

    jump: np.ndarray
    history: np.ndarray
    time_step: float
    position: np.ndarray
    reference: np.ndarray
    axes: np.ndarray
    area: np.ndarray
    bodies: tuple[int, int]
    fields: np.ndarray

    def __len__(self) -> int:
        return len(self.area)


@dataclass(frozen=True, eq=False)
class LawResponse:
    """Output of your own law at n points. A tuple of the first two or three does as well.

    Attributes
    ----------
    traction : array_like, (n, dim)
        Force by undeformed area along the axes, positive where it resists a positive jump.
    tangent : array_like, (n, dim, dim)
        ``tangent[p, i, j]`` is the derivative of ``traction[p, i]`` by ``jump[p, j]``, with history and time step held. It need not be
        symmetric.
    history : array_like, (n, h), optional
        The history as it would be after a step that ends here. Default: as it was.
    stored, dissipated : array_like, (n,), optional
        Energies per area that unloading would give back, and that have been dissipated since the beginning. Only reported energies depend on them.
        Default: 0.

    Examples
    --------
    >>> from fmc_contact import LawResponse
    >>> LawResponse(np.zeros((1, 2)), np.zeros((1, 2, 2))).stored is None
    True
    """

    traction: ArrayLike
    tangent: ArrayLike
    history: Optional[ArrayLike] = None
    stored: Optional[ArrayLike] = None
    dissipated: Optional[ArrayLike] = None


InterfaceLaw = Callable[[LawPoints], Union[LawResponse, tuple[ArrayLike, ...]]]
"""Your own law: of all points of a pair at once."""


def _asked(law: InterfaceLaw) -> Callable[..., None]:
    """The function that the library calls: the law with arrays."""

    def respond(_user: object, points: int, response: int) -> None:
        given, to = fmc_law_points.from_address(points), fmc_law_response.from_address(response)
        n, dim, h = given.count, given.dim, given.history_count
        vectors, squares, kept = (n, dim), (n, dim, dim), (n, h)
        # Copies: the law may keep what it is given, and the memory goes back after the call.
        asked = LawPoints(
            jump=of_memory(given.jump, vectors).copy(),
            history=of_memory(given.history, kept).copy(),
            time_step=given.time_step,
            position=of_memory(given.position, vectors).copy(),
            reference=of_memory(given.reference, vectors).copy(),
            axes=of_memory(given.axes, squares).copy(),
            area=of_memory(given.area, (n,)).copy(),
            bodies=(given.body, given.partner),
            fields=of_memory(given.fields, (n, 2, given.field_count)).copy(),
        )
        found = law(asked)
        if not isinstance(found, LawResponse):
            if not isinstance(found, tuple) or len(found) not in (2, 3):
                expected = "(traction, tangent), (traction, tangent, history) or a LawResponse"
                raise TypeError(f"a law returned a {type(found).__name__}, expected {expected}")
            found = LawResponse(*found)
        of_memory(to.traction, vectors)[...] = floats(found.traction, "traction", vectors)
        of_memory(to.tangent, squares)[...] = floats(found.tangent, "tangent", squares)
        if found.history is not None:
            of_memory(to.history, kept)[...] = floats(found.history, "history", kept)
        if found.stored is not None:
            of_memory(to.stored, (n,))[...] = floats(found.stored, "stored", (n,))
        if found.dissipated is not None:
            of_memory(to.dissipated, (n,))[...] = floats(found.dissipated, "dissipated", (n,))

    return respond


def law_struct(law: InterfaceLaw, history: int, guard: Callable[..., Callable[..., int]]) -> tuple[fmc_own_law, Any]:
    """A law for the library, and the objects that must outlive it."""
    count = history_count(history, "point")
    if not callable(law):
        raise TypeError(f"law is {law!r}, expected a function of the points")
    struct, callback = fmc_own_law(), fmc_respond(guard(_asked(law)))
    check(library.fmc_own_law_init(byref(struct)))
    struct.history_count, struct.respond = count, callback
    return struct, callback


def check_law(
    law: InterfaceLaw,
    dim: int,
    scale: float,
    *,
    history: int = 0,
    jump: Optional[ArrayLike] = None,
    time_step: float = 0.0,
    fields: Optional[ArrayLike] = None,
) -> list[str]:
    """Sentences on your own law: whether the same question has the same answer, and whether its tangent is the derivative of its traction.

    Differences have steps of 1e-6 of ``scale``, and must agree to 1e-6 of the largest entry. Corners of a law, as where damage begins, are
    recognised. The history is 0, and then the result of other jumps. A sentence about a fault begins with a word and ``WRONG``.

    Parameters
    ----------
    law : callable
        The law, as for ``pairs.set``.
    dim : int
        2 or 3.
    scale : float
        A jump over which the tractions change (length), such as the opening at which damage begins.
    history : int
        Number of values that a point keeps.
    jump : array_like, (m, dim), optional
        Jumps at which to check. Default: 60 that are spread over −scale/4 … scale along the normal and −scale … scale across it.
    time_step : float
        Duration of the step. 0: not set.
    fields : array_like, (m,), optional
        Values of fields, the same on both sides of every point, for a law that looks at them.

    Returns
    -------
    list of str
        A sentence for everything that was looked at.

    Raises
    ------
    InterfaceLawError
        If the law returns a number that is not finite.
    DimensionError, NotPositiveError, LengthError
        For impossible values. Exceptions of the law are reraised unchanged.

    Examples
    --------
    >>> from fmc_contact import check_law
    >>> def springs(points):
    ...     return 100.0 * points.jump, np.broadcast_to(100.0 * np.eye(2), points.axes.shape)
    >>> check_law(springs, 2, 0.1)[2]
    'symmetry: the tangent is symmetric'
    """
    raised: list[BaseException] = []
    struct, _alive = law_struct(with_fields(law, fields), history, lambda function: guarded(function, raised))
    each = integer(dim)
    if each is None:
        raise TypeError(f"dim is {dim!r}, expected 2 or 3")
    jumps = np.empty((0, each)) if jump is None else np.ascontiguousarray(floats(jump, "jump"))
    if jumps.ndim != 2 or jumps.shape[1] != each:
        raise shape_error("jump", jumps.shape, f"(jumps, {each})")
    given = (byref(struct), each, float(scale), jumps if jumps.size else None, len(jumps), float(time_step))
    return sentences(lambda tell: library.fmc_own_law_check(*given, tell, None), raised)


@dataclass(frozen=True, eq=False)
class LawStates:
    """The points of all interfaces by your own laws, m rows, by pair of bodies.

    Attributes
    ----------
    bodies : ndarray of int, (m, 2)
        The pair in ``Result.bodies``, the lower one first.
    position : ndarray, (m, dim)
        Where the point is, on the first body.
    area : ndarray, (m,)
        Its tributary area, undeformed.
    axes : ndarray, (m, dim, dim)
        Normal of the second body and axes in its plane, by rows.
    jump : ndarray, (m, dim)
        Opening and sliding along these (length).
    traction : ndarray, (m, dim)
        Traction along these (force per area): positive along the normal in tension.
    stored, dissipated : ndarray, (m,)
        Energies per area, as the law returned them.

    Examples
    --------
    >>> contact.laws.points(coords).jump.shape
    (0, 2)
    """

    bodies: np.ndarray
    position: np.ndarray
    area: np.ndarray
    axes: np.ndarray
    jump: np.ndarray
    traction: np.ndarray
    stored: np.ndarray
    dissipated: np.ndarray

    def __len__(self) -> int:
        return len(self.area)


class InterfaceLaws:
    """Interfaces that follow your own laws, as ``pairs.set(a, b, interface="law", law=...)`` makes them.

    Examples
    --------
    >>> len(contact.laws.points(coords))
    0
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def points(self, coords: ArrayLike) -> LawStates:
        """All points of interfaces by your own laws at ``coords``, by pair.

        Parameters
        ----------
        coords : array_like, (n, dim) or (dim, n)
            Coordinates of all nodes.

        Returns
        -------
        LawStates
            A row for each point, in the order of ``history``.

        Raises
        ------
        LengthError, NonFiniteCoordinateError
            If the coordinates do not fit the mesh.
        InterfaceLawError
            If a law returns a number that is not finite.
        UntiedError
            If other reference coordinates leave no face of an interface.

        Examples
        --------
        >>> len(contact.laws.points(coords))
        0
        """
        view, dim = coords_view(coords, self._core.dim), self._core.dim
        with self._core.handle:
            found = self._core.handle.rows(fmc_law_point, library.fmc_context_law_points, byref(view.struct))
        row = written(found, fmc_law_point)
        return LawStates(
            bodies=np.column_stack([row["body"], row["partner"]]),
            position=row["position"][:, :dim].copy(),
            area=row["area"].copy(),
            axes=row["axes"].reshape(-1, 3, 3)[:, :dim, :dim].copy(),
            jump=row["jump"][:, :dim].copy(),
            traction=row["traction"][:, :dim].copy(),
            stored=row["stored"].copy(),
            dissipated=row["dissipated"].copy(),
        )

    def set_fields(self, values: Optional[ArrayLike]) -> None:
        """Sets fields that your own laws are asked with at their points, such as a temperature. They stay until others are set.

        Parameters
        ----------
        values : array_like, (n,) or (n, m), or None
            One or m numbers for every node. None: no fields.

        Raises
        ------
        LengthError
            If there is another number of nodes.
        NotPositiveError
            If a number is not finite. The fields stay as they were.

        Examples
        --------
        >>> contact.laws.set_fields(np.full(8, 293.15))
        >>> contact.laws.set_fields(None)
        """
        given = np.empty((0, 0)) if values is None else np.ascontiguousarray(floats(values, "values"))
        given = given[:, None] if given.ndim == 1 else given
        if given.ndim != 2:
            raise shape_error("values", given.shape, "(nodes,) or (nodes, fields)")
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_law_fields, given, len(given), given.shape[1])

    @property
    def history(self) -> np.ndarray:
        """History of all points after the committed steps, in the order of ``points``, one point after the other.

        A restart needs it and the coordinates.

        Raises
        ------
        LengthError
            If there are more or fewer numbers.
        NotPositiveError
            If a number is not finite. The history is then unchanged.
        UntiedError
            As ``points``.

        Examples
        --------
        >>> contact.laws.history.shape
        (0,)
        >>> contact.laws.history = []
        """
        count = c_size_t()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_law_history, None, 0, byref(count))
            found = np.empty(count.value)
            self._core.handle.call(library.fmc_context_law_history, found, found.size, None)
        return found

    @history.setter
    def history(self, history: ArrayLike) -> None:
        values = np.ascontiguousarray(floats(history, "history")).ravel()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_law_history, values, values.size)
