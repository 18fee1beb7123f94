"""Numbers of very different size in one problem: conditions by large numbers on the diagonal, bodies far from the origin, soft on stiff."""

from functools import partial

import numpy as np
import solver
from bodies import Bodies
from meshes import QUAD4, TRI3, disc, grid
from problem import Expected, Problem, Step
from scipy.sparse import diags
from skfem import MeshQuad
from solver import contact_of


def _sole(is_linear):
    """A block with a rounded sole above a floor."""
    mesh = grid(QUAD4.mesh, [0, 0], [1, 1], [16, 16])
    points = mesh.p.copy()
    points[1] += (points[0] - 0.5) ** 2 * 0.2 * (1 - points[1])
    bodies = Bodies([MeshQuad(points, mesh.t)], QUAD4, 1e3, 0.3, is_linear)
    contact = contact_of(bodies)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    top = [bodies.unknowns(0, lambda x: x[1] > 1 - 1e-9, axis) for axis in (0, 1)]
    prescribed = np.zeros(bodies.size)
    prescribed[top[1]] = -0.02
    return bodies, contact, np.concatenate(top), prescribed


def large_diagonal(factor, is_linear):
    """Displacements prescribed by a large number on the diagonal, times Young's modulus, with all unknowns free."""
    bodies, contact, top, prescribed = _sole(is_linear)
    known = solver.solve(bodies.host(), contact, np.zeros(bodies.size), bodies.free([top]), prescribed)
    force = known.result.obstacles[0].force[1]
    bodies, contact, top, prescribed = _sole(is_linear)
    large = np.zeros(bodies.size)
    large[top] = factor * 1e3

    def host(u):
        inside, matrix = bodies.host()(u)
        return inside + large * (u - prescribed), (matrix + diags(large)).tocsr()

    # A spring gives way by its force over its stiffness.
    tolerance = max(1e-6, 10 / factor)
    same = Expected("F/F0", lambda found: found.result.obstacles[0].force[1] / force, 1.0, tolerance, "the same problem by `prescribed`")
    step = Step(host, bodies.free([]), expected=(same,), most_solves=known.iterations + 3)
    return Problem(contact, np.zeros(bodies.size), [step])


def _far(sizes):
    """A disc on a block, with its origin so many of its sizes away."""
    size, off = 0.1, 0.1 * sizes
    block = grid(QUAD4.mesh, [off - size, off - size], [off + size, off], [20, 10])
    bodies = Bodies([block, disc(size, 3, (off, size + off))], [QUAD4, TRI3], 1e3, 0.3)
    top = [bodies.unknowns(1, lambda x: x[1] > off + 1.9 * size, axis) for axis in (0, 1)]
    bottom = bodies.unknowns(0, lambda x: x[1] < off - 0.95 * size)
    prescribed = np.zeros(bodies.size)
    prescribed[top[1]] = -0.02 * size
    force = lambda found: -found.reactions[top[1]].sum() / size
    return bodies, bodies.free([*top, bottom]), prescribed, force


def far_from_origin(sizes):
    """The same scene and another origin: the same force, in as many solves."""
    bodies, free, prescribed, force = _far(0.0)
    known = solver.solve(bodies.host(), contact_of(bodies), np.zeros(bodies.size), free, prescribed)
    wanted = force(known)
    bodies, free, prescribed, force = _far(sizes)
    # Coordinates are rounded to eps of the distance; the push is a fiftieth of a size.
    tolerance = max(1e-8, 100 * 50 * np.finfo(float).eps * sizes) * wanted
    same = Expected("F/size", force, wanted, tolerance, "the same scene at the origin")
    step = Step(bodies.host(), free, prescribed, expected=(same,), most_solves=known.iterations + 1)
    return Problem(contact_of(bodies), np.zeros(bodies.size), [step])


def soft_on_stiff(ratio, gap, friction=0.3):
    """A soft block on a stiff one, both free, on a floor."""
    young = 1e6
    meshes = [grid(QUAD4.mesh, [0, 0], [1, 1], [4, 4]), grid(QUAD4.mesh, [0.1, 1 + gap], [0.9, 2 + gap], [4, 4])]
    bodies = Bodies(meshes, QUAD4, [young * ratio, young], 0.3)
    contact = contact_of(bodies, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    load = bodies.weight(1e3)
    # The displacements of the stiff body are rounded to eps of what it moves, times its stiffness.
    tolerance = max(1e-7, 1e-12 * ratio)
    expected = (
        Expected("floor/W", lambda found: found.result.obstacles[0].force[1] / load.sum(), 1.0, tolerance, "statics"),
        Expected("N/W", lambda found: found.result.bodies[1].force[1] / 800, 1.0, tolerance, "statics"),
    )
    step = Step(bodies.host(load), bodies.free([]), expected=expected, most_solves=6)
    return Problem(contact, np.zeros(bodies.size), [step], friction > 0)


PROBLEMS = {
    f"{factor:g} E on the diagonal, {'linear' if is_linear else 'neo-Hookean'}": partial(large_diagonal, factor, is_linear)
    for is_linear in (True, False)
    for factor in (1e6, 1e9, 1e12, 1e15, 1e20, 1e30)
}
PROBLEMS |= {f"{sizes:g} sizes from the origin": partial(far_from_origin, sizes) for sizes in (10, 1e2, 1e3, 1e4, 1e5, 1e6)}
PROBLEMS |= {f"soft on stiff 1:{ratio:g}, gap {gap:g}": partial(soft_on_stiff, ratio, gap) for ratio in (1e3, 1e6, 1e9) for gap in (0.0, 0.01)}
SLOW = set()
