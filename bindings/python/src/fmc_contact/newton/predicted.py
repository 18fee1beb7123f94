"""Bodies carried along by what is prescribed."""

from __future__ import annotations

from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from .levels import condensed_of
from .linear import solved, summed
from .prescribed import moved, start
from .state import Model


def predicted(
    residual_and_tangent: Callable[[np.ndarray], Any],
    contact: Any,
    x: ArrayLike,
    free: ArrayLike,
    prescribed: ArrayLike,
    *,
    solve: Optional[Callable[[Any, np.ndarray], np.ndarray]] = None,
) -> Optional[np.ndarray]:
    """Where one linear solve leads from the equilibrium ``x`` when what is prescribed is moved, in the shape of ``x``: bodies follow as
    their tangent and the semidefinite one of the contact say, without a look at what they meet there. ``None`` where the matrix is
    singular. Arguments as for ``newton``."""
    begin, solved_for = start(x, free)
    model = Model(residual_and_tangent, contact, begin.shape, solved_for)
    step = moved(begin, solved_for, prescribed)
    state = model.at(begin)
    if solve is None and not state.result.pairs:
        try:
            change = condensed_of(model).carried(begin.ravel(), step, state.inside, state.matrix)
            found: np.ndarray = begin + change.reshape(begin.shape)
            return found
        except (ValueError, ImportError, RuntimeError, np.linalg.LinAlgError):
            pass
    matrix = summed(state.matrix, contact.tangent(begin, semidefinite=True))
    right = -(state.residual + matrix @ step)[solved_for]
    try:
        step[solved_for] = (solve or solved)(matrix[solved_for][:, solved_for], right)
    except (RuntimeError, np.linalg.LinAlgError):
        return None
    return begin + step.reshape(begin.shape) if np.isfinite(step).all() else None
