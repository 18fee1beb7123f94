"""Scalar fields through contact: heat or charge that flows between bodies that touch, are tied, or are near one another."""

from __future__ import annotations

from ctypes import byref
from dataclasses import dataclass, field
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import View, floats, shape_error, vector
from ._constants import FMC_ERROR_NOT_POSITIVE
from ._handle import Handle
from ._library import check, library
from ._rows import compressed_rows
from ._structs import fmc_conductance
from .errors import of_status


@dataclass(frozen=True, eq=False)
class Conductance:
    """Conductance h of a contact: flux per area and jump of the field, for heat W/(m^2 K). Tables are linear between their entries.

    Attributes
    ----------
    by_pressure : array_like, (entries, 2)
        Pressures ≥ 0, each larger than the one before, and h ≥ 0 there, where surfaces touch. h is constant before the first and beyond the
        last. One entry is a constant. Without entries there is no flux.
    by_gap : array_like, (entries, 2)
        Gaps ≥ 0, each larger than the one before, and h ≥ 0 there, where surfaces are apart. Beyond the last there is no flux. Without entries
        there is no flux.

    Examples
    --------
    >>> from fmc_contact import Conductance
    >>> h = Conductance(by_pressure=[(0.0, 10.0), (100.0, 50.0)], by_gap=[(0.0, 10.0), (0.1, 0.2)])
    >>> contact.flux(coords, np.zeros(8), h).flux.shape
    (8,)
    """

    by_pressure: ArrayLike = field(default_factory=list)
    by_gap: ArrayLike = field(default_factory=list)


@dataclass(frozen=True, eq=False)
class ContactFlux:
    """Flux through contact, and its derivative by the field.

    ``data``, ``indices``, ``indptr`` are the derivative, the same for every field, in compressed rows: symmetric, positive semidefinite. Its rows
    and columns are the n nodes, then the m obstacles.

    Attributes
    ----------
    flux : ndarray, (n,) or (fields, n)
        Flux out of every node into its partners: int N h (T - T_other) dA. Its sum with ``obstacles`` is zero.
    obstacles : ndarray, (m,) or (fields, m)
        The same out of every obstacle; zero where they have no values.
    data : ndarray
        Entries of the derivative.
    indices : ndarray of int
        Column of every entry, ascending within a row.
    indptr : ndarray of int, (n + m + 1,)
        Entries of row r are those from ``indptr[r]`` to ``indptr[r + 1]``.

    Examples
    --------
    >>> found = contact.flux(coords, np.zeros(8), 10.0)
    >>> len(found.indptr)
    9
    """

    flux: np.ndarray
    obstacles: np.ndarray
    data: np.ndarray
    indices: np.ndarray
    indptr: np.ndarray

    @property
    def matrix(self) -> Any:
        """The derivative of the flux out of the nodes by the field at the nodes, to be added to a matrix of conduction.

        A ``scipy.sparse.csr_matrix``, (n, n). Without scipy a tuple ``(rows, cols, values)``.

        Examples
        --------
        >>> contact.flux(coords, np.zeros(8), 10.0).matrix.shape
        (8, 8)
        """
        count = self.flux.shape[-1]
        rows = np.repeat(np.arange(len(self.indptr) - 1), np.diff(self.indptr))
        of_nodes = (rows < count) & (self.indices < count)
        triplets = rows[of_nodes], self.indices[of_nodes], self.data[of_nodes]
        try:
            from scipy.sparse import csr_matrix
        except ImportError:
            return triplets
        return csr_matrix((triplets[2], triplets[:2]), shape=(count, count))


@dataclass(frozen=True, eq=False)
class FrictionHeat:
    """Energy that friction has dissipated since the step began, as heat: its sum is the dissipation of all pairs.

    Attributes
    ----------
    nodes : ndarray, (n,)
        By node.
    obstacles : ndarray, (m,)
        By obstacle.

    Examples
    --------
    >>> contact.friction.begin_step(coords)
    >>> print(contact.friction_heat(coords).nodes.sum())
    0.0
    """

    nodes: np.ndarray
    obstacles: np.ndarray


def friction_heat(handle: Handle, coords: View, effusivities: Optional[ArrayLike], counts: tuple[int, int, int]) -> FrictionHeat:
    """Finds it at ``coords``, of so many nodes, bodies and obstacles."""
    nodes, bodies, obstacles = counts
    given = None if effusivities is None else vector(effusivities, bodies + obstacles, "effusivities")
    found, through = np.empty(nodes), np.empty(obstacles)
    handle.call(library.fmc_context_friction_heat, byref(coords.struct), given, found, through)
    return FrictionHeat(found, through)


def flux(
    handle: Handle,
    coords: View,
    fields: ArrayLike,
    conductance: Union[float, Conductance],
    of_obstacles: Optional[ArrayLike],
    counts: tuple[int, int],
    index_base: int,
) -> ContactFlux:
    """Finds it at ``coords``, of so many nodes and obstacles."""
    values = np.ascontiguousarray(_rows(fields, "fields", counts[0]))
    shape, count = values.shape[:-1], values.size // max(counts[0], 1)
    others = None
    if of_obstacles is not None:
        others = np.ascontiguousarray(floats(of_obstacles, "obstacles", (*shape, counts[1])))
        # An empty array has no pointer of its own.
        others = others if others.size else None
    found, through = np.empty((*shape, counts[0])), np.empty((*shape, counts[1]))
    tables, kept = _tables(conductance)
    handle.call(library.fmc_context_flux, byref(coords.struct), byref(tables), count, values, others, found, through)
    del kept
    indptr, indices, data = compressed_rows(handle, library.fmc_context_flux_matrix, index_base=index_base)
    return ContactFlux(found, through, data, indices, indptr)


def _rows(values: ArrayLike, name: str, count: int) -> np.ndarray:
    """One field, (count,), or several, (fields, count)."""
    array = floats(values, name)
    if array.ndim not in (1, 2) or array.shape[-1] != count:
        raise shape_error(name, array.shape, f"({count},) or (fields, {count})")
    return array


def _tables(conductance: Union[float, Conductance]) -> tuple[fmc_conductance, object]:
    """The struct, and the arrays that it points to, to be kept as long."""
    if not isinstance(conductance, Conductance):
        number_of_all = float(floats(conductance, "conductance", ()))
        if not 0 <= number_of_all < np.inf:
            text = f"the conductance is {number_of_all}, expected a number >= 0, or tables: a Conductance"
            raise of_status(FMC_ERROR_NOT_POSITIVE, text)
        conductance = Conductance(by_pressure=[(0.0, number_of_all)])
    struct = fmc_conductance()
    check(library.fmc_conductance_init(byref(struct)))
    kept = []
    for name, places, number in (("by_pressure", "pressures", "pressure_count"), ("by_gap", "gaps", "gap_count")):
        table = floats(getattr(conductance, name), name)
        if table.size and (table.ndim != 2 or table.shape[1] != 2):
            raise shape_error(name, table.shape, "(entries, 2)")
        columns = [np.ascontiguousarray(column) for column in table.reshape(-1, 2).T]
        falling = np.flatnonzero(np.diff(columns[0]) <= 0)
        if falling.size:
            row, (before, here) = falling[0] + 1, columns[0][falling[0] : falling[0] + 2]
            text = f"entry {row} of '{places}' is {here} after {before}: {name} lists its {places} ascending, each larger than the one before"
            raise of_status(FMC_ERROR_NOT_POSITIVE, text)
        setattr(struct, number, len(columns[0]))
        setattr(struct, places, columns[0].ctypes.data)
        setattr(struct, name, columns[1].ctypes.data)
        kept.append(columns)
    return struct, kept
