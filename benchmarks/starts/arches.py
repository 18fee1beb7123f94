"""Semicircular arches of dry voussoirs under their weight, whose joints touch exactly: they stand from some thickness on.

Heyman's thickness for a continuous ring is 0.1075 R. An arch of n voussoirs opens at joints alone, so its own least thickness and its thrust
are found by linear programming on the forces at the joints (limit analysis of rigid blocks), with the weights of the meshes.
"""

from functools import partial

import numpy as np
from bodies import Bodies
from meshes import QUAD4, sector
from problem import Expected, Problem, Refused, Step
from scipy.optimize import linprog
from solver import contact_of

_ALONG, _LAYERS = 2, 3


def _voussoirs(count, thickness, overlap=0.0):
    angle = np.pi / count
    radii = 1 - thickness / 2, 1 + thickness / 2
    return [sector(*radii, i * angle - overlap, (i + 1) * angle + overlap, _LAYERS, _ALONG) for i in range(count)]


def _masses(mesh):
    """Area and centre of a mesh of quadrilaterals."""
    x, y = mesh.p[:, mesh.t]
    cross = x * np.roll(y, -1, 0) - np.roll(x, -1, 0) * y
    area = cross.sum() / 2
    centre = [((one + np.roll(one, -1, 0)) * cross).sum() / 6 / area for one in (x, y)]
    return area, np.array(centre)


def thrusts(count, thickness, friction):
    """Least and largest horizontal thrust of rigid voussoirs, by the weight of all; None if the arch falls.

    Unknowns are the normal force, the shear and the moment about the middle of every joint.
    """
    masses = [_masses(mesh) for mesh in _voussoirs(count, thickness)]
    total = sum(area for area, _ in masses)
    angles = np.arange(count + 1) * np.pi / count
    along, out = np.c_[-np.sin(angles), np.cos(angles)], np.c_[np.cos(angles), np.sin(angles)]
    equal, right = np.zeros((3 * count, 3 * count + 3)), np.zeros(3 * count)
    for i, (area, centre) in enumerate(masses):
        # A joint presses the voussoir before it backwards, and the one behind it forwards.
        for joint, sign in ((i, 1.0), (i + 1, -1.0)):
            arm = out[joint] - centre
            for column, direction in ((0, along[joint]), (1, out[joint])):
                equal[3 * i : 3 * i + 2, 3 * joint + column] = sign * direction
                equal[3 * i + 2, 3 * joint + column] = sign * (arm[0] * direction[1] - arm[1] * direction[0])
            equal[3 * i + 2, 3 * joint + 2] = sign
        right[3 * i + 1] = area / total
    bounds_of, at = [], lambda j, c, value: np.eye(1, 3 * count + 3, 3 * j + c)[0] * value
    for joint in range(count + 1):
        for sign in (-1, 1):
            bounds_of.append(at(joint, 1, sign) - at(joint, 0, friction))
            bounds_of.append(at(joint, 2, sign) - at(joint, 0, thickness / 2))
    bounds = [(0, None), (None, None), (None, None)] * (count + 1)
    ends = []
    for sign in (1, -1):
        # At the springing the joint is horizontal: its shear is the thrust.
        found = linprog(at(0, 1, sign), np.array(bounds_of), np.zeros(len(bounds_of)), equal, right, bounds)
        if found.status:
            return None
        ends.append(abs(found.x[1]))
    return tuple(sorted(ends))


def least_thickness(count, friction):
    """Thickness from which on rigid voussoirs stand, by the radius."""
    low, high = 0.05, 0.2
    while high - low > 1e-6:
        middle = (low + high) / 2
        low, high = (middle, high) if thrusts(count, middle, friction) is None else (low, middle)
    return high


def arch(count, thickness, friction=0.8, young=1e7, overlap=0.0):
    """An arch on a floor. ``young`` by weight per volume and radius."""
    bodies = Bodies(_voussoirs(count, thickness, overlap), QUAD4, young, 0.2)
    contact = contact_of(bodies, friction_coefficient=friction)
    contact.contact.obstacles.add_half_space([0, 0], [0, 1])
    load = bodies.weight(1.0)
    weight = -load.sum()
    bounds = thrusts(count, thickness, friction)
    if bounds is None:
        refused = Refused(tuple(range(count)), "no line of thrust lies within the arch")
        step = Step(bodies.host(load), bodies.free([]), refused=refused)
        return Problem(contact, np.zeros(bodies.size), [step], True)
    middle, room = sum(bounds) / 2, (bounds[1] - bounds[0]) / 2
    vertical = lambda found: -found.result.obstacles[0].force[1] / weight
    first = bodies.unknowns(0, lambda x: x[1] < 1e-9, 0)
    thrust = lambda found: abs(contact.on_dofs(found.result.forces)[first].sum()) / weight
    step = Step(
        bodies.host(load),
        bodies.free([]),
        expected=(
            Expected("floor/W", vertical, 1.0, 1e-6, "statics; the arch rests on rounding of E / ρ g R"),
            # Elastic joints move the line of thrust by a part of the thickness.
            Expected("thrust/W", thrust, middle, room + 0.02 * middle, "between the least and the largest of rigid voussoirs"),
        ),
        most_solves=30,
    )
    return Problem(contact, np.zeros(bodies.size), [step], True)


PROBLEMS = {}
for count in (15, 27):
    for thickness in (0.2, 0.15, 0.12, 0.112, 0.104, 0.1, 0.08):
        for young in (1e5, 1e6, 1e7):
            PROBLEMS[f"{count} voussoirs, t/R {thickness:g}, E {young:g} ρgR"] = partial(arch, count, thickness, 0.8, young)
    PROBLEMS[f"{count} voussoirs, t/R 0.15, μ 2"] = partial(arch, count, 0.15, 2.0)
    PROBLEMS[f"{count} voussoirs, t/R 0.08, μ 2"] = partial(arch, count, 0.08, 2.0)
    PROBLEMS[f"{count} voussoirs, t/R 0.2, overlap 1e-6"] = partial(arch, count, 0.2, 0.8, 1e7, 1e-6)
SLOW = {name for name in PROBLEMS if any(f"t/R {thin}" in name for thin in ("0.104", "0.1,", "0.08"))}
