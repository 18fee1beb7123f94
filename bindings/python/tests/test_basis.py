"""Unknowns of a host in place of nodes."""

from importlib.util import find_spec

import numpy as np
import pytest
from fmc_contact import Contact, errors

SQUARES = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.1, 0.9], [0.9, 0.9], [0.9, 1.9], [0.1, 1.9]], float)
CELLS = [[0, 1, 2, 3], [4, 5, 6, 7]]


def contact(**options):
    return Contact(SQUARES, CELLS, "quad", stiffness=1e3, **options)


def rigid():
    """Every body on an origin and two axes: node = origin + x e1 + y e2."""
    matrix = np.zeros((8, 6))
    for node, (x, y) in enumerate(SQUARES):
        matrix[node, 3 * (node // 4) :][:3] = 1, x, y
    return matrix, np.tile([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], (2, 1))


@pytest.mark.parametrize("index_base", [0, 1])
@pytest.mark.parametrize("is_sparse", [False, True])
def test_forces_and_tangent_come_back_through_the_matrix(index_base, is_sparse):
    matrix, unknowns = rigid()
    plain = contact()
    expected = plain.evaluate(SQUARES)
    cells = np.array(CELLS) + index_base
    found = Contact(SQUARES, cells, "quad", stiffness=1e3, index_base=index_base)
    if is_sparse:
        sparse = pytest.importorskip("scipy.sparse")
        found.mesh.set_basis(sparse.coo_matrix(matrix))
    else:
        found.mesh.set_basis(matrix)
    assert (found.node_count, found.unknown_count) == (8, 6)
    result = found.evaluate(unknowns)
    np.testing.assert_allclose(result.forces, matrix.T @ expected.forces, atol=1e-12)
    assert abs(result.energy - expected.energy) < 1e-12
    weights = found.mesh.point_weights()
    np.testing.assert_allclose(weights.to_points(unknowns), SQUARES, atol=1e-15)
    assert found.nodal_contact(unknowns).pressure.shape == (8,)
    assert np.isfinite(found.stable_step(unknowns, np.ones(6)))
    if find_spec("scipy"):
        assert found.tangent(unknowns).shape == (12, 12)
    found.mesh.set_basis(None)
    np.testing.assert_array_equal(found.evaluate(SQUARES).forces, expected.forces)


def test_what_is_no_basis_is_refused():
    matrix, _unknowns = rigid()
    found = contact()
    with pytest.raises(ValueError, match=r"matrix has shape .*, expected \(8, unknowns\)"):
        found.mesh.set_basis(matrix[:7])
    with pytest.raises(ValueError, match="unknowns"):
        found.mesh.set_basis(matrix[0])
    matrix[3, 1] = np.nan
    with pytest.raises(errors.FmcError, match="not|nan|NaN"):
        found.mesh.set_basis(matrix)
    assert found.evaluate(SQUARES).energy > 0
    found.mesh.set_basis(rigid()[0])
    with pytest.raises(errors.FmcError):
        found.evaluate(SQUARES)
