"""Options as keywords. Names, values and defaults are the library's: what is not given keeps the default."""

from __future__ import annotations

from ctypes import byref
from numbers import Integral, Real
from typing import Mapping, TypedDict

import numpy as np

from ._constants import FMC_ESTIMATOR, FMC_LAW, FMC_PATTERN, FMC_WEIGHTS
from ._library import check, library
from ._structs import fmc_options

CHOICES = {"law": FMC_LAW, "estimator": FMC_ESTIMATOR, "pattern": FMC_PATTERN, "weights": FMC_WEIGHTS}
"""Options that take one of a few values: names by number."""

_SWITCHES = ("momentum_correction", "self_contact", "axisymmetric", "check_cells")
_HIDDEN = ("struct_size", "reserved")


class Options(TypedDict, total=False):
    """Keywords of ``contact_force``, ``Contact`` and ``Contact.set_options``, in addition to ``stiffness``.

    The header, ``include/fmc_contact.h``, describes each in full at ``fmc_options``.
    """

    law: str
    """``"depth"``: a pressure that grows with the penetration, from the depth of the material below its own surface, for
    bodies made of cells. ``"fiber"``: the same on flat faces, along the directions of patches. ``"volume"``: energy
    k V^exponent per pair. The default is the library's, ``"depth"``."""
    exponent: float
    """m >= 1, for the law ``"volume"`` only; 1."""
    smoothing_length: float
    """Smoothing length over which the pressure of the law ``"fiber"`` grows to k; 0: pressure k times penetration. Any other
    law refuses it."""
    estimator: str
    """``"auto"``: exact where it can be, sampled with curved obstacles; the default. The law ``"depth"`` is measured without lines under every
    estimator. ``"exact"``: for straight-sided meshes and flat-sided obstacles. ``"fibers"``: sampled, for any
    shape."""
    pattern: str
    """``"lines"``: families of parallel lines. ``"isotropic"``: short segments, as in the paper."""
    weights: str
    """``"balance"``: least noise. ``"consistent"``: the force is the gradient of the estimated energy."""
    spacing: float
    """Distance between neighbouring lines (length); 0: chosen from the size of the facets in contact."""
    fiber_length: float
    """Length of an isotropic fiber; 0: the mean size of the facets in contact."""
    fiber_count: int
    """Approximate number of fibers per pair; 0: chosen from the facets in contact. Excludes ``spacing``."""
    seed: int
    """Seed of the random shift of the pattern; 0."""
    momentum_correction: bool
    """Whether the forces are corrected so that their sum and moment vanish; True."""
    self_contact: bool
    """Whether self-contact, the overlap of each body with itself, is evaluated; False."""
    friction_coefficient: float
    """Coefficient of Coulomb friction of all pairs that have none of their own; 0. With it, steps are begun and committed
    (``FrictionSteps.begin_step``), and the tangent is unsymmetric."""
    friction_stiffness: float
    """Tangential stiffness of the stick, a pressure per length; 0: the stiffness of the law at a first touch, which
    ``"volume"`` does not have."""
    cohesion: float
    """Shear traction that is transmitted without pressure wherever there is contact; 0."""
    shear_limit: float
    """Largest shear traction; 0: no limit."""
    memoryless_slip: float
    """Slip of a step from which on friction without memory acts in full: a speed times the time step, say. Smooth, and nothing is
    carried from one step to the next, so that what should stick creeps. 0: friction with memory. Not together with
    ``friction_stiffness``."""
    axisymmetric: bool
    """Axisymmetry, in 2D: coordinates are (r, z) with r >= 0, and volumes, areas, energies and forces are those of whole
    rings; False. Not with friction."""
    check_cells: bool
    """Whether every evaluation checks the orientation of every cell; True."""
    threads: int
    """Number of threads, at least 1; 1. The result does not depend on it."""
    index_base: int
    """Number of the first node, 0 or 1; 0. Node numbers are counted from it, in messages too."""


def _text(key: str, value: object) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, (Integral, np.bool_)):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    raise TypeError(f"option '{key}' is a {type(value).__name__}, a number or a name is wanted")


def defaults() -> fmc_options:
    """The library's own defaults."""
    options = fmc_options()
    check(library.fmc_options_init(byref(options)))
    return options


def changed(options: fmc_options, changes: Mapping[str, object]) -> fmc_options:
    """A copy with some options changed. Raises ``UnknownOptionError`` for an unknown name or value."""
    copy = fmc_options.from_buffer_copy(options)
    for key, value in changes.items():
        check(library.fmc_options_set(byref(copy), key.encode(), _text(key, value).encode()))
    return copy


def described(options: fmc_options) -> dict[str, object]:
    """The options as they would be given by keywords."""
    values = {name: getattr(options, name) for name, *_ in fmc_options._fields_ if name not in _HIDDEN}
    values.update({key: names[values[key]] for key, names in CHOICES.items()})
    values.update({key: bool(values[key]) for key in _SWITCHES})
    return values
