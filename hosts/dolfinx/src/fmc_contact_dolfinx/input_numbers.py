"""Fields in the numbering of the arrays that a mesh was made from."""

from __future__ import annotations

from typing import Any

import numpy as np

from .space import Displacement, LayoutError
from .surface import whole


def by_input_number(function: Any) -> np.ndarray:
    """Values of a displacement at the nodes of the mesh, in the order of the coordinates that ``create_mesh`` was given. Collective.

    Parameters
    ----------
    function : Function
        The displacement.

    Returns
    -------
    ndarray, (nodes, dim)
        The values, on every rank, whatever the number of ranks.

    Examples
    --------
    >>> by_input_number(u)
    """
    displacement = Displacement(function.function_space)
    shown = whole(displacement, None)
    values = shown.replica.gather(displacement.owned_values(function))
    at_nodes = values if shown.matrix is None else shown.matrix @ values
    return at_nodes[: shown.input_count]


def set_by_input_number(function: Any, values: np.ndarray) -> None:
    """Sets a displacement of first order, ghosts included, from values that every rank has. Collective.

    Parameters
    ----------
    function : Function
        The displacement.
    values : array_like, (nodes, dim)
        Values in the order of the coordinates that ``create_mesh`` was given.

    Raises
    ------
    LayoutError
        If the unknowns are no nodes.

    Examples
    --------
    >>> set_by_input_number(u, np.zeros((nodes, 3)))
    """
    displacement = Displacement(function.function_space)
    if displacement.reading is not None:
        raise LayoutError("values at the nodes of a mesh do not set a displacement whose unknowns are no nodes")
    replica = whole(displacement, None).replica
    owned = function.x.array[: displacement.owned * displacement.dim].reshape(-1, displacement.dim)
    owned[replica.local] = values[replica.rows]
    function.x.scatter_forward()
