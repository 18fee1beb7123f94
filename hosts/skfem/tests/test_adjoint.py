"""The adjoint of an equilibrium with cells of second order, whose multipliers belong to points that are no nodes, and in 3D."""

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from skfem import Basis, ElementHex1, ElementTriP2, ElementVector, MeshHex, MeshTri
from skfem.models.elasticity import lame_parameters, linear_elasticity


class Pressed:
    """A body whose face of least height is pressed on a plane that is a little oblique, and along it where there is friction."""

    def __init__(self, mesh, element, law, penetration, friction=0.0):
        self.basis = Basis(mesh, ElementVector(element))
        self.dim = mesh.dim()
        self.matrix = linear_elasticity(*lame_parameters(100.0, 0.3)).assemble(self.basis)
        self.held = self.basis.get_dofs(lambda x: np.isclose(x[-1], 1.0))
        self.free = np.setdiff1d(np.arange(self.basis.N), self.held.all())
        self.law, self.penetration, self.friction = law, penetration, friction
        self.factors = np.random.default_rng(5).standard_normal(self.basis.N)

    def solved(self, push=0.0, young=0.0, height=0.0, straight=True):
        contact = SkfemContact(self.basis, stiffness=self.law, friction_coefficient=self.friction)
        self.inner = contact.contact
        up = np.eye(self.dim)[-1]
        normal = up + 0.03 * np.eye(self.dim)[0]
        self.inner.obstacles.add_half_space(0 * up, normal)
        if self.friction:
            contact.begin_step(np.zeros(self.basis.N))
        self.inner.obstacles.set_pose(0, self.posed(height))
        end = np.zeros(self.basis.N)
        end[self.held.all(f"u^{self.dim}")] = -0.03 - push
        if self.friction:
            end[self.held.all("u^1")] = 0.004
        options = {"penetration": self.penetration, "tolerance": 1e-13, "max_updates": 200, "max_iterations": 2000, "straight_slip": straight}
        return find_equilibrium(lambda u: ((1 + young) * (self.matrix @ u), (1 + young) * self.matrix), contact, 0 * end, self.free, end, **options)

    def posed(self, height):
        pose = self.inner.obstacles.get(0).pose
        pose.position[-1] += height
        return pose

    def compare(self, within, step):
        found = self.solved()
        count = len(self.inner.multipliers.values)
        got = found.adjoint(self.factors, by=["positions"])
        of = {
            "push": -got.prescribed[self.held.all(f"u^{self.dim}")].sum(),
            "young": -got.balance @ (self.matrix @ found.x),
            "height": got.gradients.positions[0, -1],
        }
        for name, value in of.items():
            ends = [self.factors @ self.solved(**{name: by}).x for by in (step, -step)]
            differences = (ends[0] - ends[1]) / (2 * step)
            assert abs(value - differences) < within * max(abs(of["push"]), abs(value)), name
        return count


def second_order():
    mesh = MeshTri.init_tensor(np.linspace(0, 1, 5), np.linspace(0, 1, 4))
    mesh.p[1] += 0.03 * (mesh.p[0] - 0.55) ** 2 * (1 - mesh.p[1])
    return mesh, ElementTriP2()


def in_space():
    mesh = MeshHex.init_tensor(np.linspace(0, 1, 4), np.linspace(0, 1, 4), np.linspace(0, 1, 3))
    mesh.p[2] += 0.004 * ((mesh.p[0] - 0.45) ** 2 + (mesh.p[1] - 0.55) ** 2) * (1 - mesh.p[2])
    return mesh, ElementHex1()


@pytest.mark.parametrize("scene", [second_order, in_space])
@pytest.mark.parametrize("friction", [0.0, 0.3], ids=["smooth", "friction"])
def test_the_law_alone(scene, friction):
    assert Pressed(*scene(), 3000.0, None, friction).compare(1e-7, 1e-6) == 0


def test_a_gap_that_is_closed_with_friction_is_told():
    pressed = Pressed(*in_space(), 3000.0, None, 0.3)
    found = pressed.solved(straight=False)
    assert found.first_touches == 1
    assert any("closed a gap" in text for text in found.adjoint(pressed.factors).warnings)


@pytest.mark.parametrize("scene", [second_order, in_space])
def test_multipliers(scene):
    # Gaps are closed to 1e-12, which differences divide by their step.
    assert Pressed(*scene(), 3000.0, 1e-12).compare(1e-6, 1e-6) >= 4
