"""Frequencies of a cantilever that an oblique tie divides, beside those of one body.

    python benchmarks/tables/tie_frequencies.py

Length 10 and height 1, plane strain, nu = 0.3, linear quadrilaterals. The tie runs from x = 4 at the lower face to x = 5 at the upper one, with n
edges across the beam at its left and 5 n / 4 at its right. It acts as a penalty of the suggested stiffness, or as equations that are
eliminated. The one body has n edges across both parts, in cells of the same shapes. The answer is the one of such a body with 32 biquadratic
quadrilaterals across. Printed are the largest errors of the frequencies 1 to 6, and the largest distances from the one body.
Needs scikit-fem and fmc_contact_skfem; seconds.
"""

import numpy as np
from fmc_contact import suggest_stiffness
from fmc_contact_skfem import SkfemContact
from scipy.sparse import block_diag, csr_matrix, identity, vstack
from scipy.sparse.linalg import eigsh
from skfem import Basis, BilinearForm, ElementQuad1, ElementQuad2, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity

LENGTH, YOUNG, POISSON = 10.0, 1.0, 0.3
EDGES = (8, 16, 32)


@BilinearForm
def inertia(u, v, w):
    return (u * v).sum(0)


def part(across, lines, element=ElementQuad1):
    """Between lines x = a + b y, with cells that are about square."""
    middles = [a + b / 2 for a, b in lines]
    counts = [round((high - low) * across) for low, high in zip(middles, middles[1:])]
    places = np.concatenate([k + np.arange(count) / count for k, count in enumerate(counts)] + [[float(len(counts))]])
    mesh = MeshQuad.init_tensor(places, np.linspace(0, 1, across + 1))
    at = [np.interp(mesh.p[0], range(len(lines)), [line[k] for line in lines]) for k in (0, 1)]
    return Basis(MeshQuad(np.array([at[0] + at[1] * mesh.p[1], mesh.p[1]]), mesh.t), ElementVector(element()), intorder=4)


class Beam:
    """Parts in a row, tied to one another."""

    def __init__(self, bases, stiffness=1.0):
        starts = np.cumsum([0] + [basis.N for basis in bases])
        elastic = linear_elasticity(*lame_parameters(YOUNG, POISSON))
        self.matrix = block_diag([elastic.assemble(basis) for basis in bases], format="csr")
        self.mass = block_diag([inertia.assemble(basis) for basis in bases], format="csr")
        self.contact = SkfemContact(list(zip(bases, starts)), stiffness=stiffness)
        if len(bases) == 2:
            self.contact.contact.pairs.set(0, 1, interface="tied")
        held = [first + basis.get_dofs(lambda x: np.isclose(x[0], 0.0)).all() for basis, first in zip(bases[:1], starts)]
        self.free = np.setdiff1d(np.arange(starts[-1]), np.concatenate(held))
        self.nodes = np.concatenate([first + basis.nodal_dofs.T.ravel() for basis, first in zip(bases, starts)])

    def by_penalty(self):
        matrix = self.matrix + self.contact.tangent(np.zeros(self.matrix.shape[0]))
        return self._frequencies(matrix[self.free][:, self.free], self.mass[self.free][:, self.free])

    def by_equations(self):
        """The unknowns of the nodes that hold are eliminated: each is in its own equations most, and the equations of one axis are apart."""
        rows = self.contact.contact.tie_constraints()
        equations = csr_matrix((rows.data, self.nodes[rows.indices], rows.indptr), (len(rows), self.matrix.shape[0]))[:, self.free].toarray()
        nodes = self.contact.contact.tie_nodes(self.contact.coords(np.zeros(self.matrix.shape[0]))).node
        column = np.full(self.matrix.shape[0], -1)
        column[self.free] = np.arange(len(self.free))
        out = column[self.nodes.reshape(-1, 2)[nodes]].ravel()
        kept = np.setdiff1d(np.arange(len(self.free)), out)
        by_kept = -np.linalg.solve(equations[:, out], equations[:, kept])
        order = np.argsort(np.concatenate([kept, out]))
        to_all = vstack([identity(len(kept)), csr_matrix(by_kept)], format="csr")[order]
        inside = lambda matrix: to_all.T @ matrix[self.free][:, self.free] @ to_all
        return self._frequencies(inside(self.matrix), inside(self.mass))

    def _frequencies(self, matrix, mass):
        return np.sqrt(eigsh(matrix.tocsc(), 6, mass.tocsc(), sigma=0.0, v0=np.ones(matrix.shape[0]))[0]) / (2 * np.pi)


LINES = (0.0, 0.0), (4.0, 1.0), (LENGTH, 0.0)


def one(across, element=ElementQuad1):
    return Beam([part(across, LINES, element)]).by_penalty()


def tied(across):
    return Beam([part(across, LINES[:2]), part(5 * across // 4, LINES[1:])], suggest_stiffness(YOUNG, 1 / across))


def worst(found, by):
    return float(np.abs(found / by - 1).max())


if __name__ == "__main__":
    answer = one(32, ElementQuad2)
    for across in EDGES:
        whole, beam = one(across), tied(across)
        errors = [worst(whole, answer)]
        for found in (beam.by_penalty(), beam.by_equations()):
            errors += [worst(found, answer), worst(found, whole)]
        print("{}: one {:.3%}; penalty {:.3%}, from one {:.3%}; equations {:.3%}, from one {:.3%}".format(across, *errors))
