"""What elimination leaves, beside inverses of dense arrays."""

import numpy as np
import pytest
from fmc_contact.cholesky import Cholesky
from fmc_contact.schur import SuperLU

sparse = pytest.importorskip("scipy.sparse")


def springs(size, seed):
    """A stiffness that is symmetric but for a part in ten, held, of a grid that has no order."""
    random = np.random.default_rng(seed)
    matrix = sparse.random(size, size, 4 / size, random_state=np.random.RandomState(1), data_rvs=random.standard_normal)
    matrix = (matrix + matrix.T + 0.1 * sparse.triu(matrix + matrix.T)).tocsr()
    return (matrix + sparse.diags(abs(matrix).sum(axis=1).A1 + abs(matrix).sum(axis=0).A1 + 1)).tocsr()


def by_mumps():
    pytest.importorskip("petsc4py.PETSc")
    from fmc_contact.mumps import Mumps, is_there

    if not is_there():
        pytest.skip("PETSc without MUMPS")
    return Mumps()


def by_cholesky():
    return Cholesky(SuperLU())


ENGINES = pytest.mark.parametrize("engine", [SuperLU, by_cholesky, by_mumps])


def check(found, matrix, rest, kept):
    solve, complement = found
    dense = matrix.toarray()
    inside = np.linalg.inv(dense[np.ix_(rest, rest)])
    expected = dense[np.ix_(kept, kept)] - dense[np.ix_(kept, rest)] @ inside @ dense[np.ix_(rest, kept)]
    assert np.abs(complement - expected).max() < 1e-12 * np.abs(expected).max()
    for right in (np.sin(np.arange(len(rest))), np.cos(np.arange(3.0 * len(rest)).reshape(-1, 3))):
        assert np.abs(solve(right) - inside @ right).max() < 1e-12 * np.abs(inside @ right).max()


@ENGINES
def test_one_matrix_after_another(engine):
    by, kept = engine(), np.arange(7, 300, 9)
    rest = np.setdiff1d(np.arange(300), kept)
    for seed in range(4):
        check(by(springs(300, seed), rest, kept), springs(300, seed), rest, kept)
    # Another pattern, other unknowns, none that are kept, none that are not.
    check(by(springs(210, 2), np.arange(200), np.arange(200, 210)), springs(210, 2), np.arange(200), np.arange(200, 210))
    check(by(springs(300, 1), rest[:-5], kept), springs(300, 1), rest[:-5], kept)
    stiff = springs(300, 0)
    check(by((stiff + stiff.T).tocsr(), rest, kept), (stiff + stiff.T).tocsr(), rest, kept)
    solve, complement = by(springs(50, 0), np.arange(50), np.arange(0))
    assert complement.shape == (0, 0) and np.allclose(springs(50, 0) @ solve(np.ones(50)), 1)
    solve, complement = by(springs(50, 0), np.arange(0), np.arange(50))
    assert np.array_equal(complement, springs(50, 0).toarray())


@ENGINES
def test_a_rest_that_is_not_held_is_an_error(engine):
    loose = springs(60, 0).tolil()
    loose[3, :], loose[:, 3] = 0, 0
    with pytest.raises(RuntimeError, match="singular"):
        engine()(loose.tocsr(), np.arange(50), np.arange(50, 60))
