"""Bodies that nothing stops: the driver has to say which, and where they go."""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import BY_NAME, QUAD4, grid
from problem import Expected, Problem, Refused, Step
from solver import contact_of

YOUNG, WEIGHT = 1e6, 1e3
GAPS = (0.0, 1e-9, 1e-6, -1e-6, 1e-2)


def pulled(cells, gap, factor):
    """A block on a floor, guided sideways, whose top is pulled up."""
    cells = BY_NAME[cells]
    dim = cells.dim
    mesh = grid(cells.mesh, [0] * (dim - 1) + [gap], [1] * (dim - 1) + [1 + gap], [3] * dim)
    bodies = Bodies([mesh], cells, YOUNG, 0.3)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_half_space([0] * dim, [0] * (dim - 1) + [1])
    held = [bodies.unknowns(0, lambda x: x[0] < np.inf, axis) for axis in range(dim - 1)]
    load = bodies.traction(0, lambda x: x[-1] > 1 + gap - 1e-9, [0] * (dim - 1) + [factor * WEIGHT])
    refused = Refused((0,), "nothing holds it down", tuple([0] * (dim - 1) + [1]), False)
    return Problem(contact, np.zeros(bodies.size), [Step(bodies.host(load), bodies.free(held), refused=refused)])


def pressed_then_pulled(factor):
    """A block that is pressed on a floor, then pulled up from there."""
    bodies = Bodies([grid(QUAD4.mesh, [0, 0], [1, 1], [4, 4])], QUAD4, 1e3, 0.0)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_half_space([0, 1e-9], [0, 1])
    load = bodies.traction(0, lambda x: x[1] > 1 - 1e-9, [0, -1])
    free = bodies.free([bodies.unknowns(0, lambda x: x[0] < np.inf, 0)])
    bears = Expected("F/P", lambda found: found.result.bodies[0].force[1], 1.0, 1e-9, "statics")
    pressed = Step(bodies.host(load), free, expected=(bears,), most_solves=5)
    lifted = Step(bodies.host(-factor * load), free, refused=Refused((0,), "nothing holds it down", (0, 1), False))
    return Problem(contact, np.zeros(bodies.size), [pressed, lifted])


def slope(friction, degrees=20.0, gap=0.0):
    """A block on a slope, by its weight alone. Beyond the angle of friction it slides for ever."""
    bodies = Bodies([grid(QUAD4.mesh, [0, gap], [1, 1 + gap], [4, 4])], QUAD4, YOUNG, 0.3)
    contact = contact_of(bodies, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    angle = np.radians(degrees)
    load = np.cos(angle) * bodies.weight(WEIGHT) + np.sin(angle) * bodies.weight(WEIGHT, 0)
    if friction <= np.tan(angle):
        refused = Refused((0,), "it slides down the slope", (-1, 0), False)
        step = Step(bodies.host(load), bodies.free([]), refused=refused)
    else:
        forces = lambda found, axis: -found.result.obstacles[0].force[axis] / WEIGHT
        step = Step(
            bodies.host(load),
            bodies.free([]),
            expected=(
                Expected("N/W", lambda found: forces(found, 1), np.cos(angle), 1e-7, "statics"),
                Expected("T/W", lambda found: forces(found, 0), np.sin(angle), 1e-7, "statics"),
            ),
            # Near the angle of friction facets take turns to stick and to slide before the block rests.
            most_solves=12 if friction > 1.1 * np.tan(angle) else 40,
        )
    return Problem(contact, np.zeros(bodies.size), [step], friction > 0)


def beside(gap=0.0):
    """A block that falls beside the one that is held."""
    low, high = grid(QUAD4.mesh, [0, 0], [1, 1], [4, 4]), grid(QUAD4.mesh, [3.1, 1 + gap], [3.9, 2 + gap], [4, 4])
    bodies = Bodies([low, high], QUAD4, YOUNG, 0.3)
    free = bodies.free([bodies.unknowns(0, lambda x: x[1] < 1e-9)])
    refused = Refused((1,), "it falls", (0, -1), False)
    return Problem(contact_of(bodies), np.zeros(bodies.size), [Step(bodies.host(bodies.weight(WEIGHT)), free, refused=refused)])


def pushed(factor, friction=0.3):
    """A block that is pressed on a floor, and pushed along it by a part of the friction that it can bear."""
    bodies = Bodies([grid(QUAD4.mesh, [0, 0], [1, 0.5], [5, 3])], QUAD4, 1e3, 0.3)
    contact = contact_of(bodies, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    pressure = 5.0
    pressed = bodies.traction(0, lambda x: x[1] > 0.5 - 1e-9, [0, -pressure])
    # Pushed at the foot, lest it tips.
    foot = bodies.unknowns(0, lambda x: x[1] < 0.17, 0)
    along = np.zeros(bodies.size)
    along[foot] = factor * friction * pressure / len(foot)
    free = bodies.free([])
    if factor > 1:
        step = Step(bodies.host(pressed + along), free, refused=Refused((0,), "it slides away", (1, 0), False))
    else:
        forces = lambda found, axis: -found.result.obstacles[0].force[axis] / pressure
        normal = Expected("N/P", lambda found: forces(found, 1), 1.0, 1e-7, "statics")
        tangential = Expected("T/μP", lambda found: -forces(found, 0) / friction, factor, 1e-7, "statics")
        step = Step(bodies.host(pressed + along), free, expected=(normal, tangential), most_solves=25)
    return Problem(contact, np.zeros(bodies.size), [step], True)


def hinge(degrees):
    """Two bars that lean on each other and stand on a floor without friction: their feet slide apart."""
    angle = np.radians(degrees)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    bar = grid(QUAD4.mesh, [0, 0], [2, 0.3], [10, 2])
    left = turn @ bar.p
    left = left - [[left[0].max()], [left[1].min()]]
    right = np.array([-left[0], left[1]])
    meshes = [QUAD4.mesh(left, bar.t), QUAD4.mesh(right, bar.t[::-1])]
    bodies = Bodies(meshes, QUAD4, YOUNG, 0.3)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    refused = Refused((0, 1), "the feet slide apart")
    return Problem(contact, np.zeros(bodies.size), [Step(bodies.host(bodies.weight(WEIGHT)), bodies.free([]), refused=refused)])


def turning(gap=0.0):
    """A block, held sideways and pressed on a ball by a force beside its middle: it turns away."""
    bodies = Bodies([grid(QUAD4.mesh, [-1, gap], [1, 0.5 + gap], [8, 2])], QUAD4, YOUNG, 0.3)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_ball(0.5, (0, -0.5))
    held = bodies.unknowns(0, lambda x: (np.abs(x[0]) < 1e-9) & (x[1] < gap + 1e-9), 0)
    load = bodies.traction(0, lambda x: (x[1] > 0.5 + gap - 1e-9) & (x[0] > 0.5), [0, -WEIGHT])
    refused = Refused((0,), "its load turns it about the ball", None, None)
    return Problem(contact, np.zeros(bodies.size), [Step(bodies.host(load), bodies.free([held]), refused=refused)])


PROBLEMS = {}
for cells in ("Quad4", "Tri3", "Tri6", "Hex8", "Tet4", "Tet10"):
    for gap in GAPS:
        PROBLEMS[f"{cells} pulled up from a floor, gap {gap:g}"] = partial(pulled, cells, gap, 1.0)
for factor in (1e-3, 1.0):
    PROBLEMS[f"pressed, then pulled up by {factor:g} P"] = partial(pressed_then_pulled, factor)
for friction in (0.5, 0.38, 0.35, 0.3, 0.0):
    for gap in (0.0, 1e-3):
        PROBLEMS[f"slope of tan 0.364, μ {friction:g}, gap {gap:g}"] = partial(slope, friction, gap=gap)
for gap in (0.0, 0.5):
    PROBLEMS[f"one block beside the other, gap {gap:g}"] = partial(beside, gap)
for factor in (0.5, 0.7, 0.9, 0.98, 1.1):
    PROBLEMS[f"pushed along a floor by {factor:g} of its friction"] = partial(pushed, factor)
for degrees in (45.0, 60.0):
    PROBLEMS[f"two bars lean at {degrees:g}° without friction"] = partial(hinge, degrees)
for gap in (0.0, 1e-3):
    PROBLEMS[f"turns about a ball, gap {gap:g}"] = partial(turning, gap)
SLOW = set()
