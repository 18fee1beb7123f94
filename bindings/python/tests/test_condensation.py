"""Bodies condensed by the library, beside dense arrays."""

import numpy as np
import pytest
from fmc_contact import Condensation
from fmc_contact.cholesky import Cholesky
from fmc_contact.errors import (
    DofOutOfRangeError,
    LengthError,
    NonFiniteStiffnessError,
    NotFactorisedError,
    NotPositiveDefiniteError,
    RepeatedDofError,
    UnsymmetricError,
)
from fmc_contact.schur import SuperLU

sparse = pytest.importorskip("scipy.sparse")


def membrane(side, held=1.0):
    """A square membrane of springs, held at one corner."""
    chain = sparse.diags([2.0 * np.ones(side), -np.ones(side - 1), -np.ones(side - 1)], [0, 1, -1]).tolil()
    chain[0, 0] = chain[side - 1, side - 1] = 1
    matrix = sparse.kronsum(chain, chain).tolil()
    matrix[0, 0] += held
    return matrix.tocsr()


@pytest.mark.parametrize("form", ["csr", "csc", "coo"])
def test_complement_and_solutions_are_those_of_dense_arrays(form):
    matrix, kept = membrane(12), np.array([5, 60, 61, 143])
    rest = np.setdiff1d(np.arange(144), kept)
    right, at_kept = np.sin(np.arange(144.0)), np.array([0.1, -0.2, 0.3, 0.4])
    factors = Condensation()
    factors.factorise(matrix.asformat(form), kept)
    dense = matrix.toarray()
    inside = np.linalg.inv(dense[np.ix_(rest, rest)])
    across = dense[np.ix_(rest, kept)]
    assert np.allclose(factors.complement, dense[np.ix_(kept, kept)] - across.T @ inside @ across, atol=1e-13)
    assert np.allclose(factors.condense(right), right[kept] - across.T @ inside @ right[rest], atol=1e-13)
    found = factors.expand(right, at_kept)
    assert np.array_equal(found[kept], at_kept)
    assert np.allclose(found[rest], inside @ (right[rest] - across @ at_kept), atol=1e-12)
    factors.factorise(matrix)
    assert factors.complement.shape == (0, 0) and np.allclose(matrix @ factors.expand(right), right, atol=1e-12)


def test_the_lower_triangle_is_enough_and_bits_are_the_same():
    bits = []
    for matrix in (membrane(20), sparse.tril(membrane(20)), membrane(20)):
        factors = Condensation()
        factors.factorise(matrix, np.arange(40))
        bits.append(factors.complement.tobytes())
    assert len(set(bits)) == 1


def test_what_is_refused_is_named_and_leaves_the_factors():
    matrix, factors = membrane(4), Condensation()
    with pytest.raises(NotFactorisedError):
        _ = factors.complement
    factors.factorise(matrix, [3])
    before = factors.complement

    def changed(row, column, value):
        other = matrix.tolil()
        other[row, column] = value
        return other.tocsr()

    for other, kept, error in [
        (matrix, [16], DofOutOfRangeError),
        (matrix, [-1], DofOutOfRangeError),
        (matrix, [2, 2], RepeatedDofError),
        (changed(0, 1, -1.5), [3], UnsymmetricError),
        (changed(0, 0, np.nan), [3], NonFiniteStiffnessError),
    ]:
        with pytest.raises(error):
            factors.factorise(other, kept)
        assert np.array_equal(factors.complement, before)
    with pytest.raises(ValueError, match="square"):
        factors.factorise(matrix[:3])
    with pytest.raises((LengthError, ValueError), match="right"):
        factors.condense(np.zeros(15))
    # A membrane that nothing holds, and one that what is kept holds.
    with pytest.raises(NotPositiveDefiniteError):
        factors.factorise(membrane(4, 0.0))
    with pytest.raises(NotFactorisedError):
        _ = factors.complement
    with pytest.raises(NotFactorisedError):
        factors.expand(np.zeros(16), [0.0])
    factors.factorise(membrane(4, 0.0), [3])
    assert abs(factors.complement[0, 0]) < 1e-13


def test_a_solver_serves_until_the_next_matrix():
    by, rest, kept = Cholesky(SuperLU()), np.arange(1, 16), np.array([0])
    first, _ = by(membrane(4), rest, kept)
    assert np.allclose(first(np.ones((15, 2))), first(np.ones(15))[:, None])
    by(membrane(4, 2.0), rest, kept)
    with pytest.raises(RuntimeError, match="were replaced"):
        first(np.ones(15))
