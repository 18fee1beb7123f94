"""Friction by your own law, from Python."""

import gc

import numpy as np
import pytest
from fmc_contact import Contact, FmcError, FrictionResponse, check_friction_law, errors, find_equilibrium
from test_search_with_friction import MU, K, another, block  # noqa: F401

PAIR = (0, ("obstacle", 0))


def coulomb(facets):
    return MU * facets.pressure, np.full(len(facets), MU)


def capped(most):
    """The shear that a metal bears: min(μ p, most)."""

    def law(facets):
        limit = np.minimum(MU * facets.pressure, most)
        return limit, np.where(limit < most, MU, 0.0)

    return law


def film(viscosity, yielding=0.0):
    """τ = τ₀ + η v."""

    def law(facets):
        size = np.linalg.norm(facets.slip, axis=1)
        along = facets.slip / np.where(size > 0, size, 1.0)[:, None]
        return FrictionResponse(yielding + viscosity * size / facets.time_step, np.zeros(len(facets)), viscosity / facets.time_step * along)

    return law


def by_law(coords, law, **other):
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=K)
    contact.obstacles.add_half_space([0, 0], [0, 1])
    contact.pairs.set(*PAIR, friction_law=law, **other)
    return contact


SQUARE = np.array([[0.0, -1e-3], [1.0, -1e-3], [1.0, 1.0], [0.0, 1.0]])


def friction_of(contact, coords):
    return -contact.evaluate(coords).forces[:, 0].sum()


def test_the_coefficient_by_a_law_is_that_of_the_library_also_in_a_search(block):  # noqa: F811
    coords, library, host = block
    own, x = by_law(coords, coulomb), [coords, coords]
    for contact in (library, own):
        contact.friction.begin_step(coords)
    for push in (0.0, 0.1, 0.25, 0.0, -0.2, 0.1):
        found = [find_equilibrium(host(push), contact, at, range(8)) for contact, at in zip((library, own), x)]
        # The same searches, to rounding.
        assert found[0].x == pytest.approx(found[1].x, abs=1e-12) and found[0].iterations == found[1].iterations
        x = [one.x for one in found]
        for contact, at in zip((library, own), x):
            contact.friction.commit_step(at)


def test_a_search_slides_at_the_speed_of_the_film(block):  # noqa: F811
    coords, _, host = block
    own, time_step = by_law(coords, film(2.0, 0.05)), 0.1
    own.cohesive.set_time_step(time_step)
    own.friction.begin_step(coords)
    x = find_equilibrium(host(0.0), own, coords, range(8)).x
    own.friction.commit_step(x)
    speeds = []
    for _ in range(4):
        found = find_equilibrium(host(0.25), own, x, range(8))
        speeds.append((found.x - x)[:, 0].mean() / time_step)
        own.friction.commit_step(found.x)
        x = found.x
    # 0.25 = 0.05 + 2 v on a side that is nearly of length 1; the first step stretches the stick too.
    assert speeds[2:] == pytest.approx([0.1, 0.1], rel=2e-3), speeds


@pytest.mark.parametrize("time_step", [1.0, 0.01])
def test_a_search_finds_the_speed_beyond_the_dip_of_a_curve(block, time_step):  # noqa: F811
    """μ(v) = 0.1 + 0.2 exp(−2 v) + 0.3 v falls before it rises: beyond the largest friction at rest there is one speed."""

    def stribeck(facets):
        size = np.linalg.norm(facets.slip, axis=1)
        along, v = facets.slip / np.where(size > 0, size, 1.0)[:, None], size / facets.time_step
        mu, slope = 0.1 + 0.2 * np.exp(-2 * v) + 0.3 * v, 0.3 - 0.4 * np.exp(-2 * v)
        return mu * facets.pressure, mu, (slope * facets.pressure / facets.time_step)[:, None] * along

    coords, _, host = block
    own = by_law(coords, stribeck)
    own.cohesive.set_time_step(time_step)
    own.friction.begin_step(coords)
    x = find_equilibrium(host(0.0), own, coords, range(8)).x
    own.friction.commit_step(x)
    for _ in range(3):
        found = find_equilibrium(host(0.35), own, x, range(8))
        speed = (found.x - x)[:, 0].mean() / time_step
        own.friction.commit_step(found.x)
        x = found.x
    # Walls that lean a little bear a few ten thousandths.
    assert 0.1 + 0.2 * np.exp(-2 * speed) + 0.3 * speed == pytest.approx(0.35, rel=1e-3), speed


def test_a_cap_holds_and_the_check_knows_its_corner():
    own = by_law(SQUARE, capped(0.2))
    own.friction.begin_step(SQUARE)
    assert friction_of(own, SQUARE + [0.1, 0.0]) == pytest.approx(min(MU * K * 1e-3, 0.2), rel=1e-12)
    assert not any("WRONG" in text for text in check_friction_law(capped(0.2), 3, 1.0, 1.0))
    assert not any("WRONG" in text for text in check_friction_law(film(2.0), 3, 1.0, 1.0, time_step=0.1))


def test_a_wrong_derivative_is_told_with_place_and_sizes():
    wrong = lambda facets: (facets.pressure**2, facets.pressure)
    warm = lambda facets: (facets.fields[:, 0, 0] * facets.pressure, facets.fields[:, 0, 0])
    assert not any("WRONG" in text for text in check_friction_law(warm, 3, 1.0, 1.0, fields=[0.3]))
    text = next(text for text in check_friction_law(wrong, 2, 1.0, 1.0) if "WRONG" in text)
    assert "the derivative of the limit by the pressure is given as" in text and "at a pressure of" in text, text


def test_history_is_committed_restarted_and_counted():
    def counting(facets):
        limit, by_pressure = coulomb(facets)
        return limit * (1 + 0.1 * facets.history[:, 0]), by_pressure * (1 + 0.1 * facets.history[:, 0]), None, facets.history + 1

    contact = by_law(SQUARE, counting, history=1)
    contact.friction.begin_step(SQUARE)
    first = SQUARE + [0.1, 0.0]
    found = friction_of(contact, first)
    contact.friction.commit_step(first)
    assert np.array_equal(contact.friction.history, np.ones(len(contact.friction.slip)))
    then = SQUARE + [0.2, 0.0]
    assert friction_of(contact, then) == pytest.approx(1.1 * found, rel=1e-12)
    other = by_law(SQUARE, counting, history=1)
    other.friction.begin_step(first)
    other.friction.slip, other.friction.history = contact.friction.slip, contact.friction.history
    assert friction_of(other, then) == friction_of(contact, then)
    with pytest.raises(errors.LengthError):
        other.friction.history = [1.0] * 99


def test_fields_come_from_the_nodes():
    seen = []

    def warm(facets):
        seen.append(facets)
        coefficient = 0.5 - 0.001 * facets.fields[:, 0, 0]
        return coefficient * facets.pressure, coefficient

    contact = by_law(SQUARE, warm)
    contact.laws.set_fields([100.0, 300.0, 0.0, 0.0])
    contact.friction.begin_step(SQUARE)
    assert friction_of(contact, SQUARE + [0.1, 0.0]) == pytest.approx(0.3 * K * 1e-3, rel=1e-12)
    last = seen[-1]
    assert last.partners == (("body", 0), ("obstacle", 0)) and np.isnan(last.fields[:, 1]).all()
    assert last.axes.shape == (len(last), 1, 2) and last.slip[0] == pytest.approx(0.1 * last.axes[0, 0, 0], rel=1e-12)


def test_what_a_law_raises_comes_out_and_leaves_the_contact_as_it_was():
    fault = [None]

    def law(facets):
        if isinstance(fault[0], Exception):
            raise fault[0]
        limit, by_pressure = coulomb(facets)
        return fault[0](limit, by_pressure) if fault[0] else (limit, by_pressure)

    contact = by_law(SQUARE, law)
    contact.friction.begin_step(SQUARE)
    coords = SQUARE + [0.1, 0.0]
    before = friction_of(contact, coords)
    for wanted, kind, text in [
        (KeyError("molten"), KeyError, "molten"),
        (lambda limit, by: (limit * np.nan, by), errors.InterfaceLawError, "body 0 and obstacle 0, at facet"),
        (lambda limit, by: (limit - 1e9, by), errors.InterfaceLawError, "number 0 of the limit is -"),
        (lambda limit, by: (limit, by, np.zeros(77)), FmcError, "by_slip"),
        (lambda limit, by: limit, TypeError, "a law of friction returned a"),
    ]:
        fault[0] = wanted
        with pytest.raises((kind, ValueError)) as raised:
            contact.evaluate(coords)
        assert text in str(raised.value), raised.value
    fault[0] = None
    assert friction_of(contact, coords) == before


def test_what_cannot_be_is_refused():
    contact = by_law(SQUARE, coulomb)
    with pytest.raises(errors.UnsupportedError, match="together with your own law of friction"):
        contact.pairs.set(*PAIR, friction_law=coulomb, friction_coefficient=0.3)
    with pytest.raises(errors.UnsupportedError, match="rough"):
        contact.pairs.set(*PAIR, friction_law=coulomb, interface="rough")
    with pytest.raises(TypeError, match="expected a function of the facets"):
        contact.pairs.set(*PAIR, friction_law=3.0)
    with pytest.raises(ValueError, match="history"):
        contact.pairs.set(*PAIR, friction_law=coulomb, history=-1)
    with pytest.raises(ValueError, match="transverse_coefficient"):
        contact.pairs.set(*PAIR, friction_law=coulomb, transverse_coefficient=0.1, direction=(1, 0, 0))
    with pytest.raises(errors.UnsupportedError, match="wear coefficient together with your own law of friction"):
        contact.pairs.set_wear(*PAIR, 1e-6, 0.0)
    contact.pairs.reset(*PAIR)
    contact.pairs.set_wear(*PAIR, 1e-6, 0.0)
    with pytest.raises(errors.UnsupportedError, match="wear coefficient together with your own law of friction"):
        contact.pairs.set(*PAIR, friction_law=coulomb)
    contact.pairs.set_wear(*PAIR, 0.0, 0.0)
    assert friction_of(contact, SQUARE + [0.1, 0.0]) == 0


def test_a_law_lives_as_long_as_its_pair():
    contact = by_law(SQUARE, lambda facets: coulomb(facets))
    gc.collect()
    contact.friction.begin_step(SQUARE)
    assert friction_of(contact, SQUARE + [0.1, 0.0]) == pytest.approx(MU * K * 1e-3, rel=1e-12)
