"""Derivatives of a history of steps with friction: from the last step back to the first, with few states kept."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ..contact import Contact
from ..errors import UnsupportedError
from ..gradients import names_of
from .history_step import BY, Begun, Handed, StepAdjoint, back_through, refuse
from .outcome import Equilibrium
from .start import count as counted
from .unknowns import Moved

Solve = Callable[[int, np.ndarray], Equilibrium]
"""Takes the number of a step and the unknowns at its start; moves obstacles, and returns what ``find_equilibrium`` finds."""

Seed = Callable[[int, Equilibrium], Optional[tuple[Optional[ArrayLike], Optional[ArrayLike]]]]
"""Takes a step and its equilibrium, and returns ∂J/∂x and ∂J/∂F there; ``None`` for zeros."""


@dataclass(frozen=True, eq=False)
class HistoryStart:
    """Derivatives by how a history began, after all of its steps have been gone back through.

    Attributes
    ----------
    coords : ndarray, (n, dim)
        By the coordinates at which the first step began, where slip is counted from.
    positions : ndarray, (m, dim)
        By the positions of the obstacles then; zeros unless requested.
    rotations : ndarray, (m, 3)
        By rotation vectors of the obstacles then; zeros unless requested.
    slip : ndarray, (rows, 8)
        By the elastic slip that was carried into the first step, in rows as ``Gradients.slip`` has them.

    Examples
    --------
    >>> from fmc_contact import HistoryStart
    >>> HistoryStart.__name__
    'HistoryStart'
    """

    coords: np.ndarray
    positions: np.ndarray
    rotations: np.ndarray
    slip: np.ndarray


class History:
    """A history of load steps with friction, and the derivatives of a number J of all its states.

    Every step begins at the end of the last one, with its elastic slip. Backwards, each step passes its derivatives by both to the step before. Few
    states are kept; other states are recomputed by solving steps once more, with bit-for-bit identical results.

    Parameters
    ----------
    contact : Contact or adapter
        As ``find_equilibrium`` takes it, with friction, a stiffness and no multipliers.
    solve : callable
        ``solve(step, x)`` moves obstacles, and returns ``find_equilibrium`` of the step, counted from 0, from the unknowns ``x``. It has
        to depend on both alone, and does not commit the step.
    count : int
        Number of steps.
    states : int
        Most states to keep at once: unknowns, coordinates, poses and slip of each. With the fewest, 3, the work grows with the square of
        the number of steps.

    Attributes
    ----------
    kept : int
        Most states that were kept at once.
    solved : int
        Number of solved steps, repetitions included.
    start : HistoryStart or None
        Derivatives by how the history began, once ``backward`` is through.

    Examples
    --------
    >>> from fmc_contact import History, find_equilibrium
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> contact.set_options(friction_coefficient=0.3)
    >>> history = History(contact, lambda step, x: find_equilibrium(bodies, contact, x, range(16)), 3)
    >>> ends = [found.x for step, found in history.forward(coords)]
    >>> back = list(history.backward(lambda step, found: (np.ones((8, 2)), None) if step == 2 else None))
    >>> [one.step for one in back], history.kept <= 20
    ([2, 1, 0], True)
    """

    def __init__(self, contact: Any, solve: Solve, count: int, states: int = 20) -> None:
        self.contact: Contact = contact if isinstance(contact, Contact) else contact.contact
        self.solve, self.count, self.states = solve, counted("count", count, 1), counted("states", states, 3)
        self.kept, self.solved = 0, 0
        self.start: Optional[HistoryStart] = None
        self._given = contact
        self._alive: dict[int, Begun] = {}
        self._unknowns: Optional[Moved] = None

    def forward(self, x: ArrayLike) -> Iterator[tuple[int, Equilibrium]]:
        """Begins a step at unknowns ``x`` and goes through all steps. Each is committed once you ask for the next.

        Parameters
        ----------
        x : array_like
            Unknowns at the start, as ``find_equilibrium`` takes them. Slip that has been carried so far stays.

        Returns
        -------
        iterator of (int, Equilibrium)
            Number of the step, from 0, and its equilibrium.

        Raises
        ------
        UnsupportedError
            For a contact with multipliers, and for cells of second order.
        FmcError
            As ``find_equilibrium`` raises.

        Examples
        --------
        >>> from fmc_contact import History, find_equilibrium
        >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
        >>> contact.set_options(friction_coefficient=0.3)
        >>> history = History(contact, lambda step, x: find_equilibrium(bodies, contact, x, range(16)), 3)
        >>> len([found.result for step, found in history.forward(coords)])
        3
        """
        self.start, self.kept, self.solved, self._alive = None, 0, 0, {}
        begin = np.array(x, np.float64)
        self._unknowns = Moved(self._given, begin.size)
        coords = np.array(self._unknowns.coords(begin.ravel()))
        self.contact.friction.begin_step(coords)
        here = Begun.here(self.contact, begin, coords)
        wanted = {0, *self._cuts(0, self.count)}
        for step in range(self.count):
            if step in wanted:
                self._keep(step, here)
            found = self._found(step, here)
            yield step, found
            here = self._committed(found)
        self._keep(self.count, here)

    def backward(self, seed: Seed, by: Iterable[str] = ()) -> Iterator[StepAdjoint]:
        """Runs backwards from the last step to the first. The contact is then as ``forward`` has left it.

        Parameters
        ----------
        seed : callable
            ``seed(step, found)`` returns ∂J/∂x, in the shape of ``x``, and ∂J/∂F of the contact's nodal forces, (n, dim), each of them
            ``None`` for zeros; or ``None`` for both.
        by : iterable of str
            ``"positions"``, ``"rotations"``, ``"stiffness"``, ``"friction"``: parameters of the contact to differentiate by.

        Returns
        -------
        iterator of StepAdjoint
            The derivatives of J by the parameters of each step. For a parameter of all steps add them up.

        Raises
        ------
        ValueError
            Before ``forward`` is through, and for other names.
        UnsupportedError
            For derivatives that are not known; docs/gradients.md lists them.

        Examples
        --------
        >>> from fmc_contact import History, find_equilibrium
        >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
        >>> contact.set_options(friction_coefficient=0.3)
        >>> history = History(contact, lambda step, x: find_equilibrium(bodies, contact, x, range(16)), 2)
        >>> J = sum(found.x[0, 0] for step, found in history.forward(coords))
        >>> by_first = np.zeros((8, 2))
        >>> by_first[0, 0] = 1
        >>> back = history.backward(lambda step, found: (by_first, None), by=["friction"])
        >>> float(sum(pair.friction for one in back for pair in one.gradients.pairs))
        0.0
        """
        names = names_of(by)
        if other := [name for name in names if name not in BY]:
            raise ValueError(f"a history has no derivative by '{other[0]}', expected {', '.join(BY)}")
        if self.count not in self._alive:
            raise ValueError("the history has no end yet: go through all of forward first")
        refuse(self.contact)
        last, later = self._alive[self.count], Handed.nothing(self.contact)
        self.start = None
        try:
            for step, begun in self._back(0, self.count, self._alive[0]):
                found = self._again(step, begun)
                one, later = back_through(step, begun, found, later, seed(step, found) or (None, None), names)
                yield one
        finally:
            last.put_back(self.contact)
        self.start = HistoryStart(later.coords, later.positions, later.rotations, later.slip)

    def _cuts(self, first: int, end: int) -> list[int]:
        """Steps whose starts are kept between two: all, or so many as make parts of the size of their number. One state is in hand, and
        one is the end."""
        spare = self.states - len(self._alive) - (1 if self.count in self._alive else 3)
        between = end - first - 1
        most = between if between <= spare else math.isqrt(between)
        parts = min(most, max(spare, 0)) + 1
        return [first + round((end - first) * part / parts) for part in range(1, parts)]

    def _back(self, first: int, end: int, begun: Begun) -> Iterator[tuple[int, Begun]]:
        """The steps of a part from its last one, each with how it began."""
        if end - first == 1:
            yield first, begun
            return
        known = [step for step in range(first + 1, end) if step in self._alive]
        cuts = known or self._cuts(first, end)
        here, at = begun, first
        for cut in [] if known else cuts:
            here = self._forth(at, cut, here)
            self._keep(cut, here)
            at = cut
        if not cuts:
            # No room: from the start of the part to every step of it.
            for step in reversed(range(first, end)):
                yield step, self._forth(first, step, begun)
            return
        for low, high in reversed(list(zip([first, *cuts], [*cuts, end]))):
            yield from self._back(low, high, begun if low == first else self._alive[low])
            if low != first:
                del self._alive[low]

    def _keep(self, step: int, begun: Begun) -> None:
        self._alive[step] = begun
        self.kept = max(self.kept, len(self._alive) + 1)

    def _forth(self, first: int, end: int, begun: Begun) -> Begun:
        """How step ``end`` began, from how another did."""
        for step in range(first, end):
            begun = self._committed(self._again(step, begun))
        return begun

    def _again(self, step: int, begun: Begun) -> Equilibrium:
        begun.put_back(self.contact)
        return self._found(step, begun)

    def _found(self, step: int, begun: Begun) -> Equilibrium:
        self.solved += 1
        found = self.solve(step, begun.x.copy())
        refuse(self.contact)
        if found.first_touches:
            what = "derivatives of a history in which bodies close a gap and rub in one step"
            raise UnsupportedError(f"{what}, step {step}: end a step where they touch, or solve with straight_slip=True")
        return found

    def _committed(self, found: Equilibrium) -> Begun:
        assert self._unknowns is not None
        coords = np.array(self._unknowns.coords(found.x.ravel()))
        self.contact.friction.commit_step(coords)
        return Begun.here(self.contact, found.x, coords)
