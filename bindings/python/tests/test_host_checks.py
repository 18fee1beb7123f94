"""``check_host`` and ``Contact.step_limit``."""

import numpy as np
import pytest
from fmc_contact import Contact, NotConvergedError, check_host, find_equilibrium
from fmc_contact.errors import NoStiffnessError

COORDS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.1], [1, 1.1], [1, 2.1], [0, 2.1]])
SQUARES = [[0, 1, 2, 3], [4, 5, 6, 7]]


def springs():
    """Every node of a square hangs on the three others, along both axes: no forces by a translation."""
    matrix = np.zeros((16, 16))
    for square in SQUARES:
        for a in square:
            for b in square:
                for axis in (0, 1):
                    matrix[2 * a + axis, 2 * b + axis] += 3.0 if a == b else -1.0
    return matrix


def said(host, free=range(16)):
    return check_host(host, Contact(COORDS, SQUARES, "quad"), COORDS, free)


def test_a_right_host_is_told_so():
    matrix = springs()
    texts = said(lambda x: (matrix @ (x - COORDS).ravel(), matrix))
    assert not any("WRONG" in text for text in texts)
    assert any("it is the derivative of the residual" in text for text in texts)
    assert "symmetry: the matrix is symmetric" in texts
    assert any("4 rigid motions are held by contact alone" in text for text in texts), texts


@pytest.mark.parametrize(
    ("host", "text"),
    [
        (lambda x: (np.zeros(16), np.eye(16)), "residual: WRONG: it does not depend on the unknowns"),
        (lambda x: (np.zeros(16), np.zeros((16, 16))), "neither the residual nor the matrix depends"),
        (lambda x: (-(x - COORDS).ravel(), np.eye(16)), "it is minus the derivative of the residual"),
        (lambda x: ((x - COORDS).ravel(), 2.0 * np.eye(16)), "matrix: WRONG: it differs"),
        (lambda x: ((x - COORDS).ravel()[::-1], np.eye(16)), "another order of unknowns"),
        (lambda x: (-(x - COORDS).ravel(), -np.eye(16)), "sign: WRONG"),
    ],
)
def test_a_wrong_host_is_told_what_is_wrong(host, text):
    # A matrix of nothing has no stiffness for the contact, which is the last thing that is looked at.
    try:
        texts = said(host)
    except NotConvergedError as error:
        texts = [str(error)]
        assert "resists no motion" in texts[0]
    assert any(text in one for one in texts), texts


def test_an_unsymmetric_matrix_and_springs_to_the_ground_are_told():
    matrix = springs() + 5.0 * np.eye(16)
    matrix[0, 1] += 2.0
    texts = said(lambda x: (matrix @ (x - COORDS).ravel(), matrix))
    assert any("is not symmetric" in text for text in texts)
    assert any("a translation along x of all bodies has forces" in text for text in texts)


def test_a_residual_that_is_not_finite_is_refused():
    with pytest.raises(NotConvergedError, match="unknown 3 is not finite"):
        said(lambda x: (np.where(np.arange(16) == 3, np.nan, 0.0), np.eye(16)))


def test_a_matrix_that_is_not_finite_is_named():
    matrix = np.eye(16)
    matrix[3, 3] = np.nan
    with pytest.raises(NotConvergedError, match="matrix is not finite: NaN at unknown 3"):
        find_equilibrium(lambda x: (x.ravel() - COORDS.ravel(), matrix), Contact(COORDS, SQUARES, "quad"), COORDS, range(16))


@pytest.mark.parametrize(("name", "value"), [("max_iterations", 0), ("max_iterations", -1), ("max_iterations", 2.5), ("max_updates", -1)])
def test_counts_are_named(name, value):
    with pytest.raises(ValueError, match=f"{name} is {value}, expected an integer of at least"):
        find_equilibrium(lambda x: (x.ravel() - COORDS.ravel(), np.eye(16)), Contact(COORDS, SQUARES, "quad"), COORDS, range(16), **{name: value})


def test_a_step_may_go_as_far_as_nothing_passes_through():
    contact = Contact(COORDS, SQUARES, "quad")
    down = np.zeros((8, 2))
    down[4:, 1] = -1.0
    limit = contact.step_limit(COORDS, down)
    # The gap of 0.1 closes at a tenth; beyond it half of a facet of length 1, or half of the thickness of 1/2.
    assert limit.first_touch == pytest.approx(0.1, rel=1e-9)
    assert 0.1 < limit.part <= 0.6
    assert contact.step_limit(COORDS, 0.01 * down).part == 1.0
    assert contact.step_limit(COORDS, -down).first_touch == float("inf")
    with pytest.raises(NoStiffnessError):
        contact.evaluate(COORDS)
