"""Prisms and pyramids: the order of their corners, and meshes of them where dolfinx makes such."""

import basix
import numpy as np
import pytest
from dolfinx import fem
from fmc_contact import Contact
from fmc_contact_dolfinx import DolfinxContact, LayoutError, by_input_number
from fmc_contact_dolfinx.cells import CELL_TYPES, TENSOR_ORDER
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI
from scenes import block, interpolate

KINDS = ["wedge", "pyramid"]


def cells(kind):
    """Nodes and cells of two blocks in wedges, or in pyramids."""
    x, conn, first = [], [], 0
    for count, low, high in ((3, [0.0] * 3, [1.0] * 3), (2, [0.1, 0.1, 0.98], [0.9, 0.9, 1.98])):
        points, hexahedra = block("hexahedron", count, low, high)
        if kind == "wedge":
            own = np.concatenate([hexahedra[:, [0, 1, 2, 4, 5, 6]], hexahedra[:, [0, 2, 3, 4, 6, 7]]])
        else:
            apex = len(points) + np.arange(len(hexahedra))[:, None]
            points = np.concatenate([points, points[hexahedra].mean(axis=1)])
            faces = ([0, 1, 2, 3], [4, 7, 6, 5], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0])
            own = np.concatenate([np.hstack([hexahedra[:, face], apex]) for face in faces])
        x.append(points)
        conn.append(own + first)
        first += len(points)
    return np.concatenate(x), np.concatenate(conn)


def space(kind):
    try:
        return vector_space(mesh_from_cells(MPI.COMM_WORLD, *cells(kind), kind))
    except (KeyError, RuntimeError) as error:
        pytest.skip(f"this dolfinx makes no meshes of {kind} cells: {error!r}")


@pytest.mark.parametrize("theirs", ["prism", "pyramid", "hexahedron", "tetrahedron"])
def test_corners_of_the_reference_cell(theirs):
    """basix' reference cell, in our order, has positive corners and the volume that it should."""
    cell, ours = getattr(basix.CellType, theirs), CELL_TYPES[theirs]
    x = np.asarray(basix.geometry(cell))
    assert len(x) == len(TENSOR_ORDER[ours])
    order = TENSOR_ORDER[ours]
    assert [order[k] for k in order] == list(range(len(x)))
    x = x[order]
    large = np.array([[-2, -2, -2], [8, -2, -2], [-2, 8, -2], [-2, -2, 8]], float)
    blocks = [(ours, [list(range(len(x)))]), ("tetra", [[len(x) + k for k in range(4)]])]
    contact = Contact(np.vstack([x, large]), blocks, stiffness=1.0, law="volume", estimator="exact")
    volume = {"prism": 1 / 2, "pyramid": 1 / 3, "hexahedron": 1.0, "tetrahedron": 1 / 6}[theirs]
    assert contact.evaluate(np.vstack([x, large])).volume == pytest.approx(volume, rel=1e-13)


@pytest.mark.parametrize("kind", KINDS)
def test_forces_are_those_of_the_package(kind):
    V = space(kind)
    x, conn = cells(kind)
    u = interpolate(fem.Function(V))
    contact = DolfinxContact(V, stiffness=1e4)
    moved = x + by_input_number(u)
    alone = Contact(x, conn, kind, stiffness=1e4).evaluate(moved)
    force = fem.Function(V)
    force.x.array[:] = contact.force(u)
    assert alone.volume > 1e-4 and (by_input_number(force) == alone.forces).all()


@pytest.mark.parametrize("kind", KINDS)
def test_boundaries_alone_are_refused(kind):
    with pytest.raises(LayoutError, match="two shapes"):
        DolfinxContact(space(kind), stiffness=1.0, whole_mesh=False)
