"""Limits of a step."""

from typing import NamedTuple


class StepLimit(NamedTuple):
    """Result of ``Contact.step_limit``.

    Attributes
    ----------
    part : float
        Part of the step, at most 1, that no body passes another by.
    first_touch : float
        Part of it at which the first gap closes, from the current slopes of the gaps; ``inf`` if no gap closes within
        ``part``.

    Examples
    --------
    >>> contact.step_limit(coords, np.zeros((8, 2))).first_touch
    inf
    """

    part: float
    first_touch: float
