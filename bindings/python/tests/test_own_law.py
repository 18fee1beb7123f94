"""Interfaces by your own law, from Python."""

import gc

import numpy as np
import pytest
from fmc_contact import Contact, FmcError, LawResponse, check_law, errors, find_equilibrium
from test_ranks import on_ranks

COORDS = np.array([[0, 0], [2, 0], [2, 1], [0, 1], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]], float)
CONN = np.array([[0, 1, 2, 3], [4, 5, 8, 7], [5, 6, 9, 8]])


def bonded(law, **other):
    contact = Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3)
    contact.pairs.set(0, 1, **{"interface": "law", "law": law, **other})
    contact.friction.begin_step(COORDS)
    return contact


def moved(x, y):
    coords = COORDS.copy()
    coords[4:] += [x, y]
    return coords


def stiffening(points, k=30.0, c=4e3):
    """t = k s + c s³ along every axis."""
    s = points.jump
    diagonal = np.eye(s.shape[1]) * (k + 3 * c * s**2)[:, :, None]
    return LawResponse(k * s + c * s**3, diagonal, stored=(k * s**2 / 2 + c * s**4 / 4).sum(1))


def test_a_bond_that_stiffens_carries_its_closed_form():
    contact = bonded(stiffening)
    by = np.array([0.03, 0.05])
    found = contact.evaluate(moved(*by))
    # On a length of 2; sums of a few numbers, to rounding.
    assert -found.forces[4:].sum(0) == pytest.approx(2 * (30 * by + 4e3 * by**3), rel=1e-13)
    assert found.energy == pytest.approx(2 * (15 * by**2 + 1e3 * by**4).sum(), rel=1e-13)
    points = contact.laws.points(moved(*by))
    assert len(points) == len(points.stored) and points.area.sum() == pytest.approx(2.0, rel=1e-15)
    # The second body is above, so that its normal is −y, and the axis +x. The first has slid the other way.
    assert points.axes[0] == pytest.approx(np.array([[0, -1], [1, 0]]), abs=1e-15)
    assert points.jump == pytest.approx(np.tile([0.05, -0.03], (len(points), 1)), abs=1e-15)
    assert (points.area * points.stored).sum() == pytest.approx(found.energy, rel=1e-13)


def cohesive_bilinear(points, strength=2.0, energy=0.1, m=100.0):
    """The cohesive law of the library, alike in both modes, over all points at once; the history is damage and dissipated energy."""
    k = m * strength**2 / (2 * energy)
    s = points.jump.copy()
    pressed = np.minimum(s[:, 0], 0.0)
    s[:, 0] = np.maximum(s[:, 0], 0.0)
    y, onset = 0.5 * k * (s**2).sum(1), energy / m
    q = np.sqrt(y / onset)
    before, spent = points.history.T
    with np.errstate(divide="ignore", invalid="ignore"):
        wanted = np.where(q <= 1, 0.0, np.where(q >= m, 1.0, m * (q - 1) / (q * (m - 1))))
        slope = np.where((wanted > before) & (q < m), m / ((m - 1) * q**2) * q / (2 * y), 0.0)
    damage = np.maximum(wanted, before)
    energy_to = lambda q: np.minimum(m * (q - 1) / (m - 1), m)
    reached = m / (m - before * (m - 1))
    spent = spent + np.where(damage > before, onset * (energy_to(q) - energy_to(reached)), 0.0)
    left = 1 - damage
    traction = (left * k)[:, None] * s
    traction[:, 0] += k * pressed
    tangent = np.eye(s.shape[1]) * (left * k)[:, None, None] - slope[:, None, None] * (k * s)[:, :, None] * (k * s)[:, None, :]
    tangent[:, 0, 0] = np.where(points.jump[:, 0] > 0, tangent[:, 0, 0], k)
    return LawResponse(traction, tangent, np.column_stack([damage, spent]), left * y + 0.5 * k * pressed**2, spent)


PATH = [moved(0.0005, 0.0007), moved(0.01, 0.02), moved(0.004, 0.01), moved(0.02, -0.001), moved(0.03, 0.05), moved(0.1, 0.2)]


def test_a_law_that_repeats_the_cohesive_one_gives_the_same_and_restarts():
    own = bonded(cohesive_bilinear, history=2)
    library = Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3)
    library.pairs.set(0, 1, interface="cohesive", normal_strength=2.0, normal_energy=0.1)
    library.friction.begin_step(COORDS)
    for number, coords in enumerate(PATH):
        a, b = own.evaluate(coords), library.evaluate(coords)
        assert a.forces == pytest.approx(b.forces, rel=1e-12, abs=1e-12 * np.abs(b.forces).max())
        assert a.energy == pytest.approx(b.energy, rel=1e-12)
        for contact in (own, library):
            contact.friction.commit_step(coords)
        assert own.laws.history.reshape(-1, 2) == pytest.approx(library.cohesive.damage, rel=1e-12, abs=1e-13)
        if number == 2:
            kept = own.laws.history
            own = bonded(cohesive_bilinear, history=2)
            own.friction.begin_step(coords)
            own.laws.history = kept
    assert (library.cohesive.damage[:, 0] == 1).all()


def test_the_check_finds_what_is_right_and_what_is_wrong():
    for dim in (2, 3):
        texts = check_law(cohesive_bilinear, dim, 0.05, history=2)
        assert not any("WRONG" in text for text in texts) and texts[1].startswith("tangent: it is the derivative")
    assert not any("WRONG" in text for text in check_law(stiffening, 2, 0.1, jump=[[0.1, 0.0], [0.0, -0.2]]))

    def secant(points):
        right = cohesive_bilinear(points)
        with np.errstate(invalid="ignore"):
            return right.traction, np.eye(2) * np.nan_to_num(right.traction / points.jump)[:, :, None], right.history

    matrix = np.random.default_rng(0).standard_normal((3, 3))
    products = lambda points: (points.fields[0, 1, 0] * points.jump @ matrix.T, np.broadcast_to(2.0 * matrix, points.axes.shape))
    assert not any("WRONG" in text for text in check_law(products, 3, 0.1, fields=[2.0]))

    wrong = [text for text in check_law(secant, 2, 0.05, history=2) if "WRONG" in text]
    assert len(wrong) == 1 and "the derivative of traction" in wrong[0]
    with pytest.raises(errors.DimensionError):
        check_law(stiffening, 4, 0.1)
    with pytest.raises(errors.NotPositiveError, match="scale"):
        check_law(stiffening, 2, 0.0)
    with pytest.raises(ZeroDivisionError):
        check_law(lambda points: 1 / 0, 2, 0.1)
    with pytest.raises(errors.InterfaceLawError, match="point 0.*traction is nan|point 0.*NaN"):
        check_law(lambda points: (np.full(points.jump.shape, np.nan), np.zeros(points.axes.shape)), 2, 0.1)


def bad_shape(points):
    return points.jump[:, :1], np.zeros(points.axes.shape)


def raises(points):
    raise KeyError("melted")


@pytest.mark.parametrize(
    ("fault", "error", "text"),
    [
        (raises, KeyError, "melted"),
        (bad_shape, ValueError, "traction has shape"),
        (lambda points: None, TypeError, "a law returned a NoneType"),
        (lambda points: (points.jump, points.axes, np.zeros((3, 7))), ValueError, "history has shape"),
        (lambda points: (points.jump + np.inf, points.axes), errors.InterfaceLawError, "bodies 0 and 1, at point 0.*traction is inf"),
    ],
)
def test_a_law_that_fails_leaves_the_contact_as_it_was(fault, error, text):
    law = {"now": cohesive_bilinear}
    contact = bonded(lambda points: law["now"](points), history=2)
    contact.friction.commit_step(PATH[1])
    expected, history = contact.evaluate(PATH[2]), contact.laws.history
    law["now"] = fault
    for call in (contact.evaluate, contact.friction.commit_step, contact.laws.points):
        with pytest.raises(error, match=text):
            call(PATH[4])
    law["now"] = cohesive_bilinear
    assert (contact.laws.history == history).all()
    assert (contact.evaluate(PATH[2]).forces == expected.forces).all()


def test_what_cannot_be_is_refused():
    contact = bonded(stiffening)
    with pytest.raises(ValueError, match="belongs to the interface 'law'"):
        contact.pairs.set(0, 1, law=stiffening)
    with pytest.raises(ValueError, match="history is -1"):
        contact.pairs.set(0, 1, interface="law", law=stiffening, history=-1)
    with pytest.raises(TypeError, match="expected a function"):
        contact.pairs.set(0, 1, interface="law", law=3.0)
    with pytest.raises(errors.UnsupportedError, match="friction of bodies"):
        contact.pairs.set(0, 1, interface="law", law=stiffening, friction_coefficient=0.3)
    with pytest.raises(FmcError):
        contact.pairs.set(0, 0, interface="law", law=stiffening)
    with pytest.raises(errors.LengthError):
        contact.laws.history = [1.0]
    other = Contact(COORDS, CONN, "quad", bodies=[0, 1, 1], stiffness=1e3)
    with pytest.raises(errors.UnsupportedError, match="without the law"):
        other.pairs.set(0, 1, interface="law")


def test_options_come_back_and_keep_the_law():
    contact = bonded(cohesive_bilinear, history=2, reach=0.1)
    contact.friction.commit_step(PATH[1])
    history = contact.laws.history
    options = contact.pairs.options(1, 0)
    assert options["interface"] == "law" and options["reach"] == 0.1 and options["law"] is None
    contact.pairs.set(1, 0, **{key: value for key, value in options.items() if value is not None})
    gc.collect()
    assert (contact.laws.history == history).all() and contact.evaluate(PATH[2]).energy > 0
    contact.pairs.reset(0, 1)
    assert len(contact.laws.points(COORDS)) == 0


def test_a_law_goes_by_fields_of_the_nodes():
    """A stiffness of the mean of both sides: 1 + x below, and 4 above; over a length of 2 that is 2 · 3."""

    def heated(points):
        k = points.fields[:, :, 0].mean(1)[:, None]
        return k * points.jump, k[:, :, None] * np.eye(2)

    contact = bonded(heated)
    contact.laws.set_fields(np.where(np.arange(10) < 4, 1 + COORDS[:, 0], 4.0))
    pull = -contact.evaluate(moved(0.0, 0.1)).forces[4:].sum(0)
    assert pull == pytest.approx([0.0, 0.1 * 2 * 3.0], abs=1e-14)
    for wrong in (np.ones(9), np.ones((2, 2, 2)), np.full(10, np.nan)):
        with pytest.raises((FmcError, ValueError)):
            contact.laws.set_fields(wrong)
    assert -contact.evaluate(moved(0.0, 0.1)).forces[4:].sum(0) == pytest.approx(pull, abs=1e-15)
    contact.laws.set_fields(None)
    with pytest.raises(IndexError):
        contact.evaluate(moved(0.0, 0.1))


def test_ranks_give_the_same_bits():
    def run(communicator=None):
        contact = bonded(cohesive_bilinear, history=2)
        if communicator is not None:
            contact.ranks.set_communicator(communicator)
        contact.friction.commit_step(PATH[1])
        return contact.evaluate(PATH[4]).forces, contact.laws.history

    expected = run()
    assert expected[0].any() and expected[1].any()
    for found in on_ranks(2, run):
        assert all(map(np.array_equal, found, expected)), found


def test_a_search_finds_the_opening_of_a_closed_form():
    """Two blocks with a joint of k s + c s³ that a load pulls apart: where the blocks are stiff by 1e6, all of it opens alike, to 1e-5."""
    elastic = pytest.importorskip("elastic")
    pytest.importorskip("scipy")
    contact = bonded(stiffening)
    matrix = elastic.stiffness(COORDS, CONN, 1e8)
    load = np.zeros(COORDS.shape)
    load[7:, 1] = 0.5, 1.0, 0.5
    found = find_equilibrium(lambda x: (matrix @ (x - COORDS).ravel() - load.ravel(), matrix), contact, COORDS, np.arange(8, 20))
    points = contact.laws.points(found.x)
    opening = next(root.real for root in np.roots([4e3, 0, 30.0, -1.0]) if abs(root.imag) < 1e-12)
    assert points.jump[:, 0] == pytest.approx(np.full(len(points), opening), rel=1e-5)
    assert (points.area * points.traction[:, 0]).sum() == pytest.approx(2.0, rel=1e-8)
    assert found.iterations <= 10, found.iterations
