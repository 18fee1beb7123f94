"""What the support matrix asks for: features of a scene, and what is wanted of a contact besides forces and tangent."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, Callable, NamedTuple

import numpy as np
from fmc_contact import Part, Shape, find_equilibrium
from scenes import K
from support_scene import EDGES, SECOND_ORDER, Scene
from test_ranks import Meeting, Rank

RUBBED = {"friction_coefficient": 0.3, "friction_stiffness": K}


class Feature(NamedTuple):
    """A row of the matrix."""

    name: str
    scene: Mapping[str, Any] = MappingProxyType({})
    """Arguments of the scene."""
    setup: Callable[[Scene], None] = lambda scene: None
    """Called before the first evaluation."""
    dims: tuple[int, ...] = (2, 3)
    kinds: tuple[str, ...] = ()
    """Types of cells, of which those of the dimension are asked one by one."""
    has_effect: bool = False
    """Whether the forces have to change by the setup: a law may ignore it."""
    is_curved: bool = False
    """Measured by quadrature in 3D, which takes long: the tangent is not compared with differences there."""


def begun(scene):
    """Friction counts slip from the coordinates without deformation."""
    scene.contact.friction.begin_step(scene.contact.coords if scene.is_in_parts else scene.first)


def at(scene, height):
    """Below the middle of the body's lower face, from which obstacles reach into it."""
    return (scene.shift + 1.6, height, 0.5)[: scene.dim]


def plane(points):
    return points[:, 1], np.tile(np.eye(points.shape[1])[1], (len(points), 1))


def box(dim):
    """Corners of a box 2 wide and 1 high below its origin, in 2D with its edges, in 3D with its triangles."""
    xy = np.array([[-1, -1], [1, -1], [1, 0], [-1, 0]], float)
    if dim == 2:
        return xy, [[0, 1], [1, 2], [2, 3], [3, 0]]
    quads = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    points = np.vstack([np.c_[xy, np.full(4, z)] for z in (-0.3, 0.3)])
    return points, [[a, b, c] for a, b, c, d in quads] + [[a, c, d] for a, b, c, d in quads]


def heights(scene):
    return np.zeros((3,) * (scene.dim - 1))


BALL = Shape("ball", radius=0.1)
OBSTACLES = {
    "half-space": lambda s, o: o.add_half_space(at(s, 0.04), np.eye(s.dim)[1]),
    "cuboid": lambda s, o: o.add_cuboid((1, 0.5, 0.3)[: s.dim], at(s, -0.46)),
    "polygon, triangle mesh": lambda s, o: o.add_polytope(*box(s.dim), at(s, 0.04)),
    "convex hull": lambda s, o: o.add_convex_hull(box(s.dim)[0], at(s, 0.04)),
    "height field": lambda s, o: o.add_height_field(heights(s), (2, 0.8)[: s.dim - 1], 1.0, at(s, 0.04)),
    "ball": lambda s, o: o.add_ball(0.5, at(s, -0.46)),
    "cylinder": lambda s, o: o.add_cylinder(0.1, 0.1, at(s, -0.06)),
    "capsule": lambda s, o: o.add_capsule(0.2, 0.26, at(s, -0.42)),
    "cone": lambda s, o: o.add_cone(0.1, 0.1, at(s, -0.06)),
    "compound": lambda s, o: o.add_compound([Part(BALL), Part(BALL, (0.3, 0, 0)[: s.dim])], at(s, -0.06)),
    "signed distance": lambda s, o: o.add_signed_distance(plane, at(s, 0.04)),
}


CURVED_OBSTACLES = ("ball", "cylinder", "capsule", "cone", "compound", "signed distance")


def obstacle(kind):
    return lambda scene: OBSTACLES[kind](scene, scene.contact.obstacles)


def together(*setups):
    return lambda scene: [setup(scene) for setup in setups] and None


def of_pair(b, **options):
    return lambda scene: scene.contact.pairs.set(0, b, **options)


def with_basis(scene):
    """Unknowns that are the nodes, scaled."""
    scene.contact.mesh.set_basis(0.5 * np.eye(len(scene.x)))
    scene.x = 2 * scene.x


def adjusted(scene):
    scene.contact.mesh.adjust(scene.first, close=0.03)


def on_ranks(scene):
    scene.contact.ranks.set_communicator(Rank(Meeting(1), 0))


def symmetric(scene):
    """The left side of the block is named, where the host holds it: forces across it do not balance."""
    scene.is_cut = True
    across = np.eye(scene.dim)[0]
    scene.contact.mesh.set_symmetry_planes([(across * (scene.shift + 0.53), across)])


def smoothed(scene):
    scene.contact.mesh.set_surface_smoothing(30.0)


TIED = of_pair(1, interface="tied", reach=0.2)
SLIDING = of_pair(1, interface="no_separation", reach=0.2)
GLUED = together(of_pair(1, interface="cohesive", reach=0.2, normal_strength=1e3 * K, normal_energy=1e3 * K), begun)


def springs(points):
    return 1e3 * K * points.jump, np.broadcast_to(1e3 * K * np.eye(points.jump.shape[1]), points.axes.shape)


BONDED = of_pair(1, interface="law", reach=0.2, law=springs)


def rubbing(facets):
    """A quarter of the pressure, by a law of the host."""
    return 0.25 * facets.pressure, np.full(len(facets), 0.25)


RUBBED_BY_LAW = together(of_pair(1, friction_law=rubbing), begun)

STRAIGHT, CURVED = tuple(EDGES), tuple(SECOND_ORDER)

GROUPS = {
    "Bodies": [
        Feature("first-order cells, all types", kinds=STRAIGHT),
        Feature("second-order cells, all types", kinds=CURVED),
        Feature("second-order on first-order bodies, 2D", {"straight_block": True}, dims=(2,), kinds=("quad9",)),
        Feature("hanging nodes", {"hanging": True}),
        Feature("hanging nodes, second-order cells", {"hanging": True}, kinds=("quad9", "hexahedron20")),
        Feature("closed surfaces without cells", {"surfaces": True}),
        Feature("self-contact", {"self_contact": True}),
        Feature("axisymmetry", {"axisymmetric": True}, dims=(2,)),
        Feature("planes of symmetry", setup=symmetric, has_effect=True),
        Feature("a separate basis", setup=with_basis),
        Feature("smoothed round surfaces", {"wavy": True}, smoothed, kinds=("quad", "wedge"), has_effect=True),
    ],
    "Obstacles": [Feature(kind, setup=obstacle(kind), is_curved=kind in CURVED_OBSTACLES) for kind in OBSTACLES],
    "Friction": [
        Feature("stiffness by default", {"friction_coefficient": 0.3}, begun),
        Feature("own `friction_stiffness`", RUBBED, begun),
        Feature("cohesion and shear limit", {**RUBBED, "cohesion": 5.0, "shear_limit": 20.0}, begun),
        Feature("static coefficient", {**RUBBED, "static_coefficient": 0.5, "weakening_slip": 0.1}, begun),
        Feature("`memoryless_slip`", {"friction_coefficient": 0.3, "memoryless_slip": 0.1}, begun),
        Feature("your own law of friction", RUBBED, RUBBED_BY_LAW),
        Feature("your own law of friction, axisymmetry", {**RUBBED, "axisymmetric": True}, RUBBED_BY_LAW, dims=(2,)),
        Feature("your own law of friction, second-order cells, 2D", RUBBED, RUBBED_BY_LAW, dims=(2,), kinds=("quad9",)),
        Feature("your own law of friction, ranks", RUBBED, together(RUBBED_BY_LAW, on_ranks)),
        Feature("your own law of friction, mesh in parts", {**RUBBED, "parts": True}, RUBBED_BY_LAW),
        Feature("with self-contact", {**RUBBED, "self_contact": True}, begun),
        Feature("with axisymmetry", {**RUBBED, "axisymmetric": True}, begun, dims=(2,)),
        Feature("with second-order cells, 2D", RUBBED, begun, dims=(2,), kinds=("quad9",)),
        Feature("with hanging nodes", {**RUBBED, "hanging": True}, begun),
        Feature("with closed surfaces", {**RUBBED, "surfaces": True}, begun),
        Feature("with a half-space", RUBBED, together(obstacle("half-space"), begun)),
        Feature("with a ball", RUBBED, together(obstacle("ball"), begun), is_curved=True),
    ],
    "Gaps, offsets, pairs": [
        Feature("an excluded pair", setup=together(of_pair(1, excluded=True), obstacle("half-space"))),
        Feature("stiffness of one pair", setup=of_pair(1, stiffness=2 * K)),
        Feature("clearance between bodies", setup=of_pair(1, gap_offset=-0.01)),
        Feature("thickness between bodies", setup=of_pair(1, gap_offset=0.01)),
        Feature("clearance to a half-space", setup=together(obstacle("half-space"), of_pair(("obstacle", 0), gap_offset=-0.01))),
        Feature("thickness of a half-space", setup=together(obstacle("half-space"), of_pair(("obstacle", 0), gap_offset=0.01))),
        Feature("thickness of a cuboid, 2D", setup=together(obstacle("cuboid"), of_pair(("obstacle", 0), gap_offset=0.01)), dims=(2,)),
        Feature("`adjust` of gaps", setup=adjusted),
    ],
    "Interfaces": [
        Feature("tied", setup=TIED),
        Feature("tied, second-order cells, 2D", setup=TIED, dims=(2,), kinds=("quad9",)),
        Feature("tied, hanging nodes", {"hanging": True}, TIED),
        Feature("tied, axisymmetry", {"axisymmetric": True}, TIED, dims=(2,)),
        Feature("tied, friction elsewhere", RUBBED, together(TIED, begun)),
        Feature("tied, closed surfaces", {"surfaces": True}, TIED),
        Feature("tied, ranks", setup=together(TIED, on_ranks)),
        Feature("tied, mesh in parts", {"parts": True}, TIED),
        Feature("no separation", setup=SLIDING),
        Feature("no separation, second-order cells, 2D", setup=SLIDING, dims=(2,), kinds=("quad9",)),
        Feature("no separation, axisymmetry", {"axisymmetric": True}, SLIDING, dims=(2,)),
        Feature("no separation, ranks", setup=together(SLIDING, on_ranks)),
        Feature("no separation, mesh in parts", {"parts": True}, SLIDING),
        Feature("rough", RUBBED, together(of_pair(1, interface="rough"), begun)),
        Feature("cohesive", setup=GLUED),
        Feature("cohesive, second-order cells, 2D", setup=GLUED, dims=(2,), kinds=("quad9",)),
        Feature("cohesive, axisymmetry", {"axisymmetric": True}, GLUED, dims=(2,)),
        Feature("cohesive, ranks", setup=together(GLUED, on_ranks)),
        Feature("cohesive, mesh in parts", {"parts": True}, GLUED),
        Feature("your own law", setup=BONDED),
        Feature("your own law, second-order cells, 2D", setup=BONDED, dims=(2,), kinds=("quad9",)),
        Feature("your own law, axisymmetry", {"axisymmetric": True}, BONDED, dims=(2,)),
        Feature("your own law, ranks", setup=together(BONDED, on_ranks)),
        Feature("your own law, mesh in parts", {"parts": True}, BONDED),
    ],
    "MPI ranks": [
        Feature("whole mesh on every rank", setup=on_ranks),
        Feature("mesh in parts", {"parts": True}),
        Feature("parts, second-order cells, 2D", {"parts": True}, dims=(2,), kinds=("quad9",)),
        Feature("parts, self-contact", {"parts": True, "self_contact": True}),
        Feature("parts, friction", {"parts": True, **RUBBED}, begun),
        Feature("parts, axisymmetry", {"parts": True, "axisymmetric": True}, dims=(2,)),
        Feature("parts, half-space", {"parts": True}, obstacle("half-space")),
        Feature("parts, hanging nodes", {"parts": True, "hanging": True}),
        Feature("parts, a separate basis", {"parts": True}, with_basis),
        Feature("parts, smoothed round surfaces", {"parts": True}, smoothed),
        Feature("parts, `adjust` of gaps", {"parts": True}, adjusted),
    ],
}

PAIRED = [
    Feature("second-order cells", kinds=("quad9",)),
    Feature("hanging nodes", {"hanging": True}),
    Feature("mesh in parts", {"parts": True}),
    Feature("self-contact", {"self_contact": True}),
    Feature("axisymmetry", {"axisymmetric": True}),
    Feature("friction", RUBBED, begun),
    Feature("smoothed round surfaces", {"wavy": True}, smoothed),
    Feature("a separate basis", setup=with_basis),
    Feature("planes of symmetry", setup=symmetric),
    Feature("clearance between bodies", setup=of_pair(1, gap_offset=-0.01)),
    Feature("`adjust` of gaps", setup=adjusted),
    Feature("half-space", setup=obstacle("half-space")),
    Feature("ball", setup=obstacle("ball"), is_curved=True),
]
"""Features of which every two are asked together, in 2D."""


def both(one, other):
    """Two features as one. Friction begins where everything else is set."""
    first, then = (other, one) if one.name == "friction" else (one, other)
    scene = {**first.scene, **then.scene}
    kinds = first.kinds or then.kinds
    return Feature("", scene, together(first.setup, then.setup), (2,), kinds, is_curved=first.is_curved or then.is_curved)


def rotations(scene):
    obstacle("half-space")(scene)
    scene.contact.obstacles.set_rotations(True)
    scene.contact.tangent_parts(scene.x, obstacles=True)


def translations(scene):
    obstacle("half-space")(scene)
    scene.contact.tangent_parts(scene.x, obstacles=True)


def augmented(scene):
    assert scene.contact.multipliers.augment(scene.x, 1e-6).multiplier_count > 0


def constraints(scene):
    assert len(scene.contact.gap_constraints(scene.x, 0.1))


def gradients(*by):
    return lambda scene: scene.contact.vjp(scene.x, adjoint=np.ones(scene.x.shape), by=by)


def conducted(scene):
    assert abs(scene.contact.flux(scene.x, scene.x[:, 1], 2.0).flux).max() > 0


def heated(scene):
    scene.contact.friction_heat(scene.x)


def worn(scene):
    scene.contact.pairs.set_wear(0, 1, 1e-9 / K, 1e-9 / K)
    scene.contact.friction.begin_step(scene.first)
    scene.contact.friction.commit_step(scene.x)
    assert scene.contact.wear.volumes.shape == (2,)


def searched(scene):
    """Springs hold every node where it is under load; contact pushes the bodies apart, against them."""
    spring, first = 100 * K, scene.x
    host = lambda x: (spring * (x - first).ravel(), spring * np.eye(first.size))
    found = find_equilibrium(host, scene.contact, first, np.arange(first.size))
    assert 0 < found.result.bodies[1].force[1], found


ASKED = {
    "semidefinite tangent": ({}, lambda scene: scene.contact.tangent_parts(scene.x, semidefinite=True)),
    "obstacle translations in the tangent": ({}, translations),
    "obstacle rotations in the tangent": ({}, rotations),
    "fields at nodes": ({}, lambda scene: scene.contact.nodal_contact(scene.x)),
    "contact points": ({}, lambda scene: scene.contact.contact_points(scene.x)),
    "gap constraints": ({}, constraints),
    "stable time step": ({}, lambda scene: scene.contact.stable_step(scene.x, np.ones(len(scene.x)))),
    "step limit": ({}, lambda scene: scene.contact.step_limit(scene.first, scene.x - scene.first)),
    "penetration tolerance": ({}, augmented),
    "penetration tolerance, friction": (RUBBED, together(begun, augmented)),
    "penetration tolerance, self-contact": ({"self_contact": True}, augmented),
    "gradient by coordinates": ({}, gradients("coords")),
    "gradient by undeformed coordinates": ({}, gradients("reference")),
    "gradient by stiffness": ({}, gradients("stiffness")),
    "gradient, friction": (RUBBED, together(begun, gradients("coords", "friction"))),
    "gradient by coordinates, tied": ({}, together(TIED, gradients("coords"))),
    "flux of a scalar field": ({}, conducted),
    "flux, tied": ({}, together(TIED, conducted)),
    "heat of friction": (RUBBED, together(begun, heated)),
    "wear": ({}, worn),
    "search for the equilibrium, 2D": ({}, searched),
    "search, stiffness from the bodies, 2D": ({"stiffness": 0.0}, searched),
    "search, friction, 2D": (RUBBED, searched),
    "search, self-contact, 2D": ({"self_contact": True}, searched),
    "search, axisymmetry": ({"axisymmetric": True}, searched),
    "search, mesh in parts, 2D": ({"parts": True}, searched),
}
"""Calls of a contact: arguments of the scene, and the call."""
