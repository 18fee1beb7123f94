"""Whether a host gives what ``find_equilibrium`` takes it to give."""

from __future__ import annotations

from typing import Any, Union

from numpy.typing import ArrayLike

from .bodies import Residual, bodies_of
from .host import Host
from .likely import refuse_start
from .outcome import NotConvergedError
from .requests import Search
from .start import start
from .unknowns import Moved


def check_host(residual_and_tangent: Union[Residual, Host], contact: Any, x: ArrayLike, free: ArrayLike) -> list[str]:
    """Sentences on a host's residual and matrix: a wrong derivative, a wrong sign, springs to the ground, loose bodies.

    Arguments as for ``find_equilibrium``. It does not solve. A sentence about a certain fault begins with a word and ``WRONG``.

    Parameters
    ----------
    residual_and_tangent : callable
        The bodies.
    contact : Contact or adapter
        The contact.
    x : array_like
        A state, such as the first one.
    free : array_like of int or bool
        Numbers of the unknowns that are solved for, or a mark for every unknown.

    Returns
    -------
    list of str
        A sentence for everything that was looked at.

    Raises
    ------
    NotConvergedError
        If the residual cannot be evaluated, or is not finite.
    ValueError
        For shapes, and for a matrix in the order of components.

    Examples
    --------
    >>> from fmc_contact import check_host
    >>> bodies = lambda x: ((1e4 * (x - coords)).ravel(), 1e4 * np.eye(16))
    >>> [text for text in check_host(bodies, contact, coords, range(16)) if text.startswith("symmetry")]
    ['symmetry: the matrix is symmetric']
    """
    begin, solved_for = start(x, free)
    refuse_start(contact, begin)
    bodies = bodies_of(residual_and_tangent, contact, begin.shape, solved_for, None)
    search = Search(bodies, Moved(contact, begin.size), begin, solved_for, None, {"check": 1}, None)
    search.run()
    result, way, texts = search.ended()
    if way == "none":
        raise NotConvergedError(texts[0], [float("nan")], result.solve_count)
    return texts + [f"unknowns: WRONG: {text}" for text in getattr(bodies, "hints", [])]
