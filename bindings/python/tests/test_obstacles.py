"""Obstacles against the overlap that they have with a square or a cube, and the push that follows."""

import numpy as np
import pytest
from fmc_contact import Contact, Part, Pose, Shape
from fmc_contact.errors import (
    DegenerateHullError,
    EmptyCompoundError,
    NonFiniteHeightError,
    ObstacleOutOfRangeError,
    ObstacleRemovedError,
    SignedDistanceError,
    TooFewHeightsError,
    UnsupportedError,
)
from scenes import K, same_bits

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
CUBE = np.vstack([np.c_[SQUARE, np.zeros(4)], np.c_[SQUARE, np.ones(4)]])
LAW = {"stiffness": K, "law": "volume"}
FINE = LAW | {"fiber_count": 20000}


def body(dim, **options):
    options = (LAW if options.get("estimator") == "exact" else FINE) | options
    if dim == 2:
        return Contact(SQUARE, [[0, 1, 2, 3]], "quad", **options)
    return Contact(CUBE, [list(range(8))], "hexahedron", **options)


def centre(dim, height):
    """Above or below the middle of the body, at ``height``."""
    return (0.5,) * (dim - 1) + (height,)


def up(dim):
    return (0.0,) * (dim - 1) + (1.0,)


def wedge(dim):
    """A box 2 wide and 1 high below its origin, as a polytope."""
    if dim == 2:
        return np.array([[-1, -1], [1, -1], [1, 0], [-1, 0.0]]), [[0, 1], [1, 2], [2, 3], [3, 0]]
    low, high = [[-1, -1], [1, -1], [1, 1], [-1, 1]], [0, 1, 2, 3]
    points = np.array([[*xy, -1.0] for xy in low] + [[*xy, 0.0] for xy in low])
    sides = [t for a, b in zip(high, high[1:] + [0]) for t in ([a, b, b + 4], [a, b + 4, a + 4])]
    return points, [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], *sides]


def plane(points):
    return points[:, -1], np.tile(np.eye(points.shape[1])[-1], (len(points), 1))


# Every flat obstacle reaches up into the body from below, 0.25 deep and wider than the body.
FLAT = {
    "half space": lambda c, d: c.obstacles.add_half_space(centre(d, 0.25), up(d)),
    "half space of any normal": lambda c, d: c.obstacles.add_half_space(centre(d, 0.25), [3 * x for x in up(d)]),
    "cuboid": lambda c, d: c.obstacles.add_cuboid((1,) * d, centre(d, -0.75)),
    "cylinder": lambda c, d: c.obstacles.add_cylinder(2, 0.5, centre(d, -0.25)),
    "polytope": lambda c, d: c.obstacles.add_polytope(*wedge(d), centre(d, 0.25)),
    "polytope of int32": lambda c, d: c.obstacles.add_polytope(wedge(d)[0], np.array(wedge(d)[1], np.int32), centre(d, 0.25)),
    "polytope in columns": lambda c, d: c.obstacles.add_polytope(wedge(d)[0].T, wedge(d)[1], centre(d, 0.25)),
    "signed distance": lambda c, d: c.obstacles.add_signed_distance(plane, centre(d, 0.25)),
    "scaled cuboid": lambda c, d: c.obstacles.add_cuboid((0.5,) * d, Pose(centre(d, -0.75), scale=2)),
    "turned cuboid": lambda c, d: c.obstacles.add_cuboid((1,) * d, Pose.along(centre(d, -0.75), [-x for x in up(d)])),
}


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("name", FLAT)
def test_flat_obstacles_push_upwards(name, dim):
    contact = body(dim)
    assert FLAT[name](contact, dim) == 0 and contact.obstacles.count == 1
    result = contact.evaluate(SQUARE if dim == 2 else CUBE)
    assert result.volume == pytest.approx(0.25, rel=0.01)
    (obstacle,) = result.obstacles
    assert obstacle.id == 0 and obstacle.node_count == 0
    assert obstacle.force == pytest.approx([-K * x for x in up(dim)], abs=0.02 * K)
    assert result.bodies[0].force == pytest.approx(-obstacle.force, abs=1e-9 * K)
    assert result.pairs[0].a == ("body", 0) and result.pairs[0].b == ("obstacle", 0)


# Half of each round obstacle is inside the body: centred on its lower face.
ROUND = {
    "ball": (lambda c, d: c.obstacles.add_ball(0.25, centre(d, 0)), {2: np.pi / 32, 3: np.pi / 96}),
    "capsule": (
        lambda c, d: c.obstacles.add_capsule(0.125, 0.25, centre(d, 0)),
        {2: 0.0625 + np.pi / 128, 3: np.pi / 256 + np.pi / 768},
    ),
    # Apex 0.25 above the face, base 0.25 below it: half its radius where they meet.
    "cone": (lambda c, d: c.obstacles.add_cone(0.25, 0.25, centre(d, 0)), {2: 0.125 * 0.25, 3: np.pi * 0.125**2 * 0.25 / 3}),
}


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("name", ROUND)
def test_round_obstacles_overlap_by_their_volume(name, dim):
    add, volume = ROUND[name]
    contact = body(dim)
    add(contact, dim)
    result = contact.evaluate(SQUARE if dim == 2 else CUBE)
    assert result.volume == pytest.approx(volume[dim], rel=0.01)
    assert result.bodies[0].force[-1] > 0


def test_an_obstacle_moves_with_its_pose():
    contact = body(2, estimator="exact")
    wall = contact.obstacles.add_half_space((0, -1), (0, 1))
    assert contact.evaluate(SQUARE).volume == 0
    contact.obstacles.set_pose(wall, (0, 0.25))
    assert contact.evaluate(SQUARE).volume == pytest.approx(0.25)
    contact.obstacles.set_pose(wall, Pose.along((0, 0.75), (0, -1)))
    assert contact.evaluate(SQUARE).volume == pytest.approx(0.25)
    contact.obstacles.set_pose(wall, None)
    assert contact.evaluate(SQUARE).volume == pytest.approx(1)
    contact.obstacles.set_pose(wall, Pose((0, 0), np.eye(2)))
    assert contact.evaluate(SQUARE).volume == pytest.approx(0)


@pytest.mark.parametrize("dim", [2, 3])
def test_a_pose_without_a_rotation_keeps_the_one_there_is(dim):
    contact, down = body(dim, estimator="exact"), -np.eye(dim)[-1]
    ceiling = contact.obstacles.add_half_space(0.9 * -down, down)
    force = contact.evaluate(SQUARE if dim == 2 else CUBE).obstacles[ceiling].force
    assert force[-1] > 0
    at = np.r_[[5.0] * (dim - 1), 0.9]
    for pose in (at, Pose(at), Pose(at, None), Pose(at, scale=1.0)):
        contact.obstacles.set_pose(ceiling, pose)
        assert contact.obstacles.get(ceiling).pose.rotation @ -down == pytest.approx(down, abs=1e-15)
        found = contact.evaluate(SQUARE if dim == 2 else CUBE).obstacles[ceiling].force
        # Of a plane that has moved along itself.
        assert found == pytest.approx(force, rel=1e-12, abs=1e-12 * force[-1])


def test_a_pose_keeps_what_it_does_not_give_and_no_more():
    contact = body(2)
    turn = [[0.6, -0.8], [0.8, 0.6]]
    box = contact.obstacles.add_cuboid((1, 1), Pose((5, 5), turn, 2.0))
    pose = lambda: repr(contact.obstacles.get(box).pose)
    contact.obstacles.set_pose(box, (6, 6))
    assert pose() == repr(Pose((6, 6), turn, 2.0))
    contact.obstacles.set_pose(box, Pose((7, 7), scale=3.0))
    assert pose() == repr(Pose((7, 7), turn, 3.0))
    contact.obstacles.set_pose(box, Pose((8, 8), np.eye(2)))
    assert pose() == repr(Pose((8, 8), np.eye(2), 3.0))
    given = Pose((9, 9))
    given.rotation, given.scale = turn, 1.0
    contact.obstacles.set_pose(box, given)
    assert pose() == repr(Pose((9, 9), turn, 1.0))
    # An array that is no longer anyone's would take a rotation, and lose it.
    with pytest.raises(ValueError, match="read-only"):
        Pose((0, 0)).rotation[:] = turn


def test_a_removed_obstacle_is_gone_and_the_others_keep_their_numbers():
    def gone(points):
        raise AssertionError("a removed obstacle is asked for its distance")

    contact, alone = body(2), body(2)
    moved = contact.obstacles.add_signed_distance(gone)
    wall = contact.obstacles.add_half_space((0, 0.25), (0, 1))
    alone.obstacles.add_half_space((0, 0.25), (0, 1))
    pose = Pose.along((1, 2), (3, 4), scale=2)
    contact.obstacles.set_pose(moved, pose)
    shape, found = contact.obstacles.get(moved)
    assert shape == "signed_distance" and repr(found) == repr(pose)
    assert contact.obstacles.get(wall)[0] == "half_space" and contact.obstacles.get(wall)[1].position.tolist() == [0, 0.25]
    contact.pairs.set(0, ("obstacle", moved), excluded=True)
    contact.obstacles.remove(moved)
    result, expected = contact.evaluate(SQUARE), alone.evaluate(SQUARE)
    assert same_bits(result.forces, expected.forces)
    assert [obstacle.force.tolist() for obstacle in result.obstacles] == [[0, 0], expected.obstacles[0].force.tolist()]
    for call in (
        lambda: contact.obstacles.remove(moved),
        lambda: contact.obstacles.get(moved),
        lambda: contact.obstacles.set_pose(moved, None),
        lambda: contact.pairs.set(0, ("obstacle", moved)),
    ):
        with pytest.raises(ObstacleRemovedError, match="obstacle 0 was removed"):
            call()
    with pytest.raises(ObstacleOutOfRangeError, match="no obstacle 2"):
        contact.obstacles.remove(2)
    with pytest.raises(IndexError, match="no obstacle -1"):
        contact.obstacles.get(-1)
    assert contact.obstacles.add_ball(1.0, (5, 5)) == 2 == contact.obstacles.count - 1


def test_poses_say_where_they_are():
    pose = Pose.along((1, 2, 3), (0, 1, 0), scale=2)
    assert pose.rotation @ [0, 0, 1] == pytest.approx([0, 1, 0]) and np.linalg.det(pose.rotation) == pytest.approx(1)
    assert repr(Pose((1, 2))) == "Pose([1.0, 2.0], None)" and repr(Pose((1, 2), scale=3)) == "Pose([1.0, 2.0], None, 3.0)"
    assert repr(Pose((1, 2), np.eye(2), 1)) == "Pose([1.0, 2.0], [[1.0, 0.0], [0.0, 1.0]], 1.0)"
    with pytest.raises(ValueError, match="position has shape"):
        Pose(0.0)
    with pytest.raises(ValueError, match="rotation has shape"):
        Pose((0, 0), np.eye(3))


def test_what_a_signed_distance_raises_comes_out():
    class Unexpected(Exception):
        pass

    def fail(points):
        raise Unexpected(f"{len(points)} points")

    contact = body(2)
    contact.obstacles.add_signed_distance(fail)
    out = np.full((4, 2), 7.0)
    with pytest.raises(Unexpected, match="points"):
        contact.evaluate(SQUARE, out=out)
    assert np.all(out == 7)
    # The same contact, the same answer; an error that was raised does not come back.
    with pytest.raises(Unexpected):
        contact.evaluate(SQUARE)


def test_a_keyboard_interrupt_comes_out():
    def interrupt(points):
        raise KeyboardInterrupt

    contact = body(2)
    contact.obstacles.add_signed_distance(interrupt)
    with pytest.raises(KeyboardInterrupt):
        contact.evaluate(SQUARE)


def test_bad_signed_distances_are_refused():
    for error, text, function in [
        (SignedDistanceError, "obstacle 0", lambda x: (np.full(len(x), np.nan), x)),
        (ValueError, r"phi, returned by the signed distance, has shape \(1,\), expected \(9,\)", lambda x: (np.zeros(1), x)),
        (ValueError, "grad, returned by the signed distance, has shape", lambda x: (np.zeros(len(x)), x[:, :1])),
        (TypeError, "None", lambda x: None),
    ]:
        contact = body(2)
        contact.obstacles.add_signed_distance(function)
        with pytest.raises(error, match=text):
            contact.evaluate(SQUARE)
    contact = body(2, estimator="exact")
    contact.obstacles.add_signed_distance(plane)
    with pytest.raises(UnsupportedError):
        contact.evaluate(SQUARE)


def test_points_of_a_signed_distance_may_be_kept():
    kept = []

    def remember(points):
        kept.append(points)
        return plane(points)

    contact = body(2)
    contact.obstacles.add_signed_distance(remember, (0, 0.25))
    contact.evaluate(SQUARE)
    assert kept and all(points.flags.owndata and np.isfinite(points).all() for points in kept)


@pytest.mark.parametrize("dim", [2, 3])
def test_hulls_and_flat_height_fields_are_boxes(dim):
    """A box 2 wide and 1 high whose top reaches 0.2 into the body."""
    corners = np.stack(np.meshgrid(*[(-1.0, 1.0)] * (dim - 1), (-1.0, 0.0), indexing="ij"), -1).reshape(-1, dim)
    for estimator in ("exact", "fibers"):
        for add in (
            lambda contact: contact.obstacles.add_convex_hull(corners, centre(dim, 0.2)),
            lambda contact: contact.obstacles.add_height_field(np.zeros((3, 4)[: dim - 1]), (2,) * (dim - 1), 1, centre(dim, 0.2)),
        ):
            contact = body(dim, estimator=estimator)
            add(contact)
            result = contact.evaluate(SQUARE if dim == 2 else CUBE)
            assert result.volume == pytest.approx(0.2, rel=1e-12 if estimator == "exact" else 0.05)


def test_a_compound_is_the_union_of_its_parts():
    parts = [Part(Shape("ball", radius=0.25), (x, 0, 0)) for x in (-0.1, 0.1)]
    contact = body(3)
    contact.obstacles.add_compound(parts, centre(3, 0.5))
    height = 0.25 - 0.1
    lens = 2 * np.pi * height**2 * (3 * 0.25 - height) / 3
    union = 2 * 4 / 3 * np.pi * 0.25**3 - lens
    assert contact.evaluate(CUBE).volume == pytest.approx(union, rel=0.01)


@pytest.mark.parametrize("dim", [2, 3])
def test_shapes_as_data_are_those_of_the_methods(dim):
    coords = SQUARE if dim == 2 else CUBE
    half = np.full(dim, 0.4)
    corners = np.vstack([np.eye(dim), np.zeros(dim)]) * 0.9
    facets = np.array([[0, 1], [1, 2], [2, 0]] if dim == 2 else [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])
    heights, lengths = np.zeros((3, 4)[: dim - 1]), (2.0,) * (dim - 1)
    two = [Part(Shape("ball", radius=0.3), centre(dim, 0.1)), Part(Shape("cuboid", half_extents=half))]
    shapes = [
        (Shape("ball", radius=0.5), lambda obstacles, pose: obstacles.add_ball(0.5, pose)),
        (Shape("cuboid", half_extents=half), lambda obstacles, pose: obstacles.add_cuboid(half, pose)),
        (Shape("cone", radius=0.5, half_height=0.6), lambda obstacles, pose: obstacles.add_cone(0.5, 0.6, pose)),
        (Shape("polytope", points=corners, facets=facets), lambda obstacles, pose: obstacles.add_polytope(corners, facets, pose)),
        (
            Shape("polytope", points=corners, facets=facets.astype(np.int32)),
            lambda obstacles, pose: obstacles.add_polytope(corners, facets, pose),
        ),
        (
            Shape("height_field", heights=heights, lengths=lengths, thickness=1),
            lambda obstacles, pose: obstacles.add_height_field(heights, lengths, 1, pose),
        ),
        (Shape("compound", parts=two), lambda obstacles, pose: obstacles.add_compound(two, pose)),
    ]
    for shape, add in shapes:
        found = []
        for way in (lambda obstacles, pose: obstacles.add(shape, pose), add):
            contact = body(dim)
            way(contact.obstacles, centre(dim, 0.2))
            assert contact.obstacles.get(0).shape == shape.kind
            found.append(contact.evaluate(coords).volume)
        assert found[0] == found[1] > 0, shape


def test_parts_of_a_compound_are_of_any_kind():
    """A compound within a compound, and a function, which must live as long as the obstacle."""

    def ball():
        return lambda x: (np.linalg.norm(x, axis=1) - 0.25, x / np.linalg.norm(x, axis=1)[:, None])

    inner = Shape("compound", parts=[Part(Shape("signed_distance", signed_distance=ball()), (-0.1, 0, 0))])
    outer = Shape("compound", parts=[Part(inner), Part(Shape("ball", radius=0.25), (0.1, 0, 0))])
    balls = Shape("compound", parts=[Part(Shape("ball", radius=0.25), (x, 0, 0)) for x in (-0.1, 0.1)])
    volumes = []
    for shape in (outer, balls):
        contact = body(3)
        contact.obstacles.add(shape, centre(3, 0.5))
        volumes.append(contact.evaluate(CUBE).volume)
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-9)


def test_what_cannot_be_built_says_why():
    contact = body(3)
    with pytest.raises(DegenerateHullError):
        contact.obstacles.add_convex_hull(np.c_[SQUARE, np.zeros(4)])
    with pytest.raises(TooFewHeightsError):
        contact.obstacles.add_height_field(np.zeros((3, 1)), (1, 1), 1)
    with pytest.raises(NonFiniteHeightError):
        contact.obstacles.add_height_field([[0, np.nan], [0, 0]], (1, 1), 1)
    with pytest.raises(EmptyCompoundError):
        contact.obstacles.add_compound([])
    with pytest.raises(ValueError, match="no shape 'torus'"):
        Shape("torus")
    assert contact.obstacles.count == 0
