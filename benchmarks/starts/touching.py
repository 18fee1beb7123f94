"""A block that just touches what bears it, or nearly, and is held by nothing else in the direction of its load.

The commonest start there is. The block's sides are guided, so its strain is uniform under a force, and the answer is that of a column.
"""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import BY_NAME, grid
from problem import Expected, Problem, Step
from scipy.integrate import quad
from scipy.optimize import brentq
from skfem.models.elasticity import lame_parameters
from solver import contact_of

YOUNG, POISSON = 1e3, 0.3
SOLVES = 5
GAPS = (0.0, 1e-9, -1e-9, 1e-6, -1e-6, 1e-2)
SUPPORTS = ("floor", "block", "two blocks")
LOADS = ("force", "weight")


def _stretch(pressure, is_linear):
    """Stretch of a guided column under a pressure on its end."""
    la, mu = lame_parameters(YOUNG, POISSON)
    if is_linear:
        return 1 - pressure / (la + 2 * mu)
    return brentq(lambda s: mu * s + (la * np.log(s) - mu) / s + pressure, 0.3, 1.0, xtol=1e-15)


def _shortening(load, total, is_linear):
    if load == "force":
        return 1 - _stretch(total, is_linear)
    return quad(lambda height: 1 - _stretch(total * height, is_linear), 0, 1)[0]


def _supports(cells, support, count):
    """Meshes of the lower bodies: none for the floor."""
    side = cells.dim - 1
    if support == "floor":
        return []
    if support == "block":
        return [grid(cells.mesh, [0] * side + [-1], [1] * side + [0], [count + 1] * cells.dim)]
    ends = [(0.0, 0.45), (0.55, 1.0)]
    counts = [count // 2 + 1] + [count + 1] * side
    return [grid(cells.mesh, [a] + [0] * (side - 1) + [-1], [b] + [1] * (side - 1) + [0], counts) for a, b in ends]


def block(cells, support, load, gap, is_linear=True):
    """The block and what bears it; the gap by the size of a cell."""
    cells = BY_NAME[cells]
    dim, count, total = cells.dim, 4 if cells.dim == 2 else 2, 1.0 if is_linear else 20.0
    gap = gap / count
    upper = grid(cells.mesh, [0] * (dim - 1) + [gap], [1] * (dim - 1) + [1 + gap], [count] * dim)
    bodies = Bodies([upper, *_supports(cells, support, count)], cells, YOUNG, POISSON, is_linear)
    contact = contact_of(bodies)
    if support == "floor":
        contact.contact.obstacles.add_half_space([0] * dim, [0] * (dim - 1) + [1])
    lower = range(1, len(bodies.meshes))
    held = [bodies.unknowns(body, lambda x: x[0] < np.inf, axis) for body in (0, *lower) for axis in range(dim - 1)]
    held += [bodies.unknowns(body, lambda x: x[-1] < -1 + 1e-9) for body in lower]
    is_top = lambda x: x[-1] > 1 + gap - 1e-9
    if load == "force":
        forces = bodies.traction(0, is_top, [0] * (dim - 1) + [-total])
    else:
        forces = bodies.weight(total, bodies=[0])
    expected = [Expected("F/P", lambda found: found.result.bodies[0].force[-1] / total, 1.0, 1e-9, "statics")]
    if support != "two blocks":
        shorter = _shortening(load, total, is_linear)
        if support == "block":
            shorter += _shortening("force", total, is_linear)
        top = bodies.unknowns(0, is_top, -1)
        # Cells of first order follow the parabola of a weight, and those of a tetrahedral mesh a uniform traction, but nearly.
        tolerance = 3e-3 if load == "force" else 1e-2
        drop = lambda found: (-found.x[top].mean() - gap) / shorter
        expected.append(Expected("shortening/column", drop, 1.0, tolerance, "a guided column; penetration is below 1e-3 of it"))
    step = Step(bodies.host(forces), bodies.free(held), expected=tuple(expected), most_solves=SOLVES)
    return Problem(contact, np.zeros(bodies.size), [step])


def half_guided(cells, gap):
    """A block of finite weight on a wider one, guided at its upper half alone: it could turn, were it not for the guide."""
    cells = BY_NAME[cells]
    dim, weight = cells.dim, 1e3
    low = grid(cells.mesh, [0] * dim, [2] * (dim - 1) + [1], [6] * (dim - 1) + [3])
    high = grid(cells.mesh, [0.5] * (dim - 1) + [1 + gap], [1.5] * (dim - 1) + [2 + gap], [4] * dim)
    bodies = Bodies([low, high], cells, 1e6, 0.3)
    held = [bodies.unknowns(0, lambda x: x[-1] < 1e-9)]
    held += [bodies.unknowns(1, lambda x: x[-1] > 1.5, axis) for axis in range(dim - 1)]
    expected = Expected("F/W", lambda found: found.result.bodies[1].force[-1] / weight, 1.0, 1e-9, "statics")
    step = Step(bodies.host(bodies.weight(weight, bodies=[1])), bodies.free(held), expected=(expected,), most_solves=SOLVES)
    return Problem(contact_of(bodies), np.zeros(bodies.size), [step])


def _named(cells, support, load, gap, is_linear):
    return f"{cells} on {support}, {load}, gap {gap:g} h{'' if is_linear else ', neo-Hookean'}"


PROBLEMS = {
    _named(*one): partial(block, *one)
    for is_linear in (True, False)
    for cells in ("Quad4", "Tri3", "Tri6", "Hex8", "Tet4", "Tet10")
    for support in SUPPORTS
    for load in LOADS
    for gap in GAPS
    for one in [(cells, support, load, gap, is_linear)]
    # The material does not change what a start does, so half of the loads and gaps do for the second one.
    if is_linear or (load == "force" and gap in (0.0, -1e-6, 1e-2))
}
PROBLEMS |= {
    f"{cells} half guided, gap {gap:g}": partial(half_guided, cells, gap) for cells in ("Quad4", "Tri3", "Hex8", "Tet4") for gap in (0.0, 1e-3)
}
SLOW = {name for name in PROBLEMS if "e-09" in name}
