"""Two blocks one on the other, of meshes that do not match."""

import numpy as np
from dolfinx.mesh import locate_entities_boundary, meshtags
from fmc_contact_dolfinx import set_by_input_number
from fmc_contact_dolfinx.space import Displacement
from fmc_contact_dolfinx.surface import whole
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from mpi4py import MPI

COMM = MPI.COMM_WORLD
NAMES = {"triangle": 2, "quad": 2, "tetra": 3, "hexahedron": 3}


def block(kind, count, low, high):
    """Nodes, (n, dim), and cells in VTK's order of a block, of so many cells along every axis, or along each."""
    dim = NAMES[kind]
    counts = np.broadcast_to(count, dim)
    ticks = [np.linspace(low[a], high[a], counts[a] + 1) for a in range(dim)]
    x = np.stack(np.meshgrid(*ticks, indexing="ij"), axis=-1).reshape(-1, dim)
    number = np.arange(len(x)).reshape(counts + 1)
    at = lambda *s: number[tuple(slice(k, k + n) for k, n in zip(s, counts))].ravel()
    if dim == 2:
        cells = np.stack([at(0, 0), at(1, 0), at(1, 1), at(0, 1)], axis=1)
        if kind == "triangle":
            cells = np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
        return x, cells
    around = ((0, 0), (1, 0), (1, 1), (0, 1))
    cells = np.stack([at(*corner, k) for k in (0, 1) for corner in around], axis=1)
    if kind == "tetra":
        paths = ([0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6])
        cells = np.concatenate([cells[:, path] for path in paths])
    return x, cells


def blocks(kind, lower=3, upper=2):
    """Nodes and cells of a unit block and of another above it, 0.02 into it. The upper one bulges downwards, so that
    they touch in the middle and not at their walls, where the law "fiber" has steps."""
    dim = NAMES[kind]
    x, cells = block(kind, lower, [0.0] * dim, [1.0] * dim)
    y, more = block(kind, upper, [0.1] * (dim - 1) + [0.98], [0.9] * (dim - 1) + [1.98])
    y[:, -1] += 0.4 * ((y[:, :-1] - 0.47) ** 2).sum(axis=1) * (1.98 - y[:, -1])
    return np.concatenate([x, y]), np.concatenate([cells, more + len(x)])


def sliced(kind):
    """Two blocks one on the other that end at x = 0; in 3D a slice one cell thick, so that all nodes lie in its ends."""
    dim = NAMES[kind]
    thick = 0.0, 0.3
    x, cells = block(kind, (8, 3, 1)[:dim], (0.0, -1.0, thick[0]), (1.0, 0.0, thick[1]))
    y, more = block(kind, (5, 3, 1)[:dim], (0.0, -0.02, thick[0]), (0.6, 0.9, thick[1]))
    return np.concatenate([x, y]), np.concatenate([cells, more + len(x)])


def cracked():
    """A block on the part 0.375 < x of its lower side; the rest is a crack, and a block lies in it."""
    x, cells = block("quad", 8, [0.0, 0.0], [1.0, 1.0])
    y, more = block("quad", 4, [0.05, -0.3], [0.2, 0.01])
    return np.concatenate([x, y]), np.concatenate([cells, more + len(x)])


def tagged(mesh, **planes):
    """Tags of the facets of a mesh in planes, 1, 2, ..., each by a function of places."""
    dim = mesh.topology.dim
    mesh.topology.create_connectivity(dim - 1, dim)
    found = [locate_entities_boundary(mesh, dim - 1, of) for of in planes.values()]
    facets, tags = np.concatenate(found), np.repeat(np.arange(1, 1 + len(found)), [len(of) for of in found])
    order = np.argsort(facets)
    return meshtags(mesh, dim - 1, facets[order].astype(np.int32), tags[order].astype(np.int32))


def bodies(kind):
    """A row of bodies of three sizes on a slab, each a little into it."""
    dim = NAMES[kind]
    long = [3.0] + [1.0] * (dim - 2)
    x, cells = block(kind, 6, [0.0] * dim, [*long, 0.8])
    for number, (count, start) in enumerate(((3, 0.1), (2, 1.0), (4, 1.9))):
        low = [start] + [0.1] * (dim - 2) + [0.79 - 0.003 * number]
        y, more = block(kind, count, low, [start + 0.7] + [0.85] * (dim - 2) + [1.5])
        # On an edge, as walls must not coincide.
        y[:, -1] += 0.02 * (y[:, 0] - start)
        cells = np.concatenate([cells, more + len(x)])
        x = np.concatenate([x, y])
    return x, cells


def permuted(x, cells, seed=3):
    """The same mesh with nodes and cells in another order; and the old number of every new node."""
    random = np.random.default_rng(seed)
    old = random.permutation(len(x))
    new = np.argsort(old)
    return x[old], new[cells][random.permutation(len(cells))], old


def space(kind, order=1, comm=COMM, x=None, cells=None):
    if x is None:
        x, cells = blocks(kind)
    return vector_space(mesh_from_cells(comm, x, cells, kind), order)


def interpolate(function, size=3e-3):
    """A smooth displacement, by places, so that it does not depend on numbers or ranks."""
    function.interpolate(lambda x: wave(x, function.function_space.mesh.geometry.dim, size))
    function.x.scatter_forward()
    return function


def wave(x, dim, size=3e-3):
    """The same at places (dim, n)."""
    return size * np.stack([np.sin((3.0 + a) * x[0] + 2.0 * x[dim - 1] + (x[1] if dim > 2 else 0.0)) for a in range(dim)])


def set_wave(function, shift=0.0):
    """The same, bit by bit on any number of ranks; the upper ones of ``bodies`` are shifted along the first axis."""
    shown = whole(Displacement(function.function_space), None)
    x = shown.undeformed.T
    at = wave(x, len(x)).T
    # The slab's top is at 0.8.
    at[(x[-1] > 0.78) & ~np.isclose(x[-1], 0.8), 0] += shift
    set_by_input_number(function, at)
    return function
