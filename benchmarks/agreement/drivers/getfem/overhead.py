"""Share of the adapter in an evaluation at about 50 000 surface nodes."""

import getfem as gf
import numpy as np
from fmc_agreement.overhead import plates, share
from fmc_contact_getfem import GetfemContact
from fmc_contact_getfem.cells import element, mesh_from_cells

gf.util("trace level", 0)
coords, cells, displacement = plates()
mesh = mesh_from_cells(coords, cells, "hexahedron")
space = gf.MeshFem(mesh, 3)
space.set_fem(element("hexahedron"))
surface = len(np.unique(mesh.pid_in_faces(mesh.outer_faces())))
model = gf.Model("real")
model.add_fem_variable("u", space)
for estimator in ("fibers", "exact"):
    contact = GetfemContact(model, "u", stiffness=1e6, estimator=estimator)
    u = np.zeros(contact.size)
    u[contact.dofs] = displacement
    whole, inner = share(contact.contact, lambda: contact.force(u))
    print(
        f"getfem, {surface} surface nodes, {estimator}: evaluation {1e3 * inner:.1f} ms, with adapter "
        f"{1e3 * whole:.1f} ms, {100 * (whole - inner) / inner:.1f} % more"
    )
