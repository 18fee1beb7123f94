"""A contact of a host that numbers its unknowns in its own way."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats
from ._index import integer
from .contact import Contact
from .result import Result


class OnUnknowns:
    """A contact of a host that numbers its unknowns in its own way: by components, by equations, or without those that it holds.

    ``find_equilibrium`` and ``check_host`` then take displacements, residual and matrix as the host has them; no permutation is needed.

    Parameters
    ----------
    contact : Contact
        The contact of the host's nodes.
    coords : array_like, (n, dim)
        Coordinates of the nodes where all unknowns are zero: the undeformed ones.
    unknowns : array_like of int, (n, dim)
        Number of the unknown that moves each coordinate, from 0. -1: none does, the coordinate stays.
    size : int, optional
        Length of the host's vectors. Default: as far as the numbers reach.

    Raises
    ------
    ValueError
        For another shape, no integers, or a number that is below -1, not below the size, or given twice: an unknown moves one coordinate.

    Examples
    --------
    A host that has all displacements along x before those along y:

    >>> from fmc_contact import OnUnknowns, find_equilibrium
    >>> on_host = OnUnknowns(contact, coords, np.arange(16).reshape(2, 8).T)
    >>> springs = 1e4 * np.eye(16)
    >>> find_equilibrium(lambda u: (springs @ u, springs), on_host, np.zeros(16), range(16)).x.shape
    (16,)
    """

    contact: Contact
    """The contact below, for its obstacles, options, pairs and so on."""
    size: int
    """Length of the host's vectors."""

    def __init__(self, contact: Contact, coords: ArrayLike, unknowns: ArrayLike, size: Optional[int] = None) -> None:
        shape = contact.unknown_count, contact.dim
        self.contact, self._undeformed = contact, floats(coords, "coords", shape).astype(np.float64)
        numbers = np.asarray(unknowns)
        if numbers.dtype.kind not in "iu":
            raise ValueError(f"unknowns have the type {numbers.dtype}, expected integers")
        if numbers.shape != shape:
            raise ValueError(f"unknowns have the shape {numbers.shape}, expected {shape}")
        self._of_freedom = numbers.astype(np.int64).ravel()
        (self._moved,) = np.nonzero(self._of_freedom >= 0)
        self._unknowns = self._of_freedom[self._moved]
        reach = int(self._of_freedom.max(initial=-1)) + 1
        found = reach if size is None else integer(size)
        if found is None:
            raise ValueError(f"the size is {size!r}, expected an integer")
        self.size = found
        self._refuse(np.flatnonzero(self._of_freedom < -1), "is below -1")
        self._refuse(np.flatnonzero(self._of_freedom >= self.size), f"is not below the size, {self.size}")
        order = np.argsort(self._unknowns, kind="stable")
        twice = self._moved[order[1:][np.diff(self._unknowns[order]) == 0]]
        self._refuse(np.sort(twice), "moves another coordinate too")

    def _refuse(self, places: np.ndarray, why: str) -> None:
        if places.size:
            node, axis = divmod(int(places[0]), self.contact.dim)
            raise ValueError(f"unknowns[{node}, {axis}] is {self._of_freedom[places[0]]}, which {why}")

    def coords(self, u: ArrayLike) -> np.ndarray:
        """Coordinates of the nodes.

        Parameters
        ----------
        u : array_like, (size,)
            Displacements, in the host's order.

        Returns
        -------
        ndarray, (n, dim)
            The coordinates.

        Raises
        ------
        ValueError
            If the displacements have another shape.

        Examples
        --------
        >>> from fmc_contact import OnUnknowns
        >>> OnUnknowns(contact, coords, np.arange(16).reshape(8, 2)).coords(np.zeros(16)).shape
        (8, 2)
        """
        found = self._undeformed.copy()
        found.flat[self._moved] += floats(u, "u", (self.size,))[self._unknowns]
        return found

    def evaluate(self, u: ArrayLike) -> Result:
        """Result of the contact at a displacement; its forces are those on the nodes.

        Parameters
        ----------
        u : array_like, (size,)
            Displacements, in the host's order.

        Returns
        -------
        Result
            Energy, forces, resultants, pairs and warnings.

        Raises
        ------
        FmcError
            As ``Contact.evaluate`` raises.

        Examples
        --------
        >>> from fmc_contact import OnUnknowns
        >>> OnUnknowns(contact, coords, np.arange(16).reshape(8, 2)).evaluate(np.zeros(16)).forces.shape
        (8, 2)
        """
        return self.contact.evaluate(self.coords(u))

    def on_dofs(self, forces: ArrayLike) -> np.ndarray:
        """Brings forces on the nodes into the host's order.

        Parameters
        ----------
        forces : array_like, (n, dim)
            ``Result.forces``.

        Returns
        -------
        ndarray, (size,)
            The forces: a load, to be subtracted from a residual.

        Raises
        ------
        ValueError
            If the forces have another shape.

        Examples
        --------
        >>> from fmc_contact import OnUnknowns
        >>> on_host = OnUnknowns(contact, coords, np.arange(16).reshape(8, 2))
        >>> on_host.on_dofs(on_host.evaluate(np.zeros(16)).forces).shape
        (16,)
        """
        total = np.zeros(self.size)
        total[self._unknowns] = floats(forces, "forces", self._undeformed.shape).ravel()[self._moved]
        return total

    def tangent(self, u: ArrayLike, semidefinite: bool = False, symmetric: bool = False) -> Any:
        """Tangent stiffness in the host's order, to be added to a stiffness matrix. Needs scipy.

        Parameters
        ----------
        u : array_like, (size,)
            Displacements, in the host's order.
        semidefinite : bool
            As for ``Contact.tangent``.
        symmetric : bool
            As for ``Contact.tangent``.

        Returns
        -------
        scipy.sparse.csr_matrix, (size, size)
            The matrix.

        Raises
        ------
        FmcError
            As ``Contact.tangent`` raises.

        Examples
        --------
        >>> from fmc_contact import OnUnknowns
        >>> OnUnknowns(contact, coords, np.arange(16).reshape(8, 2)).tangent(np.zeros(16)).shape
        (16, 16)
        """
        from scipy.sparse import csr_matrix

        rows, cols, values = self.contact.tangent_parts(self.coords(u), semidefinite, symmetric=symmetric).triplets()
        rows, cols = self._of_freedom[rows], self._of_freedom[cols]
        are_moved = (rows >= 0) & (cols >= 0)
        return csr_matrix((values[are_moved], (rows[are_moved], cols[are_moved])), (self.size, self.size))
