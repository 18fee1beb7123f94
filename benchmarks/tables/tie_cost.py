"""What a tie costs, beside a contact of as many facets.

    python benchmarks/tables/tie_cost.py [EDGES]

Two layers of cubes of 224 x 224 and 223 x 223 (or of EDGES and one less), one on the other: 1e5 facets that face each other. They are in contact,
1e-3 of a facet deep, or tied; on one thread. Printed are processor times, the least of three: the first evaluation, an evaluation at other
coordinates, and a tangent with forces, and their ratios of tie to contact. Needs fmc_contact alone; a minute.
"""

import sys
import time

import numpy as np
from fmc_contact import Contact

EDGES = 224


def layer(edges, low, first):
    """Cubes over the unit square, one upon it."""
    ticks, up = np.linspace(0, 1, edges + 1), np.array([low, low + 1 / edges])
    points = np.stack(np.meshgrid(ticks, ticks, up, indexing="ij"), -1).reshape(-1, 3)
    k = np.arange(first, first + len(points)).reshape(edges + 1, edges + 1, 2)
    around = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return points, np.stack([k[i : i + edges, j : j + edges, m].ravel() for m in (0, 1) for i, j in around], 1)


def meshes(edges, depth):
    lower, upper = layer(edges, -1 / edges, 0), layer(edges - 1, -depth, 2 * (edges + 1) ** 2)
    return np.concatenate([lower[0], upper[0]]), np.concatenate([lower[1], upper[1]])


def seconds(function, *words):
    begun = time.process_time()
    function(*words)
    return time.process_time() - begun


def measured(edges, is_tied):
    """Seconds of the first evaluation, of a later one, and of forces with tangent. The tie is found by the first."""
    coords, cells = meshes(edges, 0.0 if is_tied else 1e-3 / edges)
    contact = Contact(coords, cells, "hexahedron", stiffness=1.0, threads=1)
    begun = time.process_time()
    if is_tied:
        contact.pairs.set(0, 1, interface="tied")
    contact.evaluate(coords)
    first = time.process_time() - begun
    random = np.random.default_rng(1)
    # Moved a little, so that nothing is kept from the evaluation before.
    moved = [coords + 1e-5 / edges * random.standard_normal(coords.shape) for _ in range(6)]
    later = min(seconds(contact.evaluate, x) for x in moved[:3])
    return first, later, min(seconds(contact.evaluate_tangent, x) for x in moved[3:])


if __name__ == "__main__":
    edges = int(sys.argv[1]) if len(sys.argv) > 1 else EDGES
    contact, tie = measured(edges, False), measured(edges, True)
    print(f"{edges**2 + (edges - 1) ** 2} facets")
    for name, one, other in zip(("first", "later", "with tangent"), contact, tie):
        print(f"{name}: contact {one:.2f} s, tie {other:.2f} s, ratio {other / one:.2f}")
    print(f"the tie is found in {tie[0] - tie[1]:.2f} s, by a later evaluation of the contact {(tie[0] - tie[1]) / contact[1]:.2f}")
