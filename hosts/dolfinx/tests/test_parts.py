"""A mesh in parts tells what the whole mesh on one rank tells, bit by bit, on any number of ranks."""

import numpy as np
import pytest
from dolfinx import fem
from fmc_contact_dolfinx import DolfinxContact
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from scenes import COMM, bodies, interpolate, permuted

# Kind, order, law, and whether steps with friction are made, in which other cells are gathered.
CASES = {
    "plane": ("triangle-1-depth-plain", "triangle-2-depth-plain", "quad-2-depth-plain", "triangle-1-fiber-plain"),
    "volume": ("tetra-1-depth-plain", "hexahedron-1-volume-plain", "tetra-2-depth-plain", "hexahedron-2-depth-plain"),
    "steps": ("quad-1-depth-steps", "triangle-2-depth-steps", "tetra-1-depth-steps"),
}


def told(ranks, folder, count, cases):
    out = folder / "told.npz"
    run = ranks(count, "tell", out, *cases)
    assert run.returncode == 0, run.stdout + run.stderr
    return dict(np.load(out))


@pytest.fixture(scope="module")
def alone(ranks, tmp_path_factory):
    made = {}

    def get(group):
        if group not in made:
            made[group] = told(ranks, tmp_path_factory.mktemp("alone"), 1, CASES[group])
        return made[group]

    return get


@pytest.mark.parametrize("group, count", [(group, count) for group in CASES for count in (2, 4)])
def test_bits_are_those_of_one_rank(ranks, alone, tmp_path, group, count):
    one, several = alone(group), told(ranks, tmp_path, count, CASES[group])
    for name, values in several.items():
        if name.endswith("received"):
            # Every rank has its own cells and some of the others', on one rank there are no others.
            assert values[:, 0].sum() == one[name][0, 0] and one[name][0, 1] == 0
            assert (values[:, 1] > 0).all() and (values.sum(axis=1) <= one[name][0, 0]).all()
        elif name.endswith("matrix"):
            # Entries are the same; the squares of some 1e4 are summed in another order.
            assert values == pytest.approx(one[name], rel=1e-12)
        else:
            assert np.array_equal(values, one[name]), name
    for case in CASES[group]:
        assert np.abs(one[f"{case}/force"]).max() > 0.1 and len(one[f"{case}/bodies"]) == 4
        assert np.abs(one[f"{case}/tangent"][:, 2]).max() > 1.0


def test_a_rank_receives_what_is_near_a_small_contact(ranks):
    run = ranks(4, "near")
    assert run.returncode == 0, run.stdout + run.stderr
    force, *numbers = run.stdout.split()
    # k times the depth on the face; at its rim the walls are nearer.
    assert float(force) == pytest.approx(1e4 * 0.01 * 0.09**2, rel=0.2)
    for own, received, facets, of_all, calls, received_bytes in np.array(numbers, int).reshape(4, 6):
        print(f"{own} own cells, {received} received, {facets} of {of_all} facets, {calls} calls, {received_bytes} B")
        assert own + received < 0.35 * (40**3 + 3**3) and of_all == 2 * 2 * 6 * (40**2 + 3**2)
        assert 0 < facets <= 0.05 * of_all and calls < 80 and received_bytes < 3000 * facets


@pytest.mark.parametrize("kind, order", [("triangle", 1), ("quad", 2), ("tetra", 1), ("hexahedron", 2)])
def test_one_rank_may_have_its_mesh_in_parts(kind, order):
    x, cells, _ = permuted(*bodies(kind))
    space = vector_space(mesh_from_cells(COMM, x, cells, kind), order)
    u = interpolate(fem.Function(space))
    whole, parts = (DolfinxContact(space, stiffness=1e4, in_parts=chosen) for chosen in (False, True))
    assert whole.whole_because == "in_parts=False was asked for" and parts.whole_because == ""
    assert np.array_equal(whole.force(u), parts.force(u)) and np.abs(whole.force(u)).max() > 0.1
    assert parts.received_cell_count == 0 and parts.contact.gathered().own_cell_count == len(cells)


def test_planes_of_symmetry_are_named_by_blocks():
    x, cells, _ = permuted(*bodies("tetra"))
    space = vector_space(mesh_from_cells(COMM, x, cells, "tetra"))
    u = interpolate(fem.Function(space))
    named = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[0], 0.0) | np.isclose(x[2], 0.8))
    forces = []
    for chosen in (False, True):
        contact = DolfinxContact(space, stiffness=1e4, in_parts=chosen)
        without = contact.force(u)
        contact.set_symmetry_blocks(named)
        forces.append(contact.force(u))
        assert np.abs(forces[-1] - without).max() > 0.1
    assert np.array_equal(*forces)
    with pytest.raises(TypeError, match="set_symmetry_blocks"):
        contact.contact.mesh.set_symmetry_nodes([1])


def test_what_cannot_be_in_parts_says_why():
    x, cells = bodies("triangle")
    mesh = mesh_from_cells(COMM, x, cells, "triangle")
    first, third = vector_space(mesh), vector_space(mesh, 3)
    because = [
        (first, {}, "there is one rank"),
        (first, {"whole_mesh": True}, "whole_mesh=True was asked for"),
        (first, {"share_work": False}, "every rank does all by itself"),
        (first, {"estimator": "fibers"}, "the boundary alone"),
        (first, {"bodies": np.full(len(cells), 2**40)}, "more than 32 bits"),
        (third, {}, "the unknowns of a space are no nodes"),
    ]
    for space, options, reason in because:
        assert reason in DolfinxContact(space, stiffness=1e4, **options).whole_because
    for space, options, reason in because[1:3] + because[4:]:
        with pytest.raises(ValueError, match=reason):
            DolfinxContact(space, stiffness=1e4, in_parts=True, **options)
    assert DolfinxContact(first, stiffness=1e4, in_parts=True, estimator="fibers").whole_because == ""


def test_forces_at_other_nodes_are_refused():
    x, cells = bodies("triangle")
    space = vector_space(mesh_from_cells(COMM, x, cells, "triangle"))
    contact = DolfinxContact(space, stiffness=1e4, in_parts=True)
    with pytest.raises(ValueError, match="values at points"):
        contact.on_unknowns(np.zeros((3, 2)))
