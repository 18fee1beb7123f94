"""Bodies that contact alone holds in every direction: a disc in a groove, a ball in a corner, rings that are pressed into each other."""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import QUAD4, TET4, TRI3, disc, ring
from problem import Expected, Problem, Step
from skfem import MeshTet
from solver import contact_of

YOUNG, WEIGHT = 1e6, 1e3


def groove(gap=0.0, shift=0.0, friction=0.0, degrees=45.0):
    """A disc in a V-shaped groove, whose sides are shifted or apart from it; a negative gap is an overlap."""
    bodies = Bodies([disc(1.0, 3, (0, 0))], TRI3, YOUNG, 0.3)
    contact = contact_of(bodies, friction_coefficient=friction)
    angle = np.radians(degrees)
    for side in (-1, 1):
        point = [side * (1 + gap) * np.sin(angle) + shift, -(1 + gap) * np.cos(angle)]
        contact.contact.obstacles.add_half_space(point, [-side * np.sin(angle), np.cos(angle)])
    load = bodies.weight(WEIGHT)
    weight = -load.sum()
    carried = lambda found: -sum(one.force[1] for one in found.result.obstacles) / weight
    expected = [Expected("sides/W", carried, 1.0, 1e-7, "statics")]
    if not friction:
        wanted = 1 / 2 / np.cos(angle)
        for side in (0, 1):
            normal = lambda found, side=side: np.linalg.norm(found.result.obstacles[side].force) / weight
            expected.append(Expected(f"N{side + 1}/W", normal, wanted, 1e-7, "statics: two forces normal to the sides"))
    step = Step(bodies.host(load), bodies.free([]), expected=tuple(expected), most_solves=36 if friction else 8)
    return Problem(contact, np.zeros(bodies.size), [step], friction > 0)


def corner(gap, friction):
    """A ball of tetrahedra in a corner of three planes."""
    bodies = Bodies([MeshTet.init_ball(2)], TET4, YOUNG, 0.3)
    contact = contact_of(bodies, friction_coefficient=friction)
    height = 1 / np.sqrt(3)
    for angle in 2 * np.pi * np.arange(3) / 3:
        normal = np.array([np.cos(angle) * np.sqrt(2 / 3), np.sin(angle) * np.sqrt(2 / 3), height])
        contact.contact.obstacles.add_half_space(-normal * (1 + gap), normal)
    load = bodies.weight(WEIGHT)
    weight = -load.sum()
    carried = lambda found: -sum(one.force[2] for one in found.result.obstacles) / weight
    expected = [Expected("planes/W", carried, 1.0, 1e-7, "statics")]
    if not friction:
        for plane in range(3):
            normal = lambda found, plane=plane: np.linalg.norm(found.result.obstacles[plane].force) / weight
            expected.append(Expected(f"N{plane + 1}/W", normal, 1 / 3 / height, 1e-7, "statics: three forces normal to the planes"))
    step = Step(bodies.host(load), bodies.free([]), expected=tuple(expected), most_solves=13 if friction else 12)
    return Problem(contact, np.zeros(bodies.size), [step], friction > 0)


def _lame(inner, middle, outer, interference, young, poisson):
    """Pressure between two thick rings of one material in plane strain, one too large by an interference of the radii."""
    young, poisson = young / (1 - poisson**2), poisson / (1 - poisson)
    within = (middle**2 + inner**2) / (middle**2 - inner**2) - poisson
    without = (outer**2 + middle**2) / (outer**2 - middle**2) + poisson
    return interference * young / middle / (within + without)


def press_fit(interference, others=0):
    """Two rings, one too large for the other, and nothing else. ``others``: by how many cells more the outer one is divided."""
    young, count = 2e11, 64
    meshes = [ring(0.5, 1 + interference / 2, 8, count), ring(1 - interference / 2, 1.5, 8, count + others)]
    bodies = Bodies(meshes, QUAD4, young, 0.3)
    pressure = _lame(0.5, 1.0, 1.5, interference, young, 0.3)
    contact = contact_of(bodies)

    def outwards(found):
        """Mean pressure on the outer ring."""
        where = np.concatenate([mesh.p for mesh in meshes], axis=1).T
        second = slice(meshes[0].p.shape[1], None)
        out = where[second] / np.linalg.norm(where[second], axis=1)[:, None]
        return (found.result.forces[second] * out).sum() / (2 * np.pi)

    # Lamé's equations have small displacements. Faces that do not match overlap too, by half of the sagitta (π / n)² / 2 of a face.
    tolerance, why = interference + (6e-4 / interference if others else 2e-3), "Lamé; 8 cells through each ring"
    expected = Expected("pressure/Lamé", lambda found: outwards(found) / pressure, 1.0, tolerance, why)
    step = Step(bodies.host(), bodies.free([]), expected=(expected,), most_solves=16)
    return Problem(contact, np.zeros(bodies.size), [step])


PROBLEMS = {
    "disc in a groove": groove,
    "disc in a groove, gap 0.01": partial(groove, 0.01),
    "disc in a groove, gap 0.5": partial(groove, 0.5),
    "disc in a groove, shifted by 0.1": partial(groove, 0.0, 0.1),
    "disc in a groove of 60°": partial(groove, degrees=60.0),
    "disc in a groove, μ 0.3": partial(groove, friction=0.3),
    "disc in a groove, overlap 1e-3, μ 0.3": partial(groove, -1e-3, friction=0.3),
}
PROBLEMS |= {f"ball in a corner, gap {gap:g}, μ {mu:g}": partial(corner, gap, mu) for gap in (0.0, 0.02) for mu in (0.0, 0.3)}
PROBLEMS |= {f"press fit of free rings, interference {one:g}": partial(press_fit, one) for one in (1e-4, 1e-3, 1e-2)}
PROBLEMS |= {f"press fit of free rings that do not match, interference {one:g}": partial(press_fit, one, 5) for one in (1e-2, 2e-2)}
SLOW = set()
