"""A block of rubber falls on a larger one, step by step in time, on any number of ranks: ``mpirun -n 2 python
falling_block.py``.

Checked: the total energy stays what it was, and the block comes back up.
"""

import numpy as np
import ufl
from dolfinx import fem, mesh
from fmc_contact_dolfinx import DolfinxContact
from fmc_contact_dolfinx.versions import vector_of, vector_space
from mpi4py import MPI

# 1. Two meshes that do not match, a space on each; the upper block is 2 mm above the lower one. m, kg, s, Pa.
comm, density, young = MPI.COMM_WORLD, 1000.0, 1e6
corners = [[(-0.1, -0.1), (0.1, 0.0)], [(-0.03, 0.002), (0.03, 0.062)]]
spaces = [vector_space(mesh.create_rectangle(comm, c, n)) for c, n in zip(corners, [(30, 15), (10, 10)])]
contact = DolfinxContact(spaces, stiffness=2e8, estimator="exact")

# 2. Hooke's law, as forms that are assembled at every step; masses are lumped; the lower block's bottom is held.
us, vs = [fem.Function(s) for s in spaces], [ufl.TestFunction(s) for s in spaces]
strain = lambda u: ufl.sym(ufl.grad(u))
stress = [young * strain(u) for u in us]  # Poisson's ratio 0
inside = [fem.form(ufl.inner(s, strain(v)) * ufl.dx) for s, v in zip(stress, vs)]
energy = [fem.form(0.5 * ufl.inner(s, strain(u)) * ufl.dx) for s, u in zip(stress, us)]


def assembled(form):
    """What this rank owns of an assembled vector, contributions of other ranks added up."""
    from dolfinx.fem.petsc import assemble_vector
    from petsc4py import PETSc

    vector = assemble_vector(form)
    vector.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
    return vector.array.copy()


one = [ufl.as_vector((density, density)) for _ in spaces]
masses = [assembled(fem.form(ufl.inner(o, v) * ufl.dx)) for o, v in zip(one, vs)]
held = fem.locate_dofs_geometrical(spaces[0], lambda x: np.isclose(x[1], -0.1))
free = [np.ones(len(m)) for m in masses]
free[0].reshape(-1, 2)[held[held < len(masses[0]) // 2]] = 0.0
velocities = [np.zeros(len(m)) for m in masses]
velocities[1][1::2] = -2.0

# 3. Leapfrog with a third of the time that a wave takes through a cell.
step = 0.33 * 0.004 / np.sqrt(young / density)
total = []
for n in range(int(0.012 / step)):
    result = contact.evaluate(*us)
    pushed = [np.zeros(len(m)) for m in masses]
    contact.add_forces(pushed, result)
    forces = [p - assembled(f) for p, f in zip(pushed, inside)]
    kicks = [step * w * f / m for w, f, m in zip(free, forces, masses)]
    # Velocities stand half a step behind; in between they are those of now.
    middle = [v + 0.5 * k for v, k in zip(velocities, kicks)]
    kinetic = sum(0.5 * m @ v**2 for m, v in zip(masses, middle if n else velocities))
    total.append(comm.allreduce(kinetic + sum(fem.assemble_scalar(e) for e in energy)) + result.energy)
    for u, v, k in zip(us, velocities, kicks):
        v += k if n else 0.5 * k
        vector_of(u).array[:] += step * v
        u.x.scatter_forward()

# 4. The checks.
rebound = comm.allreduce(masses[1][1::2] @ velocities[1][1::2]) / comm.allreduce(masses[1][1::2].sum())
drift = np.abs(np.array(total) / total[0] - 1.0).max()
if comm.rank == 0:
    print(f"rebound {rebound:.3f} m/s, energy changed by {100 * drift:.2f} % at most")
assert rebound > 0.5 and drift < 0.01
