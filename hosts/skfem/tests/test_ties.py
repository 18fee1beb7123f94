"""Tied bodies in equilibrium: uniform stress, curved interfaces, bending, and bodies that only a tie holds."""

from types import SimpleNamespace

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag
from scipy.sparse.linalg import spsolve
from skfem import (
    Basis,
    BilinearForm,
    ElementHex1,
    ElementHex2,
    ElementHexS2,
    ElementQuad1,
    ElementQuad2,
    ElementQuadS2,
    ElementTetP1,
    ElementTetP2,
    ElementTriP1,
    ElementTriP2,
    ElementVector,
    FacetBasis,
    LinearForm,
    MeshHex,
    MeshQuad,
    MeshQuad2,
    MeshTet,
    MeshTri,
)
from skfem.helpers import ddot, grad, mul, trace, transpose
from skfem.models.elasticity import lame_parameters, linear_elasticity

LAME, SHEAR = lame_parameters(1.0, 0.3)
IN_PLANE = {"T3": ElementTriP1, "T6": ElementTriP2, "Q4": ElementQuad1, "Q8": ElementQuadS2, "Q9": ElementQuad2}
IN_SPACE = {"T4": ElementTetP1, "T10": ElementTetP2, "H8": ElementHex1, "H20": ElementHexS2, "H27": ElementHex2}


def block(kind, edges, low):
    """A block of height 1/2 above ``low``, with so many edges along each side of its lower face."""
    across, up = np.linspace(0, 1, edges + 1), np.linspace(low, low + 0.5, 3)
    if kind in IN_PLANE:
        mesh = (MeshTri if kind[0] == "T" else MeshQuad).init_tensor(across, up)
        return Basis(mesh, ElementVector(IN_PLANE[kind]()), intorder=5)
    mesh = (MeshTet if kind[0] == "T" else MeshHex).init_tensor(across, across, up[::2])
    return Basis(mesh, ElementVector(IN_SPACE[kind]()), intorder=5)


class Tied:
    """Two bodies, tied, and the matrix of both."""

    def __init__(self, bases, stiffness=0.0, **tie):
        self.bases = list(zip(bases, (0, bases[0].N)))
        self.matrix = block_diag([linear_elasticity(LAME, SHEAR).assemble(basis) for basis in bases], format="csr")
        self.contact = SkfemContact(self.bases, stiffness=stiffness)
        self.contact.contact.pairs.set(0, 1, interface="tied", **tie)
        self.load, self.free = np.zeros(self.matrix.shape[0]), np.ones(self.matrix.shape[0], bool)

    def hold(self, where):
        for basis, first in self.bases:
            self.free[first : first + basis.N][where(basis.doflocs)] = False

    def by_penalty(self, prescribed=0.0):
        u = np.where(self.free, 0.0, prescribed)
        tangent = (self.matrix + self.contact.tangent(u)).tocsr()
        right = self.load - self.matrix @ u + self.contact.force(u)
        u[self.free] += spsolve(tangent[self.free][:, self.free].tocsc(), right[self.free])
        return u

    def found(self, prescribed=None):
        return find_equilibrium(lambda u: (self.matrix @ u - self.load, self.matrix), self.contact, np.zeros(len(self.load)), self.free, prescribed)


def uniform(tied, stress):
    """Loads of a uniform stress on all faces but those of the tie; the displacement that has it on the lowest face."""
    dim = len(stress)
    strain = (stress - LAME / (2 * SHEAR + dim * LAME) * np.trace(stress) * np.eye(dim)) / (2 * SHEAR)
    prescribed = np.zeros(len(tied.load))
    for basis, first in tied.bases:
        facets = basis.mesh.boundary_facets()
        middles = basis.mesh.p[:, basis.mesh.facets[:, facets]].mean(1)
        outer = FacetBasis(basis.mesh, basis.elem, facets=facets[~np.isclose(middles[-1], 0.5)], intorder=6)
        tied.load[first : first + basis.N] = LinearForm(lambda v, w: np.einsum("ij,j...,i...->...", stress, w.n, v)).assemble(outer)
        prescribed[first : first + basis.N] = basis.project(lambda x: np.einsum("ij,j...->i...", strain, x))
    tied.hold(lambda x: x[-1] < 1e-9)
    return prescribed


def stress_error(tied, u, stress):
    error = 0.0
    for basis, first in tied.bases:
        gradient = basis.interpolate(u[first : first + basis.N]).grad
        strain = (gradient + np.swapaxes(gradient, 0, 1)) / 2
        own = 2 * SHEAR * strain + LAME * np.einsum("ii...->...", strain) * np.eye(len(stress))[:, :, None, None]
        error = max(error, np.abs(own - stress[:, :, None, None]).max())
    return error / np.abs(stress).max()


STRESSES = {2: 1e-2 * np.array([[0.3, 0.25], [0.25, -1]]), 3: 1e-2 * np.array([[0.3, 0.25, 0.1], [0.25, -1, 0.2], [0.1, 0.2, 0.6]])}


@pytest.mark.parametrize("kinds, edges", [(IN_PLANE, (3, 7)), (IN_PLANE, (14, 1)), (IN_SPACE, (2, 3))])
def test_a_uniform_stress_passes(kinds, edges):
    # Rounding in matrices of this size is 1e-12.
    for below in kinds:
        for above in kinds:
            tied = Tied([block(below, edges[0], 0.0), block(above, edges[1], 0.5)], stiffness=50.0)
            stress = STRESSES[tied.contact.contact.dim]
            u = tied.by_penalty(uniform(tied, stress))
            assert stress_error(tied, u, stress) < 1e-11, (below, above)


def test_the_search_needs_no_stiffness():
    # The upper block is held by the tie alone.
    tied = Tied([block("Q9", 3, 0.0), block("Q4", 7, 0.5)])
    prescribed = uniform(tied, STRESSES[2])
    found = tied.found(prescribed)
    assert stress_error(tied, found.x, STRESSES[2]) < 1e-9
    tractions = tied.contact.contact.tie_nodes(tied.contact.coords(found.x))
    # On the lower body, whose facets are the larger ones.
    assert set(tractions.body) == {0} and np.allclose(tractions.traction, STRESSES[2][:, 1], atol=1e-6)


@pytest.mark.parametrize("ratio", [1e-6, 1e-4, 1.0])
def test_a_coating_is_strained_by_its_substrate_at_any_load(ratio):
    # All is linear: its traction by the strain of the bar is one number, and no residual of it is taken for rounding of the other one.
    tractions = []
    for strain in (1e-2, 1e-4, 1e-6):
        tied = Tied([rectangle("Q4", (0, 0), (4, 1), (8, 2)), rectangle("Q4", (0, 1), (4, 1.5), (11, 2))])
        bar, coating = (slice(first, first + basis.N) for basis, first in tied.bases)
        tied.matrix = block_diag([tied.matrix[bar, bar], ratio * tied.matrix[coating, coating]], format="csr")
        for dofs in (tied.bases[0][0].get_dofs(lambda x: x[0] < 1e-9).all("u^1"), tied.bases[0][0].get_dofs(lambda x: x[1] < 1e-9).all("u^2")):
            tied.free[dofs] = False
        basis = tied.bases[0][0]
        end = FacetBasis(basis.mesh, basis.elem, facets=basis.mesh.facets_satisfying(lambda x: x[0] > 4 - 1e-9), intorder=5)
        tied.load[bar] = LinearForm(lambda v, w: strain * v[0]).assemble(end)
        found = tied.found()
        inside = tied.matrix @ found.x
        left = (inside - tied.load - tied.contact.force(found.x))[coating]
        assert np.abs(left).max() < 1e-5 * np.abs(inside[coating]).max()
        tractions.append(np.abs(tied.contact.contact.tie_nodes(tied.contact.coords(found.x)).traction).max() / (ratio * strain))
    # Multipliers are updated until they change by 1e-3; coordinates of 4 are rounded to 1e-10 of the smallest displacement.
    assert tractions == pytest.approx(np.full(3, tractions[0]), rel=1e-3)


def rectangle(kind, low, high, edges):
    mesh = MeshQuad.init_tensor(*(np.linspace(low[axis], high[axis], edges[axis] + 1) for axis in range(2)))
    if kind == "T6":
        mesh = mesh.to_meshtri()
    return Basis(mesh, ElementVector(IN_PLANE[kind]()), intorder=4)


QUADRANTS = (
    [("Q4", (0, 0), (1, 1), (2, 3)), ("Q9", (1, 0), (2, 1), (3, 2)), ("T6", (0, 1), (1, 2), (3, 4)), ("Q8", (1, 1), (2, 2), (2, 5))],
    [(0, 1), (0, 2), (1, 3), (2, 3)],
)
T_JOINT = ([("Q4", (0, 0), (2, 1), (3, 2)), ("Q8", (0, 1), (0.9, 2), (3, 3)), ("T6", (0.9, 1), (2, 2), (4, 2))], [(0, 1), (0, 2), (1, 2)])


@pytest.mark.parametrize("parts, ties", [QUADRANTS, T_JOINT])
@pytest.mark.parametrize("size, stress_size", [(1.0, 1e-2), (1e-3, 1e-5)])
def test_several_bodies_that_are_tied_are_one(parts, ties, size, stress_size):
    bases = [rectangle(kind, np.multiply(size, low), np.multiply(size, high), edges) for kind, low, high, edges in parts]
    starts = np.cumsum([0] + [basis.N for basis in bases])
    matrix = block_diag([linear_elasticity(LAME, SHEAR).assemble(basis) for basis in bases], format="csr")
    contact = SkfemContact(list(zip(bases, starts)))
    for pair in ties:
        contact.contact.pairs.set(*pair, interface="tied")
    stress = stress_size * np.array([[1.0, 0.4], [0.4, -0.7]])
    load, free, places = np.zeros(starts[-1]), np.ones(starts[-1], bool), np.hstack([basis.doflocs for basis in bases])
    for basis, first in zip(bases, starts):
        facets = basis.mesh.facets_satisfying(lambda x: np.isclose(np.abs(x / size - 1).max(0), 1), boundaries_only=True)
        outer = FacetBasis(basis.mesh, basis.elem, facets=facets, intorder=4)
        load[first : first + basis.N] = LinearForm(lambda v, w: np.einsum("ij,j...,i...->...", stress, w.n, v)).assemble(outer)
    corner = np.isclose(places, 0.0).all(0)
    other = np.flatnonzero(np.isclose(places, np.array([[2.0 * size], [0.0]])).all(0))
    free[corner] = free[other[1]] = False
    found = find_equilibrium(lambda u: (matrix @ u - load, matrix), contact, np.zeros(starts[-1]), free)
    error = stress_error(SimpleNamespace(bases=list(zip(bases, starts))), found.x, stress)
    # The next update would change tractions by 1e-3 of the largest; a gap of that is a strain of 1/160 of it.
    assert error < 2e-5 and not found.warnings and found.iterations <= 6, (error, found.iterations)


def test_a_tie_of_a_given_stiffness_gives_way():
    # Its jump is below a thousandth of the displacements, and by far more than a ten-thousandth of its tractions: it stays.
    tied = Tied([block("Q4", 3, 0.0), block("Q4", 4, 0.5)])
    tied.contact.contact.pairs.set(0, 1, interface="tied", stiffness=2e4)
    tied.hold(lambda x: x[1] < 1e-9)
    upper, first = tied.bases[1]
    top = FacetBasis(upper.mesh, upper.elem, facets=upper.mesh.facets_satisfying(lambda x: x[1] > 1 - 1e-9), intorder=4)
    tied.load[first:] = LinearForm(lambda v, w: 1e-3 * v[1]).assemble(top)
    found = tied.found()
    nodes = tied.contact.contact.tie_nodes(tied.contact.coords(found.x))
    assert found.updates == 0 and np.allclose(np.abs(nodes.jump), np.abs(nodes.traction) / 2e4, rtol=1e-6, atol=1e-12)


def test_a_gap_bends_by_its_shear():
    # Uniform stress along the tie does not see a gap; the error of a shear stress is the moment of the gap.
    errors = {}
    for gap in (0.0, 0.01, 0.02):
        upper = block("Q9", 3, 0.5)
        upper = Basis(upper.mesh.translated((0, gap)), upper.elem, intorder=5)
        tied = Tied([block("Q9", 3, 0.0), upper], stiffness=50.0, reach=0.05)
        assert tied.contact.contact.pairs.tie(0, 1).largest_gap == pytest.approx(gap, abs=1e-14)
        for shear in (0.0, 1e-4):
            stress = np.array([[0.0, shear], [shear, -1e-4]])
            tied.free[:], tied.load[:] = True, 0.0
            prescribed = uniform(tied, stress)
            # The upper block's lower face is at 0.5 + gap.
            upper, first = tied.bases[1]
            facets = upper.mesh.facets_satisfying(lambda x: x[1] > 0.5 + gap + 1e-9, boundaries_only=True)
            outer = FacetBasis(upper.mesh, upper.elem, facets=facets, intorder=6)
            load = LinearForm(lambda v, w: np.einsum("ij,j...,i...->...", stress, w.n, v)).assemble(outer)
            tied.load[first:] = load
            errors[gap, shear] = stress_error(tied, tied.by_penalty(prescribed), stress)
    assert max(errors[gap, 0.0] for gap in (0.0, 0.01, 0.02)) < 1e-8
    assert errors[0.0, 1e-4] < 1e-8
    assert 0.5 < errors[0.02, 1e-4] / (2 * errors[0.01, 1e-4]) < 1.5 and errors[0.01, 1e-4] < 0.1


def curved(edges, side, is_second_order):
    """A block below or above y = 0.15 cos 2x."""
    mesh = MeshQuad.init_tensor(np.linspace(0, np.pi, 2 * edges + 1), np.linspace(0, 1, edges + 1))

    def place(p):
        wave = 0.15 * np.cos(2 * p[0])
        low, high = (-1.0, wave) if side == 0 else (wave, 1.0)
        return np.array([p[0], low + p[1] * (high - low)])

    if is_second_order:
        mesh = MeshQuad2.from_mesh(mesh)
        return Basis(MeshQuad2(place(mesh.doflocs), mesh.t), ElementVector(ElementQuad2()), intorder=6)
    return Basis(MeshQuad(place(mesh.p), mesh.t), ElementVector(ElementQuad1()), intorder=6)


def exact(x):
    return 1e-3 * np.array([np.sin(x[0] + 0.4) * np.cos(x[1]), np.cos(0.7 * x[0]) * np.sin(x[1] + 0.3)])


def body_force(x):
    """-div sigma of the exact displacement."""
    s, c = np.sin, np.cos
    ux = -s(x[0] + 0.4) * c(x[1])  # u_xx and u_yy alike.
    vx, vy = -0.49 * c(0.7 * x[0]) * s(x[1] + 0.3), -c(0.7 * x[0]) * s(x[1] + 0.3)
    uxy, vxy = -c(x[0] + 0.4) * s(x[1]), -0.7 * s(0.7 * x[0]) * c(x[1] + 0.3)
    first = (LAME + 2 * SHEAR) * ux + SHEAR * ux + (LAME + SHEAR) * vxy
    second = (LAME + 2 * SHEAR) * vy + SHEAR * vx + (LAME + SHEAR) * uxy
    return -1e-3 * np.array([first, second])


@pytest.mark.parametrize("is_second_order, order", [(False, 2), (True, 3)])
def test_a_curved_interface_converges(is_second_order, order):
    errors = []
    for edges in (2, 4, 8):
        tied = Tied([curved(2 * edges, 0, is_second_order), curved(3 * edges, 1, is_second_order)], stiffness=1e6)
        prescribed = np.zeros(len(tied.load))
        for basis, first in tied.bases:
            own = slice(first, first + basis.N)
            tied.load[own] = LinearForm(lambda v, w: (body_force(w.x) * v).sum(0)).assemble(basis)
            values = exact(basis.doflocs)
            for axis in range(2):
                prescribed[own][basis.nodal_dofs[axis]] = values[axis][basis.nodal_dofs[axis]]
            component = np.zeros(basis.N, int)
            for dofs in (basis.nodal_dofs, basis.facet_dofs, basis.interior_dofs):
                for row, of_row in enumerate(dofs):
                    component[of_row] = row % 2
            prescribed[own] = np.where(component == 0, values[0], values[1])
        tied.hold(lambda x: (x[0] < 1e-9) | (x[0] > np.pi - 1e-9) | (np.abs(np.abs(x[1]) - 1) < 1e-9))
        # So stiff that the penalty is not seen.
        u, squared = tied.by_penalty(prescribed), 0.0
        for basis, first in tied.bases:
            off = np.asarray(basis.interpolate(u[first : first + basis.N])) - exact(np.asarray(basis.global_coordinates()))
            squared += ((off**2).sum(0) * basis.dx).sum()
        errors.append(np.sqrt(squared))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders[-1] > order - 0.3, (errors, orders)


def beam(below, above, edges, stiffness):
    bases = []
    for kind, count, low in zip((below, above), edges, (0.0, 0.5)):
        mesh = MeshQuad.init_tensor(np.linspace(0, 10, count + 1), np.linspace(low, low + 0.5, 3))
        bases.append(Basis(mesh, ElementVector(IN_PLANE[kind]())))
    tied = Tied(bases, stiffness=stiffness)
    tied.hold(lambda x: x[0] < 1e-9)
    for basis, first in tied.bases:
        end = FacetBasis(basis.mesh, basis.elem, facets=basis.mesh.facets_satisfying(lambda x: x[0] > 10 - 1e-9))
        tied.load[first : first + basis.N] = LinearForm(lambda v, w: 1e-6 * v[1]).assemble(end)
    u = tied.found().x if stiffness == 0 else tied.by_penalty()
    return u[np.flatnonzero((bases[0].doflocs[0] > 10 - 1e-9) & (bases[0].doflocs[1] < 1e-9))[1]]


@pytest.mark.parametrize("kinds, edges", [(("Q9", "Q4"), (5, 35)), (("Q4", "Q9"), (35, 5)), (("Q9", "Q9"), (4, 28))])
def test_no_stiffness_locks(kinds, edges):
    # By 1 % between a penalty as soft as the bodies and one of 1e7; a tie at points loses 10 to 25 %.
    tips = [beam(*kinds, edges, stiffness) for stiffness in (1.0, 1e3, 1e7)]
    assert max(tips) < 1.01 * min(tips)
    assert 0.99 * min(tips) < beam(*kinds, edges, 0.0) < 1.01 * max(tips)


def test_equations_are_those_that_a_host_eliminates():
    # Nodes of one side by those of the other: the solution by null space is that of a stiff penalty.
    tied = Tied([block("Q4", 3, 0.0), block("Q4", 5, 0.5)], stiffness=1e7)
    tied.hold(lambda x: x[1] < 1e-9)
    upper, first = tied.bases[1]
    tied.load[first:] = LinearForm(lambda v, w: 1e-3 * v[0]).assemble(upper)
    rows = tied.contact.contact.tie_constraints()
    nodes = np.concatenate([first + basis.nodal_dofs.T.ravel() for basis, first in tied.bases])
    equations = np.zeros((len(rows), len(tied.load)))
    for row in range(len(rows)):
        own = slice(rows.indptr[row], rows.indptr[row + 1])
        equations[row, nodes[rows.indices[own]]] = rows.data[own]
    free = tied.free
    left = np.linalg.svd(equations[:, free])[2][np.linalg.matrix_rank(equations[:, free]) :].T
    matrix = left.T @ tied.matrix[free][:, free].toarray() @ left
    u = np.zeros(len(free))
    u[free] = left @ np.linalg.solve(matrix, left.T @ tied.load[free])
    assert np.abs(u - tied.by_penalty()).max() < 1e-5 * np.abs(u).max()


def kinematics(u):
    """Deformation gradient and Green's strain."""
    identity = np.zeros_like(u)
    for axis in range(len(u)):
        identity[axis, axis] = 1.0
    gradient = identity + u
    return gradient, 0.5 * (mul(transpose(gradient), gradient) - identity), identity


def finite(bases):
    """A host of bodies with the material of St. Venant and Kirchhoff: residual and matrix."""
    starts = np.cumsum([0] + [basis.N for basis in bases])

    def stress(strain, identity):
        return 2.0 * SHEAR * strain + LAME * trace(strain) * identity

    def residual(u):
        forces, matrices = [], []
        for basis, first in zip(bases, starts):

            @LinearForm
            def inside(v, w):
                f, strain, identity = kinematics(w["now"].grad)
                return ddot(mul(f, stress(strain, identity)), grad(v))

            @BilinearForm
            def slope(du, v, w):
                f, strain, identity = kinematics(w["now"].grad)
                by = 0.5 * (mul(transpose(grad(du)), f) + mul(transpose(f), grad(du)))
                return ddot(mul(grad(du), stress(strain, identity)) + mul(f, stress(by, identity)), grad(v))

            now = basis.interpolate(u[first : first + basis.N])
            forces.append(inside.assemble(basis, now=now))
            matrices.append(slope.assemble(basis, now=now))
        return np.concatenate(forces), block_diag(matrices, "csr")

    return residual


@pytest.mark.parametrize(("kind", "steps"), [("Q4", 1), ("Q4", 4), ("Q9", 3), ("H8", 3)])
def test_a_tied_body_turned_in_few_steps_is_left_without_stress(kind, steps):
    """One body is turned by 120 degrees, the other follows. Multipliers found on the way there would leave a false stress of 1e-3 E."""
    bases = [block(kind, edges, low) for edges, low in ((2, 0.0), (3, 0.5))]
    starts = np.cumsum([0] + [basis.N for basis in bases])
    places = np.concatenate([basis.doflocs.T for basis in bases])
    axis = np.concatenate([np.zeros(basis.N, int) for basis in bases])
    for basis, first in zip(bases, starts):
        for k in range(basis.mesh.dim()):
            axis[first + basis.get_dofs(elements=True).all(f"u^{k + 1}")] = k
    contact = SkfemContact(list(zip(bases, starts)))
    contact.contact.pairs.set(0, 1, interface="tied")
    free = np.ones(starts[-1], bool)
    free[bases[0].get_dofs(lambda x: np.isclose(x[-1], 0.0)).all()] = False
    u = np.zeros(starts[-1])
    for step in range(1, steps + 1):
        angle = np.radians(120.0) * step / steps
        c, s, last = np.cos(angle), np.sin(angle), places.shape[1] - 1
        turned = places.copy()
        turned[:, 0], turned[:, last] = c * places[:, 0] - s * places[:, last], s * places[:, 0] + c * places[:, last]
        rigid = np.take_along_axis(turned - places, axis[:, None], 1)[:, 0]
        found = find_equilibrium(finite(bases), contact, u, free, rigid)
        u = found.x
        assert not found.warnings
        # Residuals of 1e-8 of the forces on the way, of which nothing is left at the end but rounding.
        assert np.abs(u - rigid).max() < 1e-9
        assert found.penetration < 1e-12
    assert np.abs(contact.contact.tie_nodes(contact.coords(u)).traction).max() < 1e-9


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("is_tied", [True, False])
@pytest.mark.parametrize("loads", [(1.0, 0.0), (1.0, 0.1, 0.01, 0.0), (1.0, 0.5, 1.0, 0.0)])
def test_a_stack_is_unloaded_to_nothing(friction, is_tied, loads):
    """Two blocks, tied or one, on a third: pressed, and the load taken away. Multipliers fall with the load: without load nothing is left."""
    element = ElementVector(ElementQuad1())
    heights = [(0.0, 0.5, 4), (0.5, 1.0, 3)] if is_tied else [(0.0, 1.0, 7)]
    meshes = [MeshQuad.init_tensor(np.linspace(-1, 2, 13), np.linspace(-1, 0, 5))]
    meshes += [MeshQuad.init_tensor(np.linspace(0, 1, 8 - k), np.linspace(low, top, n + 1)) for k, (low, top, n) in enumerate(heights)]
    bases = [Basis(mesh, element) for mesh in meshes]
    starts = np.cumsum([0] + [basis.N for basis in bases])
    matrix = block_diag([linear_elasticity(LAME, SHEAR).assemble(basis) for basis in bases], format="csr")
    contact = SkfemContact(list(zip(bases, starts)), friction_coefficient=friction)
    if is_tied:
        contact.contact.pairs.set(1, 2, interface="tied")
    top = FacetBasis(meshes[-1], element, facets=meshes[-1].facets_satisfying(lambda x: np.isclose(x[1], 1.0)))
    load = np.zeros(starts[-1])
    load[starts[-2] :] = LinearForm(lambda v, w: -0.01 * v[1]).assemble(top)
    free = np.ones(starts[-1], bool)
    free[bases[0].get_dofs(lambda x: np.isclose(x[1], -1.0)).all()] = False
    u = np.zeros(starts[-1])
    for number, part in enumerate(loads):
        found = find_equilibrium(lambda u: (matrix @ u - part * load, matrix), contact, u, free)
        u = found.x
        if friction:
            contact.commit_step(u)
        assert abs(found.reactions[~free].sum() - part * 0.01) < 1e-9
        # What friction leaves behind needs a way of its own: facets that stuck slide back.
        if number > 0 and not friction:
            assert found.iterations <= 6
    assert abs(u @ (matrix @ u)) < 1e-12 * 0.01
