"""A host that numbers its unknowns in its own way finds what one finds that numbers them as the contact does."""

import numpy as np
import pytest
from fmc_contact import Contact, OnUnknowns, check_host, find_equilibrium
from scenes import K, same_bits
from scipy.sparse import csr_matrix

COORDS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.0], [1, 1.0], [1, 2.0], [0, 2.0]])
SQUARES = [[0, 1, 2, 3], [4, 5, 6, 7]]
HELD = np.array([0, 1, 2, 3, 12, 13, 14, 15])
FREE = np.setdiff1d(np.arange(16), HELD)
# Squares of springs between all nodes, and a push that presses them together by a tenth.
SPRINGS = 100 * np.kron(np.kron(np.eye(2), np.eye(4) - 0.25), np.eye(2))
PUSH = np.where(np.arange(16) >= 12, np.tile([0.0, -0.1], 8), 0.0)

BY_COMPONENTS = np.arange(16).reshape(2, 8).T
SHUFFLED = np.random.default_rng(3).permutation(16).reshape(8, 2)
WITH_GAPS = 2 * np.arange(16).reshape(8, 2) + 1


def contact():
    return Contact(COORDS, SQUARES, "quad", stiffness=K)


def in_order_of(numbers, size):
    """The springs, the unknowns that are solved for and the push, for a host of these numbers."""
    matrix, push = np.zeros((size, size)), np.zeros(size)
    to = np.ravel(numbers)
    matrix[np.ix_(to, to)], push[to] = SPRINGS, PUSH
    return matrix, to[FREE], push


def by_contact(**options):
    return find_equilibrium(lambda x: (SPRINGS @ (x - COORDS).ravel(), SPRINGS), contact(), COORDS, FREE, COORDS + PUSH.reshape(8, 2), **options)


@pytest.mark.parametrize("two_level", [True, False])
@pytest.mark.parametrize("numbers", [BY_COMPONENTS, SHUFFLED, WITH_GAPS], ids=["by components", "shuffled", "with gaps"])
def test_a_host_with_numbers_in_another_order_finds_the_same_equilibrium(numbers, two_level):
    size = int(numbers.max()) + 2
    on_host = OnUnknowns(contact(), COORDS, numbers, size)
    matrix, free, push = in_order_of(numbers, size)
    found = find_equilibrium(lambda u: (matrix @ u, matrix), on_host, np.zeros(size), free, push, two_level=two_level)
    expected = by_contact(two_level=two_level)
    # Up to the order of sums.
    assert np.abs(on_host.coords(found.x) - expected.x).max() < 1e-13
    assert np.abs(found.reactions[np.ravel(numbers)] - expected.reactions.ravel()).max() < 1e-11
    assert expected.result.bodies[1].force[1] > 1
    assert not found.x[np.setdiff1d(np.arange(size), numbers)].any() and found.way == expected.way


@pytest.mark.parametrize("two_level", [True, False])
def test_coordinates_without_an_unknown_stay(two_level):
    numbers = np.full(16, -1)
    moved = np.setdiff1d(np.arange(16), HELD[:4])
    numbers[moved] = np.arange(12)[::-1]
    on_host = OnUnknowns(contact(), COORDS, numbers.reshape(8, 2))
    matrix, push = np.zeros((12, 12)), np.zeros(12)
    matrix[np.ix_(numbers[moved], numbers[moved])], push[numbers[moved]] = SPRINGS[np.ix_(moved, moved)], PUSH[moved]
    free = numbers[FREE]
    found = find_equilibrium(lambda u: (matrix @ u, matrix), on_host, np.zeros(12), free, push, two_level=two_level)
    expected = by_contact(two_level=True)
    assert on_host.size == 12 and (found.way == "condensed") is two_level
    # The search ends at a residual of 1e-9 of the forces.
    assert np.abs(on_host.coords(found.x) - expected.x).max() < (1e-13 if two_level else 1e-9)
    assert same_bits(on_host.coords(found.x)[:2], COORDS[:2])


def test_forces_and_tangent_are_brought_into_the_order_of_the_host():
    on_host, below = OnUnknowns(contact(), COORDS, SHUFFLED), contact()
    u = np.random.default_rng(5).normal(0, 0.02, 16)
    x = COORDS + u[SHUFFLED]
    assert same_bits(on_host.coords(u), x)
    result = below.evaluate(x)
    forces = on_host.on_dofs(on_host.evaluate(u).forces)
    assert np.abs(forces).max() > 0.1 and same_bits(forces[SHUFFLED], result.forces)
    to = SHUFFLED.ravel()
    for options in ({}, {"semidefinite": True}, {"symmetric": True}):
        tangent = on_host.tangent(u, **options)
        assert isinstance(tangent, csr_matrix)
        assert same_bits(tangent.toarray()[np.ix_(to, to)], below.tangent(x, **options).toarray())


@pytest.mark.parametrize("two_level", [True, False])
def test_nodes_may_be_counted_from_one(two_level):
    below = Contact(COORDS, np.array(SQUARES) + 1, "quad", stiffness=K, index_base=1)
    on_host = OnUnknowns(below, COORDS, SHUFFLED)
    matrix, free, push = in_order_of(SHUFFLED, 16)
    found = find_equilibrium(lambda u: (matrix @ u, matrix), on_host, np.zeros(16), free, push, two_level=two_level)
    assert np.abs(on_host.coords(found.x) - by_contact(two_level=two_level).x).max() < 1e-13


def test_a_host_is_checked_in_its_own_order():
    on_host = OnUnknowns(contact(), COORDS, BY_COMPONENTS)
    matrix, free, _ = in_order_of(BY_COMPONENTS, 16)
    texts = check_host(lambda u: (matrix @ u, matrix), on_host, np.zeros(16), free)
    assert "symmetry: the matrix is symmetric" in texts and not any("WRONG" in text for text in texts)


@pytest.mark.parametrize(
    ("numbers", "size", "text"),
    [
        (np.arange(16).reshape(2, 8), None, r"unknowns have the shape \(2, 8\), expected \(8, 2\)"),
        (np.arange(16.0).reshape(8, 2), None, "unknowns have the type float64, expected integers"),
        (np.arange(16).reshape(8, 2) % 15, None, r"unknowns\[7, 1\] is 0, which moves another coordinate too"),
        (np.arange(16).reshape(8, 2), 12, r"unknowns\[6, 0\] is 12, which is not below the size, 12"),
        (np.arange(16).reshape(8, 2), 16.5, "the size is 16.5, expected an integer"),
        (np.arange(16).reshape(8, 2) - 2, None, r"unknowns\[0, 0\] is -2, which is below -1"),
    ],
)
def test_numbers_that_cannot_be_are_refused_by_place(numbers, size, text):
    with pytest.raises(ValueError, match=text):
        OnUnknowns(contact(), COORDS, numbers, size)


def test_displacements_of_another_length_are_refused():
    with pytest.raises(ValueError, match=r"u has shape \(8, 2\), expected \(16,\)"):
        OnUnknowns(contact(), COORDS, SHUFFLED).coords(COORDS)
