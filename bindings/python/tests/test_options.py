"""Every option by its keyword."""

import re
from pathlib import Path
from typing import get_type_hints

import numpy as np
import pytest
from fmc_contact import Contact, Options, contact_force, suggest_stiffness
from fmc_contact.errors import BadValueError, NotPositiveError, UnknownOptionError
from fmc_contact.options import CHOICES, changed, defaults, described
from scenes import K, same_bits

HEADER = Path(__file__).parents[3] / "include" / "fmc_contact.h"

CHANGES = {
    "stiffness": 5.0,
    "law": "fiber",
    "exponent": 2.5,
    "smoothing_length": 0.25,
    "estimator": "exact",
    "pattern": "isotropic",
    "weights": "consistent",
    "spacing": 0.125,
    "fiber_length": 0.5,
    "fiber_count": 1000,
    "seed": 2**64 - 1,
    "momentum_correction": False,
    "self_contact": True,
    "check_cells": False,
    "axisymmetric": True,
    "friction_coefficient": 0.25,
    "friction_stiffness": 3.0,
    "cohesion": 0.5,
    "shear_limit": 7.0,
    "memoryless_slip": 0.125,
    "static_coefficient": 0.5,
    "weakening_slip": 1e-3,
    "weld": 1e-6,
    "threads": 3,
    "index_base": 1,
}


def test_there_is_a_keyword_for_every_option():
    assert set(CHANGES) == set(described(defaults())) == set(get_type_hints(Options))


def test_defaults_are_those_that_the_header_tells():
    text = HEADER.read_text()
    for key, names in CHOICES.items():
        said = re.search(rf"A value of `fmc_{key}`. Default `FMC_{key.upper()}_(\w+)`", text).group(1)
        assert described(defaults())[key] == said.lower() and said.lower() in names.values()


@pytest.mark.parametrize("key", CHANGES)
def test_every_keyword_sets_its_option_and_no_other(key):
    # From another law than the one that is set, whatever the default.
    before = changed(defaults(), {"law": "volume"})
    after = described(changed(before, {key: CHANGES[key]}))
    assert after[key] == CHANGES[key] and type(after[key]) is type(CHANGES[key])
    assert {k: v for k, v in after.items() if k != key} == {k: v for k, v in described(before).items() if k != key}


def test_numbers_of_numpy_are_numbers():
    numbers = {"stiffness": np.float32(0.5), "seed": np.int64(4), "momentum_correction": np.bool_(0)}
    options = described(changed(defaults(), numbers))
    assert (options["stiffness"], options["seed"], options["momentum_correction"]) == (0.5, 4, False)


@pytest.mark.parametrize("value", [0.1, 1e-300, 1.7976931348623157e308, 1 / 3])
def test_numbers_arrive_to_the_last_bit(value):
    assert described(changed(defaults(), {"stiffness": value}))["stiffness"] == value


def test_what_is_no_option_is_refused(squares):
    coords, conn = squares
    with pytest.raises(UnknownOptionError, match="no option 'stifness'; there are stiffness, "):
        contact_force(coords, conn, "quad", stiffness=K, stifness=2)
    with pytest.raises(BadValueError, match="'estimator' has no value 'exakt': expected fibers or exact or auto"):
        contact_force(coords, conn, "quad", stiffness=K, estimator="exakt")
    with pytest.raises(BadValueError, match="'fiber_count' has no value '10.5': expected a whole number"):
        contact_force(coords, conn, "quad", stiffness=K, fiber_count=10.5)
    with pytest.raises(TypeError, match="option 'spacing' is a list"):
        contact_force(coords, conn, "quad", stiffness=K, spacing=[0.1])
    with pytest.raises(TypeError, match="stiffness"):
        contact_force(coords, conn, "quad")


def test_options_that_are_changed_count_from_then_on(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="volume", estimator="exact")
    before = contact.evaluate(coords)
    contact.set_options(stiffness=2 * K)
    after = contact.evaluate(coords)
    assert same_bits(after.forces, 2 * before.forces) and contact.options["estimator"] == "exact"
    with pytest.raises(NotPositiveError, match="'stiffness' is -1"):
        contact.set_options(stiffness=-1)
    assert contact.options["stiffness"] == 2 * K and same_bits(contact.evaluate(coords).forces, after.forces)


def evaluated(squares, **options):
    coords, conn = squares
    return contact_force(coords, conn, "quad", **{"stiffness": K, "law": "volume", "estimator": "fibers", **options})


def test_what_each_option_does(squares):
    plain = evaluated(squares)
    # w = k V^m, here of an overlap of 0.08.
    assert evaluated(squares, exponent=2, estimator="exact").energy == pytest.approx(K * 0.08**2)
    # psi(L) = k (sqrt(L^2 + e^2) - e) over the height 0.8, L = 0.1.
    smooth = evaluated(squares, law="fiber", smoothing_length=0.1, estimator="exact")
    assert smooth.energy == pytest.approx(0.8 * K * (np.sqrt(0.02) - 0.1))
    finer = evaluated(squares, spacing=plain.pairs[0].spacing / 4)
    assert finer.fiber_count == pytest.approx(4 * plain.fiber_count, rel=0.1)
    assert evaluated(squares, fiber_count=10 * plain.fiber_count).fiber_count > 5 * plain.fiber_count
    assert not same_bits(evaluated(squares, seed=1).forces, plain.forces)
    isotropic = evaluated(squares, pattern="isotropic", fiber_count=20000, fiber_length=0.2)
    assert isotropic.volume == pytest.approx(0.08, rel=0.1)
    assert not same_bits(evaluated(squares, weights="consistent").forces, plain.forces)
    assert np.abs(plain.forces.sum(0)).max() < 1e-9
    assert not same_bits(evaluated(squares, momentum_correction=False).forces, plain.forces)
    assert same_bits(evaluated(squares, threads=2).forces, plain.forces)
    coords, conn = squares
    assert same_bits(evaluated((coords, conn + 1), index_base=1).forces, plain.forces)


def test_cells_are_not_checked_where_nobody_asks_for_it(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, law="volume", check_cells=False)
    inverted = coords.copy()
    inverted[0] = 0.8, 0.8
    contact.evaluate(inverted)


def test_a_body_overlaps_itself_where_it_is_looked_for():
    # Three squares in a chain, the third back over the first: one body by the numbers given.
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5], [1.5, 0.5], [1.5, 1.5], [0.5, 1.5]], float)
    options = {"stiffness": K, "law": "volume", "bodies": [0, 0]}
    squares = np.arange(8).reshape(2, 4)
    assert contact_force(coords, squares, "quad", **options).volume == 0
    folded = contact_force(coords, squares, "quad", self_contact=True, **options)
    assert folded.volume == pytest.approx(0.25, rel=0.02) and folded.pairs[0].a == folded.pairs[0].b


def test_stiffness_is_suggested():
    assert suggest_stiffness(1e6, 10.0) == 1e6 == suggest_stiffness(1e6, 10.0, law="fiber")
    # The traction m k V^(m - 1) is the modulus, at an overlap a tenth of a cell deep.
    assert suggest_stiffness(1e9, 0.1, law="volume") == 1e9
    assert suggest_stiffness(1e9, 0.1, law="volume", dim=2, exponent=2) == pytest.approx(1e9 / (2 * 0.001))
    with pytest.raises(NotPositiveError, match="'cell_size' is 0"):
        suggest_stiffness(1e6, 0)
    with pytest.raises(NotPositiveError, match="'modulus' is -1"):
        suggest_stiffness(-1, 0.1)
    with pytest.raises(BadValueError, match="option 'law' has no value -1"):
        suggest_stiffness(1e9, 0.1, law="depht")


def test_options_in_force_have_the_stiffness_of_now(squares):
    coords, conn = squares
    contact = Contact(coords, conn, "quad", stiffness=K, index_base=0, cohesion=2.0)
    contact.stiffen(3.0)
    assert contact.options["stiffness"] == 3.0 * K and contact.options["cohesion"] == 2.0
    contact.set_options(stiffness=5.0)
    assert contact.options["stiffness"] == 5.0
