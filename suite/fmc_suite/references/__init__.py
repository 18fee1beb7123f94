"""Known answers: closed forms by name, each with its source and a bound in the file of the problem."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Callable

from . import columns, friction, indentation, rings


def _given(value: float) -> float:
    """A number from a publication or a converged computation, of which the problem's file says how it was made."""
    return value


FORMS: Mapping[str, Callable[..., float]] = {
    "given": _given,
    "column_displacement": columns.displacement,
    "column_force": columns.force,
    "confined_force": columns.confined_force,
    "ring_pressure": rings.outside,
    "ring_displacement": rings.outside_displacement,
    "press_fit": rings.press_fit,
    "hertz_line": indentation.line_peak,
    "hertz_ball": indentation.ball_peak,
    "flat_punch": indentation.punch_mean,
    "ellipse_peak": indentation.ellipse_peak,
    "wedge": indentation.wedge_mean,
    "rounded_punch": indentation.rounded_punch_mean,
    "coulomb": friction.coulomb,
    "slope": friction.slope,
    "belt": friction.belt,
}


def reference(raw: Mapping[str, Any]) -> float:
    """The value of a problem's ``[reference]``: its form, with all entries but those that are text for readers."""
    words = {name: value for name, value in raw.items() if name not in ("form", "source", "bound", "checked")}
    return float(FORMS[raw["form"]](**words))
