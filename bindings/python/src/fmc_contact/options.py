"""Options as keywords. The library defines names, values and defaults; an option that is not given keeps its default."""

from __future__ import annotations

from collections.abc import Mapping
from ctypes import byref
from numbers import Integral, Real
from typing import Any, TypedDict

import numpy as np

from ._constants import FMC_ESTIMATOR, FMC_LAW, FMC_PATTERN, FMC_WEIGHTS
from ._library import check, library
from ._structs import fmc_options

CHOICES = {"law": FMC_LAW, "estimator": FMC_ESTIMATOR, "pattern": FMC_PATTERN, "weights": FMC_WEIGHTS}
"""Options that take one of a few values: names by number."""

_SWITCHES = ("momentum_correction", "self_contact", "axisymmetric", "check_cells")
_HIDDEN = ("struct_size", "reserved")


class OtherOptions(TypedDict, total=False):
    """Keywords of ``Contact`` and ``contact_force``, which have ``stiffness`` as an argument of its own: see ``Options``.

    Examples
    --------
    >>> from fmc_contact import OtherOptions
    >>> others: OtherOptions = {"law": "depth", "threads": 2}
    >>> contact = Contact(coords, squares, "quad", stiffness=1000.0, **others)
    """

    law: str
    exponent: float
    smoothing_length: float
    estimator: str
    pattern: str
    weights: str
    spacing: float
    fiber_length: float
    fiber_count: int
    seed: int
    momentum_correction: bool
    self_contact: bool
    friction_coefficient: float
    friction_stiffness: float
    cohesion: float
    shear_limit: float
    memoryless_slip: float
    static_coefficient: float
    weakening_slip: float
    weld: float
    axisymmetric: bool
    check_cells: bool
    threads: int
    index_base: int


class Options(OtherOptions, total=False):
    """Keywords of ``Contact.set_options``, and of ``Contact`` and ``contact_force``.

    Options that are not given keep the default of the library. The header, ``include/fmc_contact.h``, describes each in full at
    ``fmc_options``.

    Attributes
    ----------
    stiffness : float
        Stiffness k > 0 of the law. For ``"depth"`` and ``"fiber"`` it is pressure per length, so that pressure is k times penetration.
    law : str
        ``"depth"``, the default: the pressure grows with the depth below the body's own surface, for bodies made of cells.
        ``"fiber"``: the same on flat faces, along the directions of patches. ``"volume"``: energy k V^exponent for each pair.
    exponent : float
        Exponent m >= 1 of the law ``"volume"``. Default: 1.
    smoothing_length : float
        Length over which the pressure of the law ``"fiber"`` grows to k. 0, the default: pressure k times penetration. Any other law
        refuses it.
    estimator : str
        ``"auto"``, the default: exact where possible, sampled with curved obstacles. ``"exact"``: for straight-sided meshes and
        flat-sided obstacles. ``"fibers"``: sampled, for any shape. The law ``"depth"`` is measured without lines under every estimator.
    pattern : str
        ``"lines"``: families of parallel lines. ``"isotropic"``: short random segments.
    weights : str
        ``"balance"``: least noise. ``"consistent"``: the force is the gradient of the estimated energy.
    spacing : float
        Distance between neighbouring lines (length). 0, the default: chosen from the size of the facets in contact.
    fiber_length : float
        Length of an isotropic fiber. 0, the default: the mean size of the facets in contact.
    fiber_count : int
        Approximate number of fibers for each pair; excludes ``spacing``. 0, the default: chosen from the facets in contact.
    seed : int
        Seed of the random shift of the pattern. Default: 0.
    momentum_correction : bool
        Whether forces are corrected so that their sum and moment vanish. Default: True.
    self_contact : bool
        Whether the overlap of each body with itself is evaluated. Default: False.
    friction_coefficient : float
        Coefficient of Coulomb friction, for all pairs without a separate one. Default: 0. With friction, steps are begun and committed
        (``contact.friction``), and the tangent is unsymmetric.
    friction_stiffness : float
        Tangential stiffness of sticking contact (pressure per length). 0, the default: the stiffness of the law at first touch,
        which ``"volume"`` does not have.
    cohesion : float
        Shear traction that is transmitted without pressure wherever there is contact. Default: 0.
    shear_limit : float
        Largest shear traction. 0, the default: no limit.
    memoryless_slip : float
        Slip in a step (length) from which on friction without memory acts in full: a speed times the time step, for example. It is smooth and
        has no history, so that sticking contact creeps. 0, the default: friction with memory. Excludes ``friction_stiffness``.
    static_coefficient : float
        Static coefficient of friction, at least ``friction_coefficient``, to which it falls with the slip. A facet that sticks throughout a step
        rests. 0, the default: one coefficient. Excludes ``memoryless_slip``.
    weakening_slip : float
        Slip (length) over which the coefficient falls, in proportion. Positive with ``static_coefficient``, else 0, the default.
    weld : float
        Distance (length) within which contact treats nodes of one body as one node, for meshes whose nodes were not merged. It is smaller than every
        edge, and cannot change later. ``contact.mesh.welded_node_count`` is the number of removed nodes. 0, the default: none.
    axisymmetric : bool
        Axisymmetry in 2D: coordinates are (r, z) with r >= 0, and volumes, areas, energies and forces refer to whole rings. Default: False. Not with
        isotropic fibers.
    check_cells : bool
        Whether every evaluation checks the orientation of every cell. Default: True.
    threads : int
        Number of threads, at least 1. Default: 1. The result does not depend on it.
    index_base : int
        Number of the first node, 0 or 1. Default: 0. Node numbers are counted from it, in messages too.

    Examples
    --------
    >>> changes: Options = {"stiffness": 2000.0, "threads": 2}
    >>> contact.set_options(**changes)
    >>> contact.options["stiffness"]
    2000.0
    """

    stiffness: float


def _text(key: str, value: object) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, (Integral, np.bool_)):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    raise TypeError(f"option '{key}' is a {type(value).__name__}, expected a number or a name")


def defaults() -> fmc_options:
    """The library's own defaults."""
    options = fmc_options()
    check(library.fmc_options_init(byref(options)))
    return options


def changed(options: fmc_options, changes: Mapping[str, object]) -> fmc_options:
    """A copy with some options changed. Raises ``UnknownOptionError`` for an unknown name, ``BadValueError`` for an unknown value."""
    copy = fmc_options.from_buffer_copy(options)
    for key, value in changes.items():
        check(library.fmc_options_set(byref(copy), key.encode(), _text(key, value).encode()))
    return copy


def described(options: fmc_options) -> dict[str, Any]:
    """The options as they would be given by keywords."""
    values: dict[str, Any] = {name: getattr(options, name) for name in (field[0] for field in fmc_options._fields_) if name not in _HIDDEN}
    values.update({key: names[values[key]] for key, names in CHOICES.items()})
    values.update({key: bool(values[key]) for key in _SWITCHES})
    return values
