"""Many hosts assemble into the same memory again: a matrix that was given before is another one then."""

import numpy as np
import pytest
from fmc_contact import Contact, find_equilibrium
from scipy.sparse import coo_matrix, csr_matrix

COORDS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 1.1], [1, 1.1], [1, 2.1], [0, 2.1]])
SQUARES = [[0, 1, 2, 3], [4, 5, 6, 7]]
PAIRS = [(a, b) for square in SQUARES for a in square for b in square if a < b]


def hardening(x):
    """Springs of force 100 d + 5000 d³ between all nodes of a square, along both axes, and their derivative."""
    u, forces, matrix = (x - COORDS).ravel(), np.zeros(16), np.zeros((16, 16))
    for a, b in PAIRS:
        for p, q in ((2 * a, 2 * b), (2 * a + 1, 2 * b + 1)):
            d = u[q] - u[p]
            forces[[q, p]] += (100 * d + 5000 * d**3) * np.array([1, -1])
            matrix[np.ix_((p, q), (p, q))] += (100 + 15000 * d**2) * np.array([[1, -1], [-1, 1]])
    return forces, matrix


dense = np.zeros((16, 16))
rows = csr_matrix(np.ones((16, 16)))


def into_array(matrix):
    dense[:] = matrix
    return dense


def into_rows(matrix):
    rows.data[:] = matrix.ravel()
    return rows


def view_of_rows(matrix):
    into_rows(matrix)
    return csr_matrix((rows.data, rows.indices, rows.indptr), rows.shape, copy=False)


def found(made, **options):
    def host(x):
        forces, matrix = hardening(x)
        return forces, made(matrix)

    end = COORDS.copy()
    end[6:, 1] -= 0.3
    free = np.arange(4, 12)
    return find_equilibrium(host, Contact(COORDS, SQUARES, "quad"), COORDS, free, end, **options)


@pytest.mark.parametrize("two_level", [True, False])
@pytest.mark.parametrize("made", [into_array, into_rows, view_of_rows], ids=lambda made: made.__name__)
def test_a_matrix_in_the_same_memory_is_factorised_again(made, two_level):
    fresh = np.array if made is into_array else csr_matrix
    again, expected = found(made, two_level=two_level), found(fresh, two_level=two_level)
    assert again.iterations == expected.iterations and again.factorisations == expected.factorisations > 1
    # csr_matrix of an array has no entries for zeros: the order of sums is another one.
    assert np.abs(again.x - expected.x).max() < 1e-13 and expected.result.bodies[1].force[1] > 10


def test_a_matrix_of_triplets_is_taken():
    assert np.abs(found(coo_matrix).x - found(csr_matrix).x).max() < 1e-13
