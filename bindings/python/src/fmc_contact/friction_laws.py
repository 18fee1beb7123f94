"""Friction by your own law: its input facets, its output, and a check by differences."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref, c_size_t
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats, of_memory
from ._constants import FMC_PARTNER
from ._handle import guarded
from ._index import integer
from ._library import check, library
from ._own_laws import history_count, sentences, with_fields
from ._structs import fmc_friction_facets, fmc_friction_law, fmc_friction_response, fmc_limit_friction


@dataclass(frozen=True, eq=False)
class FrictionFacets:
    """All n facets of a pair for which the library calls your law of friction: the facets under pressure, of both sides.

    Attributes
    ----------
    pressure : ndarray, (n,)
        Mean pressures over the area in contact, positive.
    slip : ndarray, (n, dim - 1)
        Slip of the first partner against the second since the step began, along the axes, including its elastic part (length).
    trial : ndarray, (n, dim - 1)
        The trial elastic slip, as if no facet slid in the step (length). Where its length times ``stiffness`` is beyond the limit, the facet
        slides by the rest.
    stiffness : float
        Stiffness of the stick, a pressure per length. 0: friction without memory.
    time_step : float
        Duration of the step, from ``contact.cohesive.set_time_step``. 0: not set.
    history : ndarray, (n, h)
        Numbers that the facets carry, as the last step that was committed left them. 0 at the first touch.
    fields : ndarray, (n, 2, m)
        Means over the facet of what ``contact.laws.set_fields`` gave, on the side of the first partner and of the second. NaN on an obstacle.
    axes : ndarray, (n, dim - 1, dim)
        Tangential axes of the slip, by rows. In 2D the normal, out of the first partner, turned by +90°. In 3D the first axis is the x axis projected
        into the facet (the z axis, where the normal is within 6° of x). The second is normal × first. They do not turn along with the material.
    position : ndarray, (n, dim)
        Where the tractions act.
    area : ndarray, (n,)
        Tributary areas of the facets. Where two bodies meet, each side has half of the area in contact.
    facet : ndarray of int, (n,)
        Places of the facets in ``contact.mesh.boundary_facets``.
    partners : tuple
        The pair, as ``Pair.a`` and ``Pair.b`` name it.

    Examples
    --------
    >>> def capped(facets, mu=0.3, most=2.0):
    ...     limit = np.minimum(mu * facets.pressure, most)
    ...     return limit, np.where(limit < most, mu, 0.0)
    """

    pressure: np.ndarray
    slip: np.ndarray
    trial: np.ndarray
    stiffness: float
    time_step: float
    history: np.ndarray
    fields: np.ndarray
    axes: np.ndarray
    position: np.ndarray
    area: np.ndarray
    facet: np.ndarray
    partners: tuple[tuple[str, int], tuple[str, int]]

    def __len__(self) -> int:
        return len(self.area)


@dataclass(frozen=True, eq=False)
class FrictionResponse:
    """Output of your own law of friction at n facets. A tuple of the first two, three or four is accepted too.

    Attributes
    ----------
    limit : array_like, (n,)
        Tractions at which the facets slide, force per area, at least 0.
    by_pressure : array_like, (n,)
        Their derivatives by the pressure, with slip, history and time step held.
    by_slip : array_like, (n, dim - 1), optional
        Their derivatives by ``slip``, with ``trial`` going along with it. Default: 0.
    history : array_like, (n, h), optional
        The history as it would be after a step that ends here. Default: as it was.

    Examples
    --------
    >>> from fmc_contact import FrictionResponse
    >>> FrictionResponse(np.ones(3), np.zeros(3)).by_slip is None
    True
    """

    limit: ArrayLike
    by_pressure: ArrayLike
    by_slip: Optional[ArrayLike] = None
    history: Optional[ArrayLike] = None


FrictionLaw = Callable[[FrictionFacets], Union[FrictionResponse, tuple[Optional[ArrayLike], ...]]]
"""Your own law of friction: of all facets of a pair at once."""


def _asked(law: FrictionLaw) -> Callable[..., None]:
    """The function that the library calls: the law with arrays."""

    def respond(_user: object, facets: int, response: int) -> None:
        given, to = fmc_friction_facets.from_address(facets), fmc_friction_response.from_address(response)
        n, across, kept = given.count, (given.count, given.dim - 1), (given.count, given.history_count)
        # Copies: the law may keep what it is given, and the memory goes back after the call.
        asked = FrictionFacets(
            pressure=of_memory(given.pressure, (n,)).copy(),
            slip=of_memory(given.slip, across).copy(),
            trial=of_memory(given.trial, across).copy(),
            stiffness=given.stiffness,
            time_step=given.time_step,
            history=of_memory(given.history, kept).copy(),
            fields=of_memory(given.fields, (n, 2, given.field_count)).copy(),
            axes=of_memory(given.axes, (*across, given.dim)).copy(),
            position=of_memory(given.position, (n, given.dim)).copy(),
            area=of_memory(given.area, (n,)).copy(),
            facet=of_memory(given.facet, (n,), c_size_t).astype(np.int64),
            partners=(("body", given.body), (FMC_PARTNER[given.partner_kind], given.partner)),
        )
        found = law(asked)
        if not isinstance(found, FrictionResponse):
            if not isinstance(found, tuple) or len(found) not in (2, 3, 4):
                expected = "(limit, by_pressure), with by_slip and history after them, or a FrictionResponse"
                raise TypeError(f"a law of friction returned a {type(found).__name__}, expected {expected}")
            found = FrictionResponse(*found)  # type: ignore[arg-type]
        of_memory(to.limit, (n,))[...] = floats(found.limit, "limit", (n,))
        of_memory(to.by_pressure, (n,))[...] = floats(found.by_pressure, "by_pressure", (n,))
        if found.by_slip is not None:
            of_memory(to.by_slip, across)[...] = floats(found.by_slip, "by_slip", across)
        if found.history is not None:
            of_memory(to.history, kept)[...] = floats(found.history, "history", kept)

    return respond


def friction_law_struct(law: FrictionLaw, history: int, guard: Callable[..., Callable[..., int]]) -> tuple[fmc_friction_law, Any]:
    """A law for the library, and the objects that must outlive it."""
    count = history_count(history, "facet")
    if not callable(law):
        raise TypeError(f"friction_law is {law!r}, expected a function of the facets")
    struct, callback = fmc_friction_law(), fmc_limit_friction(guard(_asked(law)))
    check(library.fmc_friction_law_init(byref(struct)))
    struct.history_count, struct.limit = count, callback
    return struct, callback


def check_friction_law(
    law: FrictionLaw, dim: int, pressure: float, slip: float, *, history: int = 0, time_step: float = 0.0, fields: Optional[ArrayLike] = None
) -> list[str]:
    """Checks your own law of friction, and returns a sentence for each check: whether the same input has the same answer, and whether its derivatives
    match its limit.

    It calls the law at 60 pressures and slips. Differences have steps of 1e-6 of ``pressure`` and ``slip``, and must agree to 1e-6 of the limit.
    Corners of a law are recognised. The history is 0, and then the result of other facets. A sentence about a fault begins with a word and ``WRONG``.

    Parameters
    ----------
    law : callable
        The law, as for ``pairs.set``.
    dim : int
        2 or 3.
    pressure : float
        The largest pressure to ask at.
    slip : float
        The largest slip of a step to ask at, along every axis (length).
    history : int
        Number of values that a facet keeps.
    time_step : float
        Duration of the step. 0: not set.
    fields : array_like, (m,), optional
        Values of fields, the same on both sides of every facet, for a law that looks at them.

    Returns
    -------
    list of str
        A sentence for everything that was looked at.

    Raises
    ------
    InterfaceLawError
        If the law returns an invalid limit.
    DimensionError, NotPositiveError
        For impossible values. Exceptions of the law are reraised unchanged.

    Examples
    --------
    >>> from fmc_contact import check_friction_law
    >>> check_friction_law(lambda facets: (0.3 * facets.pressure, np.full(len(facets), 0.3)), 2, 1.0, 1.0)[0]
    'answers: the same input has the same answer, facet by facet'
    """
    raised: list[BaseException] = []
    struct, _alive = friction_law_struct(with_fields(law, fields), history, lambda function: guarded(function, raised))
    each = integer(dim)
    if each is None or each < 0:
        raise TypeError(f"dim is {dim!r}, expected 2 or 3")
    given = (byref(struct), each, float(pressure), float(slip), float(time_step))
    return sentences(lambda tell: library.fmc_friction_law_check(*given, tell, None), raised)
