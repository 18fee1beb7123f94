"""``find_equilibrium``: one load step, from what a host has: a residual and a matrix."""

import re
import subprocess
import sys

import numpy as np
import pytest
from elastic import stiffness
from fmc_contact import Contact, NoSupportError, NotConvergedError, errors, find_equilibrium
from scenes import K

YOUNG = 100.0


@pytest.fixture
def column():
    """Two unit squares, one above the other and 0.1 apart, each of four springs up the sides, 1 E / length by area, and
    two across; the bottom is held, the top is moved. Contact and host."""
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.1], [1, 1.1], [1, 2.1], [0, 2.1]])
    matrix = np.zeros((16, 16))
    for a, b, axis in [(0, 3, 1), (1, 2, 1), (4, 7, 1), (5, 6, 1)] + [(n, n + 1, 0) for n in (0, 2, 4, 6)]:
        p, q = 2 * a + axis, 2 * b + axis
        matrix[[p, q], [p, q]] += YOUNG / 2
        matrix[[p, q], [q, p]] -= YOUNG / 2
    # Sideways the squares stand on soft ground: springs up their sides do not hold them there.
    matrix += np.diag([1e-3, 0.0] * 8)
    contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", stiffness=K, law="depth", estimator="auto")
    return coords, contact, lambda x: (matrix @ (x - coords).ravel(), matrix)


def two_blocks():
    """Two unit squares of four cells, one on the other."""
    square = np.array([[x, y] for y in (0, 0.5, 1) for x in (0, 0.5, 1)])
    cells = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]])
    return np.vstack([square, square + [0.2, 1.0]]), np.vstack([cells, cells + 9])


HELD = [0, 1, 2, 3, 12, 13, 14, 15]
FREE = np.setdiff1d(np.arange(16), HELD)


def pushed(coords, by):
    target = coords.copy()
    target[6:, 1] -= by
    return target


def test_two_columns_and_the_contact_between_them_are_springs_in_series(column):
    coords, contact, host = column
    start = coords.copy()
    found = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.15), two_level=False)
    # 0.05 is shared by two columns of E and the contact of k. At its rims contact bears less than k δ, and walls that
    # are sunk in are pressed sideways: both by a part of the order of δ / h, 0.0024.
    in_series = 0.05 / (2 / YOUNG + 1 / K)
    assert found.reactions[:2, 1].sum() == pytest.approx(in_series, rel=0.005)
    assert found.reactions[6:, 1].sum() == pytest.approx(-found.reactions[:2, 1].sum(), rel=1e-9)
    assert found.residuals[-1] <= 1e-9 and found.iterations <= 12 and np.isfinite(found.residuals).all()
    assert found.residuals[0] > 0.1 and np.array_equal(found.x[6:], pushed(coords, 0.15)[6:])
    assert np.abs(found.reactions.ravel()[FREE]).max() <= 1e-9 * YOUNG
    assert np.array_equal(coords, start) and contact.options["stiffness"] == K


def test_the_next_load_step_carries_bodies_in_contact_along(column):
    coords, contact, host = column
    first = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.15))
    second = find_equilibrium(host, contact, first.x, FREE, pushed(coords, 0.16))
    assert second.iterations <= 3 and second.parts == 1
    again = find_equilibrium(host, contact, second.x, FREE)
    assert again.iterations == 0 and np.array_equal(again.x, second.x)


def test_a_deep_overlap_leads_to_the_equilibrium_of_small_load_steps(column):
    coords, contact, host = column
    gently = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.12), two_level=False)
    gently = find_equilibrium(host, contact, gently.x, FREE, pushed(coords, 0.2), two_level=False)
    contact.set_options(stiffness=K)
    at_once = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.2), two_level=False)
    assert np.abs(at_once.x - gently.x).max() < 1e-7 and contact.options["stiffness"] == K


def test_what_is_not_found_is_an_error_that_says_why(column):
    coords, contact, host = column
    with pytest.raises(NotConvergedError, match="after 1 linear solves: the residual is") as caught:
        find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.2), max_iterations=1)
    assert caught.value.iterations == 1
    with pytest.raises(NotConvergedError, match="after 3 linear solves: the residual is") as caught:
        find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.2), max_iterations=3, two_level=False)
    assert len(caught.value.residuals) == 4 and caught.value.iterations == 3 and contact.options["stiffness"] == K
    with pytest.raises(NotConvergedError, match="Singular matrix: is every body supported"):
        find_equilibrium(lambda x: (np.ones(16), np.zeros((16, 16))), contact, coords, FREE)
    with pytest.raises(NotConvergedError, match="not finite"):
        find_equilibrium(lambda x: (np.full(16, np.nan), np.eye(16)), contact, coords, FREE)
    # The upper square is pushed through itself.
    with pytest.raises(NotConvergedError, match="the prescribed values were not reached") as caught:
        loose = lambda x: (x.ravel() - coords.ravel(), np.eye(16))
        find_equilibrium(loose, contact, coords, FREE, pushed(coords, 3.0))
    assert 0 < caught.value.iterations <= 100


def test_bodies_that_move_as_one_are_in_equilibrium(column):
    coords, contact, _ = column
    free = np.arange(4)
    for push in (0.1, 0.3, 1 / 3):
        springs = 1e4 * (np.eye(16) - 0.125 * np.tile(np.eye(2), (8, 8)))
        target = coords - [0.0, push]
        found = find_equilibrium(lambda x: (springs @ (x - coords).ravel(), springs), contact, coords, free, target)
        assert found.iterations <= 2 and np.abs(found.x - target).max() < 1e-13


def test_wrong_arguments_are_told(column):
    coords, contact, host = column
    with pytest.raises(ValueError, match=r"prescribed has shape \(16,\), expected \(8, 2\)"):
        find_equilibrium(host, contact, coords, FREE, coords.ravel())
    wrong = coords.copy()
    wrong[7, 0] = np.inf
    with pytest.raises(ValueError, match=r"prescribed\[7, 0\] is inf, expected finite numbers"):
        find_equilibrium(host, contact, coords, FREE, wrong)
    with pytest.raises(ValueError, match=r"x\[7, 0\] is inf, expected finite numbers"):
        find_equilibrium(host, contact, wrong, FREE)
    # Entries at free unknowns are not read.
    wrong = pushed(coords, 0.15)
    wrong.ravel()[FREE] = np.nan
    assert np.isfinite(find_equilibrium(host, contact, coords, FREE, wrong).x).all()
    with pytest.raises(ValueError, match="residual has 3 entries, x has 16"):
        find_equilibrium(lambda x: (np.zeros(3), np.eye(3)), contact, coords, FREE)
    with pytest.raises(ValueError, match="the penetration is 0"):
        find_equilibrium(host, contact, coords, FREE, penetration=0.0)


def test_arrays_and_sparse_matrices_give_the_same(column):
    sparse = pytest.importorskip("scipy.sparse")
    coords, contact, host = column
    dense = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.15))
    is_free = np.isin(np.arange(16), FREE)
    found = find_equilibrium(
        lambda x: (host(x)[0].reshape(8, 2), sparse.csr_matrix(host(x)[1])), contact, coords, is_free,
        pushed(coords, 0.15),
    )  # fmt: skip
    assert np.abs(found.x - dense.x).max() < 1e-12


def test_it_runs_without_scipy():
    program = """
import sys; sys.modules["scipy"] = sys.modules["scipy.sparse"] = None
import numpy as np
from fmc_contact import Contact, find_equilibrium
coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=1e3, law="depth", estimator="auto")
contact.obstacles.add_half_space((0, 0.1), (0, 1))
host = lambda x: ((x - coords).ravel() * 1e3, np.eye(8) * 1e3)
print(find_equilibrium(host, contact, coords, range(8)).iterations)
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert re.fullmatch(r"[1-8]\n", run.stdout)


def test_two_levels_find_the_same_equilibrium_in_fewer_iterations(column):
    sparse = pytest.importorskip("scipy.sparse")
    coords, contact, host = column
    # Free sideways the column is unstable, and rounding decides whether it leans.
    upright = [unknown for unknown in FREE if unknown % 2 == 1]
    for push in (0.101, 0.102):
        plain = find_equilibrium(host, contact, coords, upright, pushed(coords, push), two_level=False)
        for kind in (np.asarray, sparse.csr_matrix):
            found = find_equilibrium(
                lambda x, kind=kind: (host(x)[0], kind(host(x)[1])), contact, coords, upright, pushed(coords, push),
                two_level=True,
            )  # fmt: skip
            assert found.iterations <= 2 < plain.iterations and found.way == "condensed"
            assert found.residuals[-1] <= 1e-9
            assert np.abs(found.x - plain.x).max() < 1e-9
            assert np.abs(found.reactions - plain.reactions).max() < 1e-6


def small_steps(coords, contact, host, push):
    """The equilibrium at the end of load steps of a hundredth of a cell."""
    x = coords
    for by in np.arange(0.1, push, 0.01)[1:].tolist() + [push]:
        x = find_equilibrium(host, contact, x, FREE, pushed(coords, by), two_level=False).x
    return x


@pytest.mark.parametrize("stiffness", [1e2, 1e3, 1e4])
@pytest.mark.parametrize("push", [0.12, 0.2, 0.5])
def test_two_levels_lead_out_of_a_deep_overlap(column, stiffness, push):
    coords, contact, host = column
    held = 20.0 * np.diag([1.0, 0.0] * 8)

    def sideways(x):
        inside, matrix = host(x)
        return inside + held @ (x - coords).ravel(), matrix + held

    contact.set_options(stiffness=stiffness)
    found = find_equilibrium(sideways, contact, coords, FREE, pushed(coords, push), two_level=True)
    assert found.iterations <= 2
    assert np.abs(found.x - small_steps(coords, contact, sideways, push)).max() < 1e-8


def test_two_levels_leave_an_equilibrium_that_is_not_stable(column):
    coords, contact, host = column
    push = 0.2
    straight = small_steps(coords, contact, host, push)
    slipped = find_equilibrium(host, contact, coords, FREE, pushed(coords, push), two_level=True)

    def energy_and_least(x):
        inside, matrix = host(x)
        rows, cols, values = contact.tangent_parts(x).triplets()
        matrix = matrix.copy()
        np.add.at(matrix, (rows, cols), values)
        energy = 0.5 * inside @ (x - coords).ravel() + contact.evaluate(x).energy
        return energy, np.linalg.eigvalsh(matrix[np.ix_(FREE, FREE)]).min()

    (high, unstable), (low, stable) = energy_and_least(straight), energy_and_least(slipped.x)
    assert unstable < -1e-3 < 0 < stable and low < 0.1 * high
    assert np.abs(slipped.x - straight).max() > 0.4


def test_a_contact_whose_coordinates_are_not_unknowns_is_refused(column):
    coords, inner, host = column

    class Adapter:
        contact, evaluate, tangent = inner, None, None

        def on_dofs(self, forces):
            return np.ravel(forces)

    class Half(Adapter):
        def coords(self, x):
            return 0.5 * x.reshape(8, 2)

    class Mean(Adapter):
        def coords(self, x):
            return 0.5 * (x + x[::-1]).reshape(8, 2)

    for adapter in (Half(), Mean()):
        for two_level in (True, False, None):
            with pytest.raises(ValueError, match="exactly one unknown has to move each coordinate"):
                find_equilibrium(host, adapter, coords.ravel(), FREE, two_level=two_level)


def test_the_way_says_how_an_equilibrium_was_found(column):
    coords, contact, host = column
    target = pushed(coords, 0.102)
    firm = lambda x: (host(x)[0] + np.tile([1.0, 0.0], 8) * (x - coords).ravel(), host(x)[1] + np.diag(np.tile([1.0, 0.0], 8)))
    two_level = find_equilibrium(firm, contact, coords, FREE, target)
    assert two_level.way == "condensed" and two_level.iterations <= 3
    asked = find_equilibrium(firm, contact, coords, FREE, target, two_level=False)
    own = find_equilibrium(firm, contact, coords, FREE, target, solve=np.linalg.solve)
    for plain in (asked, own):
        assert plain.way == "nearest" and plain.contact_iterations == 0
        assert plain.x == pytest.approx(two_level.x, abs=1e-9)


def test_more_unknowns_in_contact_than_are_kept_are_not_condensed(column, monkeypatch):
    coords, contact, host = column
    monkeypatch.setattr("fmc_contact.condensed.MOST_KEPT", 3)
    found = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.15))
    plain = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.15), two_level=False)
    assert found.way == plain.way and found.contact_iterations == 0
    assert found.x == pytest.approx(plain.x, abs=1e-9)


def test_factors_of_linear_bodies_serve_later_load_steps(column):
    sparse = pytest.importorskip("scipy.sparse")
    coords, contact, host = column

    held = 20.0 * np.diag([1.0, 0.0] * 8)

    def in_rows(x):
        inside, matrix = host(x)
        return inside + held @ (x - coords).ravel(), sparse.csr_matrix(matrix + held)

    first = find_equilibrium(in_rows, contact, coords, FREE, pushed(coords, 0.102))
    second = find_equilibrium(in_rows, contact, first.x, FREE, pushed(coords, 0.103))
    assert first.factorisations >= 1 and second.factorisations == 0 and second.contact_iterations >= 1
    # Other bodies are factorised.
    third = find_equilibrium(lambda x: tuple(2 * one for one in in_rows(x)), contact, second.x, FREE)
    assert third.factorisations >= 1 and not np.array_equal(third.x, second.x)


def yielding(coords, host, force=60.0, width=0.02):
    """The same columns on springs that yield: residual, tangent, and energy."""

    def bodies(x):
        inside, matrix = host(x)
        d = (x - coords).ravel()
        held, size = np.tanh(d / width), abs(d / width)
        stiff, log_cosh = 1.0 - held**2, size + np.log1p(np.exp(-2.0 * size)) - np.log(2.0)
        energy = 0.5 * inside @ d + force * width * log_cosh.sum()
        return inside + force * held, matrix + np.diag(force / width * stiff), energy

    return bodies


def test_a_step_that_goes_too_far_is_shortened(column):
    coords, contact, host = column
    target = pushed(coords, 0.11)
    near = find_equilibrium(yielding(coords, host), contact, coords, FREE, target)
    # From where the springs have yielded a whole step leads as far beyond to the other side, and back.
    start = near.x.copy()
    start[2:6, 0] += 0.05
    whole, residuals = start.ravel().copy(), []
    for _ in range(10):
        inside, matrix, _ = yielding(coords, host)(whole.reshape(-1, 2))
        residuals.append(np.linalg.norm(inside[FREE]))
        whole[FREE] -= np.linalg.solve(matrix[np.ix_(FREE, FREE)], inside[FREE])
    assert residuals[-1] > 0.5 * residuals[0]
    for given in (yielding(coords, host), lambda x: yielding(coords, host)(x)[:2]):
        found = find_equilibrium(given, contact, start, FREE)
        assert found.way == "condensed" and found.iterations <= 7 and np.abs(found.x - near.x).max() < 1e-8


def test_what_is_prescribed_is_moved_in_parts_where_all_of_it_turns_a_cell_inside_out():
    coords = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    contact = Contact(coords, [[0, 1, 2, 3]], "quad", stiffness=K, law="depth", estimator="auto")
    contact.obstacles.add_half_space((0, -5), (0, 1))

    # The lower nodes hang on the upper ones by springs, of which the host's matrix does not know: they follow a solve later.
    def hanging(x):
        inside = np.zeros(8)
        inside[[0, 2]], inside[[1, 3]] = x[:2, 0] - [0, 1], x[:2, 1] - x[[3, 2], 1] + 1.0
        return inside, np.eye(8)

    target = coords - [0.0, 1.5]
    found = find_equilibrium(hanging, contact, coords, np.arange(4), target, two_level=False)
    assert np.array_equal(found.x[2:], target[2:]) and np.abs(found.x - target).max() < 1e-12
    # Half a thickness at a time, and less where that turns the cell.
    assert 3 <= found.parts <= 6


def test_a_contact_without_a_stiffness_gets_one_from_the_bodies(column):
    coords, _, host = column
    contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad", law="depth", estimator="auto")
    with pytest.raises(errors.NoStiffnessError):
        contact.evaluate(pushed(coords, 0.15))
    found = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.15), two_level=False)
    # The method of multipliers: next to no penetration, so the columns alone are in series.
    assert found.residuals[-1] <= 1e-9 and found.updates > 0
    assert found.penetration <= 1e-3 * 0.05
    assert found.reactions[:2, 1].sum() == pytest.approx(0.05 * YOUNG / 2, rel=0.005)


@pytest.mark.parametrize("upper", [1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6])
@pytest.mark.parametrize("lower", [1e-3, 1.0, 1e3])
def test_a_contact_that_is_used_again_follows_another_stiffness_of_the_bodies(lower, upper):
    coords, quads = two_blocks()
    target = coords - [0.0, 0.02] * (coords[:, 1:] > 1.9)
    free = np.flatnonzero(np.repeat((coords[:, 1] > 0) & (coords[:, 1] < 1.9), 2))

    def host(*factors):
        matrix = stiffness(coords, quads, YOUNG * np.repeat(factors, 4))
        return lambda x: (matrix @ (x - coords).ravel(), matrix)

    def force(contact, *factors):
        found = find_equilibrium(host(*factors), contact, coords, free, target)
        return -found.reactions[coords[:, 1] > 1.9, 1].sum()

    used, unused = [Contact(coords, quads, "quad") for _ in range(2)]
    force(used, 1.0, 1.0)
    # Of the penetration of a few thousandths of the push that is left, which is another one by another stiffness.
    assert force(used, lower, upper) == pytest.approx(force(unused, lower, upper), rel=5e-3)


@pytest.mark.parametrize("factor", [1e-6, 1e-3, 0.1, 10.0, 1e3])
def test_bodies_that_all_become_others_stay_where_friction_holds_them(factor):
    coords, quads = two_blocks()
    top = coords[:, 1] > 1.9
    target = coords + [0.002, -0.02] * top[:, None]
    free = np.flatnonzero(np.repeat((coords[:, 1] > 0) & ~top, 2))
    matrix = stiffness(coords, quads, YOUNG)
    contact = Contact(coords, quads, "quad", friction_coefficient=0.5)
    contact.friction.begin_step(coords)
    first = find_equilibrium(lambda x: (matrix @ (x - coords).ravel(), matrix), contact, coords, free, target)
    contact.friction.commit_step(first.x)
    other = factor * matrix
    found = find_equilibrium(lambda x: (other @ (x - coords).ravel(), other), contact, first.x, free, target)
    # Lengths stay but for another update of the multipliers, and all forces are those of other moduli.
    assert np.abs(found.x - first.x).max() < 5e-3 * 0.02
    assert found.reactions[top].sum(axis=0) == pytest.approx(factor * first.reactions[top].sum(axis=0), rel=5e-3)


@pytest.mark.parametrize("asked", [None, 1e-4])
def test_a_corner_within_a_facet_is_told_with_its_penetration(asked):
    coords, quads = two_blocks()
    turned = coords[9:] - coords[9]
    coords[9:] = [0.3, 1.0] + turned @ np.array([[1, 1], [-1, 1]]) / 2**0.5
    top = np.arange(len(coords)) == 17
    target = coords - [0.0, 0.02] * top[:, None]
    free = np.flatnonzero(np.repeat((coords[:, 1] > 0) & ~top, 2))
    matrix = stiffness(coords, quads, YOUNG)

    def search(**options):
        contact = Contact(coords, quads, "quad", **options)
        host = lambda x: (matrix @ (x - coords).ravel(), matrix)
        given = {} if asked is None else {"penetration": asked}
        return find_equilibrium(host, contact, coords, free, target, **given)

    found = search()
    assert found.updates == 0 and any("within single facets" in said for said in found.warnings), found.warnings
    # As hard as that: the force is a good deal larger.
    assert search(stiffness=1e6).reactions[17, 1] < 1.1 * found.reactions[17, 1] < 0


def test_a_body_that_nothing_stops_is_named(column):
    coords, contact, host = column
    free = np.arange(8, 16)

    # The upper square is pulled up, and only its own springs hold it together.
    def pulled(x):
        inside, matrix = host(x)
        inside = inside - np.bincount([13, 15], [1.0, 1.0], 16)
        matrix = matrix - np.diag([1e-3, 0.0] * 8)
        return inside - 1e-3 * np.ravel([[1.0, 0.0]] * 8) * (x - coords).ravel(), matrix

    with pytest.raises(NoSupportError, match="nothing stops") as caught:
        find_equilibrium(pulled, contact, coords, free)
    assert caught.value.body == 1 and not caught.value.is_rotation
    assert caught.value.direction == pytest.approx([0.0, 1.0], abs=1e-6)


def test_a_body_that_nothing_holds_comes_to_rest_on_another(column):
    coords, contact, host = column
    free = np.setdiff1d(np.arange(16), [0, 1, 2, 3])
    weight = np.bincount([9, 11, 13, 15], [-0.25] * 4, 16)
    stiff = np.diag([0.0, 0.0] * 4 + [20.0, 0.0] * 4) + np.diag([20.0, 0.0] * 4 + [0.0, 0.0] * 4)

    def heavy(x):
        inside, matrix = host(x)
        return inside + stiff @ (x - coords).ravel() - weight, matrix + stiff

    found = find_equilibrium(heavy, contact, coords, free)
    assert found.rigid_steps > 0 and found.residuals[-1] <= 1e-9
    # What the ground bears is the weight; the gap of 0.1 is closed.
    assert found.reactions[:2, 1].sum() == pytest.approx(1.0, rel=1e-8)
    assert 0.0 < found.result.penetration < 1e-2 and (found.x[4:6, 1] < coords[4:6, 1] - 0.09).all()


def test_a_chance_balance_is_a_warning(column):
    coords, contact, host = column
    standing = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.102), two_level=False)
    held = 20.0 * np.diag([1.0, 0.0] * 8)
    firm = lambda x: (host(x)[0] + held @ (x - coords).ravel(), host(x)[1] + held)
    sturdy = find_equilibrium(firm, contact, coords, FREE, pushed(coords, 0.102), two_level=False)
    # Soft ground sideways does not keep a square upright on the other's tip; firm ground does.
    assert any("unstable" in one for one in standing.warnings) and sturdy.warnings == []


def test_bodies_are_carried_along_by_what_is_prescribed(column):
    coords, contact, host = column
    found = find_equilibrium(host, contact, coords, FREE, pushed(coords, 0.05))
    # Nothing touches: the upper square follows as one, the lower one stays.
    wanted = coords.copy()
    wanted[4:, 1] -= 0.05
    assert np.abs(found.x - wanted).max() < 1e-12


@pytest.mark.parametrize("degrees", [10, 30, 45, 77])
def test_without_any_load_nothing_moves_that_rounding_alone_presses(degrees):
    """Two squares that touch on an inclined plane: their faces overlap, or not, by what their coordinates are rounded to."""
    turn = np.array([[np.cos(np.radians(degrees)), -np.sin(np.radians(degrees))], [np.sin(np.radians(degrees)), np.cos(np.radians(degrees))]])
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    coords = np.concatenate([square, square + [0.1, 1.0]]) @ turn.T + [0.3, 0.7]
    # Springs between all nodes of a square.
    one = YOUNG * np.kron(4 * np.eye(4) - 1, np.eye(2))
    matrix = np.kron(np.eye(2), one)
    contact = Contact(coords, [[0, 1, 2, 3], [4, 5, 6, 7]], "quad")
    for friction in (0.0, 0.5):
        contact.set_options(friction_coefficient=friction)
        found = find_equilibrium(lambda x: (matrix @ (x - coords).ravel(), matrix), contact, coords, range(8, 16))
        assert np.array_equal(found.x, coords) and found.iterations == 0


@pytest.mark.parametrize(
    ("free", "said"),
    [
        (np.ones(15, bool), "15 marks for 16 unknowns"),
        ([3, 16], r"free\[1\] is 16"),
        ([-1], r"free\[0\] is -1"),
        ([0, 1, 1, 0], "twice: marks"),
    ],
)
def test_unknowns_that_cannot_be_free_are_told(column, free, said):
    coords, contact, host = column
    with pytest.raises(ValueError, match=said):
        find_equilibrium(host, contact, coords, free)
