"""Most likely faults of a host, in sentences for its programmer."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from .._arrays import shape_error
from ..contact import Contact
from .unknowns import Moved

_SAME = 1e-12
"""Displacements by coordinates that are these, up to the rounding of a sum."""

_ROUNDING = 1e-6
"""Forces by the sum of their parts below which the matrix does not know a stretch."""

_LARGE = 0.1
"""Residual by that of bodies stretched to twice their size above which the cause is looked for: hardly a load step begins with as much."""

_SMALL = 0.1
"""Residual at the other kind of unknowns by that at the start: there loads alone are left."""


def refuse_start(contact: Any, begin: np.ndarray) -> None:
    """Errors: ``ValueError`` for displacements in place of coordinates, the other way round, or for columns."""
    if isinstance(contact, Contact):
        if begin.size and not begin.any():
            raise ValueError("x is zero: with a Contact x are coordinates; OnUnknowns(contact, coords, unknowns) takes displacements")
        expected = contact.unknown_count, contact.dim
        if begin.shape != expected:
            hint = "transpose it, and have the residual in the same shape" if begin.shape == expected[::-1] else ""
            raise shape_error("x", begin.shape, f"{expected}: with a Contact x are coordinates", hint)
        return
    if begin.ndim != 1 or not begin.any():
        return
    places = _spread(contact, begin.size, contact.coords(np.zeros(begin.size)))
    if np.abs(begin - places).max() <= _SAME * np.abs(places).max():
        raise ValueError(
            "x are the places of the nodes without displacement: with this contact x are displacements, zeros where a first load step "
            "begins; with a Contact x are coordinates"
        )


def refuse_columns(residual: Any, shape: tuple[int, ...]) -> None:
    """Errors: ``ValueError`` for a residual in columns, (dim, n), which in a row would be another one."""
    found = np.shape(residual)
    if len(found) == len(shape) == 2 and found != shape and found == shape[::-1]:
        raise shape_error("the residual", found, f"{shape}, as x has", "transpose it")


def other_unknowns(
    at: Callable[[np.ndarray], np.ndarray], contact: Any, x: np.ndarray, residual: np.ndarray, matrix: Any
) -> list[str]:
    """A sentence where the host takes displacements and is given coordinates, or the other way round; ``at`` is its residual elsewhere.

    The residual is then as large as in bodies stretched to twice their size, and small at the other kind of unknowns. A correct host never has both:
    its loads alone would have to press the bodies to a point, or stretch them to twice their size."""
    takes_coords = isinstance(contact, Contact)
    rows = x if takes_coords else contact.coords(x)
    places, stretch = (one.ravel() if takes_coords else _spread(contact, x.size, one) for one in (rows, rows - rows.mean(axis=0)))
    stretched, found = np.linalg.norm(matrix @ stretch), np.linalg.norm(residual)
    if not (stretched > _ROUNDING * np.linalg.norm(abs(matrix) @ abs(stretch)) and _LARGE * stretched < found < np.inf):
        return []
    try:
        other = at(np.zeros(x.shape) if takes_coords else places)
    except Exception:
        # Bodies without extent, or twice as large, may be refused in any way.
        return []
    if not np.linalg.norm(other) <= _SMALL * found:
        return []
    if takes_coords:
        return [
            "the residual at the start is as for bodies stretched to twice their size, and small where x is zero: the function "
            "takes displacements, and with a Contact x are coordinates; OnUnknowns(contact, coords, unknowns) takes displacements"
        ]
    return [
        "the residual at the start is as for bodies without extent, and small where x are the positions of the nodes: the function takes "
        "coordinates, and with this contact x are displacements"
    ]


def _spread(contact: Any, size: int, rows: np.ndarray) -> np.ndarray:
    """Coordinates of an adapter by the unknown that moves each; 0 for unknowns that move none."""
    of_coordinate = Moved(contact, size).of_coordinate
    moved = of_coordinate >= 0
    found = np.zeros(size)
    found[of_coordinate[moved]] = rows.ravel()[moved]
    return found


def refuse_part(matrix: Any, size: int) -> None:
    """Errors: ``ValueError`` for a matrix without the rows and columns of some unknowns."""
    if matrix.shape != (size, size):
        raise ValueError(
            f"the matrix has shape {tuple(matrix.shape)}, expected {(size, size)}: rows and columns of unknowns that are not free belong to it"
        )


def refuse_components(matrix: Any, dim: int) -> None:
    """Errors: ``ValueError`` for a matrix in the order ``axis * n + node``, which would be read as another one without a sign of it:
    translations in that order have no forces, and those in the order of the contact have."""
    count = matrix.shape[0] // dim
    translations = np.eye(dim)
    by_node = matrix @ np.tile(translations, (count, 1))
    by_axis = matrix @ np.repeat(translations, count, axis=0)
    least = 1e-9 * float((abs(matrix) @ np.ones(matrix.shape[0])).max(initial=0.0))
    if count > dim and (abs(by_axis) <= least).all() and (abs(by_node).max(axis=0) > 1e3 * least).all():
        raise ValueError(
            "the matrix has all displacements along x before those along y, the contact needs node * dim + axis: "
            f"OnUnknowns(contact, coords, np.arange({matrix.shape[0]}).reshape({dim}, {count}).T) takes the host's order"
        )


def unconnected(matrix: Any, moved: np.ndarray) -> list[str]:
    """A sentence if supports move that the matrix does not connect with the bodies. Their rows were replaced by rows of the unit matrix, so that the
    bodies do not feel the motion."""
    marks = (moved != 0.0).astype(np.float64)
    if not marks.any():
        return []
    sizes = abs(matrix)
    across = sizes @ marks - sizes.diagonal() * marks
    if np.any(across > 0.0):
        return []
    return [
        "the matrix connects no unknown that is moved with any other: it has to have the rows and columns of supports as they were "
        "before boundary conditions"
    ]
