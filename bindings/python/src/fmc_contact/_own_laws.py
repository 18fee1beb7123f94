"""Common part of your own laws, of interfaces and of friction."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats
from ._index import integer
from ._library import check
from ._structs import fmc_log_callback


def history_count(history: int, carrier: str) -> int:
    """Number of values that each carrier keeps, checked."""
    count = integer(history)
    if count is None:
        raise TypeError(f"history is {history!r}, expected the number of values that a {carrier} keeps")
    if count < 0:
        raise ValueError(f"history is {count}, expected at least 0")
    return count


def with_fields(law: Callable[[Any], Any], fields: Optional[ArrayLike]) -> Callable[[Any], Any]:
    """The law, with the same values of fields on both sides wherever it is asked."""
    if fields is None:
        return law
    values = floats(fields, "fields").ravel()
    return lambda asked: law(replace(asked, fields=np.broadcast_to(values, (len(asked), 2, len(values)))))


def sentences(ask: Callable[[Any], int], raised: list[BaseException]) -> list[str]:
    """Sentences of a check. Exceptions of the law are reraised unchanged."""
    texts: list[str] = []
    status = ask(fmc_log_callback(lambda _user, _level, text: texts.append(text.decode())))
    if raised:
        raise raised[0]
    # What is wrong with the answers is told; other errors come before any sentence.
    if not texts:
        check(status)
    return texts
