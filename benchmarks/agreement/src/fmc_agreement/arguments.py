"""Cases on the command line."""

from __future__ import annotations

import argparse
from collections.abc import Collection


def with_cases(parser: argparse.ArgumentParser, names: Collection[str]) -> argparse.Namespace:
    """Arguments, with those of ``names`` that are asked for as ``case``, none for all; ends the program if one is not
    there."""
    parser.add_argument("case", nargs="*", help=f"only these: {', '.join(names)}")
    found = parser.parse_args()
    if unknown := [case for case in found.case if case not in names]:
        parser.error(f"no such case: {', '.join(unknown)} (there are {', '.join(names)})")
    return found
