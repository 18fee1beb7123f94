"""A mesh that ranks hold in parts; here they are threads."""

import fmc_contact
import numpy as np
import pytest
from scenes import grid
from test_ranks import Rank, SendingRank, contact_of, on_ranks

OPTIONS = {"law": "depth", "friction_coefficient": 0.4, "friction_stiffness": 20.0}


def part_of(blocks, rank, size):
    """Own coordinates, cells and numbers of a rank."""
    coords, conn = blocks
    middle = coords[conn].mean(axis=1)[:, 0]
    cells = np.nonzero(np.clip((middle * size / 2).astype(int), 0, size - 1) == rank)[0]
    numbers, own = np.unique(conn[cells], return_inverse=True)
    bodies = (conn[cells].min(axis=1) >= 601 * 3).astype(np.int32)
    return coords[numbers], own.reshape(-1, 4), {"node_numbers": numbers, "cell_numbers": cells, "bodies": bodies}


def whole(blocks, **options):
    return contact_of(blocks, bodies=(blocks[1].min(axis=1) >= 601 * 3).astype(np.int32), **options)


def parted(blocks, comm, **options):
    coords, conn, numbers = part_of(blocks, comm.rank, comm.size)
    return fmc_contact.PartitionedContact(comm, coords, conn, "quad", stiffness=30.0, **numbers, **options), numbers


@pytest.mark.parametrize("kind", [Rank, SendingRank])
@pytest.mark.parametrize("law", ["fiber", "depth", "volume"])
def test_parts_have_the_bits_of_the_whole(blocks, law, kind):
    expected = whole(blocks, law=law).evaluate(blocks[0])

    def work(comm):
        contact, numbers = parted(blocks, comm, law=law)
        result = contact.evaluate(contact.coords)
        assert np.array_equal(contact.coords, blocks[0][contact.nodes])
        own = contact.on_own_nodes(result.forces)
        assert np.array_equal(own, expected.forces[numbers["node_numbers"]])
        assert np.array_equal(result.forces, expected.forces[contact.nodes])
        counts = contact.gathered()
        assert counts.node_count == len(contact.nodes) and counts.cell_count == len(contact.gathered_cells())
        assert counts.whole_facet_count == 2 * (602 + 532) and counts.gather_count == 1
        return result.volume

    assert on_ranks(3, work, kind) == [expected.volume] * 3


def test_steps_with_friction_go_on_with_other_ranks(blocks):
    coords = blocks[0]
    moved = coords + np.outer(np.arange(len(coords)) >= 601 * 3, [1e-3, 0])
    contact = whole(blocks, **OPTIONS)
    contact.friction.begin_step(coords)
    contact.friction.commit_step(moved)
    expected = contact.evaluate(coords).forces

    def first(comm):
        contact, numbers = parted(blocks, comm, **OPTIONS)
        contact.friction.begin_step(contact.coords)
        contact.set_coords(moved[numbers["node_numbers"]])
        contact.friction.commit_step(contact.coords)
        return contact.friction.carried_slip

    carried = on_ranks(3, first)
    assert len(carried[0]) > 100 and all(np.array_equal(carried[0], other) for other in carried)

    def second(comm):
        contact, numbers = parted(blocks, comm, **OPTIONS)
        contact.set_coords(moved[numbers["node_numbers"]])
        contact.friction.begin_step(contact.coords)
        contact.friction.carried_slip = carried[0]
        contact.set_coords(coords[numbers["node_numbers"]])
        return np.array_equal(contact.evaluate(contact.coords).forces, expected[contact.nodes])

    assert on_ranks(2, second) == [True, True]


def test_errors_are_told_on_all_ranks():
    (a, of_a), (b, of_b) = grid((600, 2), (0, 2), (0, 1)), grid((530, 20), (0.2, 1.7), (0.99, 9))
    blocks = np.concatenate([a, b]), np.concatenate([of_a, of_b + len(a)])

    def work(comm):
        contact, numbers = parted(blocks, comm)
        wrong = blocks[0][numbers["node_numbers"]]
        if comm.rank == 1:
            wrong[3, 1] = np.nan
        with pytest.raises(fmc_contact.FmcError) as caught:
            contact.set_coords(wrong)
        with pytest.raises((fmc_contact.errors.LengthError, fmc_contact.errors.OnOtherRankError)):
            contact.set_coords(wrong[: len(wrong) - comm.rank])
        contact.set_coords(blocks[0][numbers["node_numbers"]])
        contact.obstacles.add_half_space((0, 8.9), (0, -1))
        with pytest.raises(fmc_contact.errors.NotGatheredError):
            contact.evaluate(contact.coords)
        with pytest.raises(fmc_contact.errors.UnsupportedError):
            contact.mesh.set_reference(contact.coords)
        with pytest.raises(fmc_contact.errors.UnsupportedError, match="own nodes"):
            contact.mesh.set_symmetry_facets([0], contact.coords)
        with pytest.raises(fmc_contact.errors.UnsupportedError):
            contact.friction.begin_step(contact.coords + 1e-9)
        return type(caught.value)

    errors = fmc_contact.errors
    assert on_ranks(2, work) == [errors.OnOtherRankError, errors.NonFiniteCoordinateError]


def test_other_contacts_are_not_in_parts(blocks):
    contact = whole(blocks)
    with pytest.raises(fmc_contact.errors.UnsupportedError, match="fmc_context_new_from_part"):
        contact._core.handle.call(fmc_contact.partition.library.fmc_context_set_coords, None, None)
    with pytest.raises(ValueError, match="node_numbers has shape \\(3,\\), expected"):
        fmc_contact.PartitionedContact(
            None, blocks[0], blocks[1], "quad", stiffness=1.0, node_numbers=[1, 2, 3], cell_numbers=[], bodies=[]
        )
