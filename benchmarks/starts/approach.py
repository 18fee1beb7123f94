"""A disc that is held by its top is brought from a gap deep into a block in one load step.

Also to the place where it just touches, and in and out again: nothing of a step depends on the steps before it.
"""

import json
from functools import partial
from pathlib import Path

import numpy as np
import solver
from bodies import Bodies
from meshes import QUAD4, QUAD9, TRI3, TRI6, disc, grid
from problem import Expected, Problem, Step
from solver import contact_of

RADIUS = 0.5
GAPS = (0.0, 0.05, 0.2, 1.0)
DEPTHS = (0.01, 0.02, 0.05, 0.1, 0.2)
_FORCES = Path(__file__).parent / "approach.json"


class Scene:
    """The bodies of a given order and material, and where the disc is held."""

    def __init__(self, order, is_linear):
        block = grid(QUAD4.mesh, [-2, -1], [2, 0], [40, 7])
        cells = [QUAD4, TRI3] if order == 1 else [QUAD9, TRI6]
        self.bodies = Bodies([block, disc(RADIUS, 4, (0, RADIUS))], cells, [1e3, 5e3], 0.3, is_linear)
        self.top = [self.bodies.unknowns(1, lambda x: x[1] > 0.9, axis) for axis in (0, 1)]
        bottom = self.bodies.unknowns(0, lambda x: x[1] < -1 + 1e-9)
        self.free = self.bodies.free([*self.top, bottom])
        self.host = self.bodies.host()

    def at(self, height, aside=0.0):
        """Prescribed displacements with the disc so high above the block."""
        found = np.zeros(self.bodies.size)
        found[self.top[0]], found[self.top[1]] = aside, height
        return found

    def moved(self, height, aside=0.0):
        """The whole disc so high above the block."""
        found = np.zeros(self.bodies.size)
        for axis, value in ((0, aside), (1, height)):
            found[self.bodies.unknowns(1, lambda x: x[1] > -1, axis)] = value
        return found

    def force(self, found):
        """Force on the disc."""
        return found.result.bodies[1].force[1]

    def problem(self, start, steps):
        return Problem(contact_of(self.bodies), start, steps)


def key(order, is_linear, depth):
    return f"order {order}, {'linear' if is_linear else 'neo-Hookean'}, {depth:g}"


def in_small_steps(order, is_linear, count=80):
    """Forces by key, of a disc that comes down in equal small steps, from where it touches to the largest depth."""
    scene, forces = Scene(order, is_linear), {}
    contact, x = contact_of(scene.bodies), np.zeros(scene.bodies.size)
    for height in -DEPTHS[-1] * np.arange(1, count + 1) / count:
        found = solver.solve(scene.host, contact, x, scene.free, scene.at(height))
        x = found.x
        for depth in DEPTHS:
            if np.isclose(-height, depth):
                forces[key(order, is_linear, depth)] = scene.force(found)
    return forces


def _known(order, is_linear, depth):
    return json.loads(_FORCES.read_text())[key(order, is_linear, depth)]


def _pressed(scene, order, is_linear, depth):
    # A facet is a tenth wide: at a small depth two or three are touched, and force depends on the stiffness of the contact.
    why = "small load steps, with a stiffness that leaves no penetration"
    by = lambda found: scene.force(found) / _known(order, is_linear, depth)
    return Expected(f"F at {depth:g}/small steps", by, 1.0, 1.2e-3 / depth, why)


def brought(order, is_linear, gap, depth):
    """From a gap to a depth."""
    scene = Scene(order, is_linear)
    expected = (_pressed(scene, order, is_linear, depth),)
    step = Step(scene.host, scene.free, scene.at(-depth), expected=expected, most_solves=80)
    return scene.problem(scene.moved(gap), [step])


def touched(order, is_linear, places):
    """To where the disc just touches, from other places: nothing is strained there, and nothing presses."""
    scene = Scene(order, is_linear)
    still = Expected("largest force", lambda found: np.abs(found.result.forces).max() / 1e3, 0.0, 1e-9, "nothing is strained")
    x, y = places[0]
    start = scene.moved(y, x) if y >= 0 else np.zeros(scene.bodies.size)
    steps = [Step(scene.host, scene.free, scene.at(y, x), most_solves=6) for x, y in places if y < 0]
    steps += [Step(scene.host, scene.free, scene.at(0.0), expected=(still,), most_solves=6)]
    return scene.problem(start, steps)


def loaded_again(order, is_linear, gap, depth=0.05):
    """Pressed, taken back to nothing, taken away to a gap, pressed again: the same force as at first, and none between."""
    scene, first = Scene(order, is_linear), {}
    size = lambda found: np.abs(found.x[: scene.bodies.offsets[1]]).max()
    # Multipliers of the steps before may leave a thousandth of what they had to take up.
    none = Expected("largest u of the block", size, 0.0, 1e-3 * depth, "nothing presses")
    apart = Expected("largest u of the block", size, 0.0, 1e-9 if gap > 1e-3 * depth else 1e-3 * depth, "the bodies are apart")

    def again(found):
        return scene.force(found) / first["force"]

    def pressed(found):
        first["force"] = scene.force(found)
        return first["force"] / _known(order, is_linear, depth)

    once = Expected(f"F at {depth:g}/small steps", pressed, 1.0, 1e-3 / depth, "small load steps")
    twice = Expected("F again/F", again, 1.0, 5e-3, "elastic bodies without friction forget; multipliers leave a thousandth")
    path = [(-depth / 5, ()), (-depth, (once,)), (-depth / 5, ()), (0.0, (none,)), (gap, (apart,)), (-depth / 5, ()), (-depth, (twice,))]
    steps = [Step(scene.host, scene.free, scene.at(y), expected=expected, most_solves=6) for y, expected in path]
    return scene.problem(np.zeros(scene.bodies.size), steps)


def _name(order, is_linear):
    return f"order {order}, {'linear' if is_linear else 'neo-Hookean'}"


KINDS = [(order, is_linear) for is_linear in (True, False) for order in (1, 2)]
BROUGHT = {f"{_name(*kind)}, from {gap:g} to {depth:g}": partial(brought, *kind, gap, depth) for kind in KINDS for gap in GAPS for depth in DEPTHS}
TOUCHED = {
    f"{_name(*kind)}, just touches from {places}": partial(touched, *kind, places)
    for kind in KINDS
    for places in ([(0, 1e-9)], [(0, 1e-6)], [(0, 0.01)], [(0, 0.2)], [(0.3, 1.0)], [(0, -0.01)])
}
AGAIN = {f"{_name(*kind)}, loaded again from {gap:g}": partial(loaded_again, *kind, gap) for kind in KINDS for gap in (1e-9, 1e-6, 1e-3, 0.1, 1.0)}
PROBLEMS = BROUGHT | TOUCHED | AGAIN
SLOW = {name for name in PROBLEMS if "order 2" in name or ("neo-Hookean" in name and "again" in name)}

if __name__ == "__main__":
    # Records the forces: with a driver that is right in small steps, and a stiffness of the contact that leaves no penetration.
    forces = {}
    for kind in KINDS:
        forces |= in_small_steps(*kind)
    _FORCES.write_text(json.dumps(forces, indent=1) + "\n")
