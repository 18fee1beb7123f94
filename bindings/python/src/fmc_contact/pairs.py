"""Options of single pairs: excluded, or with a separate law."""

from __future__ import annotations

from collections.abc import Iterable
from ctypes import byref
from typing import Any, Optional, Union

import numpy as np

from ._constants import (
    FMC_INTERFACE,
    FMC_LAW,
    FMC_PAIR_FRICTION_OF_CONTEXT,
    FMC_PAIR_LAW_OF_CONTEXT,
    FMC_PARTNER,
    FMC_SOFTENING,
)
from ._core import Core
from ._index import index_of, integer
from ._library import check, library
from ._structs import fmc_orthotropic_friction, fmc_pair_options, fmc_ppr, fmc_tie
from .friction_laws import FrictionLaw, friction_law_struct
from .laws import InterfaceLaw, law_struct
from .ties import Tie

Partner = Union[int, tuple[str, int]]
"""A body by its number among ``Result.bodies``, or ``("body", number)`` or ``("obstacle", number)``, as in
``Pair.a``."""

_SIDES = ("a", "b")
_OF_LAW = ("stiffness", "exponent", "smoothing_length")
_OF_COHESIVE = ("normal_strength", "shear_strength", "normal_energy", "shear_energy", "mixed_mode_exponent", "viscosity")
_OF_PPR = ("normal_shape", "shear_shape", "normal_slope", "shear_slope")


def _named(partner: Partner) -> tuple[int, int]:
    kind, index = partner if isinstance(partner, tuple) else ("body", partner)
    numbers = {name: number for number, name in FMC_PARTNER.items()}
    if kind not in numbers:
        raise ValueError(f"no partner '{kind}', expected body or obstacle")
    return numbers[kind], index_of(kind, index)


def _two(surfaces: Any) -> tuple[int, int]:
    """Numbers of two named parts of surfaces."""
    found = [integer(surface) for surface in surfaces] if isinstance(surfaces, Iterable) else []
    if len(found) != 2 or found[0] is None or found[1] is None:
        raise TypeError(f"surfaces is {surfaces!r}, expected two numbers of add_surface")
    a, b = found[0], found[1]
    if not (0 <= a < 1 << 31 and 0 <= b < 1 << 31):
        raise ValueError(f"surfaces is {surfaces!r}, and add_surface has given no such number")
    return a, b


def _orthotropic(across: Optional[float], direction: Optional[Iterable[float]], direction_of: str) -> Optional[fmc_orthotropic_friction]:
    """Friction along a direction, as it was set."""
    if direction_of not in _SIDES:
        raise ValueError(f"option 'direction_of' has no value '{direction_of}', expected a or b")
    if across is None and direction is None:
        return None
    if across is None or direction is None:
        raise ValueError("transverse_coefficient and direction go together")
    numbers = [float(x) for x in direction]
    if len(numbers) != 3:
        raise ValueError(f"direction has {len(numbers)} numbers, expected 3")
    friction = fmc_orthotropic_friction()
    check(library.fmc_orthotropic_friction_init(byref(friction)))
    friction.transverse_coefficient, friction.direction_of = float(across), _SIDES.index(direction_of)
    friction.direction[:] = numbers
    return friction


class Pairs:
    """Options of single pairs: a pair is excluded, or has a separate law.

    A partner is a body by its number among ``Result.bodies``, or ``("body", number)`` or ``("obstacle", number)``. The order of the
    two does not matter. After an error the options are as they were.

    Examples
    --------
    >>> contact.pairs.set(0, 1, stiffness=500.0)
    >>> contact.pairs.options(0, 1)["law"]
    'depth'
    >>> contact.pairs.reset(0, 1)
    """

    def __init__(self, core: Core) -> None:
        self._core = core

    def set(
        self,
        a: Partner,
        b: Partner,
        *,
        law: Optional[Union[str, InterfaceLaw]] = None,
        stiffness: Optional[float] = None,
        exponent: Optional[float] = None,
        smoothing_length: Optional[float] = None,
        friction_coefficient: Optional[float] = None,
        static_coefficient: float = 0.0,
        weakening_slip: float = 0.0,
        gap_offset: float = 0.0,
        excluded: bool = False,
        interface: str = "contact",
        reach: float = 0.0,
        normal_strength: float = 0.0,
        shear_strength: float = 0.0,
        normal_energy: float = 0.0,
        shear_energy: float = 0.0,
        mixed_mode_exponent: float = 0.0,
        softening: str = "linear",
        viscosity: float = 0.0,
        surfaces: Optional[tuple[int, int]] = None,
        transverse_coefficient: Optional[float] = None,
        direction: Optional[Iterable[float]] = None,
        direction_of: str = "a",
        normal_shape: Optional[float] = None,
        shear_shape: Optional[float] = None,
        normal_slope: Optional[float] = None,
        shear_slope: Optional[float] = None,
        history: int = 0,
        friction_law: Optional[FrictionLaw] = None,
    ) -> None:
        """Sets the options of a pair, and replaces earlier ones.

        A body with itself (``a == b``) is evaluated against itself if this is called without ``excluded``, whatever the option ``self_contact``.

        Parameters
        ----------
        a, b : int or tuple
            The partners.
        law : str or callable, optional
            Law of the pair, as in ``Options``. Default: the law of the contact, also after it changes. With ``interface="law"`` your own law,
            a function of ``LawPoints`` that returns a ``LawResponse``. Default then: the one that the pair has; its points begin with a
            history of 0 again.
        stiffness : float, optional
            Stiffness of the pair. Alone, it applies with the current law of the contact. Of a cohesive interface: the traction by opening
            without damage, and in compression. By default so much that damage begins at a hundredth of the opening at which a linear softening
            ends.
        exponent, smoothing_length : float, optional
            Of the laws ``"volume"`` and ``"fiber"``, as in ``Options``.
        friction_coefficient : float, optional
            Coefficient of the pair, which may be infinite: it then never slides. All other options of its friction come from the contact, except
            friction at rest. For a cohesive interface: coefficient of the broken part under pressure.
        static_coefficient, weakening_slip : float
            Friction of the pair at rest, as in ``Options``. Default: as for the contact, or none with a ``friction_coefficient``.
        gap_offset : float
            Distance (length) at which contact begins. Penetration, gap and pressure are counted from there. The surface of an
            obstacle is taken to lie so much further out, as with a shell's thickness or a coating. A negative offset is a
            clearance. Half-spaces, balls and capsules keep their shape, and so do cylinders with a clearance. Any other shape
            becomes its signed distance minus the offset, with rounded edges; the estimator ``"exact"`` then supports the law
            ``"depth"`` only. Between bodies the law must be ``"depth"`` and the offset not positive: each body may enter by
            ``-gap_offset`` before it presses.
        excluded : bool
            Whether the pair is not evaluated at all; with ``surfaces``, whether these parts alone are held, and no other face is in
            contact.
        interface : str
            ``"contact"``, or ``"tied"``: two bodies go together where their undeformed faces lie opposite each other, and are in no
            contact anywhere. See ``tie``. ``"cohesive"``: they are held together there until they break. See ``contact.cohesive``.
            ``"no_separation"``: they slide on each other there without friction, and do not separate. ``friction.begin_step``,
            ``friction.commit_step`` and updates of multipliers search again for the points that face each other. ``"rough"``: contact that never
            slides where it is closed. ``"law"``: they are held together by your own law. See ``contact.laws``.
        reach : float
            Of bodies that are tied, held together or slide without separation: the largest gap or overlap between faces that belong together
            (length). A gap stays as it is. 0: a tenth of the mean facet of the body with the larger facets, including all its faces.
        normal_strength, shear_strength : float
            Of a cohesive interface: the tractions at which damage begins in pure opening and in pure sliding. The value for sliding is by default
            equal to the value for opening.
        normal_energy, shear_energy : float
            Energy per area that pure opening and pure sliding take until the interface is broken. The value for sliding is by default equal to the
            value for opening.
        mixed_mode_exponent : float
            Exponent, at least 1, by which the two are mixed (Benzeggagh and Kenane). 0: 2.
        softening : str
            How the traction falls: ``"linear"`` or ``"exponential"``. ``"ppr"``: it rises and falls by the potential of Park, Paulino and Roesler,
            without ``stiffness``, ``mixed_mode_exponent`` or ``viscosity``.
        viscosity : float
            A time by which damage lags behind the law, so that searches pass where a structure snaps. Set the duration of steps with
            ``contact.cohesive.set_time_step``.
        surfaces : tuple of int, optional
            With ``"tied"``, ``"cohesive"`` and ``"no_separation"``: the parts of the surfaces of ``a`` and ``b`` that belong together, as
            numbers of ``contact.mesh.add_surface``. All other faces of the two bodies are in contact, by the law ``"depth"``.
            Default: all faces may belong together, and no others are in contact.
        transverse_coefficient : float, optional
            Coefficient of friction across ``direction``, in 3D. Along it the coefficient is ``friction_coefficient``. Default: the
            same in all directions.
        direction : sequence of float, optional
            The direction, with ``transverse_coefficient``: 3 numbers, of any length but 0. It is given for the body without deformation, or in
            the frame of the obstacle, is projected into every facet, and moves along as the facet deforms and turns.
        direction_of : str
            To which partner the direction belongs: ``"a"`` or ``"b"``.
        normal_shape, shear_shape : float, optional
            With ``softening="ppr"``: shapes α and β, above 1. Below 2 the traction falls late, above it early with a long tail. Default: 2.
        normal_slope, shear_slope : float, optional
            With ``softening="ppr"``: the opening or sliding at the strength, divided by the one at which the traction ends. Above 0, and
            at most 1/√(2 shape − 1). Default: 0.05.
        history : int
            With your own law: number of values that each point, or facet, keeps from step to step. They begin with 0, also where a law is set
            again.
        friction_law : callable, optional
            Your own law of friction, in place of coefficients, ``cohesion`` and ``shear_limit``: a function of ``FrictionFacets`` that returns
            a ``FrictionResponse``, with the tractions at which facets slide. Options of the pair that are set later take it back.

        Raises
        ------
        BodyOutOfRangeError, ObstacleOutOfRangeError
            If there is no such partner.
        TypeError
            If the number of a body or an obstacle is no integer.
        NotPositiveError
            If a value is not positive.
        BadValueError, OptionsConflictError
            If a value is unknown, or would have no effect.
        UnsupportedError
            For two obstacles, for a law that the estimator does not support, for a gap offset or a tie that cannot be, and for a pair
            that wears and could not with these options.
        UntiedError
            If bodies that are tied, or joined by a cohesive interface, lie opposite each other nowhere within reach.

        Examples
        --------
        >>> contact.pairs.set(0, 1, excluded=True)
        >>> contact.evaluate(coords).energy
        0.0
        """
        law_values = {"stiffness": stiffness, "exponent": exponent, "smoothing_length": smoothing_length}
        own_law = None if law is None or isinstance(law, str) else law
        if (own_law is not None or (history != 0 and friction_law is None)) and interface != "law":
            raise ValueError(f"{'law' if own_law is not None else 'history'} of your own belongs to the interface 'law', not to '{interface}'")
        if history != 0 and own_law is None and friction_law is None:
            raise ValueError(f"history is {history}, and no law is given that keeps it: give 'law', too")
        own = fmc_pair_options()
        check(library.fmc_pair_options_init(byref(own)))
        own.excluded, own.gap_offset = bool(excluded), float(gap_offset)
        interfaces = {name: number for number, name in FMC_INTERFACE.items()}
        if interface not in interfaces:
            raise ValueError(f"option 'interface' has no value '{interface}', expected {' or '.join(interfaces)}")
        own.interface_kind, own.reach = interfaces[interface], float(reach)
        softenings = {name: number for number, name in FMC_SOFTENING.items()}
        if softening not in softenings:
            raise ValueError(f"option 'softening' has no value '{softening}', expected {' or '.join(softenings)}")
        own.softening, own.mixed_mode_exponent = softenings[softening], float(mixed_mode_exponent)
        own.viscosity = float(viscosity)
        own.normal_strength, own.shear_strength = float(normal_strength), float(shear_strength)
        own.normal_energy, own.shear_energy = float(normal_energy), float(shear_energy)
        own.static_coefficient, own.weakening_slip = float(static_coefficient), float(weakening_slip)
        if surfaces is not None:
            own.surface_a, own.surface_b = _two(surfaces)
        if friction_coefficient is not None:
            # The number by which the C interface says: that of the contact.
            if float(friction_coefficient) == FMC_PAIR_FRICTION_OF_CONTEXT:
                raise ValueError(f"friction_coefficient is {friction_coefficient}, expected at least 0")
            own.friction_coefficient = float(friction_coefficient)
        if isinstance(law, str):
            numbers = {name: number for number, name in FMC_LAW.items()}
            if law not in numbers:
                raise ValueError(f"option 'law' has no value '{law}', expected {' or '.join(numbers)}")
            own.law = numbers[law]
        elif stiffness is not None and interface not in ("cohesive", "law"):
            own.law = self._core.options.law
            law_values = {key: getattr(self._core.options, key) if value is None else value for key, value in law_values.items()}
        for key, value in law_values.items():
            if value is not None:
                setattr(own, key, float(value))
        friction = _orthotropic(transverse_coefficient, direction, direction_of)
        shapes = dict(zip(_OF_PPR, (normal_shape, shear_shape, normal_slope, shear_slope)))
        shapes = {key: float(value) for key, value in shapes.items() if value is not None}
        if own_law is not None:
            if shapes or friction is not None or friction_law is not None:
                raise ValueError("an interface by your own law takes neither shapes nor friction")
            return self._set_law(a, b, own, own_law, history)
        if friction_law is not None:
            if shapes or friction is not None:
                raise ValueError("a pair with your own law of friction takes neither shapes nor a transverse_coefficient")
            return self._set_friction_law(a, b, own, friction_law, history)
        if shapes and friction is not None:
            raise ValueError(f"{next(iter(shapes))} and transverse_coefficient of one pair: the broken part has one coefficient of friction")
        if shapes:
            ppr = fmc_ppr()
            check(library.fmc_ppr_init(byref(ppr)))
            for key, value in shapes.items():
                setattr(ppr, key, value)
            with self._core.handle:
                return self._core.handle.call(library.fmc_context_set_ppr_pair, *_named(a), *_named(b), byref(own), byref(ppr))
        if friction is None:
            return self._set(a, b, byref(own))
        with self._core.handle:
            call = library.fmc_context_set_orthotropic_pair
            self._core.handle.call(call, *_named(a), *_named(b), byref(own), byref(friction))

    def reset(self, a: Partner, b: Partner) -> None:
        """Takes the options of a pair back: it follows the options of the contact again.

        Parameters
        ----------
        a, b : int or tuple
            The partners.

        Raises
        ------
        BodyOutOfRangeError, ObstacleOutOfRangeError
            If there is no such partner.

        Examples
        --------
        >>> contact.pairs.reset(0, 1)
        """
        self._set(a, b, None)

    def _set_law(self, a: Partner, b: Partner, options: fmc_pair_options, law: InterfaceLaw, history: int) -> None:
        handle, sides = self._core.handle, (_named(a), _named(b))
        struct, callback = law_struct(law, history, handle.guarded)
        with handle:
            handle.call(library.fmc_context_set_law_pair, *sides[0], *sides[1], byref(options), byref(struct))
        # Until the pair has another law: other options may keep this one.
        handle.keep(("law", *sorted(sides)), callback)

    def _set_friction_law(self, a: Partner, b: Partner, options: fmc_pair_options, law: FrictionLaw, history: int) -> None:
        handle, sides = self._core.handle, (_named(a), _named(b))
        struct, callback = friction_law_struct(law, history, handle.guarded)
        with handle:
            handle.call(library.fmc_context_set_friction_law_pair, *sides[0], *sides[1], byref(options), byref(struct))
        handle.keep(("friction_law", *sorted(sides)), callback)

    def _set(self, a: Partner, b: Partner, options: Any) -> None:
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_pair_options, *_named(a), *_named(b), options)

    def options(self, a: Partner, b: Partner) -> dict[str, Any]:
        """The options of a pair; without separate options the ones that apply to it.

        Parameters
        ----------
        a, b : int or tuple
            The partners.

        Returns
        -------
        dict
            The keywords of ``set``. ``None`` where the value is taken from the contact.

        Raises
        ------
        BodyOutOfRangeError, ObstacleOutOfRangeError
            If there is no such partner.

        Examples
        --------
        >>> contact.pairs.options(0, 1)["excluded"]
        False
        """
        found = fmc_pair_options()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_pair_options, *_named(a), *_named(b), byref(found))
            friction = fmc_orthotropic_friction()
            self._core.handle.call(library.fmc_context_orthotropic_pair, *_named(a), *_named(b), byref(friction))
            ppr = fmc_ppr()
            self._core.handle.call(library.fmc_context_ppr_pair, *_named(a), *_named(b), byref(ppr))
        has_law = found.law != FMC_PAIR_LAW_OF_CONTEXT
        has_friction = found.friction_coefficient != FMC_PAIR_FRICTION_OF_CONTEXT
        options: dict[str, Any] = {"excluded": bool(found.excluded), "gap_offset": found.gap_offset}
        options["friction_coefficient"] = found.friction_coefficient if has_friction else None
        options.update(static_coefficient=found.static_coefficient, weakening_slip=found.weakening_slip)
        options.update(interface=FMC_INTERFACE[found.interface_kind], reach=found.reach, softening=FMC_SOFTENING[found.softening])
        options.update({key: getattr(found, key) for key in _OF_COHESIVE})
        is_ppr = options["softening"] == "ppr"
        options.update({key: getattr(ppr, key) if is_ppr else None for key in _OF_PPR})
        options["surfaces"] = (found.surface_a, found.surface_b) if found.surface_a else None
        options["law"] = FMC_LAW[found.law] if has_law else None
        options.update({key: getattr(found, key) if has_law else None for key in _OF_LAW})
        if options["interface"] == "cohesive":
            options["stiffness"] = found.stiffness
        direction = tuple(friction.direction)
        is_orthotropic = any(direction)
        options["transverse_coefficient"] = friction.transverse_coefficient if is_orthotropic else None
        options.update(direction=direction if is_orthotropic else None, direction_of=_SIDES[friction.direction_of])
        return options

    def set_wear(self, a: Partner, b: Partner, wear_a: float, wear_b: float = 0.0) -> None:
        """Has a pair wear by Archard's law: a side that slides by ds under the pressure p loses K p ds of its depth.

        Surfaces wear when a step is committed, see ``contact.wear``. All other options of the pair stay, and ``set`` leaves these as they
        are; ``reset`` ends the wear.

        Parameters
        ----------
        a, b : int or tuple
            The partners.
        wear_a, wear_b : float
            K of ``a`` and of ``b``, in 1/pressure: a wear coefficient without unit by the hardness. 0: that side does not wear, as
            obstacles never do.

        Raises
        ------
        BodyOutOfRangeError, ObstacleOutOfRangeError
            If there is no such partner.
        NotPositiveError
            If a number is negative or not finite.
        UnsupportedError
            For wear of an obstacle, of a body with itself, by the law ``"volume"``, of bodies that are held together or never slide, and
            of a mesh in parts.

        Examples
        --------
        >>> contact.pairs.set_wear(0, 1, 1e-3, 2e-3)
        >>> contact.pairs.wear(1, 0)
        (0.002, 0.001)
        """
        with self._core.handle:
            self._core.handle.call(library.fmc_context_set_pair_wear, *_named(a), *_named(b), float(wear_a), float(wear_b))

    def wear(self, a: Partner, b: Partner) -> tuple[float, float]:
        """Wear coefficients of a pair, as set by ``set_wear``.

        Parameters
        ----------
        a, b : int or tuple
            The partners.

        Returns
        -------
        tuple of float
            K of ``a`` and of ``b``, in 1/pressure.

        Raises
        ------
        BodyOutOfRangeError, ObstacleOutOfRangeError
            If there is no such partner.

        Examples
        --------
        >>> contact.pairs.wear(0, 1)
        (0.0, 0.0)
        """
        wear_a, wear_b = np.empty(1), np.empty(1)
        with self._core.handle:
            self._core.handle.call(library.fmc_context_pair_wear, *_named(a), *_named(b), wear_a, wear_b)
        return float(wear_a[0]), float(wear_b[0])

    def tie(self, a: int, b: int) -> Tie:
        """The tie of two bodies, as found without deformation; for bodies that slide without separation, as found last.

        Parameters
        ----------
        a, b : int
            The bodies.

        Returns
        -------
        Tie
            Area, gap and reach of the tie. Its area is 0 where the bodies are not tied.

        Raises
        ------
        BodyOutOfRangeError
            If there is no such body.
        UntiedError
            If other reference coordinates leave no face of the tie.

        Examples
        --------
        >>> contact.pairs.tie(0, 1).area
        0.0
        """
        found = fmc_tie()
        with self._core.handle:
            self._core.handle.call(library.fmc_context_tie, index_of("body", a), index_of("body", b), byref(found))
        return Tie(found.area, found.largest_gap, found.node_count, found.reach)
