"""Coarse round faces that conform: levels of the depth cross every facet, and edges of both bodies coincide but for rounding."""

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementHex1, ElementVector, MeshHex, asm
from skfem.models.elasticity import lame_parameters, linear_elasticity


class Pair:
    """Two elastic bodies with smoothed faces, E = 1e6."""

    def __init__(self, meshes, friction):
        self.bases = [Basis(mesh, ElementVector(ElementHex1())) for mesh in meshes]
        self.starts = np.cumsum([0] + [basis.N for basis in self.bases])
        stiffness = linear_elasticity(*lame_parameters(1e6, 0.3))
        self.matrix = block_diag([asm(stiffness, basis) for basis in self.bases], "csr")
        self.contact = SkfemContact(list(zip(self.bases, self.starts)), friction_coefficient=friction)
        self.contact.set_surface_smoothing(30.0)

    def where(self, place, axis=None):
        dofs = [start + basis.get_dofs(place).all(axis and [axis]) for start, basis in zip(self.starts, self.bases)]
        return np.concatenate(dofs)

    def found(self, held, prescribed=None, two_level=None, start=None):
        """The equilibrium, and the force on the second body."""
        start = np.zeros(self.contact.size) if start is None else start
        free = np.setdiff1d(np.arange(self.contact.size), held)
        host = lambda u: (self.matrix @ u, self.matrix)
        found = find_equilibrium(host, self.contact, start, free, prescribed, two_level=two_level)
        return found, self.contact.evaluate(found.x).bodies[1].force


def sector(inner, outer, cells, height, angle=np.pi / 2):
    mesh = MeshHex.init_tensor(*[np.linspace(a, b, n + 1) for a, b, n in zip((inner, 0, 0), (outer, angle, height), cells)])
    radius, angle, z = mesh.p
    return MeshHex(np.stack([radius * np.cos(angle), radius * np.sin(angle), z]), mesh.t)


# Facets around the shaft and the hub, layers, interference, height of the hub (0.5 of the shaft), friction.
FITS = [
    (7, 6, 3, 0.0, 0.5, 0.1),
    (8, 7, 1, 0.0, 0.5, 0.0),
    (4, 6, 3, 1e-3, 0.5, 0.0),
    (8, 5, 3, 2e-3, 0.5, 0.0),
    (4, 5, 2, 1e-2, 0.3, 0.0),
    (7, 8, 2, 1e-3, 1.0, 0.0),
    # With a rim and friction: points of friction on the layer over a face once jumped to the largest of their parts.
    (6, 9, 3, 0.0, 0.3, 0.1),
    (8, 11, 2, 2e-3, 0.5, 0.3),
]


@pytest.mark.parametrize("shaft, hub, layers, interference, height, friction", FITS)
def test_a_coarse_press_fit_is_found_either_way(shaft, hub, layers, interference, height, friction):
    radii = (1 + 0.5 * interference, 1 - 0.5 * interference)
    meshes = [sector(0.5, radii[0], (1, shaft, layers), 0.5), sector(radii[1], 1.5, (1, hub, layers), height)]
    pair = Pair(meshes, friction)
    pair.contact.contact.mesh.set_symmetry_planes([(np.zeros(3), normal) for normal in np.eye(3)])
    held = np.concatenate([pair.where(lambda x, k=k: np.isclose(x[k], 0), f"u^{k + 1}") for k in range(3)])
    ways = [pair.found(held, two_level=two_level) for two_level in (True, False)]
    # Newton's method alone takes 6 to 14 steps; with forces that jump most did not end within 100.
    assert all(found.iterations <= 20 for found, _ in ways)
    forces = [force for _, force in ways]
    # Surfaces may be moved out by another penetration within what a search leaves.
    assert forces[1] == pytest.approx(forces[0], rel=1e-3, abs=1e-3 * np.abs(forces[0]).max())


def fit_between_planes(smoothed):
    """Rings of 8 and 11 facets per quarter with an interference of 2e-3, held along z: the pair, and the equilibrium."""
    pair = Pair([sector(0.5, 1.001, (2, 8, 1), 0.5), sector(0.999, 1.5, (2, 11, 1), 0.5)], 0.0)
    if not smoothed:
        pair.contact.set_surface_smoothing(0.0)
    planes = [(np.zeros(3), normal) for normal in np.eye(3)] + [([0, 0, 0.5], [0, 0, 1])]
    pair.contact.contact.mesh.set_symmetry_planes(planes)
    held = [pair.where(lambda x, k=k: np.isclose(x[k], 0), f"u^{k + 1}") for k in range(3)]
    found, _ = pair.found(np.concatenate([*held, pair.where(lambda x: np.isclose(x[2], 0.5), "u^3")]))
    return pair, found


def test_nodal_pressures_have_no_spikes():
    """Other sides press nodes whose facets do not touch, on the outer face too: their pressure is no more than that of the fit."""
    pair, found = fit_between_planes(smoothed=True)
    # Lamé's solution of plane strain: the rings give by (R² + r²) / (R² − r²) each, and by the Poisson's ratios, which cancel.
    exact = 2e-3 * 1e6 / (1 - 0.3**2) / (3.25 / 1.25 + 1.25 / 0.75)
    assert pair.contact.nodal_contact(found.x).pressure.max() == pytest.approx(exact, rel=0.1)


def test_faceted_fits_are_advised_to_be_smoothed():
    _, found = fit_between_planes(smoothed=False)
    within_facets = [text for text in found.warnings if "within single facets" in text]
    assert within_facets and all("smooth their round faces" in text for text in within_facets)


def cap(inner, outer, count, half, turn):
    """A part of a shell around the origin, towards z: its sides are 2 half wide."""
    angles = np.linspace(-half, half, count + 1)
    mesh = MeshHex.init_tensor(angles, angles, np.linspace(inner, outer, 3))
    s, t, radius = mesh.p
    ways = np.array([np.tan(s), np.tan(t), np.ones_like(s)])
    x = radius * ways / np.linalg.norm(ways, axis=0)
    c, s = np.cos(turn), np.sin(turn)
    return MeshHex(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ x, mesh.t)


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("ball, socket, turn", [(3, 4, 0.0), (4, 5, 0.2)])
def test_a_ball_is_pressed_into_its_socket(ball, socket, turn, friction):
    pair = Pair([cap(0.5, 1.0, ball, np.pi / 5, turn), cap(1.0, 1.5, socket, np.pi / 4, 0.0)], friction)
    is_at = lambda radius: lambda x: np.abs(np.linalg.norm(x, axis=0) - radius) < 0.06
    pushed = np.zeros(pair.contact.size)
    pushed[pair.where(is_at(0.5), "u^3")] = 1e-3
    held = np.concatenate([pair.where(is_at(0.5)), pair.where(is_at(1.5))])
    found, force = pair.found(held, pushed)
    assert found.iterations <= 10
    # The patch is symmetric about its axis but for the turn of the cells.
    assert np.abs(force[:2]).max() < 1e-3 * force[2]
    lower, _ = pair.found(held, pushed, two_level=False)
    assert lower.iterations <= 12


def test_a_pin_is_pushed_to_one_side_of_its_hole_and_back():
    """A hollow pin with clearance and friction is pushed by its bore, released, and pushed the other way: the forces mirror each other."""
    meshes = [sector(0.4, 0.99, (2, 10, 1), 0.3, np.pi), sector(1.0, 1.6, (2, 14, 1), 0.3, np.pi)]
    pair = Pair(meshes, 0.3)
    planes = [([0, 0, 0], [0, 0, 1]), ([0, 0, 0.3], [0, 0, 1]), ([0, 0, 0], [0, 1, 0])]
    pair.contact.contact.mesh.set_symmetry_planes(planes)
    within = lambda least, most: lambda x: (least < np.hypot(x[0], x[1])) & (np.hypot(x[0], x[1]) < most)
    bore, rim = pair.where(within(0, 0.41)), pair.where(within(1.5, 2))
    ends = pair.where(lambda x: np.isclose(np.abs(x[2] - 0.15), 0.15), "u^3")
    held = np.concatenate([bore, rim, ends, pair.where(lambda x: np.isclose(x[1], 0), "u^2")])
    x, prescribed, forces = np.zeros(pair.contact.size), np.zeros(pair.contact.size), []
    for push in (0.015, 0.0, -0.015):
        prescribed[pair.where(within(0, 0.41), "u^1")] = push
        found, force = pair.found(held, prescribed, start=x)
        assert found.iterations <= 12
        x = found.x
        pair.contact.commit_step(x)
        forces.append(force[0])
    assert forces[0] > 0 and abs(forces[1]) < 1e-6 * forces[0]
    assert forces[2] == pytest.approx(-forces[0], rel=1e-6)
