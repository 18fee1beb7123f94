"""Derivatives against central differences, each in a contact that has the other value."""

import numpy as np
import pytest
from fmc_contact import Contact, FmcError, Pose
from fmc_contact.errors import UnsupportedError
from scenes import grid, triangles

STEP = 1e-6
WITHIN = 1e-6
"""Of a derivative by its size: a step of 1e-6 has a rounding of 1e-10 of the value, and no truncation to speak of."""


def disturbed(coords, seed, by=0.02):
    return coords + by * np.random.default_rng(seed).uniform(-1, 1, coords.shape)


def plane():
    """Two blocks of squares and triangles on no lattice, and where they press on one another."""
    (a, of_a), (b, of_b) = grid((5, 3), (0, 1.5), (-1, 0)), grid((3, 3), (0.3, 1.3), (0, 0.8))
    reference = disturbed(np.concatenate([a, b]), 1)
    cells = [("quad", of_a), ("triangle", triangles(of_b + len(a)))]
    coords = disturbed(reference, 2)
    coords[len(a) :, 1] -= 0.25
    return reference, cells, coords


def space():
    """Two blocks of hexahedra on no lattice."""
    shape = np.array([3, 3, 3])
    lattice = np.stack(np.meshgrid(*(np.arange(n) for n in shape), indexing="ij"), -1).reshape(-1, 3).astype(float)
    number = np.arange(27).reshape(shape)
    at = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    first = [(i, j, k) for i in range(2) for j in range(2) for k in range(2)]
    of_one = np.array([[number[i + a, j + b, k + c] for a, b, c in at] for i, j, k in first])
    a, b = lattice * [0.7, 0.6, 0.5], lattice * [0.5, 0.45, 0.4] + [0.2, 0.1, 1.0]
    reference = disturbed(np.concatenate([a, b]), 3)
    coords = disturbed(reference, 4)
    coords[27:, 2] -= 0.25
    return reference, [("hexahedron", of_one), ("hexahedron", of_one + 27)], coords


SCENES = pytest.mark.parametrize("scene", [plane, space])


def contact_of(reference, cells, **options):
    return Contact(reference, cells, **{"stiffness": 30.0, **options})


def values(contact, coords, adjoint):
    found = contact.evaluate(coords)
    return np.array([found.energy, (adjoint * found.forces).sum()])


def compare(gradient, value, direction):
    """A gradient along a direction against the differences of ``value``, a function of how far to go."""
    slope = (value(STEP) - value(-STEP)) / (2 * STEP)
    size = np.linalg.norm(gradient)
    assert size > 0 and abs((gradient * direction).sum() - slope) < WITHIN * size, ((gradient * direction).sum(), slope)


@SCENES
@pytest.mark.parametrize("of", [0, 1], ids=["energy", "forces"])
@pytest.mark.parametrize("name", ["coords", "reference"])
def test_by_nodes(scene, of, name):
    reference, cells, coords = scene()
    random = np.random.default_rng(7)
    adjoint, direction = random.uniform(-1, 1, (2, *coords.shape))
    contact = contact_of(reference, cells)
    seeds = {"energy": 1.0} if of == 0 else {"adjoint": adjoint}
    gradient = getattr(contact.vjp(coords, by=[name], **seeds), name)

    def value(by):
        if name == "coords":
            return values(contact, coords + by * direction, adjoint)[of]
        return values(contact_of(reference + by * direction, cells), coords, adjoint)[of]

    compare(gradient, value, direction)


def test_a_punch_that_is_shaped_anew():
    """The forces on a block, as a punch is re-shaped: its nodes and its undeformed nodes move together. The coordinates alone are
    18 % off."""
    reference, cells, coords = plane()
    lower = np.arange(len(coords)) < 24
    random = np.random.default_rng(0)
    adjoint = random.standard_normal(coords.shape) * lower[:, None]
    direction = random.standard_normal(coords.shape) * ~lower[:, None]
    found = contact_of(reference, cells).vjp(coords, adjoint, by=["coords", "reference"])

    def value(by):
        return values(contact_of(reference + by * direction, cells), coords + by * direction, adjoint)[1]

    compare(found.coords + found.reference, value, direction)
    slope = (found.coords + found.reference) * direction
    assert abs((found.coords * direction).sum() / slope.sum() - 1) > 1e-3


@pytest.mark.parametrize("law", ["depth", "volume", "fiber"])
def test_by_stiffness(law):
    reference, cells, coords = plane()
    adjoint = np.random.default_rng(7).uniform(-1, 1, coords.shape)
    contact = contact_of(reference, cells, law=law, estimator="exact")
    found = contact.vjp(coords, adjoint, energy=2.0, by=["stiffness"])
    assert found.coords is None and found.reference is None and len(found.pairs) == 1
    slopes = values(contact, coords, adjoint) @ [2.0, 1.0] / 30.0
    assert found.stiffness == pytest.approx(slopes, rel=1e-12)


def obstacle_scene(law):
    reference, cells, coords = plane()
    contact = contact_of(reference, cells, law=law, estimator="exact")
    contact.pairs.set(0, 1, excluded=True)
    return contact, coords


@pytest.mark.parametrize("of", [0, 1], ids=["energy", "forces"])
@pytest.mark.parametrize("law", ["depth", "volume"])
def test_by_the_pose_of_an_obstacle(law, of):
    contact, coords = obstacle_scene(law)
    normal = np.array([0.3, 1.0]) / np.hypot(0.3, 1.0)
    start, turn = np.array([0.1, -0.9]), 0.2
    random = np.random.default_rng(7)
    adjoint, shift = random.uniform(-1, 1, coords.shape), np.array([0.4, -0.7])
    seeds = {"energy": 1.0} if of == 0 else {"adjoint": adjoint}

    def placed(position, angle):
        rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        contact.obstacles.set_pose(0, Pose(position, rotation))
        return values(contact, coords, adjoint)[of]

    contact.obstacles.add_half_space(start, normal)
    placed(start, turn)
    found = contact.vjp(coords, by=["positions", "rotations", "gap_offset"], **seeds)
    compare(found.positions[0], lambda by: placed(start + by * shift, turn), shift)
    compare(found.rotations[0], lambda by: placed(start, turn + by), np.array([0, 0, 1]))
    placed(start, turn)

    def out(by):
        for body in (0, 1):
            contact.pairs.set(body, ("obstacle", 0), gap_offset=by)
        return values(contact, coords, adjoint)[of]

    compare(np.array([sum(pair.gap_offset for pair in found.pairs)]), out, 1.0)


def test_by_the_coefficient_of_friction():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells, friction_coefficient=0.3)
    before = coords.copy()
    before[24:] -= [0.05, -0.1]
    contact.friction.begin_step(before)
    adjoint = np.random.default_rng(7).uniform(-1, 1, coords.shape)
    found = contact.vjp(coords, adjoint, by=["friction"])

    def value(by):
        contact.set_options(friction_coefficient=0.3 + by)
        return values(contact, coords, adjoint)[1]

    compare(np.array([found.pairs[0].friction]), value, 1.0)
    contact.set_options(friction_coefficient=0.3)
    with pytest.raises(UnsupportedError, match="unless friction is frozen"):
        contact.vjp(coords, adjoint)
    # Without a facet so near to its limit that differences would pass it.
    contact.friction.begin_step(coords - np.array([0.05, 0]) * (np.arange(len(coords)) >= 24)[:, None])
    contact.friction.freeze(coords)
    found = contact.vjp(coords, adjoint)
    direction = np.random.default_rng(8).uniform(-1, 1, coords.shape)
    compare(found.coords, lambda by: values(contact, coords + by * direction, adjoint)[1], direction)
    with pytest.raises(UnsupportedError, match="friction by reference coordinates"):
        contact.vjp(coords, adjoint, by=["reference"])
    with pytest.raises(UnsupportedError, match="frictional forces by the stiffness of a pair while friction is frozen"):
        contact.vjp(coords, adjoint, by=["stiffness"])


def test_what_is_not_known_is_refused():
    reference, cells, coords = plane()
    adjoint = np.ones_like(coords)
    with pytest.raises(UnsupportedError, match="unless its patches are kept"):
        contact_of(reference, cells, law="fiber", estimator="exact").vjp(coords, adjoint)
    with pytest.raises(UnsupportedError, match="gap offset between bodies"):
        contact_of(reference, cells).vjp(coords, adjoint, by=["gap_offset"])
    ring = contact_of(reference + [2, 0], cells, axisymmetric=True)
    with pytest.raises(UnsupportedError, match="axisymmetry"):
        ring.vjp(coords + [2, 0], adjoint, by=["reference"])
    with pytest.raises(ValueError, match="'by' has no value 'shape'"):
        contact_of(reference, cells).vjp(coords, adjoint, by=["shape"])
    with pytest.raises(FmcError):
        contact_of(reference, cells).vjp(coords, adjoint * np.nan)


def test_other_laws_have_nothing_of_the_reference():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells, law="volume", estimator="exact")
    assert (contact.vjp(coords, energy=1.0, by=["reference"]).reference == 0).all()


def test_nothing_is_asked_for():
    reference, cells, coords = plane()
    contact = contact_of(reference, cells)
    before = contact.evaluate(coords).forces.tobytes()
    found = contact.vjp(coords, np.ones_like(coords), by=[])
    assert found.coords is None and found.pairs == () and contact.evaluate(coords).forces.tobytes() == before
