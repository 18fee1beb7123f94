"""Bodies carried along by what is prescribed."""

from __future__ import annotations

from typing import Any, Callable

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
    solve: Callable[[Any, np.ndarray], np.ndarray] | None = None,
) -> np.ndarray | None:
    """Where one linear solve leads from the equilibrium ``x`` when what is prescribed is moved, in the shape of ``x``: bodies follow as
    their tangent and the semidefinite one of the contact say, without a look at what they meet there. ``None`` where the matrix is
    singular. Arguments as for ``newton``."""
    x, free = start(x, free)
    model = Model(residual_and_tangent, contact, x.shape, free)
    step = moved(x, free, prescribed)
    state = model.at(x)
    if solve is None and not state.result.pairs:
        try:
            return x + condensed_of(model).carried(x.ravel(), step, state.inside, state.matrix).reshape(x.shape)
        except (ValueError, ImportError, RuntimeError, np.linalg.LinAlgError):
            pass
    matrix = summed(state.matrix, contact.tangent(x, semidefinite=True))
    right = -(state.residual + matrix @ step)[free]
    try:
        step[free] = (solve or solved)(matrix[free][:, free], right)
    except (RuntimeError, np.linalg.LinAlgError):
        return None
    return x + step.reshape(x.shape) if np.isfinite(step).all() else None
