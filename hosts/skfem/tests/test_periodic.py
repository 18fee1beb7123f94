"""Ties with a period and with a jump: homogenised laminates, cells in shear, and a bolt that is tightened."""

import numpy as np
import pytest
from fmc_contact import find_equilibrium
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag, csr_array
from skfem import Basis, BilinearForm, ElementQuad1, ElementTetP1, ElementTriP1, ElementVector, MeshQuad, MeshTet, MeshTri
from skfem.helpers import ddot, eye, sym_grad, trace
from skfem.models.elasticity import lame_parameters, linear_elasticity


def face(contact, size, body, axis, at, layer=(0.0, 1.0)):
    """The facets of a body in a plane, as a named surface; of a cell those of a layer across the last axis."""
    facets, coords = contact.contact.mesh.boundary_facets(), contact.coords(np.zeros(size))
    is_in = np.abs(coords[:, axis] - at) < 1e-9
    if axis < coords.shape[1] - 1:
        is_in &= (coords[:, -1] > layer[0] - 1e-9) & (coords[:, -1] < layer[1] + 1e-9)
    return contact.contact.mesh.add_surface((facets.body == body) & np.append(is_in, True)[facets.nodes].all(axis=1))


class Cell:
    """A periodic cell of size 1 that is tied to itself along every axis."""

    def __init__(self, basis, lame, shear, layers=((0.0, 1.0),)):
        self.basis, self.dim = basis, basis.mesh.dim()

        @BilinearForm
        def elastic(u, v, w):
            strain = sym_grad(u)
            stress = 2 * shear(w.x) * strain + lame(w.x) * eye(trace(strain), self.dim)
            return ddot(stress, sym_grad(v))

        self.matrix = elastic.assemble(basis)
        self.contact = SkfemContact([(basis, 0)])
        # Tractions along the layers differ from layer to layer, so each has ties of its own.
        self.ties = []
        for axis in range(self.dim):
            for layer in layers if axis < self.dim - 1 else layers[:1]:
                surfaces = tuple(face(self.contact, basis.N, 0, axis, at, layer) for at in (1.0, 0.0))
                self.ties.append((axis, self.contact.contact.ties.add(surfaces, period=np.eye(self.dim)[axis])))
        self.free = np.ones(basis.N, bool)
        self.free[basis.nodal_dofs[:, 0]] = False

    def stress(self, gradient):
        """Of the cell at a displacement gradient."""
        for axis, tie in self.ties:
            self.contact.contact.ties.set_jump(tie, gradient[:, axis])
        found = find_equilibrium(lambda u: (self.matrix @ u, self.matrix), self.contact, np.zeros(self.basis.N), self.free)
        coords = self.contact.coords(found.x)
        return sum(np.outer(self.contact.contact.ties.force(tie, coords), np.eye(self.dim)[axis]) for axis, tie in self.ties)

    def by_equations(self, gradient):
        """The same by multipliers of the ties' equations, C u = H C X; the stress is that of the nodal forces that hold the cell."""
        for _, tie in self.ties:
            self.contact.contact.ties.set_jump(tie, np.zeros(self.dim))
        found, x = self.contact.contact.tie_constraints(), self.basis.mesh.p.T
        assert np.array_equal(self.contact.coords(np.zeros(self.basis.N)), x)
        dofs = self.basis.nodal_dofs.T.ravel()
        rows = csr_array((found.data, found.indices, found.indptr), shape=(len(found), x.size)).toarray()
        right = ((rows @ x.ravel()).reshape(-1, self.dim) @ gradient.T).ravel()
        matrix = self.matrix.toarray()[np.ix_(dofs, dofs)]
        both = np.block([[matrix, rows.T], [rows, np.zeros((len(found), len(found)))]])
        # Ties that meet in a corner hold it more than once.
        u = np.linalg.lstsq(both, np.append(np.zeros(x.size), right), rcond=1e-11)[0][: x.size]
        return (matrix @ u).reshape(x.shape).T @ x


def bent(mesh, keep=()):
    """The mesh with nodes that slide in its faces, and in planes of the last axis that are kept, so that opposite faces do not match."""
    p = mesh.p.copy()
    others = mesh.p.sum(axis=0) - mesh.p
    for axis in range(len(p)):
        x = mesh.p[axis]
        along = x * (1 - x) * (np.prod([x - at for at in keep], axis=0) if axis == len(p) - 1 else 1)
        p[axis] = x + 0.25 * along * others[axis]
    return type(mesh)(p, mesh.t)


# Layers below and above y = 0.4.
FRACTIONS = np.array([0.4, 0.6])
LAYERS = np.array([lame_parameters(1.0, 0.3), lame_parameters(20.0, 0.2)])


def laminate():
    mesh = bent(MeshTri.init_tensor(np.linspace(0, 1, 6), np.array([0, 0.15, 0.4, 0.6, 0.85, 1])), keep=(0.4,))
    of = lambda which: lambda x: np.where(x[1] < 0.4, *LAYERS[:, which])
    return Cell(Basis(mesh, ElementVector(ElementTriP1())), of(0), of(1), ((0.0, 0.4), (0.4, 1.0)))


def test_a_laminate_has_its_moduli():
    # In a laminate strain along the layers and stress across them are the same everywhere.
    cell, (lame, shear) = laminate(), LAYERS.T
    mean = lambda values: float(FRACTIONS @ values)
    m = lame + 2 * shear
    c22 = 1 / mean(1 / m)
    c12 = mean(lame / m) * c22
    c11 = mean(m - lame**2 / m) + mean(lame / m) ** 2 * c22
    c66 = 1 / mean(1 / shear)
    for gradient, expected in [
        ([[1, 0], [0, 0]], [[c11, 0], [0, c12]]),
        ([[0, 0], [0, 1]], [[c12, 0], [0, c22]]),
        ([[0, 1], [0, 0]], [[0, c66], [c66, 0]]),
        ([[0, 0], [1, 0]], [[0, c66], [c66, 0]]),
        ([[0, -1], [1, 0]], [[0, 0], [0, 0]]),
    ]:
        found = cell.by_equations(np.array(gradient, float))
        assert np.abs(found - expected).max() < 1e-10 * c11, (gradient, found, expected)
        # The search leaves jumps that change tractions by a millionth.
        searched = cell.stress(1e-3 * np.array(gradient, float)) / 1e-3
        assert np.abs(searched - expected).max() < 5e-6 * c11, (gradient, searched, expected)


def test_a_block_shears():
    mesh = bent(MeshTet.init_tensor(*(np.linspace(0, 1, n) for n in (3, 4, 4))))
    lame, shear = lame_parameters(1.0, 0.3)
    cell = Cell(Basis(mesh, ElementVector(ElementTetP1())), lambda x: lame + 0 * x[0], lambda x: shear + 0 * x[0])
    gradient = np.zeros((3, 3))
    gradient[0, 2] = 1e-3
    expected = shear * (gradient + gradient.T)
    assert np.abs(cell.by_equations(gradient) - expected).max() < 1e-10 * 1e-3
    assert np.abs(cell.stress(gradient) - expected).max() < 5e-6 * 1e-3


# A bolt of width 1 beside a clamped part of width 2, both of length 4, under a head that is hard and does not turn. No contraction.
BOLT, PART, HEAD = 3.0, 1.0, 1e6
BOLT_SPRING, PART_SPRING = BOLT * 1 / 4, PART * 2 / 4


class Joint:
    """The bolt is cut at half its length, where pretension takes a length out of it."""

    def __init__(self):
        boxes = [((0, 0), (1, 2), BOLT), ((0, 2), (1, 4), BOLT), ((1, 0), (3, 4), PART), ((0, 4), (3, 5), HEAD)]
        edges = [(3, 4), (4, 5), (5, 8), (7, 2)]
        self.bases, matrices, first = [], [], 0
        for (low, high, young), counts in zip(boxes, edges):
            mesh = MeshQuad.init_tensor(*(np.linspace(low[k], high[k], counts[k] + 1) for k in range(2)))
            basis = Basis(mesh, ElementVector(ElementQuad1()))
            matrices.append(linear_elasticity(*lame_parameters(young, 0.0)).assemble(basis))
            self.bases.append((basis, first))
            first += basis.N
        self.matrix, self.load, self.free = block_diag(matrices, format="csr"), np.zeros(first), np.ones(first, bool)
        for basis, start in self.bases:
            self.free[start + basis.nodal_dofs[0]] = False
            self.free[start + basis.nodal_dofs[1][basis.mesh.p[1] == 0]] = False
        self.contact = SkfemContact(self.bases)
        contact = self.contact.contact
        contact.pairs.set(1, 3, interface="tied")
        for a, b in [(0, 1), (0, 2), (1, 2)]:
            contact.pairs.set(a, b, excluded=True)
        self.cut = contact.ties.add((face(self.contact, first, 1, 1, 2.0), face(self.contact, first, 0, 1, 2.0)))

    def forces(self, shorter, pull):
        """Tension of the bolt and pressure on the part."""
        self.contact.contact.ties.set_jump(self.cut, (0, -shorter))
        basis, first = self.bases[3]
        top = first + basis.nodal_dofs[1][basis.mesh.p[1] == 5]
        self.load[:] = 0
        self.load[top] = pull / len(top)
        found = find_equilibrium(
            lambda u: (self.matrix @ u - self.load, self.matrix), self.contact, np.zeros(len(self.load)), self.free, penetration=1e-7
        )
        coords = self.contact.coords(found.x)
        result = self.contact.contact.evaluate(coords)
        tension = -self.contact.contact.ties.force(self.cut, coords)[1]
        pressing = [pair.force[1] for pair in result.pairs if (pair.a, pair.b) == (("body", 2), ("body", 3))]
        return tension, sum(pressing)


def test_a_bolt_is_tightened_and_pulled():
    joint, shorter = Joint(), 1e-2
    clamped = shorter / (1 / BOLT_SPRING + 1 / PART_SPRING)
    assert joint.forces(shorter, 0.0) == pytest.approx((clamped, clamped), rel=1e-3)
    # The joint diagram: the bolt takes its share of the pull until the part is free, and then all.
    share = BOLT_SPRING / (BOLT_SPRING + PART_SPRING)
    pull = 0.5 * clamped
    assert joint.forces(shorter, pull) == pytest.approx((clamped + share * pull, clamped - (1 - share) * pull), rel=1e-3)
    pull = 4 * clamped
    assert joint.forces(shorter, pull) == pytest.approx((pull, 0.0), rel=1e-3, abs=1e-9)
    # Linear until then: a wanted force follows from one solve.
    first, _ = joint.forces(shorter, 0.0)
    assert joint.forces(shorter * 0.02 / first, 0.0)[0] == pytest.approx(0.02, rel=1e-3)
