"""Initial values for the stiffness."""

from __future__ import annotations

from ctypes import byref, c_double

from ._library import check, library


def suggest_fiber_stiffness(pressure: float, penetration: float) -> float:
    """Stiffness k of the law ``"fiber"`` (Pa/length) from the largest contact ``pressure`` expected (Pa) and the
    acceptable ``penetration`` at that pressure (length): their ratio.

    From Young's modulus E of the softer body and facets of size h, take E and h / 10. Errors: ``NotPositiveError``.
    """
    stiffness = c_double()
    check(library.fmc_suggest_fiber_stiffness(pressure, penetration, byref(stiffness)))
    return stiffness.value


def suggest_stiffness(
    dim: int,
    *,
    modulus: float | None = None,
    facet_size: float | None = None,
    pressure: float | None = None,
    overlap: float | None = None,
    exponent: float = 1.0,
) -> float:
    """Stiffness k of the law ``"volume"``, w = k V^exponent; in Pa / (length^dim)^(exponent - 1).

    Either from Young's ``modulus`` of the softer body (Pa) and the ``facet_size`` of its facets in contact (length): an
    overlap a tenth of a facet deep over a patch one facet wide is resisted by the traction E. Or from the largest
    contact ``pressure`` expected (Pa) and the ``overlap`` of one pair that may be accepted when it is reached
    (length^dim; not used for exponent 1): 1.2 times what resists that pressure.

    Errors: ``DimensionError``, ``NotPositiveError``.
    """
    stiffness = c_double()
    if modulus is not None and facet_size is not None and pressure is None and overlap is None:
        arguments = (dim, exponent, modulus, facet_size, byref(stiffness))
        check(library.fmc_suggest_stiffness_from_modulus(*arguments))
    elif pressure is not None and modulus is None and facet_size is None:
        arguments = (dim, exponent, pressure, 0.0 if overlap is None else overlap, byref(stiffness))
        check(library.fmc_suggest_stiffness_from_pressure(*arguments))
    else:
        raise TypeError("give modulus and facet_size, or pressure and overlap (pressure alone for exponent 1)")
    return stiffness.value
