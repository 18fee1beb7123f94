"""Second order: uniform pressure as the shape functions have it, two blocks that carry one stress, curved meshes."""

import numpy as np
import pytest
import skfem
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scenes import ELEMENTS, MESHES, by_axis, joined
from scipy.sparse import block_diag
from skfem import Basis, ElementVector, FacetBasis, LinearForm
from skfem.models.elasticity import lame_parameters, linear_elasticity

SECOND = [element for element in ELEMENTS if "2" in element]
LAWS = {"fiber": {"law": "fiber"}, "volume": {"law": "volume"}}


def stacked(element, depth=0.0, counts=(3, 2)):
    """Bases of two blocks of one width, the upper one ``depth`` into the lower; their faces do not match."""
    dim = 3 if element.endswith("3D") else 2
    bases = []
    for count, height in zip(counts, (0.0, 1.0 - depth)):
        ticks = [np.linspace(0.0, 1.0, count + 1)] * (dim - 1) + [np.linspace(height, height + 1.0, count + 1)]
        mesh = MESHES[element[0]][dim].init_tensor(*ticks)
        bases.append(Basis(mesh, ElementVector(ELEMENTS[element]())))
    return bases


def load(basis, height):
    """The load of unit pressure upwards on the face at a height, as scikit-fem integrates it."""
    facets = basis.mesh.facets_satisfying(lambda x: np.isclose(x[-1], height), boundaries_only=True)
    return LinearForm(lambda v, w: v[-1]).assemble(FacetBasis(basis.mesh, basis.elem, facets=facets, intorder=4))


@pytest.mark.parametrize("element", SECOND)
@pytest.mark.parametrize("law", LAWS)
def test_uniform_pressure_is_the_load_of_the_shape_functions(element, law):
    bases = stacked(element, depth=0.01)
    contact = SkfemContact(joined(bases), stiffness=1e4, estimator="exact", **LAWS[law])
    found = contact.force(np.zeros(contact.size))
    # The energy k V has the pressure k, a fiber k L.
    pressure = contact.evaluate(np.zeros(contact.size)).bodies[1].force[-1]
    assert pressure == pytest.approx(100.0 if law == "fiber" else 1e4, rel=1e-9)
    expected = np.concatenate([-pressure * load(bases[0], 1.0), pressure * load(bases[1], 0.99)])
    # Pressure of the law "volume" is on the strips of the walls too, across.
    up = np.concatenate([by_axis(basis)[-1] + offset for basis, offset in joined(bases)])
    assert np.abs(found - expected)[up].max() < 1e-9 * np.abs(expected).max()
    assert law == "volume" or np.abs(found - expected).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.parametrize(
    "element, fractions",
    [
        ("P2", [1 / 6, 1 / 6, 2 / 3]),
        ("Q2", [1 / 6, 1 / 6, 2 / 3]),
        ("Q S2", [1 / 6, 1 / 6, 2 / 3]),
        ("Q2 3D", [1 / 36] * 4 + [1 / 9] * 4 + [4 / 9]),
        ("Q S2 3D", [-1 / 12] * 4 + [1 / 3] * 4),
        # Two triangles: nothing on corners, a third of either on its edges, two on that which they share.
        ("P2 3D", [0] * 4 + [1 / 6] * 4 + [1 / 3]),
    ],
)
@pytest.mark.parametrize("law", LAWS)
def test_shares_of_one_face(element, fractions, law):
    basis = stacked(element, counts=(1, 1))[0]
    contact = SkfemContact(basis, stiffness=1e4, estimator="exact", **LAWS[law])
    up = np.eye(basis.mesh.dim())[-1]
    contact.contact.obstacles.add_half_space(0.01 * up, up)
    found = contact.force(np.zeros(basis.N))
    upwards = by_axis(basis)[-1]
    bottom = np.intersect1d(upwards, np.flatnonzero(basis.doflocs[-1] == 0.0))
    total = found[bottom].sum()
    assert np.sort(found[bottom] / total) == pytest.approx(np.sort(fractions), abs=1e-9)
    assert np.abs(found[np.setdiff1d(upwards, bottom)]).max() < 1e-9 * total


@pytest.mark.parametrize("element", SECOND)
def test_two_blocks_carry_one_stress(element):
    """Springs in series: two blocks of height 1 without Poisson's effect, and the layer that the law is."""
    young, stiffness, down = 1e3, 1e4, 0.02
    bases = stacked(element)
    contact = SkfemContact(joined(bases), stiffness=stiffness, law="fiber", estimator="exact")
    elastic = block_diag([linear_elasticity(*lame_parameters(young, 0.0)).assemble(one) for one in bases], format="csr")
    x = np.concatenate([basis.doflocs for basis in bases], axis=1)
    up = np.concatenate([by_axis(basis)[-1] + offset for basis, offset in joined(bases)])
    bottom, top = (np.intersect1d(np.flatnonzero(np.isclose(x[-1], height)), up) for height in (0.0, 2.0))
    # Bodies are held aside at the walls x = 0 (and y = 0), where nothing pushes them.
    aside = []
    for axis in range(x.shape[0] - 1):
        of_axis = np.concatenate([by_axis(basis)[axis] + offset for basis, offset in joined(bases)])
        aside.append(np.intersect1d(np.flatnonzero(x[axis] == 0.0), of_axis))
    prescribed = np.zeros(contact.size)
    prescribed[top] = -down
    free = np.setdiff1d(np.arange(contact.size), np.concatenate([bottom, top, *aside]))
    start = np.zeros(contact.size)
    step = find_equilibrium(lambda u: (elastic @ u, elastic), contact, start, free, prescribed, tolerance=1e-12)
    pressure = down / (2.0 / young + 1.0 / stiffness)
    assert -step.reactions[top].sum() == pytest.approx(pressure, rel=1e-9)
    lower = np.arange(contact.size) < bases[0].N
    exact = np.zeros(contact.size)
    exact[up] = np.where(lower[up], -pressure / young * x[-1, up], -down + pressure / young * (2.0 - x[-1, up]))
    assert np.abs(step.x - exact).max() < 1e-9 * down


@pytest.mark.parametrize("mesh, element", [(skfem.MeshTri2, skfem.ElementTriP2), (skfem.MeshQuad2, skfem.ElementQuad2)])
def test_a_curved_disc_has_the_area_of_its_parabolas(mesh, element):
    """In the plane the core encloses the area under the shape functions, wherever the middles are."""
    disc = curved_disc(mesh)
    basis = Basis(disc, ElementVector(element()), intorder=6)
    contact = SkfemContact(basis, stiffness=1.0, law="volume", estimator="exact")
    contact.contact.obstacles.add_half_space((0.0, 10.0), (0.0, 1.0))
    area = basis.dx.sum()
    assert abs(area - np.pi) < 2e-3 < abs(0.5 * 16 * np.sin(2 * np.pi / 16) - np.pi)
    assert contact.evaluate(np.zeros(basis.N)).volume == pytest.approx(area, rel=1e-12)


def curved_disc(mesh):
    """The unit disc with nodes and middles on the circle."""
    if mesh is skfem.MeshTri2:
        return skfem.MeshTri2.init_circle(2)
    square = skfem.MeshQuad.init_tensor(np.linspace(-1, 1, 5), np.linspace(-1, 1, 5))
    fine = mesh.from_mesh(square)
    x, y = fine.doflocs
    # The square mapped on the disc, edge on arc.
    return mesh(np.stack([x * np.sqrt(1 - y**2 / 2), y * np.sqrt(1 - x**2 / 2)]), fine.t)


def test_a_curved_ball_comes_near_its_volume():
    """Faces curved two ways: of fourth order in the size of the cells, where straight ones are of second."""
    errors = []
    for refinements in (1, 2):
        straight = skfem.MeshTet.init_ball(refinements)
        ball = skfem.MeshTet2.from_mesh(straight)
        # Middles of edges of the surface, and no other nodes, go to the sphere.
        surface = Basis(ball, skfem.ElementTetP2()).get_dofs(straight.boundary_facets()).flatten()
        places = ball.doflocs.copy()
        places[:, surface] /= np.linalg.norm(places[:, surface], axis=0)
        ball = skfem.MeshTet2(places, ball.t)
        basis = Basis(ball, ElementVector(skfem.ElementTetP2()))
        contact = SkfemContact(basis, stiffness=1.0, law="volume", estimator="exact")
        contact.contact.obstacles.add_half_space((0.0, 0.0, 10.0), (0.0, 0.0, 1.0))
        errors.append(abs(contact.evaluate(np.zeros(basis.N)).volume / (4 / 3 * np.pi) - 1.0))
    print(errors)
    assert errors[1] < errors[0] / 8
