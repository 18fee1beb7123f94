"""Bodies that friction holds or drags: blocks that overhang, wedges whose load is gone or turns, planks on two supports, a bar out of a clamp."""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import QUAD4, grid
from problem import Expected, Problem, Step
from skfem import MeshQuad
from solver import contact_of

YOUNG, POISSON, WEIGHT = 1e6, 0.3, 1e2
SLOPE = np.tan(np.radians(10))
"""Of the faces of the wedge; it locks where friction is above it."""
LOCKED = {0.0: 318.79, -1.0: 318.73, -10.0: 318.18, -50.0: 314.93}
"""Force on a side of the wedge by the load that is left after 500, reached in small steps: 500, 10, 1, 1e-6, 0, -1, -10, -25, -50."""

KEY = {0.0: 1.2598, 0.2: 1.0637}
"""The same of a tapered key driven by 10."""


def overhang(friction, over, below, above):
    """A block that lies on another and stands out by a part of its width; it tips at 1/2."""
    meshes = [grid(QUAD4.mesh, [0, 0], [1, 0.25], [below, 3]), grid(QUAD4.mesh, [over, 0.25], [1 + over, 0.5], [above, 3])]
    bodies = Bodies(meshes, QUAD4, YOUNG, POISSON)
    load = bodies.weight(WEIGHT)
    held = [bodies.unknowns(0, lambda x: x[1] < 1e-9)]
    borne = Expected("borne/W", lambda found: found.result.bodies[1].force[1] / (0.25 * WEIGHT), 1.0, 1e-7, "statics")
    still = Expected("largest u", lambda found: np.abs(found.x).max(), 0.0, 0.01, "bending alone")
    step = Step(bodies.host(load), bodies.free(held), expected=(borne, still), most_solves=50)
    return Problem(contact_of(bodies, friction_coefficient=friction), np.zeros(bodies.size), [step], True)


def wedge(path):
    """A wedge between two blocks, with a load that is gone or turns in the end."""
    warped = lambda mesh, to: MeshQuad(np.array(to(*mesh.p)), mesh.t)
    side = lambda at: warped(grid(QUAD4.mesh, [0, -0.3], [1, 1.5], [5, 11]), at)
    meshes = [
        warped(grid(QUAD4.mesh, [-1, 0], [1, 1], [8, 8]), lambda x, y: (x * (0.3 + SLOPE * y), y)),
        side(lambda x, y: (0.3 + SLOPE * y + x * (1.2 - SLOPE * y), y)),
        side(lambda x, y: (-1.5 + x * (1.2 - SLOPE * y), y)),
    ]
    bodies = Bodies(meshes, QUAD4, YOUNG, POISSON)
    held = [bodies.unknowns(1, lambda x: x[0] > 1.5 - 1e-9), bodies.unknowns(2, lambda x: x[0] < -1.5 + 1e-9)]
    top, free = bodies.unknowns(0, lambda x: x[1] > 1 - 1e-9, 1), bodies.free(held)
    steps = []
    for force in path:
        load = np.zeros(bodies.size)
        load[top] = -force / len(top)
        wanted = LOCKED.get(force)
        reason = "small load steps, which agree to 1e-3: where a body sticks depends a little on the way"
        expected = () if wanted is None else (Expected("side force", lambda found: found.result.bodies[1].force[0], wanted, 1e-3 * wanted, reason),)
        steps.append(Step(bodies.host(load), free, expected=expected, most_solves=30))
    return Problem(contact_of(bodies, friction_coefficient=0.5), np.zeros(bodies.size), steps, True)


def key(load):
    """A taper between two half-spaces whose faces are steeper, driven by 10 and let go; only friction and its own stress hold it."""
    angle = np.radians(20)
    mesh = grid(QUAD4.mesh, [-1, 0.05], [1, 0.95], [4, 5])
    mesh = MeshQuad(np.array([mesh.p[0] * (0.3 + np.tan(angle) * mesh.p[1]), mesh.p[1]]), mesh.t)
    bodies = Bodies([mesh], QUAD4, 1e5, POISSON)
    contact = contact_of(bodies, friction_coefficient=0.6)
    for side in (1, -1):
        contact.contact.obstacles.add_half_space([0.3 * side, 0], [-side * np.cos(angle), np.sin(angle)])
    top = bodies.unknowns(0, lambda x: x[1] > 0.95 - 1e-9, 1)
    reason = "load steps of -1 and 0: where a body sticks depends a little on the way"
    held = Expected("wall force", lambda found: np.abs(found.result.obstacles[0].force[0]), KEY[load], 1e-3, reason)
    steps = []
    for force, expected in ((-10.0, ()), (load, (held,))):
        forces = np.zeros(bodies.size)
        forces[top] = force / len(top)
        steps.append(Step(bodies.host(forces), bodies.free([]), expected=expected, most_solves=30))
    return Problem(contact, np.zeros(bodies.size), steps, True)


def clamp(friction, way, cells):
    """A bar that is pulled out between two jaws, pressed by a force, in one step."""
    low, high = [(-1, -0.2), (0, 0.2), (0, -0.8)], [(2, 0.2), (1, 0.8), (1, -0.2)]
    bodies = Bodies([grid(QUAD4.mesh, a, b, [n, 4]) for a, b, n in zip(low, high, cells)], QUAD4, YOUNG, POISSON)
    pulled = bodies.unknowns(0, lambda x: x[0] > 2 - 1e-9, 0)
    held = [pulled, bodies.unknowns(1, lambda x: x[1] > 0.8 - 1e-9, 0), bodies.unknowns(2, lambda x: x[1] < -0.8 + 1e-9)]
    load, free = bodies.traction(1, lambda x: x[1] > 0.8 - 1e-9, [0, -1e3]), bodies.free(held)
    prescribed = np.zeros(bodies.size)
    prescribed[pulled] = way
    # The jaws lean as they are dragged along.
    pull = Expected("pull/2μP", lambda found: found.result.bodies[0].force[0] / (-2e3 * friction), 1.0, 2e-3, "Coulomb")
    steps = [Step(bodies.host(load), free, most_solves=30), Step(bodies.host(load), free, prescribed, (pull,), most_solves=100)]
    return Problem(contact_of(bodies, friction_coefficient=friction), np.zeros(bodies.size), steps, True)


def plank(friction, cells):
    """A plank that bends over two square supports under its weight, and slides outwards on both."""
    height, span, over, by_length = 0.3, 2.8, 0.6, 30.0
    corners = [((-2, 0), (2, height)), ((-1.7, -0.5), (-1.4, 0)), ((1.4, -0.5), (1.7, 0))]
    bodies = Bodies([grid(QUAD4.mesh, a, b, n) for (a, b), n in zip(corners, ([cells, 4], [3, 4], [4, 4]))], QUAD4, YOUNG, POISSON)
    held = [bodies.unknowns(body, lambda x: x[1] < -0.5 + 1e-9) for body in (1, 2)]
    load = bodies.weight(by_length / height, bodies=[0])
    # Slope over the supports: of the span, of what hangs over, and of friction at the lower face.
    bending, borne = YOUNG / (1 - POISSON**2) * height**3 / 12, by_length * (span / 2 + over)
    moment = by_length * over**2 / 2 + friction * borne * height / 2
    slope = (by_length * span**3 / 24 - moment * span / 2) / bending
    outwards = (friction + slope) / (1 - friction * slope)
    pushed = lambda found: found.result.bodies[2].force[0] / -found.result.bodies[2].force[1]
    leads_away = lambda found: sum("unstable" in str(told) for told in found.warnings)
    expected = (
        Expected("outwards/N", pushed, outwards, 2e-3, "beam theory, without shear"),
        Expected("borne/W", lambda found: -found.result.bodies[2].force[1] / borne, 1.0, 2e-3, "symmetry, but for the cells"),
        Expected("warnings that it leads away", leads_away, 0, 0, "what slides sticks on its way back"),
    )
    step = Step(bodies.host(load), bodies.free(held), expected=expected, most_solves=35)
    return Problem(contact_of(bodies, friction_coefficient=friction), np.zeros(bodies.size), [step], True)


def site(load, told):
    """A steel block on another at site coordinates: the load is not much more than coordinates are rounded to there, or less."""
    low, high = np.array([5e5, 4e6]), np.array([5e5 + 1, 4e6 + 0.5])
    meshes = [grid(QUAD4.mesh, low, high, [4, 2]), grid(QUAD4.mesh, low + [0, 0.5], high + [0, 0.5], [5, 2])]
    bodies = Bodies(meshes, QUAD4, 2e11, POISSON)
    held = [bodies.unknowns(0, lambda x: x[1] < 4e6 + 1e-6)]
    step = Step(bodies.host(bodies.weight(2 * load)), bodies.free(held), told=told)
    return Problem(contact_of(bodies, friction_coefficient=0.3), np.zeros(bodies.size), [step], True)


PROBLEMS = {
    f"block that overhangs by {over:g}, μ {friction:g}, {below} on {above} cells": partial(overhang, friction, over, below, above)
    for friction, over, below, above in (
        (0.1, 0.2, 12, 13),
        (0.1, 0.3, 12, 13),
        (0.3, 0.35, 8, 9),
        (0.3, 0.4, 12, 13),
        (0.3, 0.45, 20, 21),
        (0.3, 0.4, 20, 21),
    )
}
for path in ((500.0, 10.0, 1.0, 1e-6, 0.0), (500.0, 0.0), (500.0, -1.0), (500.0, 10.0, -10.0), (500.0, -1e-3, -50.0), (500.0, -50.0)):
    PROBLEMS[f"wedge, loads {', '.join(f'{force:g}' for force in path)}"] = partial(wedge, path)
for load in KEY:
    PROBLEMS[f"tapered key, loads -10, {load:g}"] = partial(key, load)
PROBLEMS["bar out of a clamp by 0.05, μ 0.4"] = partial(clamp, 0.4, 0.05, (15, 6, 7))
for friction in (0.1, 0.3, 0.5):
    for cells in (16, 24, 32, 40):
        PROBLEMS[f"plank of {cells} cells on two supports, μ {friction:g}"] = partial(plank, friction, cells)
for load, told in ((2e4, "count as none"), (1e6, "may be wrong by up to")):
    PROBLEMS[f"load of {load:g} N at site coordinates"] = partial(site, load, told)
SLOW = set()
