"""What is most likely wrong with a host, in sentences for its programmer."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..contact import Contact


def refuse_displacements(contact: Any, begin: np.ndarray) -> None:
    """Errors: ``ValueError`` where coordinates are wanted and zeros are given."""
    if isinstance(contact, Contact) and begin.size and not begin.any():
        raise ValueError("x is zero: with a Contact x are coordinates; OnUnknowns(contact, coords, unknowns) takes displacements")


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
            "the matrix has all displacements along x before those along y, the contact wants node * dim + axis: "
            f"OnUnknowns(contact, coords, np.arange({matrix.shape[0]}).reshape({dim}, {count}).T) takes the host's order"
        )


def unconnected(matrix: Any, moved: np.ndarray) -> list[str]:
    """A sentence where supports are moved that the matrix connects with nothing: their rows were replaced by those of the unit matrix,
    and the bodies feel nothing of the motion."""
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
