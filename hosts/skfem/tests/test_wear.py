"""Wear of elastic bodies, in equilibrium step by step."""

import numpy as np
import pytest
from fmc_contact import Pose, find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from skfem import Basis, ElementQuad1, ElementQuad2, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

E, LOAD, WEAR = 1e3, 2.0, 1e-4


class Pin:
    """An elastic pin of width 1 on a plane, below a load on its top, which is held sideways."""

    def __init__(self, nu, stiffness, cells=8, element=ElementQuad1, **options):
        self.mesh = MeshQuad.init_tensor(np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1))
        self.basis = Basis(self.mesh, ElementVector(element()))
        self.K = linear_elasticity(*lame_parameters(E, nu)).assemble(self.basis)
        self.push = np.zeros(self.basis.N)
        top = self.mesh.p[1] == 1
        # A load that is even: half at the ends.
        even = np.where(np.isin(self.mesh.p[0], (0, 1)), 0.5, 1.0)[top] / cells
        self.push[self.basis.nodal_dofs[1, top]] = -LOAD * even
        self.contact = SkfemContact(self.basis, stiffness=stiffness, **options)
        self.plane = self.contact.contact.obstacles.add_half_space((0, 0), (0, 1))
        self.free = np.setdiff1d(np.arange(self.basis.N), self.basis.nodal_dofs[0, top])
        self.u, self.way = np.zeros(self.basis.N), 0.0
        self.foot = self.mesh.p[1] == 0
        self.contact.contact.pairs.set_wear(0, ("obstacle", self.plane), WEAR)

    def slide(self, way, **options):
        self.way += way
        self.contact.contact.obstacles.set_pose(self.plane, Pose((self.way, 0)))
        found = find_equilibrium(lambda u: (self.K @ u - self.push, self.K), self.contact, self.u, self.free, **options)
        self.u = found.x
        return found

    def commit(self):
        self.contact.commit_step(self.u)

    def pressures(self):
        return self.contact.contact.nodal_contact(self.contact.coords(self.u)).pressure[: self.mesh.nvertices][self.foot]

    def depths(self):
        return self.contact.contact.wear.depth[: self.mesh.nvertices][self.foot]


@pytest.mark.parametrize(("cycles", "element"), [(4, ElementQuad1), (50, ElementQuad1), (50, ElementQuad2)])
def test_a_thousand_cycles_of_an_elastic_pin_under_a_constant_load(cycles, element):
    # Without Poisson's ratio the pressure is even: h = K p s. Few cycles a step on a coarse mesh.
    pin, stroke = Pin(0.0, 10 * E, 2 if cycles == 4 else 8, element), 1e-3
    pin.contact.contact.wear.set_cycles(cycles)
    pin.contact.begin_step(pin.u)
    for _ in range(1000 // cycles):
        pin.slide(stroke)
        pin.commit()
    expected = WEAR * LOAD * 1000 * stroke
    # Half a percent is asked for. Walls are pressed as far as they lie in the plane, 2e-4 of the width.
    assert pin.depths() == pytest.approx(expected, rel=1e-3)
    assert pin.contact.contact.wear.volumes == pytest.approx(expected, rel=1e-3)


def test_a_restart_with_a_penetration_tolerance_is_the_unbroken_run():
    given, stroke = E, 0.02

    def pin():
        return Pin(0.3, given, friction_coefficient=0.2)

    def go(pin, steps):
        for _ in range(steps):
            pin.slide(stroke, penetration=1e-6)
            pin.commit()
        return pin

    unbroken = pin()
    unbroken.contact.begin_step(unbroken.u)
    before = go(unbroken, 2)
    contact = before.contact.contact
    saved = contact.options["stiffness"], contact.multipliers.values, contact.wear.facets, contact.friction.slip, before.u, before.way
    # As far as it goes: a new contact that does not know of it would raise it again.
    assert saved[0] == 16 * given
    go(unbroken, 3)

    again = pin()
    contact = again.contact.contact
    contact.stiffen(saved[0] / given)
    contact.multipliers.values, contact.wear.facets = saved[1:3]
    again.u, again.way = saved[4:]
    contact.obstacles.set_pose(again.plane, Pose((again.way, 0)))
    again.contact.begin_step(again.u)
    contact.friction.slip = saved[3]
    go(again, 3)
    assert np.array_equal(again.u, unbroken.u)
    assert np.array_equal(contact.wear.facets, unbroken.contact.contact.wear.facets)
    assert contact.options["stiffness"] == saved[0]


def test_the_peaks_below_a_punch_wear_flat():
    # A punch with sharp corners on an elastic plate that goes to and fro below it: peaks at its corners at first.
    n, width = 8, 4
    punch = MeshQuad.init_tensor(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
    plate = MeshQuad.init_tensor(np.linspace(-1.5, 2.5, 5 * width + 1), np.linspace(-1, 0, 6))
    bases = [Basis(mesh, ElementVector(ElementQuad1())) for mesh in (punch, plate)]
    moduli = (10 * E, E)
    K = block_diag([linear_elasticity(*lame_parameters(e, 0.3)).assemble(basis) for e, basis in zip(moduli, bases)], "csr")
    contact = SkfemContact([(bases[0], 0), (bases[1], bases[0].N)], stiffness=50 * E)
    contact.contact.pairs.set_wear(0, 1, WEAR)
    top, foot = punch.p[1] == 1, punch.p[1] == 0
    push = np.zeros(K.shape[0])
    push[bases[0].nodal_dofs[1, top]] = -LOAD / n * np.where(np.isin(punch.p[0, top], (0, 1)), 0.5, 1.0)
    bottom = bases[0].N + bases[1].nodal_dofs[:, plate.p[1] == -1]
    free = np.setdiff1d(np.arange(K.shape[0]), np.concatenate([bases[0].nodal_dofs[0, top], bottom.ravel()]))
    u, first, last = np.zeros(K.shape[0]), None, None
    contact.begin_step(u)
    # Small cycles at first, so that pressures do not swing: K k s is 0.1 at the most.
    for step in range(240):
        contact.contact.wear.set_cycles(1 if step < 40 else 2)
        u[bottom[0]] = 0.01 * (-1) ** step
        u = find_equilibrium(lambda u: (K @ u - push, K), contact, u, free).x
        last = contact.contact.nodal_contact(contact.coords(u)).pressure[: punch.nvertices][foot]
        first = last if first is None else first
        contact.commit_step(u)
    assert first.max() > 1.5 * first.min(), first
    # All of the foot goes back alike in the end: the pressure is even.
    assert np.ptp(last) < 0.1 * np.ptp(first) and last.mean() == pytest.approx(LOAD, rel=0.02), (first, last)
    depths = contact.contact.wear.depth[: punch.nvertices][foot]
    assert depths[[0, -1]].min() > depths[n // 2], depths


def test_the_volume_is_that_of_the_work_of_friction():
    pin = Pin(0.3, 10 * E, friction_coefficient=0.2)
    pin.contact.begin_step(pin.u)
    work, lost = 0.0, 0.0
    for step in range(40):
        found = pin.slide(1e-3 if step < 10 else 5e-3)
        work += found.result.friction.dissipation
        pin.commit()
        lost = pin.contact.contact.wear.volumes[0]
    assert lost == pytest.approx(WEAR / 0.2 * work, rel=1e-3)


def test_with_multipliers_the_pressure_is_whole():
    pin = Pin(0.0, 2 * E, 4)
    pin.contact.begin_step(pin.u)
    for _ in range(5):
        pin.slide(0.1, penetration=1e-5)
        pin.commit()
    # What is left of the penetration is 1e-5 of 1e-3.
    assert pin.depths() == pytest.approx(WEAR * LOAD * 0.5, rel=2e-3)


def test_a_step_that_wears_too_much_is_told():
    pin = Pin(0.0, 10 * E, 4)
    pin.contact.contact.wear.set_cycles(100)
    pin.contact.begin_step(pin.u)
    found = pin.slide(0.05)
    assert any("wears off up to 5.0" in str(warning) for warning in found.result.warnings), found.result.warnings
