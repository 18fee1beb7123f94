"""Contact forces in one call."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from .contact import Contact
from .creation import Cells
from .result import Result

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Options


def contact_force(
    coords: ArrayLike,
    conn: Cells,
    cell_type: str | None = None,
    *,
    stiffness: float,
    bodies: ArrayLike | None = None,
    **options: Unpack[Options],
) -> Result:
    """Contact forces between the bodies of a mesh.

    Arguments and errors are those of ``Contact`` and of ``Contact.evaluate``, and so are the forces, bit for bit; a
    ``Contact`` finds the boundary once for many evaluations, and has obstacles.

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
    cell_type: str | None = None,
    *,
    stiffness: float,
    slip: ArrayLike | None = None,
    reference: ArrayLike | None = None,
    bodies: ArrayLike | None = None,
    **options: Unpack[Options],
) -> tuple[Result, np.ndarray]:
    """Contact forces with friction at the end ``coords`` of a step that began at ``start``, and the elastic slip, (facets,
    dim), that is carried into the next step; ``slip`` is what was carried into this one, none by default. A step that is
    rejected leaves nothing to be undone.

    ``reference``, by default ``start``, are the coordinates without deformation, from which the law ``"depth"`` has its
    depths. Other arguments and errors are those of ``Contact``, and the bits those of a ``Contact`` that is kept.
    """
    begin = start if reference is None else reference
    contact = Contact(begin, conn, cell_type, stiffness=stiffness, bodies=bodies, **options)
    contact.friction.begin_step(start)
    if slip is not None:
        contact.friction.slip = slip
    result = contact.evaluate(coords)
    contact.friction.commit_step(coords)
    return result, contact.friction.slip
