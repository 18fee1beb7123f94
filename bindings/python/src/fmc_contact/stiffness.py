"""Initial values for the stiffness."""

from __future__ import annotations

from ctypes import byref, c_double

from ._constants import FMC_LAW
from ._library import check, library

_LAWS = {name: number for number, name in FMC_LAW.items()}


def suggest_stiffness(
    modulus: float, cell_size: float, *, law: str = "depth", dim: int = 3, exponent: float = 1.0
) -> float:
    """A stiffness k to begin with, from Young's modulus E and the size h of cells.

    With the laws ``"depth"`` and ``"fiber"`` k is 10 E / h: a penetration of a tenth of a cell presses with E. With ``"volume"``,
    w = k V^exponent, an overlap a tenth of a cell deep, over a patch one cell wide, presses with E.

    Parameters
    ----------
    modulus : float
        Young's modulus of the softer body (pressure).
    cell_size : float
        Size of its cells in contact (length).
    law : str
        ``"depth"``, ``"fiber"`` or ``"volume"``.
    dim : int
        Number of axes, 2 or 3; for the law ``"volume"`` alone.
    exponent : float
        Exponent of the law ``"volume"``.

    Returns
    -------
    float
        Stiffness (pressure per length); with ``"volume"`` in pressure / (length^dim)^(exponent - 1).

    Raises
    ------
    BadValueError
        If there is no such law.
    DimensionError, NotPositiveError
        If an argument cannot be.

    Examples
    --------
    >>> from fmc_contact import suggest_stiffness
    >>> suggest_stiffness(2e11, 0.005)
    400000000000000.0
    """
    stiffness = c_double()
    check(library.fmc_suggest_stiffness(_LAWS.get(law, -1), dim, exponent, modulus, cell_size, byref(stiffness)))
    return stiffness.value
