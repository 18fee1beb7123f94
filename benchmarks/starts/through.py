"""Steps that carry a body through a thinner one, if nothing bounds them."""

from functools import partial

import numpy as np
import solver
from bodies import Bodies
from meshes import QUAD4, grid
from problem import Expected, Problem, Step
from solver import contact_of

_THICKNESS = 0.05


def _plate():
    """A plate clamped at its ends, and a stiffer block above it that is moved by its top."""
    young = 1e6
    plate = grid(QUAD4.mesh, [-1, -_THICKNESS], [1, 0], [40, 2])
    block = grid(QUAD4.mesh, [-0.2, 0.001], [0.2, 0.3], [6, 4])
    bodies = Bodies([plate, block], QUAD4, [young, 10 * young], 0.3)
    ends = bodies.unknowns(0, lambda x: np.abs(x[0]) > 1 - 1e-9)
    top = [bodies.unknowns(1, lambda x: x[1] > 0.3 - 1e-9, axis) for axis in (0, 1)]
    return bodies, bodies.free([ends, *top]), top[1], lambda found: found.result.bodies[0].force[1] / young


def block_into_plate(thicknesses, count=40):
    """In one step by so many thicknesses of the plate; expected is what equal small steps reach."""
    bodies, free, top, force = _plate()
    contact, x = contact_of(bodies), np.zeros(bodies.size)
    prescribed = np.zeros(bodies.size)
    for i in range(1, count + 1):
        prescribed[top] = -_THICKNESS * thicknesses * i / count
        known = solver.solve(bodies.host(), contact, x, free, prescribed)
        x = known.x
    lowest = lambda found: found.x[bodies.unknowns(0, lambda x: np.abs(x[0]) < 1e-9, 1)].min()
    # Multipliers have another history after 40 steps; both leave less than a thousandth of the motion.
    same = Expected("F/small steps", lambda found: force(found) / force(known), 1.0, 3e-3, "40 small steps")
    place = Expected("plate/small steps", lambda found: lowest(found) / lowest(known), 1.0, 3e-3, "40 small steps")
    step = Step(bodies.host(), free, prescribed, expected=(same, place), most_solves=25 + 10 * thicknesses)
    return Problem(contact_of(bodies), np.zeros(bodies.size), [step])


def _bars(load):
    """A cantilever, loaded at its tip, above a plate that is held at its other end."""
    thin = 0.05
    beam = grid(QUAD4.mesh, [0, 0], [2, thin], [40, 2])
    plate = grid(QUAD4.mesh, [1.5, -0.1], [2.5, -0.05], [20, 2])
    bodies = Bodies([beam, plate], QUAD4, 1e6, 0.3)
    tip = bodies.unknowns(0, lambda x: x[0] > 2 - 1e-9, 1)
    forces = np.zeros(bodies.size)
    forces[tip] = -load / len(tip)
    held = [bodies.unknowns(0, lambda x: x[0] < 1e-9), bodies.unknowns(1, lambda x: x[0] > 2.5 - 1e-9)]
    return bodies, forces, bodies.free(held), tip


def cantilever(load, count=40):
    """A load in one step that would bend the beam through the plate; expected is what equal small steps reach."""
    bodies, forces, free, tip = _bars(load)
    contact, x = contact_of(bodies), np.zeros(bodies.size)
    for i in range(1, count + 1):
        known = solver.solve(bodies.host(i / count * forces), contact, x, free)
        x = known.x
    pair = lambda found: found.result.bodies[0].force[1]
    expected = (
        Expected("F/small steps", lambda found: pair(found) / pair(known), 1.0, 3e-3, "40 small steps"),
        Expected("tip/small steps", lambda found: found.x[tip].mean() / known.x[tip].mean(), 1.0, 3e-3, "40 small steps"),
    )
    step = Step(bodies.host(forces), free, expected=expected, most_solves=25)
    return Problem(contact_of(bodies), np.zeros(bodies.size), [step])


PROBLEMS = {f"block into a plate by {n:g} thicknesses": partial(block_into_plate, n) for n in (1, 2, 3, 4, 6)}
PROBLEMS |= {f"cantilever through a plate by a load of {load:g}": partial(cantilever, load) for load in (1.0, 5.0, 20.0)}
SLOW = set()
