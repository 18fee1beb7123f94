"""Stacks of free blocks under their weight on a floor, touching, overlapping or apart."""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import BY_NAME, QUAD4, grid
from problem import Expected, Problem, Step
from scipy.sparse import block_diag
from skfem import BilinearForm
from solver import contact_of

YOUNG, POISSON, WEIGHT, COUNT = 1e6, 0.3, 1e3, 4
GAPS = (0.0, 1e-6, -1e-6, 1e-4, -1e-4, 1e-2, -1e-2, 0.3, 8.0)
"""By the size of a cell."""


def blocks(count, gap, shift):
    """Meshes of blocks that become narrower, or are shifted sideways, with gaps by the size of a cell."""
    meshes, base = [], 0.0
    for level in range(count):
        base += gap / COUNT
        less, aside = (0.05 * min(level, 6), 0.0) if not shift else (0.0, shift * level)
        cells = [COUNT + level % 2] * 2
        meshes.append(grid(QUAD4.mesh, [less + aside, base], [1 - less + aside, base + 1], cells))
        base += 1
    return meshes


def _springs(bodies, stiffness):
    """Springs between every point and its place, by volume."""
    form = BilinearForm(lambda u, v, w: stiffness * sum(a * b for a, b in zip(u, v)))
    return block_diag([form.assemble(basis) for basis in bodies.bases], "csr")


def _floor_bears(bodies, contact, load, others=None):
    """The force of the floor, and of other supports at a displacement, by the weight."""
    contact.contact.obstacles.add_half_space([0] * bodies.dim, [0] * (bodies.dim - 1) + [1])
    weight = -load.sum()
    reason = "statics: the floor bears all blocks, to the residual at which the driver stops"
    carried = lambda found: -found.result.obstacles[0].force[-1] + (others(found.x) if others else 0.0)
    return Expected("floor/W", lambda found: carried(found) / weight, 1.0, 1e-7, reason)


def _settled(bodies, gap):
    """The mean fall of every block but for its compression: the sum of the gaps below it."""
    places = [bodies.unknowns(body, lambda x: x[0] < np.inf, -1) for body in range(len(bodies.meshes))]
    worst = lambda found: max(abs(found.x[at].mean() + max(gap, 0.0) * (level + 1)) for level, at in enumerate(places))
    # n blocks of weight W are shortened by less than n² W / E, twice that where the blocks above are narrower.
    return Expected("largest fall less gaps", worst, 0.0, 3 * len(places) ** 2 * WEIGHT / YOUNG + max(-gap, 0) * len(places), "gaps and compression")


def stack(count, gap, friction=0.0, support="", spring=0.0, shift=0.0, most_solves=6, told=""):
    """Blocks that become narrower, or are shifted sideways. ``support``: ``held`` for one node of each sideways; empty for nothing."""
    bodies = Bodies(blocks(count, gap, shift), QUAD4, YOUNG, POISSON)
    contact = contact_of(bodies, friction_coefficient=friction)
    load = bodies.weight(WEIGHT)
    host, others = bodies.host(load), None
    if spring:
        springs = _springs(bodies, spring)
        matrix, heights = (bodies.stiffness + springs).tocsr(), bodies.weight(1.0) != 0
        host = lambda u: (matrix @ u - load, matrix)
        others = lambda u: -(springs @ u)[heights].sum()
    held = []
    if support == "held":
        for body, mesh in enumerate(bodies.meshes):
            foot = np.lexsort((np.abs(mesh.p[0] - 0.5), mesh.p[1]))[0]
            held.append(bodies.unknowns(body, lambda x, at=mesh.p[:, foot]: np.abs(x - at[:, None]).max(axis=0) < 1e-9, 0))
    expected = (_floor_bears(bodies, contact, load, others), _settled(bodies, gap / COUNT))
    # A solve finds where blocks with friction first touch.
    most = most_solves + 1 if friction and gap > 0 else most_solves
    step = Step(host, bodies.free(held), expected=expected, most_solves=most, told=told)
    return Problem(contact, np.zeros(bodies.size), [step], friction > 0)


def stack_in_space(cells, gap, friction=0.5):
    """Three blocks in space, the upper ones smaller and standing aside."""
    cells = BY_NAME[cells]
    meshes = []
    for level in range(3):
        low = np.array([0.05 * level, 0.05 * level, level + gap * (level + 1)])
        meshes.append(grid(cells.mesh, low, low + [1 - 0.1 * level, 1 - 0.1 * level, 1], [3 + level % 2] * 3))
    bodies = Bodies(meshes, cells, YOUNG, POISSON)
    contact = contact_of(bodies, friction_coefficient=friction)
    load = bodies.weight(WEIGHT)
    expected = (_floor_bears(bodies, contact, load), _settled(bodies, gap))
    step = Step(bodies.host(load), bodies.free([]), expected=expected, most_solves=8)
    return Problem(contact, np.zeros(bodies.size), [step], friction > 0)


PROBLEMS = {}
for count in (3, 5, 8):
    for gap in GAPS:
        PROBLEMS[f"{count} blocks, μ 0.5, gap {gap:g} h"] = partial(stack, count, gap, 0.5)
        PROBLEMS[f"{count} blocks, no friction, held sideways, gap {gap:g} h"] = partial(stack, count, gap, support="held")
        PROBLEMS[f"{count} blocks, no friction, nothing held, gap {gap:g} h"] = partial(stack, count, gap, told="unstable")
for gap in (0.0, 1e-6, 1e-4, 1e-2):
    for spring in (1e-9, 1e-5, 1e-3):
        PROBLEMS[f"3 blocks on springs of {spring:g} E, gap {gap:g}"] = partial(stack, 3, gap * COUNT, spring=spring * YOUNG)
for gap in (0.0, 1e-4):
    PROBLEMS[f"3 shifted blocks, μ 0.5, gap {gap:g}"] = partial(stack, 3, gap * COUNT, 0.5, shift=0.05)
for cells in ("Hex8", "Tet4"):
    for gap in (0.0, 1e-4, 0.02, -0.02):
        PROBLEMS[f"3 blocks of {cells}, μ 0.5, gap {gap:g}"] = partial(stack_in_space, cells, gap)
SLOW = set()
