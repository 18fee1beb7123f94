"""Initial values for the stiffness."""

from __future__ import annotations

from ctypes import byref, c_double
from typing import Optional

from ._library import check, library


def suggest_fiber_stiffness(pressure: float, penetration: float) -> float:
    """Stiffness k of the laws ``"depth"`` and ``"fiber"``: largest pressure divided by the penetration that you accept.

    If you know Young's modulus E of the softer body and the size h of its facets, take E and h / 10.

    Parameters
    ----------
    pressure : float
        Largest contact pressure that you expect.
    penetration : float
        Penetration that you accept at that pressure (length).

    Returns
    -------
    float
        Stiffness (pressure per length).

    Raises
    ------
    NotPositiveError
        If an argument is not positive.

    Examples
    --------
    >>> from fmc_contact import suggest_fiber_stiffness
    >>> suggest_fiber_stiffness(2e11, 0.0005)
    400000000000000.0
    """
    stiffness = c_double()
    check(library.fmc_suggest_fiber_stiffness(pressure, penetration, byref(stiffness)))
    return stiffness.value


def suggest_stiffness(
    dim: int,
    *,
    modulus: Optional[float] = None,
    facet_size: Optional[float] = None,
    pressure: Optional[float] = None,
    overlap: Optional[float] = None,
    exponent: float = 1.0,
) -> float:
    """Stiffness k of the law ``"volume"``, w = k V^exponent.

    Give ``modulus`` and ``facet_size``: an overlap a tenth of a facet deep, over a patch one facet wide, then meets the traction E.
    Or give ``pressure`` and ``overlap``: k is 1.2 times the value that meets that pressure.

    Parameters
    ----------
    dim : int
        Number of axes, 2 or 3.
    modulus : float, optional
        Young's modulus of the softer body (pressure).
    facet_size : float, optional
        Size of its facets in contact (length).
    pressure : float, optional
        Largest contact pressure that you expect.
    overlap : float, optional
        Overlap of one pair that you accept at that pressure (length^dim). Not used for exponent 1.
    exponent : float
        Exponent of the law.

    Returns
    -------
    float
        Stiffness, in pressure / (length^dim)^(exponent - 1).

    Raises
    ------
    TypeError
        If neither pair of arguments is given.
    DimensionError, NotPositiveError
        If an argument cannot be.

    Examples
    --------
    >>> from fmc_contact import suggest_stiffness
    >>> suggest_stiffness(2, pressure=1000.0)
    1200.0
    """
    stiffness = c_double()
    if modulus is not None and facet_size is not None and pressure is None and overlap is None:
        check(library.fmc_suggest_stiffness_from_modulus(dim, exponent, modulus, facet_size, byref(stiffness)))
    elif pressure is not None and modulus is None and facet_size is None:
        largest = 0.0 if overlap is None else overlap
        check(library.fmc_suggest_stiffness_from_pressure(dim, exponent, pressure, largest, byref(stiffness)))
    else:
        raise TypeError("give modulus and facet_size, or pressure and overlap (pressure alone for exponent 1)")
    return stiffness.value
