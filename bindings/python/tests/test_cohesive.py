"""Cohesive interfaces from Python: options, what is told of them, and damage that is kept."""

import numpy as np
import pytest
from fmc_contact import Contact, FmcError, errors
from test_ranks import arrays, on_ranks

COORDS = np.array([[0, 0], [2, 0], [2, 1], [0, 1], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]], float)
CONN = np.array([[0, 1, 2, 3], [4, 5, 8, 7], [5, 6, 9, 8]])
LAW = {"normal_strength": 2.0, "normal_energy": 0.1, "shear_strength": 3.0, "shear_energy": 0.4}


def glued(**other):
    contact = Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3)
    contact.pairs.set(0, 1, **{"interface": "cohesive", **LAW, **other})
    contact.friction.begin_step(COORDS)
    return contact


def moved(x, y):
    coords = COORDS.copy()
    coords[4:] += [x, y]
    return coords


def test_options_come_back():
    contact = glued(mixed_mode_exponent=1.5, stiffness=1e4, softening="exponential", reach=0.1)
    options = contact.pairs.options(0, 1)
    assert options["interface"] == "cohesive" and options["law"] is None and options["softening"] == "exponential"
    assert (options["stiffness"], options["mixed_mode_exponent"], options["reach"]) == (1e4, 1.5, 0.1)
    assert {key: options[key] for key in LAW} == LAW
    # What is not said of sliding is that of opening.
    contact.pairs.set(0, 1, interface="cohesive", normal_strength=2.0, normal_energy=0.1)
    options = contact.pairs.options(0, 1)
    assert (options["shear_strength"], options["shear_energy"], options["mixed_mode_exponent"]) == (2.0, 0.1, 2.0)
    contact.pairs.set(0, 1, **{key: value for key, value in options.items() if value is not None})
    assert contact.pairs.options(0, 1) == options


PPR = {"softening": "ppr", "normal_shape": 5.0, "shear_shape": 1.6, "normal_slope": 0.1, "shear_slope": 0.2}


def test_shapes_of_the_law_ppr_come_back():
    contact = glued(**PPR)
    options = contact.pairs.options(0, 1)
    assert {key: options[key] for key in PPR} == PPR
    contact.pairs.set(0, 1, **{key: value for key, value in options.items() if value is not None})
    assert contact.pairs.options(1, 0) == options
    contact.pairs.set(0, 1, interface="cohesive", softening="ppr", **LAW)
    assert [contact.pairs.options(0, 1)[key] for key in PPR] == ["ppr", 2.0, 2.0, 0.05, 0.05]
    contact.pairs.set(0, 1, interface="cohesive", **LAW)
    assert [contact.pairs.options(0, 1)[key] for key in PPR] == ["linear"] + 4 * [None]


def test_the_law_ppr_opens_by_its_closed_form():
    contact = glued(**PPR)
    a, m = 5.0, 5.0 * 4.0 * 0.01 / (1 - 5.0 * 0.01)

    def rise(x):
        return a * (1 + a / m) * (1 - x) ** (a - 1) * (1 + a * x / m) ** (m - 1) * x

    end = 0.1 / 2.0 * rise(0.1)
    for x in (0.02, 0.1, 0.5, 1.0, 1.5):
        expected = 0.1 / end * rise(min(x, 1.0))
        pull = -contact.evaluate(moved(0.0, x * end)).forces[4:].sum(0) / 2.0
        assert pull == pytest.approx([0.0, expected], abs=1e-12)
        assert x != 0.1 or pull[1] == pytest.approx(2.0, rel=1e-13)
    told = contact.cohesive.interface(0, 1, moved(0.0, 1.5 * end))
    assert told.dissipated == pytest.approx(0.1 * 2.0, rel=1e-12) and told.stored == 0.0


@pytest.mark.parametrize(
    "wrong",
    [
        {"normal_strength": 0.0},
        {"normal_energy": -1.0},
        {"mixed_mode_exponent": 0.5},
        {"stiffness": 19.0},
        {"law": "depth", "stiffness": 1e4},
        {"gap_offset": -0.1},
        {"softening": "sudden"},
        {"normal_shape": 3.0},
        {**PPR, "normal_shape": 1.0},
        {**PPR, "normal_slope": 0.5},
        {**PPR, "viscosity": 1.0},
        {**PPR, "stiffness": 1e4},
        {**PPR, "transverse_coefficient": 0.1, "direction": (1, 0, 0)},
        {"interface": "tied"},
        {"interface": "contact", "reach": 0.1},
    ],
)
def test_what_is_no_such_interface_is_refused(wrong):
    with pytest.raises((FmcError, ValueError)):
        glued(**wrong)


def test_sliding_follows_the_closed_form():
    contact = glued()
    # 50 σ²/G is the stiffness of opening; in sliding damage begins and ends where this triangle says.
    stiffness = 50 * 2.0**2 / 0.1 * (0.1 / 0.4) * (3.0 / 2.0) ** 2
    onset, end = 3.0 / stiffness, 2 * 0.4 / 3.0
    for slid in (0.5 * onset, 0.05, 0.2, 1.1 * end):
        expected = stiffness * slid if slid < onset else 3.0 * max(end - slid, 0.0) / (end - onset)
        pull = -contact.evaluate(moved(slid, 0.0)).forces[4:].sum(0) / 2.0
        assert pull == pytest.approx([expected, 0.0], abs=1e-10)
        points = contact.cohesive.points(moved(slid, 0.0))
        # The lower body has gone the other way, and pulls the upper one back.
        assert np.allclose(points.sliding, [-slid, 0.0]) and np.allclose(points.traction, [-expected, 0.0], atol=1e-10)
        assert np.allclose(points.opening, 0.0) and points.area.sum() == pytest.approx(2.0)
        assert (points.bodies == [0, 1]).all() and np.allclose(points.position[:, 1], 1.0)
    told = contact.cohesive.interface(1, 0, moved(1.1 * end, 0.0))
    assert told.dissipated == pytest.approx(0.4 * 2.0, rel=1e-12) and told.broken_area == pytest.approx(2.0)
    assert told.point_count == len(points) and told.largest_gap == 0.0


def test_damage_is_accepted_and_kept_for_a_restart():
    contact, other = glued(), glued()
    contact.evaluate(moved(0.0, 0.05))
    assert not contact.cohesive.damage.any()
    contact.friction.commit_step(moved(0.01, 0.05))
    damage = contact.cohesive.damage
    assert (damage[:, 0] > 0.9).all() and damage.shape == (len(contact.cohesive.points(COORDS)), 2)
    other.cohesive.damage = damage
    for coords in (moved(0.0, 0.01), moved(0.02, 0.07)):
        assert (contact.evaluate(coords).forces == other.evaluate(coords).forces).all()
        assert contact.evaluate(coords).energy == other.evaluate(coords).energy
    for wrong in (damage[:-1], damage.ravel(), damage + 1.0, -damage):
        with pytest.raises(FmcError):
            other.cohesive.damage = wrong
    assert (other.cohesive.damage == damage).all()


def test_bodies_without_one_are_told_so():
    contact = Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3)
    assert contact.cohesive.interface(0, 1, COORDS).area == 0.0
    assert len(contact.cohesive.points(COORDS)) == 0 and contact.cohesive.damage.shape == (0, 2)
    with pytest.raises(errors.BodyOutOfRangeError):
        contact.cohesive.interface(-1, 0, COORDS)


def test_messages_name_what_was_given():
    contact = glued()
    with pytest.raises(FmcError, match="'mixed_mode_exponent' is 0.5"):
        glued(mixed_mode_exponent=0.5)
    for law in ({"law": "depth"}, {"law": "depth", "stiffness": 1e4}):
        with pytest.raises(errors.OptionsConflictError, match="'law' of a pair has no effect with the interface 'cohesive'"):
            glued(**law)
    with pytest.raises(FmcError, match="a stiffness of a cohesive interface above 5e9"):
        glued(stiffness=1e50)
    damage = contact.cohesive.damage
    damage[1, 0] = np.nan
    with pytest.raises(FmcError) as refused:
        contact.cohesive.damage = damage
    assert str(refused.value) == "'damage' is NaN, which is not allowed"
    # Nothing is damaged: a plain zero, not -0.0.
    told = contact.cohesive.interface(0, 1, COORDS)
    assert not np.signbit([told.damaged_area, told.broken_area]).any()


@pytest.mark.parametrize(("size", "law"), [(2, {}), (3, {}), (4, PPR)])
def test_every_rank_has_the_bits_of_one(size, law):
    def found(comm=None):
        contact = Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3)
        if comm is not None:
            contact.ranks.set_communicator(comm)
        contact.pairs.set(0, 1, interface="cohesive", **LAW, **law)
        contact.friction.begin_step(COORDS)
        contact.friction.commit_step(moved(0.01, 0.03))
        result, matrix = contact.evaluate_tangent(moved(0.02, 0.04))
        return result.forces, result.energy, contact.cohesive.damage, *arrays(matrix)

    alone = found()
    assert alone[2].any() and alone[0].any()
    for of_rank in on_ranks(size, found):
        assert all(np.array_equal(one, other) for one, other in zip(of_rank, alone)), of_rank


def test_what_is_broken_stays_so_where_points_are_found_anew():
    contact = glued()
    torn = COORDS + np.outer((np.arange(len(COORDS)) >= 4) * COORDS[:, 0], [0.0, 0.03])
    contact.friction.commit_step(torn)
    damage, forces = contact.cohesive.damage.copy(), contact.evaluate(torn).forces
    assert damage[:, 0].min() < 0.8 < 0.99 < damage[:, 0].max()
    changes = [
        lambda: setattr(contact.mesh, "offsets", contact.mesh.offsets),
        lambda: contact.mesh.adjust(COORDS, close=0.01, remove=0.01),
        lambda: contact.mesh.set_reference(COORDS),
        lambda: contact.mesh.set_reference(COORDS + [5.0, -3.0]),
        lambda: contact.mesh.set_reference(COORDS),
    ]
    for change in changes:
        change()
        np.testing.assert_array_equal(contact.cohesive.damage, damage)
    np.testing.assert_array_equal(contact.evaluate(torn).forces, forces)
    # Where they face one another nowhere there is no interface; later it is the old one again.
    contact.mesh.set_reference(moved(0.0, 3.0))
    with pytest.raises(errors.UntiedError):
        contact.evaluate(torn)
    contact.mesh.set_reference(COORDS)
    np.testing.assert_array_equal(contact.cohesive.damage, damage)
    # Other common pieces, a little aside: the most that a point has been through is the same, and the energy nearly so.
    contact.mesh.set_reference(moved(0.01, 0.0))
    assert contact.cohesive.damage[:, 0].max() == damage[:, 0].max()
    before = damage[:, 1].mean()
    assert contact.cohesive.damage[:, 1].mean() == pytest.approx(before, rel=0.05)


def test_what_is_broken_rubs_and_a_restart_goes_on():
    contact, other = glued(friction_coefficient=0.3), glued(friction_coefficient=0.3)
    assert contact.pairs.options(0, 1)["friction_coefficient"] == 0.3
    # Pressed by 50 σ²/G times 1e-3, sheared until it is broken: μ p remains.
    pressure = 50 * 2.0**2 / 0.1 * 1e-3
    broken = moved(0.4, -1e-3)
    assert contact.evaluate(broken).forces[4:].sum(0) / 2.0 == pytest.approx([-0.3 * pressure, pressure], abs=1e-10)
    contact.friction.commit_step(broken)
    told, points = contact.cohesive.interface(0, 1, broken), contact.cohesive.points(broken)
    assert told.dissipated == pytest.approx(0.4 * 2.0) and told.viscous == 0.0
    assert told.rubbed == pytest.approx((points.area * points.rubbed).sum()) and told.rubbed > 0
    damage, history = contact.cohesive.damage, contact.cohesive.history
    assert history.shape == (len(points), 5) and np.allclose(history[:, 1], 0) and history[:, 0].all()
    other.cohesive.damage, other.cohesive.history = damage, history
    for coords in (moved(0.3999, -1e-3), moved(0.2, -2e-3)):
        assert (contact.evaluate(coords).forces == other.evaluate(coords).forces).all()
    for wrong in (history[:-1], history.ravel(), history * np.nan):
        with pytest.raises(FmcError):
            other.cohesive.history = wrong
    with pytest.raises(FmcError, match="friction at rest of bodies with a cohesive interface"):
        glued(static_coefficient=0.4, weakening_slip=0.1)


def test_viscosity_holds_damage_back():
    contact = glued(viscosity=0.5)
    assert contact.pairs.options(0, 1)["viscosity"] == 0.5
    with pytest.raises(FmcError, match=r"without a time step.*set_time_step"):
        contact.evaluate(COORDS)
    for wrong in (0.0, -1.0, np.nan):
        with pytest.raises(errors.NotPositiveError):
            contact.cohesive.set_time_step(wrong)
    contact.cohesive.set_time_step(0.5)
    # Broken by the law, half broken after a time of η.
    at = moved(0.0, 0.2)
    assert contact.cohesive.points(at).damage == pytest.approx(0.5)
    contact.friction.commit_step(at)
    assert contact.cohesive.points(at).damage == pytest.approx(0.75)
    told = contact.cohesive.interface(0, 1, at)
    assert told.viscous > 0 and contact.evaluate(at).energy == pytest.approx(told.stored + told.dissipated + told.viscous)
    with pytest.raises(FmcError, match="'viscosity' of a pair belongs to the interface 'cohesive'"):
        contact.pairs.set(0, 1, viscosity=0.5)
