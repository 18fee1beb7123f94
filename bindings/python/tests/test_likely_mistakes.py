"""What a host most likely gets wrong is named, and never leads to an equilibrium of something else."""

import numpy as np
import pytest
from fmc_contact import Contact, NotConvergedError, check_host, find_equilibrium
from scenes import K
from scipy.sparse import csr_matrix

COORDS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.0], [1, 1.0], [1, 2.0], [0, 2.0]])
SQUARES = [[0, 1, 2, 3], [4, 5, 6, 7]]
FREE = np.arange(4, 12)
# Springs between all nodes of a square.
SPRINGS = 100 * np.kron(np.kron(np.eye(2), np.eye(4) - 0.25), np.eye(2))
PUSHED = COORDS - np.outer(np.arange(8) >= 6, (0.0, 0.1))


def found(host, x=COORDS, prescribed=PUSHED, **options):
    return find_equilibrium(host, Contact(COORDS, SQUARES, "quad", **options), x, FREE, prescribed)


def linear(matrix, of=COORDS):
    return lambda x: (matrix @ (x - of).ravel(), matrix)


def test_without_a_mistake_there_is_no_warning():
    assert found(linear(SPRINGS)).warnings == [] and found(linear(csr_matrix(SPRINGS))).result.bodies[1].force[1] > 1


@pytest.mark.parametrize("made", [np.array, csr_matrix])
def test_a_matrix_in_the_order_of_components_is_refused_with_the_way_out(made):
    order = np.arange(16).reshape(8, 2).T.ravel()
    matrix = made(SPRINGS[np.ix_(order, order)])
    for call in (lambda: found(linear(matrix)), lambda: check_host(linear(matrix), Contact(COORDS, SQUARES, "quad"), COORDS, FREE)):
        with pytest.raises(ValueError, match=r"OnUnknowns\(contact, coords, np.arange\(16\).reshape\(2, 8\).T\) takes the host's order"):
            call()


def test_springs_to_the_ground_are_no_other_order():
    assert found(linear(SPRINGS + 1e-3 * np.eye(16))).warnings == []


def test_displacements_in_place_of_coordinates_are_refused():
    host = linear(SPRINGS, 0 * COORDS)
    with pytest.raises(ValueError, match="x is zero: with a Contact x are coordinates; OnUnknowns"):
        found(host, 0 * COORDS, PUSHED - COORDS)
    with pytest.raises(ValueError, match="x is zero"):
        check_host(host, Contact(COORDS, SQUARES, "quad"), 0 * COORDS, FREE)


def test_a_matrix_without_the_rows_of_supports_is_refused_by_its_shape():
    part = SPRINGS[np.ix_(FREE, FREE)]
    with pytest.raises(ValueError, match=r"the matrix has shape \(8, 8\), expected \(16, 16\): rows and columns of unknowns that are not"):
        found(lambda x: ((SPRINGS @ (x - COORDS).ravel()), part))


@pytest.mark.parametrize("diagonal", [1.0, 1e12])
def test_supports_that_are_rows_of_the_unit_matrix_are_told(diagonal):
    matrix, held = SPRINGS.copy(), np.setdiff1d(np.arange(16), FREE)
    matrix[held], matrix[:, held] = 0.0, 0.0
    matrix[held, held] = diagonal
    step = found(linear(csr_matrix(matrix)))
    assert step.result.bodies[1].force[1] == 0 and len(step.warnings) == 1
    assert "the matrix connects no unknown that is moved with any other" in step.warnings[0]


def test_large_numbers_on_the_diagonal_hold_without_a_warning():
    matrix = SPRINGS.copy()
    held = np.setdiff1d(np.arange(16), FREE)
    matrix[held, held] += 1e6
    assert found(linear(matrix)).warnings == []


def test_wrong_signs_are_named_where_no_equilibrium_is_found():
    with pytest.raises(NotConvergedError, match="; matrix: WRONG: it is minus the derivative of the residual"):
        found(lambda x: (-SPRINGS @ (x - COORDS).ravel(), SPRINGS), stiffness=K)
    with pytest.raises(NotConvergedError, match="; sign: WRONG: the matrix pushes along a displacement") as caught:
        found(lambda x: (-SPRINGS @ (x - COORDS).ravel(), -SPRINGS))
    assert "symmetry" not in str(caught.value)


def test_a_host_that_fails_in_the_check_does_not_hide_why_there_is_no_equilibrium():
    calls, last = [], np.inf

    def host(x):
        calls.append(x)
        if len(calls) > last:
            raise RuntimeError("out of licences")
        return -SPRINGS @ (x - COORDS).ravel(), SPRINGS

    def attempt():
        calls.clear()
        contact = Contact(COORDS, SQUARES, "quad", stiffness=K)
        with pytest.raises(NotConvergedError, match="no equilibrium after 1 linear solves") as caught:
            find_equilibrium(host, contact, COORDS, FREE, PUSHED, max_iterations=1)
        return str(caught.value)

    assert "WRONG" in attempt()
    last = len(calls) - 1
    assert "WRONG" not in attempt() and len(calls) == last + 1
