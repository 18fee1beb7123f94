"""The scene of the support matrix: a body with a slit that closes, and a block that presses on it, in 2D or 3D, of any cells.

          x---------x           the block; no two faces lie in one plane
       x--+--x---x--+---x
       |  x--+---+--x   |       the upper arm; the slit below it is open without deformation, and overlaps under load
       x-----x   x------x
       |     x----------x       the lower arm; obstacles reach into it from below
       x-----x----------x
"""

import numpy as np
from fmc_contact import Contact, PartitionedContact
from scenes import TETRA_OF_CUBE, K
from test_ranks import Meeting, Rank

EDGES = {
    "triangle": "01 12 20",
    "quad": "01 12 23 30",
    "tetra": "01 12 20 03 13 23",
    "hexahedron": "01 12 23 30 45 56 67 74 04 15 26 37",
    "wedge": "01 12 20 34 45 53 03 14 25",
    "pyramid": "01 12 23 30 04 14 24 34",
}
FACES = {"quad": "0123", "hexahedron": "0473 1265 0154 3762 0321 4567 01234567"}
OUTWARD = "0321 4567 0154 1265 2376 3047"
SECOND_ORDER = {
    "triangle6": "triangle",
    "quad8": "quad",
    "quad9": "quad",
    "tetra10": "tetra",
    "hexahedron20": "hexahedron",
    "hexahedron27": "hexahedron",
    "wedge15": "wedge",
    "pyramid13": "pyramid",
}
CUT = {
    "triangle": [[0, 1, 2], [0, 2, 3]],
    "tetra": TETRA_OF_CUBE,
    "wedge": [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]],
}
SLIT, TOP = 1.1, 2.0


def corners(words):
    return [[int(digit) for digit in word] for word in words.split()]


class Nodes:
    """Nodes by a name, each made once; without deformation, and under load."""

    def __init__(self):
        self.numbers, self.first, self.loaded = {}, [], []

    def at(self, name, first, loaded):
        if name not in self.numbers:
            self.numbers[name] = len(self.first)
            self.first.append(np.array(first, float))
            self.loaded.append(np.array(loaded, float))
        return self.numbers[name]

    def mean(self, nodes):
        """The node in the middle of some."""
        parts = [[rows[node] for node in nodes] for rows in (self.first, self.loaded)]
        return self.at(frozenset(int(node) for node in nodes), *(np.mean(part, axis=0) for part in parts))


def boxes(dim, hanging):
    """Low and high corners of the block's cells."""
    found = [([x, 2.02, 0.1][:dim], [x + 0.96, 3.0, 0.9][:dim]) for x in (0.53, 1.49)]
    if hanging:
        low, high = (np.array(corner) for corner in found.pop(1))
        half = (high - low) / 2
        found += [(low + half * np.array(at), low + half * (np.array(at) + 1)) for at in np.ndindex(*(2,) * dim)]
    return found


def body_with_slit(nodes, dim):
    """Cells of the body with a slit, 3 by 2."""
    x = np.linspace(0, 3, 4)

    def node(i, level, z):
        # Levels: 0 bottom, 1 lower lip of the slit, 2 upper lip, 3 top; the lips are one up to the slit's end.
        level = 1 if level == 2 and i < 2 else level
        along, across = (x[i] * 0.98, 0.05 + 0.9 * z) if level > 1 and i > 1 else (x[i], z)
        first = [along, (0, 1, SLIT, TOP)[level], across][:dim]
        loaded = [along, (0, 1, 0.98, TOP)[level], across][:dim]
        return nodes.at(("slit", i, level, z), first, loaded)

    layers = (0.0,) if dim == 2 else (0.0, 1.0)
    square = lambda i, low, high, z: [node(i, low, z), node(i + 1, low, z), node(i + 1, high, z), node(i, high, z)]
    return [[one for z in layers for one in square(i, low, high, z)] for low, high in ((0, 1), (2, 3)) for i in range(3)]


def block(nodes, dim, hanging):
    """Cells of the block, which is lowered onto the body."""
    around = [(0, 0), (1, 0), (1, 1), (0, 1)]
    cells = []
    for low, high in boxes(dim, hanging):
        ends = np.array([low, high])
        places = [(*xy, *z) for z in ([()] if dim == 2 else [(0,), (1,)]) for xy in around]
        of_cell = [ends[list(place), range(dim)] for place in places]
        cells.append([nodes.at(("block", *at.round(9)), at, at + [0.01, -0.06, 0][:dim]) for at in of_cell])
    return cells


def with_type(nodes, cells, kind):
    """Squares or cubes as cells of another type."""
    straight = SECOND_ORDER.get(kind, kind)
    cells = np.array(cells)
    if straight == "pyramid":
        cells = np.array([[*cell[face], nodes.mean(cell)] for cell in cells for face in np.array(corners(OUTWARD))[:, ::-1]])
    elif straight in CUT:
        cells = cells[:, np.array(CUT[straight])].reshape(-1, len(CUT[straight][0]))
    if kind == straight:
        return cells
    middles = [[nodes.mean(cell[edge]) for edge in corners(EDGES[straight])] for cell in cells]
    if kind in ("quad9", "hexahedron27"):
        middles = [[*row, *(nodes.mean(cell[face]) for face in corners(FACES[straight]))] for row, cell in zip(middles, cells)]
    return np.hstack([cells, middles])


class Scene:
    """A contact, and the coordinates at which it is asked.

    ``kind`` is the type of the cells, ``straight_block`` leaves the block at first order; ``surfaces``: facets instead of cells; ``parts``: a mesh
    in parts, of one rank; ``wavy``: round surfaces; ``first`` and ``x`` are coordinates of all unknowns without deformation and under load.
    """

    def __init__(self, dim, kind=None, hanging=False, surfaces=False, parts=False, straight_block=False, wavy=False, **options):
        nodes, kind = Nodes(), kind or ("quad" if dim == 2 else "hexahedron")
        lower = body_with_slit(nodes, dim)
        upper = block(nodes, dim, hanging)
        given = [(kind, with_type(nodes, lower, kind)), (SECOND_ORDER.get(kind, kind) if straight_block else kind, None)]
        given[1] = (given[1][0], with_type(nodes, upper, given[1][0]))
        first, place = np.unique(np.array(nodes.first).round(9), axis=0, return_inverse=True)
        given = [(name, place.ravel()[cells]) for name, cells in given]
        loaded = np.empty_like(first)
        loaded[place.ravel()] = nodes.loaded
        aside = np.eye(dim)[0] if options.get("axisymmetric") else np.zeros(dim)
        self.dim, self.is_in_parts, self.shift = dim, parts, aside[0]
        for rows in (first, loaded):
            rows[:, 1] += 0.03 * np.sin(2.2 * rows[:, 0]) * wavy
        self.first, self.x, self.is_cut = first + aside, loaded + aside, False
        options = {"stiffness": K, **options}
        if surfaces:
            facets = [boundary(cells, corners(EDGES["quad"] if dim == 2 else OUTWARD)) for _, cells in given]
            self.contact = Contact.from_facets(self.first, np.vstack(facets), "line" if dim == 2 else "quad", **options)
        elif parts:
            bodies = np.repeat([0, 1], [len(cells) for _, cells in given])
            own = {"node_numbers": np.arange(len(self.first)), "cell_numbers": np.arange(len(bodies)), "bodies": bodies}
            self.contact = PartitionedContact(Rank(Meeting(1), 0), self.first, given, **own, **options)
            self.contact.set_coords(self.x)
            self.x = self.contact.coords
        else:
            self.contact = Contact(self.first, given, **options)


def boundary(cells, faces):
    """Faces that one cell alone has."""
    every = np.vstack([cells[:, face] for face in faces])
    _, place, count = np.unique(np.sort(every, axis=1), axis=0, return_index=True, return_counts=True)
    return every[place[count == 1]]
