"""Bodies that are loaded, unloaded partly or to zero and loaded again, with and without friction; only contact bears them.

Where the load is gone, nothing presses: bodies are undeformed beside one another, and have not gone farther than the load had moved them.
"""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import BY_NAME, QUAD4, grid
from problem import Expected, Problem, Step
from solver import contact_of
from stacks import WEIGHT, blocks

YOUNG, POISSON = 1e3, 0.3
SOLVES = 6
PATHS = {
    "by halves": (1.0, 0.5, 0.0, 0.5, 1.0),
    "at once": (1.0, 0.0, 1.0),
    "twice": (1.0, 0.0, 0.0, 1.0, 0.0),
    "by tenths": (1.0, 0.1, 0.01, 0.0, 1.0),
}


def _steps(bodies, load, free, path, borne, has_friction):
    """The load steps. ``borne``: the force of the lowest contact, by that of the load."""
    farthest = {}

    def far(found):
        farthest["loaded"] = max(farthest.get("loaded", 0.0), np.abs(found.x).max())
        return borne(found)

    free_of_force = Expected("largest force", lambda found: np.abs(found.result.forces).max(), 0.0, 1e-9 * np.abs(load).max(), "there is no load")
    still = Expected("largest u / loaded", lambda found: np.abs(found.x).max() / farthest["loaded"], 0.0, 2.0, "nothing drives bodies along")
    steps = []
    for before, part in zip((0.0, *path), path):
        # The residual at which the driver stops, and statics.
        loaded = Expected("borne", far, part, 1e-7, "statics")
        expected = (loaded,) if part else (free_of_force, still)
        # With friction, bodies that are pressed slide two ways; those that were dragged along come back turned a little. Where nothing changes
        # there is nothing to be solved for.
        most = 0 if part == before else SOLVES if not has_friction else 10 if part < before else 16
        steps.append(Step(bodies.host(part * load), free, expected=expected, most_solves=most))
    return steps


def on_block(cells, path, friction=0.0, shear=0.0, is_linear=True):
    """A block on another one, pressed by its top, and dragged along by a part of the pressure."""
    cells = BY_NAME[cells]
    dim, count, total = cells.dim, 4 if cells.dim == 2 else 2, 1.0 if is_linear else 20.0
    side = dim - 1
    upper = grid(cells.mesh, [0.1] * side + [0.0], [0.9] * side + [1.0], [count] * dim)
    lower = grid(cells.mesh, [0.0] * side + [-1.0], [1.0] * side + [0.0], [count + 1] * dim)
    bodies = Bodies([upper, lower], cells, YOUNG, POISSON, is_linear)
    contact = contact_of(bodies, friction_coefficient=friction)
    held = [bodies.unknowns(1, lambda x: x[-1] < -1 + 1e-9)]
    if not friction:
        held += [bodies.unknowns(0, lambda x: x[0] < np.inf, axis) for axis in range(side)]
    load = bodies.traction(0, lambda x: x[-1] > 1 - 1e-9, [-shear * total] + [0.0] * (dim - 2) + [-total])
    weight = total * 0.8**side
    steps = _steps(bodies, load, bodies.free(held), PATHS[path], lambda found: found.result.bodies[0].force[-1] / weight, friction > 0)
    return Problem(contact, np.zeros(bodies.size), steps, friction > 0)


def stack(count, path, friction=0.0, is_held=True):
    """Blocks on a floor, held sideways by one node each, or by friction alone."""
    bodies = Bodies(blocks(count, 0.0, 0.0), QUAD4, 1e6, POISSON)
    contact = contact_of(bodies, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    held = []
    for body, mesh in enumerate(bodies.meshes if is_held else []):
        foot = mesh.p[:, np.lexsort((np.abs(mesh.p[0] - 0.5), mesh.p[1]))[0]]
        held.append(bodies.unknowns(body, lambda x, at=foot: np.abs(x - at[:, None]).max(axis=0) < 1e-9, 0))
    load = bodies.weight(WEIGHT)
    steps = _steps(bodies, load, bodies.free(held), PATHS[path], lambda found: found.result.obstacles[0].force[-1] / load.sum(), friction > 0)
    return Problem(contact, np.zeros(bodies.size), steps, friction > 0)


PROBLEMS = {
    f"{cells} on a block, {'linear' if is_linear else 'neo-Hookean'}, μ {friction:g}, drag {shear:g}, {path}": partial(
        on_block, cells, path, friction, shear, is_linear
    )
    for cells in ("Quad4", "Hex8")
    for is_linear in (True, False)
    for friction, shear in ((0.0, 0.0), (0.3, 0.0), (0.3, 0.1))
    for path in PATHS
}
PROBLEMS |= {
    f"stack of {count}, μ {friction:g}, {'held' if is_held else 'free'}, {path}": partial(stack, count, path, friction, is_held)
    for count in (3, 5)
    for friction, is_held in ((0.0, True), (0.3, True), (0.5, False))
    for path in PATHS
}
SLOW = {name for name in PROBLEMS if "Hex8" in name or "twice" in name}
