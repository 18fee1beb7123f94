"""What a space shows to the contact, on one rank."""

import numpy as np
import pytest
from dolfinx import fem
from fmc_contact import Contact, errors
from fmc_contact_dolfinx import DolfinxContact, LayoutError, by_input_number
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI
from scenes import NAMES, block, blocks, interpolate, permuted, space


@pytest.mark.parametrize("kind", NAMES)
def test_first_order_gives_the_bits_of_the_package(kind):
    x, cells = blocks(kind)
    V = space(kind)
    u = interpolate(fem.Function(V))
    contact = DolfinxContact(V, stiffness=1e4, estimator="exact")
    moved = x + by_input_number(u)
    assert (contact.coords(u) == moved).all()
    # Depths are those without displacement.
    alone = Contact(x, cells, kind, stiffness=1e4, estimator="exact").evaluate(moved)
    force = fem.Function(V)
    force.x.array[:] = contact.force(u)
    assert alone.volume > 1e-4 and (by_input_number(force) == alone.forces).all()


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("order", [1, 2])
def test_boundary_encloses_the_volume_of_the_mesh(kind, order):
    dim = NAMES[kind]
    x, cells = block(kind, 3, [0.0] * dim, [1.0, 2.0, 0.5][:dim])
    x = x + 0.02 * np.sin(7.0 * x)
    x, cells, _ = permuted(x, cells)
    V = vector_space(mesh_from_cells(MPI.COMM_WORLD, x, cells, kind), order)
    if order == 1:
        contact = DolfinxContact(V, stiffness=1.0, whole_mesh=False)
        at = contact.coords(fem.Function(V))[contact._shows._skin.facets]
        if dim == 2:
            volume = 0.5 * (at[:, 0, 0] * at[:, 1, 1] - at[:, 0, 1] * at[:, 1, 0]).sum()
        else:
            volume = np.einsum("ij,ij->i", at[:, 0], np.cross(at[:, 1], at[:, 2])).sum() / 6.0
    else:
        contact = DolfinxContact(V, stiffness=1.0, law="volume", estimator="exact")
        up = np.eye(dim)[-1]
        contact.contact.obstacles.add_half_space(10.0 * up, up)
        volume = contact.evaluate(fem.Function(V)).volume
    import ufl

    measure = fem.assemble_scalar(fem.form(fem.Constant(V.mesh, 1.0) * ufl.dx))
    # Faces of hexahedra are bent; split about their centres they are flat, of the same volume.
    assert volume == pytest.approx(measure, rel=1e-12)


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("order", [1, 2])
def test_force_is_minus_the_slope_of_the_energy(kind, order):
    V = space(kind, order)
    dim = NAMES[kind]
    u, direction = fem.Function(V), fem.Function(V)

    interpolate(u)
    direction.interpolate(lambda p: np.stack([np.cos((2.0 + a) * p[0] + p[dim - 1]) for a in range(dim)]))
    contact = DolfinxContact(V, stiffness=1e4, estimator="exact", momentum_correction=False)
    contact.keep_patches(u)
    step, energies = 1e-6, []
    for sign in (-1, 1):
        energies.append(contact.evaluate(u.x.array + sign * step * direction.x.array).energy)
    slope = (energies[1] - energies[0]) / (2 * step)
    assert slope == pytest.approx(-contact.force(u) @ direction.x.array, rel=1e-6)


def test_other_spaces_are_refused():
    mesh = space("triangle").mesh
    dim = mesh.geometry.dim
    make = (lambda *e: fem.functionspace(mesh, e)) if hasattr(fem, "functionspace") else None
    old = (lambda f, k: fem.VectorFunctionSpace(mesh, (f, k))) if make is None else None
    spaces = [
        make("DG", 1, (dim,)) if make else old("DG", 1),
        make("CR", 1, (dim,)) if make else old("CR", 1),
        make("Lagrange", 1) if make else fem.FunctionSpace(mesh, ("CG", 1)),
    ]
    for other in spaces:
        with pytest.raises(LayoutError):
            DolfinxContact(other, stiffness=1.0)
    with pytest.raises(LayoutError):
        DolfinxContact(mesh.geometry, stiffness=1.0)


def test_bodies_by_numbers_of_cells():
    _x, _cells = blocks("quad")
    V = space("quad")
    number = np.asarray(V.mesh.topology.original_cell_index)
    of_cells = np.where(number < 9, 5, 8)
    for whole in (True, False):
        contact = DolfinxContact(V, stiffness=1e4, estimator="exact", bodies=of_cells, whole_mesh=whole)
        assert [body.id for body in contact.evaluate(fem.Function(V)).bodies] == [5, 8]


def test_second_order_has_no_flat_facets():
    with pytest.raises(ValueError, match="passed whole"):
        DolfinxContact(space("triangle", 2), stiffness=1.0, whole_mesh=False)


def test_an_error_leaves_the_contact_as_it_was():
    V = space("triangle")
    contact = DolfinxContact(V, stiffness=1e4, estimator="exact")
    u = interpolate(fem.Function(V))
    before = contact.force(u)
    bad = u.x.array.copy()
    bad[3] = np.inf
    with pytest.raises(errors.NonFiniteCoordinateError):
        contact.force(bad)
    assert (contact.force(u) == before).all()


@pytest.mark.parametrize("whole", [True, False])
def test_tangent_of_two_spaces_is_minus_the_slope_of_their_forces(whole):
    """A square list of matrices, one for every pair of spaces."""
    from petsc4py import PETSc

    x, cells = block("quad", 3, [0.0, 0.0], [1.0, 1.0])
    y, more = block("quad", 2, [0.1, 0.98], [0.9, 1.98])
    y[:, 1] += 0.4 * (y[:, 0] - 0.47) ** 2
    spaces = [vector_space(mesh_from_cells(MPI.COMM_WORLD, *one, "quad")) for one in ((x, cells), (y, more))]
    contact = DolfinxContact(spaces, stiffness=1e4, estimator="exact", momentum_correction=False, whole_mesh=whole)
    us = [interpolate(fem.Function(one)).x.array.copy() for one in spaces]
    contact.keep_patches(*us)
    sizes = [len(u) for u in us]
    matrices = [[PETSc.Mat().createAIJ((m, n), nnz=4, comm=MPI.COMM_WORLD) for n in sizes] for m in sizes]
    for line in matrices:
        for matrix in line:
            matrix.setUp()
            matrix.setOption(PETSc.Mat.Option.NEW_NONZERO_ALLOCATION_ERR, False)
            matrix.assemble()
    contact.add_tangent(matrices, contact.tangent(*us))
    dense = np.block([[matrix.convert("dense").getDenseArray() for matrix in line] for line in matrices])
    direction = np.random.default_rng(5).standard_normal(sum(sizes))
    step, forces = 1e-7, []
    for sign in (-1, 1):
        parts = np.split(np.concatenate(us) + sign * step * direction, [sizes[0]])
        forces.append(np.concatenate(contact.force(*parts)))
    slope = (forces[1] - forces[0]) / (2 * step)
    assert np.abs(slope).max() > 1.0
    assert np.linalg.norm(slope + dense @ direction) < 1e-5 * np.linalg.norm(slope)


def test_a_component_that_is_held_gets_no_force():
    V = space("triangle")
    u = interpolate(fem.Function(V))
    contact = DolfinxContact(V, stiffness=1e4, estimator="exact")
    result = contact.evaluate(u)
    free, held = np.zeros((2, len(u.x.array)))
    contact.add_forces(free, result)
    touched = np.flatnonzero(free[1::2]) * 2 + 1
    bc = fem.dirichletbc(np.float64(0.0), touched[:1].astype(np.int32), V.sub(1))
    contact.add_forces(held, result, bcs=[bc])
    assert len(touched) > 1 and held[touched[0]] == 0.0
    free[touched[0]] = 0.0
    assert (held == free).all()


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("order", [1, 2])
def test_nodal_pressure_as_a_function(kind, order):
    V = space(kind, order)
    u = fem.Function(V)
    contact = DolfinxContact(V, stiffness=1e4, estimator="exact")
    field = contact.nodal_contact(u)
    pressure, normal = contact.function(field.pressure, "pressure"), contact.function(field.normal)
    assert pressure.name == "pressure" and field.touching.any()
    dim = NAMES[kind]
    places = pressure.function_space.tabulate_dof_coordinates()[:, :dim]
    at_blocks = V.tabulate_dof_coordinates()[:, :dim]
    shown = 0
    for x, p, n in zip(contact.coords(u), field.pressure, field.normal):
        here = np.flatnonzero(np.abs(places - x).max(axis=1) < 1e-9)
        if p > 0 and len(here):
            shown += 1
            assert pressure.x.array[here] == pytest.approx(p)
            block = np.flatnonzero(np.abs(at_blocks - x).max(axis=1) < 1e-9)
            assert normal.x.array.reshape(-1, dim)[block[0]] == pytest.approx(n)
    assert shown >= 2 and np.count_nonzero(pressure.x.array) == shown


def test_numbers_are_not_cut_from_fractions():
    V = space("quad")
    count = V.mesh.topology.index_map(2).size_local + V.mesh.topology.index_map(2).num_ghosts
    with pytest.raises(TypeError, match="bodies has dtype float64, expected integers"):
        DolfinxContact(V, stiffness=1e3, bodies=np.full(count, 0.5))
    with pytest.raises(TypeError, match="blocks has dtype float64, expected integers"):
        DolfinxContact(V, stiffness=1e3).set_symmetry_blocks([0.5])


def test_two_spaces_have_meshes_of_their_own_in_one_dimension():
    V = space("triangle")
    for other in (V, vector_space(V.mesh, 2)):
        with pytest.raises(LayoutError, match=r"spaces\[0\] and spaces\[1\] are on the same mesh"):
            DolfinxContact([V, other], stiffness=1.0)
    with pytest.raises(LayoutError, match=r"spaces\[0\] is in 2D and spaces\[1\] in 3D"):
        DolfinxContact([V, space("tetra")], stiffness=1.0)
    assert DolfinxContact([V, space("triangle")], stiffness=1.0).space_count == 2
