"""Share of the adapter in an evaluation at about 50 000 surface nodes."""

import numpy as np
from fmc_agreement.overhead import plates, share
from fmc_contact_skfem import SkfemContact
from fmc_contact_skfem.field import mesh_from_cells
from skfem import Basis, ElementHex1, ElementVector

coords, cells, displacement = plates()
basis = Basis(mesh_from_cells(coords, cells, "hexahedron"), ElementVector(ElementHex1()), intorder=1)
u = np.zeros(basis.N)
u[basis.nodal_dofs.T] = displacement
surface = len(np.unique(basis.mesh.facets[:, basis.mesh.boundary_facets()]))
for estimator in ("fibers", "exact"):
    contact = SkfemContact(basis, stiffness=1e6, estimator=estimator)
    whole, inner = share(contact.contact, lambda: contact.force(u))
    print(
        f"skfem, {surface} surface nodes, {estimator}: evaluation {1e3 * inner:.1f} ms, with adapter "
        f"{1e3 * whole:.1f} ms, {100 * (whole - inner) / inner:.1f} % more"
    )
