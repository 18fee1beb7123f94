"""Bodies whose matrix Python does not have."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Optional

import numpy as np

from ..ranks import Communicator


class Refused(Exception):
    """A request of a search cannot be answered: raised by the bodies, with the reason.

    A function that is given to ``find_equilibrium`` raises it for a state that its bodies cannot have, such as one with an inverted cell. The
    search then makes a shorter step. Any other exception ends the search and reaches the caller, except errors of this package, which count as
    refusals too.

    Examples
    --------
    >>> from fmc_contact.search import Refused
    >>> raise Refused("cell 7 is inverted")
    Traceback (most recent call last):
    ...
    fmc_contact.search.host.Refused: cell 7 is inverted
    """


class Host(ABC):
    """Bodies for a search, in place of ``residual_and_tangent``, whose matrix is distributed over ranks, or never assembled.

    Vectors are of all unknowns, (size,). On several ranks each makes the same search, and returns bit-for-bit identical results. A method raises
    ``Refused``, with the reason, if it has no answer.
    """

    factorisations = 0
    """Matrices factorised, if they are counted."""
    comm: Optional[Communicator] = None
    """Of the ranks that make the same search. What a method raises on one of them ends the search on all, but for ``Refused``."""

    @abstractmethod
    def forces(self, x: np.ndarray, matrix: bool) -> tuple[np.ndarray, Optional[float]]:
        """Internal less external forces without contact, and an energy or ``None``. With ``matrix`` the search requests their derivative
        next."""

    @abstractmethod
    def product(self, vector: np.ndarray, magnitudes: bool) -> np.ndarray:
        """The matrix, or the matrix of its magnitudes, times a vector."""

    @abstractmethod
    def diagonal(self) -> np.ndarray:
        """Its diagonal."""

    @abstractmethod
    def solve(self, x: np.ndarray, flags: int, shift: float, right: np.ndarray) -> np.ndarray:
        """Solution, zero where unknowns are held, of the matrix, ``shift`` times its diagonal, and the contact's tangent at ``x`` with the
        keywords ``TANGENTS[flags]``."""
