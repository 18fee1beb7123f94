"""Where the unknowns of bases are in the vectors of the whole problem."""

from __future__ import annotations

from typing import Any

from fmc_contact._index import integer

from .errors import LayoutError
from .field import Field, field


def fields_of(bases: Any) -> list[Field]:
    """The bases, checked. Each has separate unknowns. Errors: ``LayoutError``, ``ValueError``."""
    if _is_basis(bases):
        return [field(bases)]
    if not isinstance(bases, (list, tuple)):
        raise LayoutError(f"bases is a {type(bases).__name__}, expected a basis or a list of (basis, offset)")
    if not bases:
        raise ValueError("there is no basis")
    fields: list[Field] = []
    ranges: list[tuple[int, int, int]] = []
    for number, pair in enumerate(bases):
        if not isinstance(pair, (list, tuple)) or len(pair) != 2 or not _is_basis(pair[0]):
            raise LayoutError(
                f"bases[{number}] is {_kind(pair)}, expected a pair of a basis and the place of its first unknown: "
                "[(first, 0), (second, first.N)]"
            )
        basis, offset = pair[0], integer(pair[1])
        if offset is None or offset < 0:
            raise ValueError(f"the offset of bases[{number}] is {pair[1]!r}, expected the number of its first unknown, from 0")
        fields.append(field(basis, offset))
        dims = [one.coords.shape[1] for one in fields]
        if dims[number] != dims[0]:
            raise LayoutError(f"bases[0] is in {dims[0]}D and bases[{number}] in {dims[number]}D")
        ranges.append((offset, offset + basis.N, number))
    ranges.sort()
    for (begin, end, one), (next_begin, next_end, other) in zip(ranges, ranges[1:]):
        if next_begin < end:
            raise ValueError(
                f"bases[{one}] has the unknowns {begin} to {end - 1} and bases[{other}] {next_begin} to {next_end - 1}: every "
                "basis has separate unknowns, [(first, 0), (second, first.N)]"
            )
    return fields


def size_of(fields: list[Field], size: Any) -> int:
    """Length of the vectors of the whole problem. Errors: ``ValueError``."""
    reaches = [one.reach for one in fields]
    reach = max(reaches)
    if size is None:
        return reach
    found = integer(size)
    if found is None:
        raise ValueError(f"the size is {size!r}, expected an integer")
    if found < reach:
        raise ValueError(
            f"vectors of {found} entries are too short, bases[{reaches.index(reach)}] has unknowns up to {reach - 1}"
        )
    return found


def _is_basis(one: Any) -> bool:
    return hasattr(one, "element_dofs")


def _kind(pair: Any) -> str:
    if isinstance(pair, (list, tuple)):
        return f"a {type(pair).__name__} of {len(pair)}" if len(pair) != 2 else f"a pair that begins with a {type(pair[0]).__name__}"
    return "a basis alone" if _is_basis(pair) else f"a {type(pair).__name__}"
