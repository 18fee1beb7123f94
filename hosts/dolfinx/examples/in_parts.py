"""A mesh that the ranks hold in parts: each gives its own cells, and has of the others only those near the contact.

    mpirun -n 4 python in_parts.py

Two blocks, the upper one 0.01 deep in the lower one, in which the pressure is the stiffness times the depth. Numbers of the input
name nodes and cells, so the force is the same, bit for bit, on any number of ranks.
"""

import numpy as np
from fmc_contact import PartitionedContact
from fmc_contact_dolfinx.versions import cell_geometry, mesh_from_cells
from mpi4py import MPI

comm, stiffness, depth = MPI.COMM_WORLD, 1e6, 0.01


def block(cells, low, high):
    """Triangles of a rectangle."""
    nx, ny = cells
    x = np.array([[a, b] for b in np.linspace(low[1], high[1], ny + 1) for a in np.linspace(low[0], high[0], nx + 1)])
    first = np.array([row * (nx + 1) + column for row in range(ny) for column in range(nx)])
    corners = np.stack([first, first + 1, first + nx + 2, first + nx + 1], axis=1)
    return x, np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])


lower, cells_of_lower = block((400, 100), (0.0, 0.0), (4.0, 1.0))
upper, cells_of_upper = block((70, 60), (1.0, 1.0 - depth), (2.0, 1.8))
cells = np.concatenate([cells_of_lower, cells_of_upper + len(lower)])
mesh = mesh_from_cells(comm, np.concatenate([lower, upper]), cells, "triangle")

own = mesh.topology.index_map(2).size_local
conn = cell_geometry(mesh)[:own]
cell_numbers = np.asarray(mesh.topology.original_cell_index)[:own]
contact = PartitionedContact(
    comm,
    mesh.geometry.x,
    conn,
    "triangle",
    node_numbers=mesh.geometry.input_global_indices,
    cell_numbers=cell_numbers,
    bodies=np.where(cell_numbers < len(cells_of_lower), 0, 1),
    stiffness=stiffness,
    law="depth",
)

# Every step: bring the mesh to the coordinates of the rank's own nodes, evaluate at those gathered, take what is on own nodes.
contact.set_coords(mesh.geometry.x)
result = contact.evaluate(contact.coords)
forces = contact.on_own_nodes(result.forces)

gathered, counts = contact.gathered(), contact.ranks.counts()
if comm.rank == 0:
    print(f"force {result.bodies[1].force[1]!r}, pressure times width {stiffness * depth}")
    print(f"{gathered.facet_count} of {gathered.whole_facet_count} facets gathered, {gathered.cell_count} of {len(cells)} cells")
    print(f"{counts.call_count} calls, {counts.received_bytes} bytes received")
# A node between ranks has its whole force on each of them: add it where its rows are owned.
assert np.isfinite(forces).all() and np.isclose(result.bodies[1].force[1], stiffness * depth, rtol=0.02)
