"""Contact forces in one call."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from ._unpack import Unpack
from .contact import Contact
from .creation import Cells
from .options import OtherOptions
from .result import Result


def contact_force(
    coords: ArrayLike,
    conn: Cells,
    cell_type: Optional[str] = None,
    *,
    stiffness: float,
    bodies: Optional[ArrayLike] = None,
    **options: Unpack[OtherOptions],
) -> Result:
    """Contact forces between the bodies of a mesh, in one call.

    If you evaluate more than once, or have obstacles, make a ``Contact`` and keep it: it finds the boundary once, and its forces are
    bit-for-bit identical.

    Parameters
    ----------
    coords, conn, cell_type, stiffness, bodies, **options
        As for ``Contact``.

    Returns
    -------
    Result
        Forces, totals, resultants, pairs and warnings.

    Raises
    ------
    FmcError, TypeError, ValueError
        As ``Contact`` and ``Contact.evaluate`` raise.

    Examples
    --------
    >>> from fmc_contact import contact_force
    >>> coords = [[0, 0], [1, 0], [1, 1], [0, 1], [0.9, -0.2], [1.9, -0.2], [1.9, 0.8], [0.9, 0.8]]
    >>> squares = [[0, 1, 2, 3], [4, 5, 6, 7]]
    >>> result = contact_force(coords, squares, "quad", stiffness=1000.0, law="volume", estimator="exact")
    >>> print(f"overlap {result.volume:.2f}, force on the first square {result.bodies[0].force[0]:.1f}")
    overlap 0.08, force on the first square -800.0
    """
    return Contact(coords, conn, cell_type, stiffness=stiffness, bodies=bodies, **options).evaluate(coords)


def contact_force_step(
    start: ArrayLike,
    coords: ArrayLike,
    conn: Cells,
    cell_type: Optional[str] = None,
    *,
    stiffness: float,
    slip: Optional[ArrayLike] = None,
    reference: Optional[ArrayLike] = None,
    bodies: Optional[ArrayLike] = None,
    **options: Unpack[OtherOptions],
) -> tuple[Result, np.ndarray]:
    """Contact forces with friction at the end of a step, in one call. A rejected step needs no undoing.

    Parameters
    ----------
    start : array_like, (n, dim) or (dim, n)
        Coordinates of all nodes at the start of the step.
    coords : array_like, (n, dim) or (dim, n)
        Coordinates of all nodes at its end.
    slip : array_like, (rows, 8), optional
        Elastic slip carried into the step, as ``contact.friction.slip`` has it. Default: none.
    reference : array_like, (n, dim) or (dim, n), optional
        Undeformed coordinates. Default: ``start``.
    conn, cell_type, stiffness, bodies, **options
        As for ``Contact``.

    Returns
    -------
    result : Result
        Forces, totals, resultants, pairs and warnings.
    slip : ndarray, (rows, 8)
        Elastic slip that is carried into the next step.

    Raises
    ------
    FmcError, TypeError, ValueError
        As ``Contact`` and its methods raise.

    Examples
    --------
    >>> from fmc_contact import contact_force_step
    >>> result, slip = contact_force_step(coords, coords + 0.001, squares, "quad", stiffness=1000.0, friction_coefficient=0.3)
    >>> slip.shape[1]
    8
    """
    begin = start if reference is None else reference
    contact = Contact(begin, conn, cell_type, stiffness=stiffness, bodies=bodies, **options)
    contact.friction.begin_step(start)
    if slip is not None:
        contact.friction.slip = slip
    result = contact.evaluate(coords)
    contact.friction.commit_step(coords)
    return result, contact.friction.slip
