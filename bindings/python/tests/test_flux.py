"""Scalar fields through contact."""

import numpy as np
import pytest
from fmc_contact import Conductance, Contact
from fmc_contact.errors import NoStepError, NotPositiveError
from test_ranks import on_ranks


def cells(n, first):
    """Those of a square of n by n."""
    corners = [(i + j * (n + 1), i + 1 + j * (n + 1)) for j in range(n) for i in range(n)]
    return np.array([(a, b, b + n + 1, a + n + 1) for a, b in corners]) + first


CELLS = np.vstack([cells(2, 0), cells(3, 9)])


def squares(gap, **options):
    """A square of four cells below, one of nine above."""
    below, above = ([(a, b) for b in np.linspace(0, 1, n) for a in np.linspace(0, 1, n)] for n in (3, 4))
    coords = np.vstack([below, np.array(above) + [0.0, 1.0 + gap]])
    contact = Contact(coords, CELLS + options.get("index_base", 0), "quad", stiffness=100.0, **options)
    return contact, coords, np.arange(len(coords)) >= len(below)


@pytest.mark.parametrize(("gap", "h"), [(-0.01, 3.0), (-0.03, 5.0), (0.05, 0.75), (0.2, 0.0)])
def test_tables_by_pressure_and_gap(gap, h):
    contact, coords, is_above = squares(gap)
    tables = Conductance(by_pressure=[(0.0, 1.0), (2.0, 5.0)], by_gap=np.array([(0.0, 1.0), (0.1, 0.5)]))
    found = contact.flux(coords, np.where(is_above, 10.0, 4.0), tables)
    assert found.flux[is_above].sum() == pytest.approx(6.0 * h, rel=1e-12)
    assert abs(found.flux.sum()) < 1e-12
    assert found.obstacles.shape == (0,)


def test_multipliers_bear_pressure_without_penetration():
    contact, coords, is_above = squares(-0.01)
    contact.multipliers.augment(coords, 1e-9)
    touching = coords + np.where(is_above[:, None], [0.0, 0.01], 0.0)
    # Away from the walls, below which the depth is less.
    assert contact.nodal_contact(touching).local_pressure.max() == pytest.approx(1.0, rel=1e-3)
    found = contact.flux(touching, np.where(is_above, 10.0, 4.0), Conductance(by_pressure=[(0.0, 1.0), (2.0, 5.0)]))
    assert found.flux[is_above].sum() == pytest.approx(6.0 * 3.0, rel=1e-12)


def test_matrix_is_the_derivative_for_every_field():
    contact, coords, _ = squares(-0.01)
    rng = np.random.default_rng(3)
    fields = rng.normal(size=(3, len(coords)))
    found = contact.flux(coords.T, fields, 2.0)
    assert found.flux.shape == fields.shape
    matrix = found.matrix.toarray()
    np.testing.assert_allclose(found.flux, fields @ matrix, atol=1e-14)
    np.testing.assert_array_equal(matrix, matrix.T)
    assert np.linalg.eigvalsh(matrix).min() > -1e-14
    np.testing.assert_array_equal(contact.flux(coords, np.full(len(coords), 293.15), 2.0).flux, 0.0)


def test_obstacles_have_values_or_take_nothing():
    contact, coords, _ = squares(0.5)
    contact.obstacles.add_half_space((0, 0.02), (0, 1))
    contact.obstacles.add_half_space((0, 9.0), (0, -1))
    fields = np.ones((2, len(coords)))
    found = contact.flux(coords, fields, 4.0, obstacles=[[0.0, 7.0], [3.0, 1.0]])
    np.testing.assert_allclose(found.obstacles, [[-4.0, 0.0], [8.0, 0.0]], atol=1e-13)
    np.testing.assert_allclose(found.flux.sum(axis=1), [4.0, -8.0], atol=1e-13)
    assert len(found.indptr) == len(coords) + 3
    assert found.matrix.shape == (len(coords), len(coords))
    np.testing.assert_array_equal(contact.flux(coords, fields, 4.0).flux, 0.0)


def test_index_base_changes_nothing():
    (contact, coords, _), (based, *_) = squares(-0.01), squares(-0.01, index_base=1)
    one, two = (one.flux(coords, coords[:, 0], 2.0) for one in (contact, based))
    for name in ("flux", "data", "indices", "indptr"):
        np.testing.assert_array_equal(getattr(one, name), getattr(two, name))


def test_heat_of_friction_is_the_dissipation():
    contact, coords, is_above = squares(-0.01, friction_coefficient=0.3)
    moved = coords + np.where(is_above[:, None], [0.1, 0.0], 0.0)
    with pytest.raises(NoStepError, match="no step has begun"):
        contact.friction_heat(moved)
    without = squares(-0.01)[0]
    assert not without.friction_heat(moved).nodes.any()
    contact.friction.begin_step(coords)
    found = contact.friction_heat(moved, [1.0, 3.0])
    dissipated = contact.evaluate(moved).friction.dissipation
    assert dissipated > 0.01
    assert found.nodes[is_above].sum() == pytest.approx(0.75 * dissipated, rel=1e-12)
    assert found.nodes.sum() == pytest.approx(dissipated, rel=1e-12)
    assert contact.friction_heat(moved).nodes[is_above].sum() == pytest.approx(0.5 * dissipated, rel=1e-12)
    with pytest.raises(NotPositiveError, match="entry 1 of 'effusivities'"):
        contact.friction_heat(moved, [1.0, np.nan])


def test_bad_input_is_named():
    contact, coords, _ = squares(-0.01)
    good = np.ones(len(coords))
    bad = good.copy()
    bad[4] = np.nan
    with pytest.raises(NotPositiveError, match="entry 4 of 'fields'"):
        contact.flux(coords, bad, 1.0)
    for wrong in (-1.0, np.nan, np.inf):
        with pytest.raises(NotPositiveError, match=f"the conductance is {wrong}, expected a number >= 0, or tables") as caught:
            contact.flux(coords, good, wrong)
        assert caught.value.status == 18
    with pytest.raises(ValueError, match=r"conductance has shape \(2,\), expected \(\)"):
        contact.flux(coords, good, [1.0, 2.0])
    with pytest.raises(NotPositiveError, match="entry 0 of 'by_pressure' is -1"):
        contact.flux(coords, good, Conductance(by_pressure=[(0.0, -1.0)]))
    with pytest.raises(NotPositiveError, match="entry 1 of 'gaps' is 0.1 after 0.1: by_gap lists its gaps ascending"):
        contact.flux(coords, good, Conductance(by_gap=[(0.1, 1.0), (0.1, 1.0)]))
    with pytest.raises(NotPositiveError, match="entry 2 of 'pressures' is 1.0 after 2.0: by_pressure lists its pressures ascending"):
        contact.flux(coords, good, Conductance(by_pressure=[(0.0, 1.0), (2.0, 1.0), (1.0, 1.0)]))
    with pytest.raises(ValueError, match="fields has shape"):
        contact.flux(coords, good[:-1], 1.0)
    with pytest.raises(ValueError, match="by_gap has shape"):
        contact.flux(coords, good, Conductance(by_gap=[1.0, 2.0]))
    with pytest.raises(ValueError, match="obstacles has shape"):
        contact.flux(coords, good, 1.0, obstacles=[1.0])


@pytest.mark.parametrize("size", [2, 3])
def test_every_rank_has_the_bits_of_one(size):
    def found(comm=None):
        contact, coords, is_above = squares(-0.01, friction_coefficient=0.3)
        contact.obstacles.add_half_space((0, 0.02), (0, 1))
        if comm is not None:
            contact.ranks.set_communicator(comm)
        contact.friction.begin_step(coords)
        moved = coords + np.where(is_above[:, None], [0.1, 0.0], 0.0)
        flux, heat = contact.flux(moved, coords[:, 0], 2.0, [3.0]), contact.friction_heat(moved)
        return flux.flux, flux.obstacles, flux.data, flux.indices, heat.nodes, heat.obstacles

    alone = found()
    assert abs(alone[1][0]) > 0 and alone[4].sum() > 0
    for of_rank in on_ranks(size, found):
        assert all(np.array_equal(one, other) for one, other in zip(of_rank, alone)), of_rank


def held(interface, **options):
    """Squares that touch along their whole faces, held together."""
    contact, coords, is_above = squares(0.0)
    contact.pairs.set(0, 1, interface=interface, **options)
    return contact, coords, is_above


GLUE = {"normal_strength": 2.0, "normal_energy": 0.1}
TABLES = Conductance(by_pressure=[(0.0, 3.0), (2.0, 5.0)], by_gap=[(0.0, 3.0), (0.2, 1.0)])


@pytest.mark.parametrize(("interface", "options"), [("tied", {}), ("cohesive", GLUE), ("no_separation", {})])
def test_what_is_held_conducts_as_what_touches(interface, options):
    contact, coords, is_above = held(interface, **options)
    field = np.where(is_above, 10.0, 4.0)
    assert contact.flux(coords, field, TABLES).flux[is_above].sum() == pytest.approx(6.0 * 3.0, rel=1e-12)
    # Pressed by its own stiffness it bears the pressure that is its force by the area of 1.
    pressed = coords - np.where(is_above[:, None], [0.0, 0.001], 0.0)
    pressure = contact.evaluate(pressed).forces[is_above, 1].sum()
    assert pressure > 0.01
    found = contact.flux(pressed, field, TABLES)
    assert found.flux[is_above].sum() == pytest.approx(6.0 * (3.0 + pressure), rel=1e-9)
    assert abs(found.flux.sum()) < 1e-12
    np.testing.assert_array_equal(found.matrix.toarray(), found.matrix.toarray().T)


def test_a_broken_part_conducts_as_a_gap_does():
    contact, coords, is_above = held("cohesive", **GLUE)
    field = np.where(is_above, 10.0, 4.0)
    apart = coords + np.where(is_above[:, None], [0.0, 0.05], 0.0)
    # Its last opening is 2 G/σ = 0.1: half way, and nearly linear from the onset on, with the damage that the interface tells.
    contact.friction.begin_step(coords)
    contact.friction.commit_step(apart)
    damage = contact.cohesive.damage[0, 0]
    assert 0.9 < damage < 1.0
    expected = (1 - damage) * 3.0 + damage * 2.5
    assert contact.flux(apart, field, TABLES).flux[is_above].sum() == pytest.approx(6.0 * expected, rel=1e-9)
    contact.friction.commit_step(coords + np.where(is_above[:, None], [0.0, 0.15], 0.0))
    assert contact.flux(apart, field, TABLES).flux[is_above].sum() == pytest.approx(6.0 * 2.5, rel=1e-9)


def test_a_pair_that_slid_conducts_where_it_is_now():
    contact, coords, is_above = held("no_separation")
    field = np.where(is_above, 10.0, 4.0)
    slid = coords + np.where(is_above[:, None], [0.25, 0.0], 0.0)
    contact.friction.begin_step(slid)
    assert contact.flux(slid, field, 3.0).flux[is_above].sum() == pytest.approx(6.0 * 3.0 * 0.75, rel=1e-9)
