"""What a host most likely gets wrong is named, and never leads to an equilibrium of something else."""

import re

import numpy as np
import pytest
from fmc_contact import Contact, NotConvergedError, OnUnknowns, check_host, find_equilibrium
from fmc_contact.search.bodies import Bodies
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


@pytest.mark.parametrize(
    ("shaped", "text"),
    [
        (lambda x: x.T, r"x has shape \(2, 8\), expected \(8, 2\): with a Contact x are coordinates: transpose it"),
        (np.ravel, r"x has shape \(16,\), expected \(8, 2\): with a Contact x are coordinates"),
        (lambda x: np.c_[x, 0 * x[:, 0]], r"x has shape \(8, 3\), expected \(8, 2\)"),
    ],
)
def test_coordinates_in_another_shape_are_refused_with_the_one_that_is_wanted(shaped, text):
    x, to = shaped(COORDS), shaped(PUSHED)
    with pytest.raises(ValueError, match=text):
        found(linear(SPRINGS, x), x, to)
    with pytest.raises(ValueError, match=text):
        check_host(linear(SPRINGS, x), Contact(COORDS, SQUARES, "quad"), x, FREE)


def test_a_residual_in_columns_is_refused():
    host = lambda x: ((SPRINGS @ (x - COORDS).ravel()).reshape(8, 2).T, SPRINGS)
    with pytest.raises(ValueError, match=r"the residual has shape \(2, 8\), expected \(8, 2\), as x has: transpose it"):
        found(host)
    assert found(lambda x: ((SPRINGS @ (x - COORDS).ravel()).reshape(8, 2), SPRINGS)).warnings == []


LOADS = np.tile([3.0, -2.0], 8)
TAKES_DISPLACEMENTS = r"the residual at the start is as for bodies stretched to twice their size, .*: the function takes displacements"
TAKES_COORDINATES = r"the residual at the start is as for bodies without extent, .*: the function takes coordinates"


# The first of linear bodies, the second of bodies that stiffen in any direction.
@pytest.mark.parametrize("host", [
    lambda u: (SPRINGS @ u - LOADS, SPRINGS),
    lambda u: (SPRINGS @ (u + 0.1 * u**3) - LOADS, SPRINGS @ np.diag(1 + 0.3 * u**2)),
], ids=["linear", "not linear"])  # fmt: skip
@pytest.mark.parametrize("stiffness", [0.0, K])
def test_a_function_of_the_other_unknowns_is_told(host, stiffness):
    """Where there is an equilibrium all the same, it is in its warnings."""
    contact = lambda: Contact(COORDS, SQUARES, "quad", stiffness=stiffness)
    on_host = lambda: OnUnknowns(contact(), COORDS, np.arange(16).reshape(8, 2))
    zeros = np.zeros(16)
    of_coords = lambda x: host((x - COORDS).ravel())
    in_place_of = lambda x: host(x.ravel() - COORDS.ravel())
    assert not told(host, on_host(), zeros) and not told(of_coords, contact(), COORDS)
    assert TAKES_DISPLACEMENTS in told(lambda x: host(x.ravel()), contact(), COORDS)
    assert TAKES_COORDINATES in told(in_place_of, on_host(), zeros)
    wrong = (lambda x: host(x.ravel()), contact(), COORDS, TAKES_DISPLACEMENTS), (in_place_of, on_host(), zeros, TAKES_COORDINATES)
    for function, of, x, text in wrong:
        assert any(re.match("unknowns: WRONG: " + text, one) for one in check_host(function, of, x, FREE))
        assert not any("unknowns: WRONG" in one for one in check_host(of_coords, contact(), COORDS, FREE))


def told(host, contact, x):
    """The one of the sentences that a search says, in its failure or in warnings."""
    try:
        texts = find_equilibrium(host, contact, x, FREE, max_iterations=20).warnings
    except NotConvergedError as error:
        texts = [str(error)]
    return [sentence for sentence in (TAKES_DISPLACEMENTS, TAKES_COORDINATES) if any(re.search(sentence, text) for text in texts)]


def test_a_host_may_write_to_the_same_memory_again_where_another_state_is_looked_at():
    def host(x):
        residual[:] = SPRINGS @ x.ravel() - LOADS
        return residual, SPRINGS

    residual = np.zeros(16)
    bodies = Bodies(host, Contact(COORDS, SQUARES, "quad"), (8, 2), FREE, None)
    first, _ = bodies.forces(COORDS.ravel(), True)
    assert bodies.hints and (first == SPRINGS @ COORDS.ravel() - LOADS).all()
    again, _ = bodies.forces(COORDS.ravel(), True)
    assert (again == first).all()


def test_places_in_place_of_displacements_are_refused():
    on_host = OnUnknowns(Contact(COORDS, SQUARES, "quad"), COORDS, np.arange(16).reshape(8, 2))
    host = lambda u: (SPRINGS @ u, SPRINGS)
    for call in (find_equilibrium, check_host):
        with pytest.raises(ValueError, match="x are the places of the nodes without displacement: with this contact x are displacements"):
            call(host, on_host, COORDS.ravel(), FREE)


def test_offsets_that_are_no_numbers_are_named():
    contact = Contact(COORDS, SQUARES, "quad", stiffness=K)
    offsets = np.zeros((8, 2))
    offsets[3, 1] = np.nan
    with pytest.raises(ValueError, match=r"offsets\[3, 1\] is nan, expected finite numbers"):
        contact.mesh.offsets = offsets
    with pytest.raises(ValueError, match=r"offsets has shape \(2, 8\), expected \(nodes, 2\): transpose it"):
        contact.mesh.offsets = np.zeros((2, 8))
    contact.mesh.offsets = np.full((8, 2), 0.01)
    assert (contact.mesh.offsets == 0.01).all()


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
