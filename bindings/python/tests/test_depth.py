"""The law ``"depth"``."""

from __future__ import annotations

import numpy as np
import pytest
from fmc_contact import Contact, contact_force, errors

K = 1e3
DEPTH = 0.01


def blocks(cells: int = 8) -> tuple[np.ndarray, np.ndarray]:
    """Two unit squares of quads, the second ``DEPTH`` deep in the first."""
    line = np.linspace(0.0, 1.0, cells + 1)
    x, y = np.meshgrid(line, line, indexing="ij")
    square = np.stack([x.ravel(), y.ravel()], axis=1)
    first = np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)
    quads = np.stack([first, first + cells + 1, first + cells + 2, first + 1], axis=-1).reshape(-1, 4)
    coords = np.concatenate([square, square + [0.0, 1.0 - DEPTH]])
    return coords, np.concatenate([quads, quads + len(square)])


@pytest.mark.parametrize("estimator", ["exact", "auto"])
def test_flat_faces_press_with_k_times_their_penetration(estimator: str) -> None:
    coords, conn = blocks()
    result = contact_force(coords, conn, "quad", stiffness=K, law="depth", estimator=estimator)
    # Less at the rims, where a wall is nearer than the face.
    assert result.bodies[1].force[1] == pytest.approx(K * DEPTH, rel=0.03)
    assert result.forces.sum(axis=0) == pytest.approx([0.0, 0.0], abs=1e-12 * K * DEPTH)
    # The walls at x = 0 are in one plane, which may be one of symmetry.
    assert [warning.kind for warning in result.warnings] == ["flush_faces"]


@pytest.mark.parametrize("pattern", ["lines", "isotropic"])
def test_estimators_have_no_part_in_it(pattern: str) -> None:
    coords, conn = blocks(2)
    exact = contact_force(coords, conn, "quad", stiffness=K, law="depth", estimator="exact")
    other = contact_force(coords, conn, "quad", stiffness=K, law="depth", estimator="fibers", pattern=pattern)
    assert (other.forces == exact.forces).all() and other.energy == exact.energy


def test_a_smoothing_length_belongs_to_the_law_fiber() -> None:
    coords, conn = blocks(2)
    with pytest.raises(errors.OptionsConflictError, match="'smoothing_length' belongs to the law 'fiber'"):
        Contact(coords, conn, "quad", stiffness=K, law="depth", smoothing_length=0.1)
    contact = Contact(coords, conn, "quad", stiffness=K)
    with pytest.raises(errors.OptionsConflictError, match="'smoothing_length' belongs to the law 'fiber'"):
        contact.pairs.set(0, 1, law="depth", stiffness=K, smoothing_length=0.1)


def test_tangent_is_the_derivative_of_the_force() -> None:
    pytest.importorskip("scipy.sparse")
    coords, conn = blocks(3)
    contact = Contact(coords, conn, "quad", stiffness=K, law="depth", estimator="exact")
    coords = coords + np.random.default_rng(1).uniform(-0.02, 0.02, coords.shape)
    direction = np.random.default_rng(2).uniform(-1.0, 1.0, coords.shape)
    step = 1e-7
    plus, minus = (contact.evaluate(coords + sign * step * direction).forces for sign in (1, -1))
    expected = (minus - plus) / (2 * step)
    found = contact.tangent(coords) @ direction.ravel()
    assert found[: coords.size] == pytest.approx(expected.ravel(), abs=1e-6 * np.abs(expected).max())


def test_reference_and_planes_of_symmetry() -> None:
    coords, conn = blocks(4)
    contact = Contact(coords, conn, "quad", stiffness=K, law="depth", estimator="exact")
    free = contact.evaluate(coords).bodies[1].force[1]
    contact.mesh.set_symmetry_nodes(np.flatnonzero(coords[:, 0] % 1.0 == 0.0))
    held = contact.evaluate(coords).bodies[1].force[1]
    assert held == pytest.approx(K * DEPTH, rel=1e-12)
    assert free < 0.995 * held
    contact.mesh.set_symmetry_nodes([])
    assert contact.evaluate(coords).bodies[1].force[1] == free
    contact.mesh.set_reference(coords * [1.0, 2.0])
    assert contact.evaluate(coords).bodies[1].force[1] > 1.5 * free
    with pytest.raises(errors.NodeOutOfRangeError) as refused:
        contact.mesh.set_symmetry_nodes([0, 1000])
    assert "1000" in str(refused.value)
    with pytest.raises(errors.InvertedCellError):
        contact.mesh.set_reference(coords * [1.0, -1.0])
    assert contact.evaluate(coords).bodies[1].force[1] > 1.5 * free


def test_nodal_pressure() -> None:
    coords, conn = blocks()
    contact = Contact(coords, conn, "quad", stiffness=K, law="depth", estimator="exact")
    field = contact.nodal_contact(coords)
    inner = (np.abs(coords[:, 1] - 1.0) < 1e-12) & (np.abs(coords[:, 0] - 0.5) < 0.3)
    assert field.pressure[inner] == pytest.approx(K * DEPTH, rel=1e-12)
