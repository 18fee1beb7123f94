"""A block of 4³ cubes on a larger one, in cells of four kinds: the force relative to k δ A, for three depths δ in cells.

    python benchmarks/tables/block_on_block.py

Needs numpy and fmc_contact; seconds.
"""

import numpy as np
from fmc_contact import Contact

# Corners of a cube in the order of Hex8; two wedges about a diagonal of the bottom, and six pyramids with their apex in the middle.
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
WEDGES = [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]
PYRAMIDS = [(0, 3, 2, 1, 8), (4, 5, 6, 7, 8), (0, 1, 5, 4, 8), (1, 2, 6, 5, 8), (2, 3, 7, 6, 8), (3, 0, 4, 7, 8)]
KINDS = {"Hex8": ("hexahedron", [tuple(range(8))]), "Pyramid5": ("pyramid", PYRAMIDS), "Tet4": ("tetra", TETRAHEDRA), "Wedge6": ("wedge", WEDGES)}
DEPTHS = 0.001, 0.01, 0.1


def block(low, high, counts, kind):
    """Coordinates and cells of a block that is divided into cubes, and these into cells of a kind."""
    axes = [np.linspace(a, b, count + 1) for a, b, count in zip(low, high, counts)]
    coords = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
    number = np.arange(len(coords)).reshape([count + 1 for count in counts])
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cubes = np.stack([number[tuple(slice(at, n + at) for at, n in zip(corner, counts))].ravel() for corner in corners], axis=1)
    cubes = np.column_stack([cubes, len(coords) + np.arange(len(cubes))])
    coords = np.concatenate([coords, coords[cubes[:, :8]].mean(axis=1)])
    used, cells = np.unique(cubes[:, KINDS[kind][1]].reshape(-1, len(KINDS[kind][1][0])), return_inverse=True)
    return coords[used], cells.reshape(-1, len(KINDS[kind][1][0]))


def forces(kind):
    """F / (k δ A) for each depth."""
    lower, upper = block((-1, -1, -1), (2, 2, 0), (7, 7, 3), kind), block((0, 0, 0), (1, 1, 1), (4, 4, 4), kind)
    cells = np.concatenate([lower[1], upper[1] + len(lower[0])])
    contact = Contact(np.concatenate([lower[0], upper[0]]), cells, KINDS[kind][0], stiffness=1.0)
    found = []
    for depth in np.array(DEPTHS) / 4:
        pressed = contact.evaluate(np.concatenate([lower[0], upper[0] - [0, 0, depth]]))
        found.append(pressed.bodies[1].force[2] / depth)
    return found


if __name__ == "__main__":
    depths = np.array(DEPTHS) / 4
    print("true depth", *[f"{value:.5f}" for value in 1 - depths + 2 / 3 * depths**2])
    for kind in KINDS:
        print(kind, *[f"{value:.5f}" for value in forces(kind)])
