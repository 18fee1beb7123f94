"""Two cubes of rubber in a box are pressed together by a quarter, in FElupe: the contact is an item of its Newton's method."""

import felupe as fem
import numpy as np
from fmc_contact import Contact
from scipy.optimize import brentq
from scipy.sparse import csr_matrix

# 1. Two unit cubes, one upon the other, with meshes that do not match, in one field.
mu, bulk = 1.0, 5.0
mesh = fem.mesh.concatenate([fem.Cube(n=4), fem.Cube(a=(0, 0, 1), b=(1, 1, 2), n=(6, 5, 4))])
field = fem.FieldContainer([fem.Field(fem.RegionHexahedron(mesh), dim=3)])
solid = fem.SolidBody(fem.NeoHooke(mu=mu, bulk=bulk), field)


# 2. The contact as FElupe wants an item: its part of the residual and of the matrix, and what a load step changes.
class ContactItem:
    def __init__(self, field):
        self.field, self.results = field, fem.mechanics.Results()
        self.assemble = fem.mechanics.Assemble(vector=self.vector, matrix=self.matrix)
        self.contact = Contact(mesh.points, mesh.cells, "hexahedron", stiffness=1.0)

    def update(self, stiffness):
        self.contact.set_options(stiffness=stiffness)

    def vector(self, field=None, **_):
        self.result = self.contact.evaluate(mesh.points + self.field[0].values)
        return csr_matrix(-self.result.forces.reshape(-1, 1))

    def matrix(self, field=None, **_):
        return self.contact.tangent(mesh.points + self.field[0].values)


item = ContactItem(field)
item.contact.mesh.set_symmetry_nodes(np.flatnonzero((mesh.points[:, :2] % 1 == 0).any(axis=1)))  # at the walls, the cubes go on

# 3. The box holds the cubes, smoothly. Its lid goes down by 0.5 in load steps that grow, and k from 10 E / h to a hundredfold.
walls = {f"{axis}{at}": (axis, at) for axis, at in (("x", 0), ("x", 1), ("y", 0), ("y", 1), ("z", 0), ("z", 2))}
walls = {
    name: fem.Boundary(field[0], **{f"f{axis}": at}, skip=[other != axis for other in "xyz"])
    for name, (axis, at) in walls.items()
}
ramp = {walls["z2"]: -0.5 * np.linspace(0.1, 1, 10) ** 2, item: np.geomspace(1e2, 1e4, 10)}
fem.Job([fem.Step([solid, item], ramp=ramp, boundaries=walls)]).evaluate(verbose=0)


# 4. The checks: the same stretch everywhere, whose stress is known, and a penetration of stress / k in undeformed lengths.
def pressure(stretch):
    return mu * 2 / 3 * (stretch ** (-5 / 3) - stretch ** (1 / 3)) + bulk * (1 - stretch)


stretch = brentq(lambda s: 2 * (1 - s) + s * pressure(s) / 1e4 - 0.5, 0.5, 1)
forces = solid.results.force.toarray().reshape(-1, 3)[:, 2]
pressed, carried = forces[mesh.points[:, 2] == 2].sum(), forces[mesh.points[:, 2] == 0].sum()
print(f"carried {carried:.5f}, closed form {pressure(stretch):.5f}, out of balance by {abs(pressed + carried):.0e}")
print(f"penetration {item.result.penetration:.4e}, closed form {pressure(stretch) / 1e4:.4e}")
assert abs(pressed + carried) < 1e-9 * carried
# Up to the penetration by the size of a cell, 7e-4.
assert abs(carried / pressure(stretch) - 1) < 1e-3
