"""Options of single pairs: left out, or with a law of their own."""

from __future__ import annotations

from ctypes import byref
from typing import Tuple, Union

from ._constants import FMC_FRICTION_OF_CONTEXT, FMC_LAW, FMC_LAW_OF_CONTEXT, FMC_PARTNER
from ._core import Core
from ._library import check, library
from ._structs import fmc_pair_options

Partner = Union[int, Tuple[str, int]]
"""A body by its number among ``Result.bodies``, or ``("body", number)`` or ``("obstacle", number)``, as in
``Pair.a``."""

_OF_LAW = ("stiffness", "exponent", "smoothing_length")


def _named(partner: Partner) -> tuple[int, int]:
    kind, index = partner if isinstance(partner, tuple) else ("body", partner)
    numbers = {name: number for number, name in FMC_PARTNER.items()}
    if kind not in numbers:
        raise ValueError(f"no partner '{kind}': body or obstacle is wanted")
    if index < 0:
        raise IndexError(f"no {kind} {index}")
    return numbers[kind], int(index)


class Pairs:
    """Options of single pairs: left out, or with a law of their own.

    Errors: ``BodyOutOfRangeError`` and ``ObstacleOutOfRangeError``, which name the index; ``NotPositiveError``;
    ``UnknownOptionError`` for an unknown value, or one that would have no effect; ``UnsupportedError`` for two obstacles,
    for a law that the estimator does not support, and for a gap offset between bodies that is positive
    or has another law than ``depth``; ``BusyError``. What was set before then stays.
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def set(
        self,
        a: Partner,
        b: Partner,
        *,
        law: str | None = None,
        stiffness: float | None = None,
        exponent: float | None = None,
        smoothing_length: float | None = None,
        friction_coefficient: float | None = None,
        gap_offset: float = 0.0,
        excluded: bool = False,
    ) -> None:
        """Gives the pair of ``a`` and ``b``, in either order, options of its own, in place of those it had.

        ``excluded``: the pair is left out; it is not measured, and adds nothing to any result. ``law`` with ``stiffness``,
        and ``exponent`` (``"volume"``) or ``smoothing_length`` (``"fiber"``): the law of this pair, as in ``Options``. ``stiffness`` alone: the law
        that the contact has now, with this stiffness. None of these: the law of the contact, also after it changes.
        ``friction_coefficient``: that of this pair; all else of its friction is that of the contact's options.

        ``gap_offset``: the distance (length) at which contact begins; penetration, gap and pressure are counted from
        there. The surface of an obstacle is taken to lie so much further out (a shell's thickness, a coating), or, if
        negative, further in (a clearance). Half-spaces, balls and capsules stay what they are, cylinders inwards; any
        other shape becomes its signed distance less the offset, with its outward edges rounded, and what holds for
        ``Obstacles.add_signed_distance`` holds for it. Between bodies, and of one with itself, only with the law ``"depth"`` and
        not positive: -c lets either body in by c before it presses.

        For a body with itself (``a == b``) this decides in place of the option ``self_contact`` whether it is evaluated
        against itself: ``excluded`` switches that off for this body, and anything else on.
        """
        given = {"stiffness": stiffness, "exponent": exponent, "smoothing_length": smoothing_length}
        own = fmc_pair_options()
        check(library.fmc_pair_options_init(byref(own)))
        own.excluded, own.gap_offset = bool(excluded), float(gap_offset)
        if friction_coefficient is not None:
            own.friction_coefficient = float(friction_coefficient)
        if law is not None:
            numbers = {name: number for number, name in FMC_LAW.items()}
            if law not in numbers:
                raise ValueError(f"option 'law' has no value '{law}': {' or '.join(numbers)} is wanted")
            own.law = numbers[law]
        elif stiffness is not None:
            own.law = self._core.options.law
            given = {key: getattr(self._core.options, key) if value is None else value for key, value in given.items()}
        for key, value in given.items():
            if value is not None:
                setattr(own, key, float(value))
        self._set(a, b, byref(own))

    def reset(self, a: Partner, b: Partner) -> None:
        """Takes a pair's options back: it follows the options of the contact again."""
        self._set(a, b, None)

    def _set(self, a: Partner, b: Partner, options: object) -> None:
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_pair_options, *_named(a), *_named(b), options)

    def options(self, a: Partner, b: Partner) -> dict[str, object]:
        """The options of a pair, as ``set`` takes them: ``excluded``, and ``law`` with what belongs to it, ``None``
        where it is the contact's, and ``gap_offset``. Of a pair without options of its own, those that hold for it."""
        found = fmc_pair_options()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_pair_options, *_named(a), *_named(b), byref(found))
        has_law = found.law != FMC_LAW_OF_CONTEXT
        options: dict[str, object] = {"excluded": bool(found.excluded)}
        has_friction = found.friction_coefficient != FMC_FRICTION_OF_CONTEXT
        options["friction_coefficient"] = found.friction_coefficient if has_friction else None
        options["gap_offset"] = found.gap_offset
        options["law"] = FMC_LAW[found.law] if has_law else None
        options.update({key: getattr(found, key) if has_law else None for key in _OF_LAW})
        return options
