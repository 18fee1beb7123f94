"""Share of the adapter in an evaluation at about 50 000 surface nodes."""

import numpy as np
from dolfinx import fem
from fmc_agreement.overhead import plates, share
from fmc_contact_dolfinx import DolfinxContact, set_by_input_number
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI

comm = MPI.COMM_WORLD
coords, cells, displacement = plates()
space = vector_space(mesh_from_cells(comm, coords, cells, "hexahedron"))
u = fem.Function(space)
set_by_input_number(u, displacement)
surface = 0
for estimator in ("fibers", "exact"):
    contact = DolfinxContact(space, stiffness=1e6, estimator=estimator)
    if estimator == "fibers":
        surface = contact._shows.points.count
    residual = np.zeros(contact._fields[0].owned * 3)

    def adapted():
        contact.add_forces(residual, contact.evaluate(u))

    whole, inner = share(contact.contact, adapted)
    whole, inner = comm.allreduce(whole, MPI.MAX), comm.allreduce(inner, MPI.MAX)
    if comm.rank == 0:
        print(
            f"dolfinx, {comm.size} ranks, {surface} surface nodes, {estimator}: evaluation {1e3 * inner:.1f} ms, "
            f"with adapter {1e3 * whole:.1f} ms, {100 * (whole - inner) / inner:.1f} % more"
        )
