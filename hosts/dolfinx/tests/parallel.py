"""Programs for several ranks, started by the tests: ``mpirun -n N python parallel.py PROGRAM [arguments]``."""

import sys

import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, attach, by_input_number, find_equilibrium
from fmc_contact_dolfinx.entries import add_entries
from fmc_contact_dolfinx.on_ranks import direct_solver
from fmc_contact_dolfinx.versions import create_vector, mesh_from_cells, vector_of, vector_space
from petsc4py import PETSc
from scenes import COMM, block, blocks, bodies, cracked, interpolate, permuted, set_wave, sliced, tagged


def elastic(u, v, young=200.0, poisson=0.3):
    """Virtual work of Hooke's law."""
    shear, lame = young / 2 / (1 + poisson), young * poisson / (1 + poisson) / (1 - 2 * poisson)
    strain = ufl.sym(ufl.grad(u))
    stress = 2 * shear * strain + lame * ufl.tr(strain) * ufl.Identity(len(u))
    return ufl.inner(stress, ufl.sym(ufl.grad(v))) * ufl.dx


def pressed(space, down=-0.05):
    """Boundary conditions: the bottom of the lower block is held, the top of the upper one pressed down."""
    m, dim = space.mesh, space.mesh.geometry.dim
    bcs = []
    for height, value in ((0.0, 0.0), (1.98, down)):
        facets = mesh.locate_entities_boundary(m, dim - 1, lambda x: np.isclose(x[dim - 1], height))
        dofs = fem.locate_dofs_topological(space, dim - 1, facets)
        vector = np.zeros(dim)
        vector[-1] = value
        bcs.append(fem.dirichletbc(vector, dofs, space))
    return bcs


def solve(out, kind, order, whole, permute, through):
    """The upper block is pressed into the lower one; writes displacement and force in the order of the nodes."""
    x, cells = blocks(kind, 4, 3)
    old = np.arange(len(x))
    if permute == "permuted":
        x, cells, old = permuted(x, cells)
    space = vector_space(mesh_from_cells(COMM, x, cells, kind), int(order))
    shown = {"whole": {"whole_mesh": True}, "boundary": {"whole_mesh": False}, "parts": {"in_parts": True}}[whole]
    contact = DolfinxContact(space, stiffness=1e4, estimator="exact", **shown)
    u, v = fem.Function(space), ufl.TestFunction(space)
    bcs = pressed(space)
    contact.keep_patches(u)
    if through == "search":
        find_equilibrium(ContactProblem(elastic(u, v), u, bcs, contact), tolerance=1e-12)
    else:
        {"newton": newton, "attached": attached}[through](elastic(u, v), u, bcs, contact)
    result = contact.evaluate(u)
    force = fem.Function(space)
    contact.add_forces(force.x.array, result)
    force.x.scatter_forward()
    tables = by_input_number(u), by_input_number(force)
    if COMM.rank == 0:
        back = np.argsort(old)
        np.savez(out, u=tables[0][back], force=tables[1][back], energy=result.energy)


def attached(form, u, bcs, contact):
    """By SNES, whose functions know nothing of contact."""
    residual, jacobian = fem.form(form), fem.form(ufl.derivative(form, u))
    snes, vector = PETSc.SNES().create(COMM), create_vector(residual, u.function_space)

    def function(snes, x, b):
        x.copy(vector_of(u))
        u.x.scatter_forward()
        with b.localForm() as local:
            local.set(0.0)
        petsc.assemble_vector(b, residual)
        petsc.apply_lifting(b, [jacobian], [bcs], [vector_of(u)], -1.0)
        b.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
        petsc.set_bc(b, bcs, vector_of(u), -1.0)

    def derivative(snes, x, a, p):
        p.zeroEntries()
        petsc.assemble_matrix(p, jacobian, bcs)
        p.assemble()

    snes.setFunction(function, vector)
    snes.setJacobian(derivative, petsc.create_matrix(jacobian))
    attach(snes, contact, bcs)
    snes.setKSP(direct_solver(COMM))
    # A short step of a line search is no sign of convergence.
    snes.setTolerances(rtol=1e-10, atol=1e-12, stol=0.0, max_it=50)
    x = vector_of(u).copy()
    snes.solve(None, x)
    assert snes.getConvergedReason() > 0
    x.copy(vector_of(u))
    u.x.scatter_forward()


def newton(form, u, bcs, contact):
    """Through dolfinx' own NonlinearProblem and NewtonSolver, where they have F and J."""
    from dolfinx.nls.petsc import NewtonSolver
    from fmc_contact_dolfinx import with_contact

    stock = with_contact(petsc.NonlinearProblem)(form, u, bcs, contact=contact)
    solver = NewtonSolver(COMM, stock)
    solver.rtol, solver.atol, solver.max_it = 1e-12, 1e-10, 40
    solver.krylov_solver.setType("preonly")
    solver.krylov_solver.getPC().setType("lu")
    solver.krylov_solver.getPC().setFactorSolverType("mumps")
    assert solver.solve(u)[1]


def two_spaces(out, stiffness="found"):
    """Hexahedra are pressed on tetrahedra and pulled along with friction: two meshes, two spaces, and a stiffness given or found."""
    x, cells = block("tetra", 3, [0.0] * 3, [1.0] * 3)
    y, more = block("hexahedron", 2, [0.2, 0.2, 1.0], [0.8, 0.8, 1.6])
    spaces = [vector_space(mesh_from_cells(COMM, *one)) for one in ((x, cells, "tetra"), (y, more, "hexahedron"))]
    given = {} if stiffness == "found" else {"stiffness": float(stiffness), "in_parts": False}
    contact = DolfinxContact(spaces, friction_coefficient=0.3, **given)
    us, moves = [fem.Function(space) for space in spaces], [fem.Function(space) for space in spaces]
    bcs = []
    for move, height in zip(moves, (0.0, 1.6)):
        dofs = fem.locate_dofs_geometrical(move.function_space, lambda x: np.isclose(x[2], height))
        bcs.append(fem.dirichletbc(move, dofs))
    residuals = [elastic(u, ufl.TestFunction(u.function_space)) for u in us]
    problem, forces = ContactProblem(residuals, us, bcs, contact), []
    contact.begin_step(*us)
    for down, along in ((0.01, 0.0), (0.02, 0.02)):
        moves[1].interpolate(lambda x: np.outer([along, 0.0, -down], np.ones(x.shape[1])))
        # By default one rank condenses, and ends at other multipliers than several do, within the penetration that is left.
        found = find_equilibrium(problem, tolerance=1e-11, two_level=False)
        contact.commit_step(*us)
        forces.append(found.result.bodies[1].force)
        pushed = by_input_number(problem.functions(found.reactions)[1]).sum(axis=0)
        # What holds the upper body against the contact.
        assert np.abs(pushed + forces[-1]).max() < 1e-9 * np.abs(pushed).max()
    tables = [by_input_number(u) for u in us]
    if COMM.rank == 0:
        np.savez(out, lower=tables[0], upper=tables[1], forces=np.array(forces))


def two_meshes(out, kind):
    """Forces between bodies on two meshes, one of a single cell, so that most ranks have nothing of it."""
    dim = {"quad": 2, "hexahedron": 3}[kind]
    x, cells = block(kind, 3, [0.0] * dim, [1.0] * dim)
    y, more = block(kind, 1, [0.2] * (dim - 1) + [0.97], [0.8] * (dim - 1) + [1.97])
    # On its edge, as the walls must not lie in the overlap.
    y[:, -1] += 0.2 * (y[:, :-1] - 0.2).sum(axis=1) + 0.0
    spaces = [vector_space(mesh_from_cells(COMM, a, b, kind)) for a, b in ((x, cells), (y, more))]
    counts = COMM.allgather(len(by := spaces[1].mesh.geometry.x))
    del by
    us = [interpolate(fem.Function(space)) for space in spaces]
    tables = []
    for whole in (True, False):
        contact = DolfinxContact(spaces, stiffness=1e4, law="fiber", estimator="exact", whole_mesh=whole)
        forces = [fem.Function(space) for space in spaces]
        for function, values in zip(forces, contact.force(*us)):
            function.x.array[: len(values)] = values
        tables += [by_input_number(force) for force in forces]
    if COMM.rank == 0:
        assert COMM.size == 1 or min(counts) == 0, "a rank without facets is wanted"
        np.savez(out, **{f"force{k}": table for k, table in enumerate(tables)})


def figures(kind, order, law, steps):
    """What a contact tells at given displacements, by input numbers; nodes and cells are given to the mesh in any order, and bodies
    are its connected components. On more than one rank the mesh is in parts."""
    x, cells, _ = permuted(*bodies(kind))
    space = vector_space(mesh_from_cells(COMM, x, cells, kind), int(order))
    friction = {"friction_coefficient": 0.3, "friction_stiffness": 1e3} if steps == "steps" else {}
    contact = DolfinxContact(space, stiffness=1e4, law=law, estimator="exact", **friction)
    assert bool(contact.whole_because) == (COMM.size == 1), contact.whole_because
    up = np.eye(x.shape[1])[-1]
    contact.contact.obstacles.add_half_space(0.004 * up, up)
    u = fem.Function(space)
    if steps == "steps":
        contact.begin_step(u)
        # Far enough that other cells are gathered.
        contact.commit_step(set_wave(u, shift=0.3))
        set_wave(u, shift=0.25)
    else:
        if law == "fiber":
            contact.keep_patches(u)
        set_wave(u)
    result, fields, tangent = contact.evaluate(u), contact.nodal_contact(u), contact.tangent(u)
    unknown = contact.unknowns()
    # What was found knows its nodes when others have been gathered since.
    contact.evaluate(fem.Function(space))
    force = fem.Function(space)
    contact.add_forces(force.x.array, result)
    force.x.scatter_forward()
    # A vector on the space of the displacement, a number below it.
    normal, pressure = contact.function(fields.normal), contact.function(fields.pressure)
    normal.sub(0).interpolate(pressure)
    normal.x.scatter_forward()
    count = space.dofmap.index_map.size_local * space.dofmap.index_map_bs
    matrix = PETSc.Mat().createAIJ(((count, None), (count, None)), nnz=50, comm=COMM)
    matrix.assemble()
    contact.add_tangent(matrix, tangent)
    (first, last), distinct = matrix.getOwnershipRange(), np.unique(unknown[tangent.rows])
    assert np.array_equal(contact.touched(tangent), distinct[(distinct >= first) & (distinct < last)])
    sums = [np.concatenate([one.force, one.moment, one.friction]) for one in (*result.bodies, *result.obstacles)]
    own = space.mesh.topology.index_map(space.mesh.topology.dim).size_local
    return {
        "force": by_input_number(force),
        "normal": by_input_number(normal),
        "tangent": _entries(space, unknown[tangent.rows], unknown[tangent.cols], np.asarray(tangent.values)),
        "sums": np.array(sums),
        "bodies": np.array([[body.id, body.node_count] for body in result.bodies]),
        "totals": np.array([result.energy, result.volume, result.penetration]),
        "received": np.array(COMM.allgather((own, contact.received_cell_count))),
        "matrix": np.array([matrix.norm()]),
    }


def _entries(space, rows, cols, values):
    """Entries of a matrix by rows and columns that are counted as the input counts nodes; those of nodes that the input has
    not, in the middle of edges, are left out."""
    index_map, dim = space.dofmap.index_map, space.dofmap.index_map_bs
    number = fem.Function(space)
    number.x.array[: index_map.size_local * dim] = np.arange(*(dim * end for end in index_map.local_range))
    number.x.scatter_forward()
    of_nodes = by_input_number(number).astype(np.int64).ravel()
    place = np.full(index_map.size_global * dim, -1)
    place[of_nodes] = np.arange(len(of_nodes))
    found = np.column_stack([place[rows], place[cols], values])
    found = found[(found[:, 0] >= 0) & (found[:, 1] >= 0)]
    return found[np.lexsort((found[:, 1], found[:, 0]))]


def tell(out, *cases):
    """``figures`` of several cases, each KIND-ORDER-LAW-STEPS, as CASE/NAME."""
    found = {}
    for case in cases:
        found.update({f"{case}/{name}": values for name, values in figures(*case.split("-")).items()})
    if COMM.rank == 0:
        np.savez(out, **found)


def cut(out, in_parts=""):
    """Forces where planes of symmetry are named by tags, by themselves, and not at all; and where a crack lies beside a ligament."""
    shown = {"in_parts": {"parts": True, "whole": False}[in_parts]} if in_parts else {}
    found = {}
    for kind, order in (("quad", 1), ("tetra", 1), ("hexahedron", 1), ("hexahedron", 2), ("triangle", 2)):
        x, cells, _ = permuted(*sliced(kind))
        space = vector_space(mesh_from_cells(COMM, x, cells, kind), order)
        places = {"wall": lambda x: np.isclose(x[0], 0.0), "low": lambda x: np.isclose(x[2], 0.0), "high": lambda x: np.isclose(x[2], 0.3)}
        if x.shape[1] == 2:
            places = {"wall": places["wall"]}
        tags, u = tagged(space.mesh, **places), fem.Function(space)
        contact = DolfinxContact(space, stiffness=1e4, **shown)
        axes = np.eye(x.shape[1])
        planes = [(0.0 * axes[0], axes[0]), *([(0.0 * axes[2], axes[2]), (0.3 * axes[2], axes[2])] if len(axes) > 2 else [])]
        for name, tell in (
            ("none", lambda: contact.set_symmetry_boundaries(tags)),
            ("planes", lambda: contact.contact.mesh.set_symmetry_planes(planes)),
            ("tags", lambda: contact.set_symmetry_boundaries(tags, *range(1, 1 + len(places)))),
        ):
            tell()
            found[f"{kind}-{order}/{name}"] = _by_input_number(contact, u)
    x, cells, _ = permuted(*cracked())
    for order in (1, 2):
        space = vector_space(mesh_from_cells(COMM, x, cells, "quad"), order)
        below = lambda x: np.isclose(x[1], 0.0)
        tags = tagged(space.mesh, ligament=lambda x: below(x) & (x[0] > 0.37), crack=lambda x: below(x) & (x[0] < 0.38))
        contact, u = DolfinxContact(space, stiffness=1e4, **shown), fem.Function(space)
        for name, values in (("none", ()), ("ligament", (1,)), ("both", (1, 2))):
            contact.set_symmetry_boundaries(tags, *values)
            found[f"crack-{order}/{name}"] = _by_input_number(contact, u)
        # Of a ligament in two parts that leave one facet between them, nodes would name this too, if it has no middle: no rank goes on alone.
        tags, told = tagged(space.mesh, right=lambda x: below(x) & (x[0] > 0.37), left=lambda x: below(x) & (x[0] < 0.3)), ""
        try:
            contact.set_symmetry_boundaries(tags, 1, 2)
        except ValueError as error:
            told = str(error)
        assert ("leave out 0 of them, and name 1 others" in told) == (order == 1), told
        found[f"crack-{order}/gap"] = _by_input_number(contact, u)
    if COMM.rank == 0:
        np.savez(out, **found)


def _by_input_number(contact, u):
    force = fem.Function(u.function_space)
    contact.add_forces(force.x.array, contact.evaluate(u))
    force.x.scatter_forward()
    return by_input_number(force)


def near():
    """A small block on a large one; each rank tells what it has of the mesh, and what that took."""
    x, cells = block("hexahedron", 40, [0.0] * 3, [1.0, 1.0, 0.9])
    y, more = block("hexahedron", 3, [0.45, 0.45, 0.89], [0.54, 0.54, 1.0])
    space = vector_space(mesh_from_cells(COMM, np.concatenate([x, y]), np.concatenate([cells, more + len(x)]), "hexahedron"))
    contact = DolfinxContact(space, stiffness=1e4, in_parts=True)
    result = contact.evaluate(fem.Function(space))
    gathered, work = contact.contact.gathered(), contact.contact.ranks.counts()
    counts = (gathered.own_cell_count, contact.received_cell_count, gathered.facet_count, gathered.whole_facet_count)
    rows = COMM.gather((*counts, work.call_count, work.received_bytes))
    if COMM.rank == 0:
        print(repr(result.bodies[1].force[2]), *(number for row in rows for number in row))


def entries():
    """A direct solver follows a matrix that gets entries at new places: few, many, few again, and none."""
    size, random = 60, np.random.default_rng(2)
    full = np.diag(random.uniform(20.0, 30.0, size)) - np.eye(size, k=1) - np.eye(size, k=-1)
    matrix = PETSc.Mat().createAIJ(((size, size)), nnz=3, comm=COMM)
    first, last = matrix.getOwnershipRange()
    for row in range(first, last):
        cols = np.flatnonzero(full[row]).astype(PETSc.IntType)
        matrix.setValues([row], cols, full[row, cols])
    matrix.assemble()
    solver = PETSc.KSP().create(COMM)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solver.getPC().setFactorSolverType("mumps")
    right, solution = matrix.createVecs()
    for count in (0, 4, 700, 2, 700, 0):
        rows, cols = random.integers(0, size, (2, count))
        values = random.uniform(-0.3, 0.3, count)
        np.add.at(full, (rows, cols), values)
        mine = (rows >= first) & (rows < last)
        add_entries(PETSc, matrix, rows[mine], cols[mine], values[mine])
        given = random.standard_normal(size)
        right.setArray(given[first:last])
        solver.solve(right, solution)
        found = np.concatenate(COMM.allgather(solution.array.copy()))
        # Well conditioned: some tens of eps.
        assert np.abs(found - np.linalg.solve(full, given)).max() < 1e-14, count


if __name__ == "__main__":
    from failures import fail, fail_later

    programs = solve, tell, cut, near, entries, two_meshes, two_spaces, fail, fail_later
    {program.__name__: program for program in programs}[sys.argv[1]](*sys.argv[2:])
