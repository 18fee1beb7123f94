"""Which displacements can be read: vector fields of first or second order, one Lagrange element a cell."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import getfem as gf
import numpy as np

from .cells import face_number, nearest, of_places
from .errors import LayoutError

_WHOLE = 65535
"""Number of the face of a cell that is in a region as a whole."""


class Field(NamedTuple):
    """One variable, as contact sees it. Its nodes are the points of the mesh that have unknowns, then the other places with
    unknowns, each in the order of GetFEM's numbers."""

    space: gf.MeshFem
    mesh: gf.Mesh
    """Kept: GetFEM finds neither once their last Python object is gone."""
    cells: list[tuple[str, np.ndarray, np.ndarray]]
    """Type, nodes (cells, nodes) in the order of ``fmc_contact``, and numbers of the cells among those of the variable."""
    dofs: np.ndarray
    """Unknowns of the nodes within the variable, (nodes, dim)."""
    coords: np.ndarray
    """Undeformed coordinates of the nodes, (nodes, dim)."""

    @property
    def size(self) -> int:
        """Number of unknowns of the variable."""
        return self.dofs.size

    def faces_on(self, regions: Sequence[int]) -> np.ndarray:
        """Faces of the cells in regions of the mesh: place of their cell in ``cells``, block after block, and their number in it as
        ``BoundaryFacets`` counts them, (faces, 2)."""
        numbers = np.asarray(self.space.convex_index())
        named = np.concatenate([np.empty((2, 0), int), *(self.mesh.region(region) for region in regions)], axis=1)
        is_face = (named[1] >= 0) & (named[1] < _WHOLE)
        named = np.unique(named[:, np.isin(named[0], numbers) & is_face], axis=1)
        kinds = np.empty(len(numbers), object)
        for kind, _, chosen in self.cells:
            kinds[chosen] = kind.rstrip("0123456789")
        contact_cell = np.argsort(np.concatenate([chosen for *_, chosen in self.cells]))
        order = np.argsort(numbers)
        cell = order[np.searchsorted(numbers[order], named[0])]
        found = np.column_stack([contact_cell[cell], np.empty(len(cell), int)])
        for transform, of_it in _of_cells(self.mesh.geotrans(), self.mesh, numbers):
            (here,) = np.nonzero(np.isin(cell, of_it))
            for face in np.unique(named[1, here]):
                at = here[named[1, here] == face]
                found[at, 1] = face_number(kinds[cell[at[0]]], transform, self.mesh.cvstruct(numbers[cell[at[0]]]), face)
        return found


def fields(model: gf.Model, variables: list[str]) -> dict[str, Field]:
    """Displacements of a model, checked: of one dimension, each of other cells."""
    found: dict[str, Field] = {}
    for name in variables:
        if name in found:
            raise LayoutError(f"'{name}' is named twice")
        one = field(model, name)
        for earlier, other in found.items():
            dims = other.coords.shape[1], one.coords.shape[1]
            if dims[0] != dims[1]:
                raise LayoutError(f"'{earlier}' is in {dims[0]}D and '{name}' in {dims[1]}D")
            if other.mesh.id == one.mesh.id:
                both = np.intersect1d(other.space.convex_index(), one.space.convex_index())
                if both.size:
                    raise LayoutError(
                        f"'{earlier}' and '{name}' both move cell {both[0]} of the same mesh, so that their bodies would be at "
                        "the same place: every variable moves separate cells"
                    )
        found[name] = one
    return found


def field(model: gf.Model, variable: str) -> Field:
    """A displacement of a model, checked."""
    try:
        space = model.mesh_fem_of_variable(variable)
        mesh = space.mesh()
    except RuntimeError as error:
        raise LayoutError(
            f"GetFEM has no mesh_fem or no mesh of '{variable}' (are their Python objects still there?): {error}"
        ) from None
    dim = mesh.dim()
    if dim not in (2, 3) or space.qdim() != dim:
        raise LayoutError(f"'{variable}' has {space.qdim()} components in {dim}D, expected a displacement")
    if space.is_reduced():
        raise LayoutError(f"'{variable}' is of a mesh_fem that is reduced: contact needs its basic unknowns")
    numbers = np.asarray(space.convex_index())
    if not len(numbers):
        raise LayoutError(f"'{variable}' has no elements")
    kinds, transforms = _of_cells(space.fem(), mesh, numbers), _of_cells(mesh.geotrans(), mesh, numbers)
    nodes_of, points_of = [], []
    cells: dict[str, list[tuple[np.ndarray, np.ndarray]]] = {}
    for element, chosen in kinds:
        name, order = _ordered(variable, element)
        unknowns = space.basic_dof_from_cvid(numbers[chosen])[0].reshape(len(chosen), -1, dim)
        if (np.diff(unknowns, axis=2) != 1).any():
            raise LayoutError(f"'{variable}' has the unknowns of a node apart: expected a vector field of one element")
        nodes = unknowns[:, :, 0] // dim
        cells.setdefault(name, []).append((nodes[:, order], chosen))
        nodes_of.append(nodes)
        points_of.append(_points(variable, mesh, numbers, chosen, element, transforms))
    # A node at a point of the mesh has its number, any other comes after all points.
    count = space.nb_basic_dof() // dim
    rank = np.full(count, -1)
    for nodes, points in zip(nodes_of, points_of):
        rank[nodes] = np.where(points < 0, mesh.max_pid() + 1 + nodes, points)
    order_of_nodes = np.argsort(rank, kind="stable")
    number = np.argsort(order_of_nodes)
    blocks = [
        (name, number[np.concatenate([nodes for nodes, _ in parts])], np.concatenate([chosen for _, chosen in parts]))
        for name, parts in cells.items()
    ]
    coords = np.ascontiguousarray(space.basic_dof_nodes()[:, ::dim].T[order_of_nodes])
    return Field(space, mesh, blocks, dim * order_of_nodes[:, None] + np.arange(dim), coords)


def _of_cells(found: tuple, mesh: gf.Mesh, numbers: np.ndarray) -> list[tuple[object, np.ndarray]]:
    """Elements or transformations, each with the places of its cells in ``numbers``; GetFEM gives a list where there are several."""
    objects, of_cells = found
    objects = objects if isinstance(objects, (list, tuple)) else [objects]
    # Of all cells that there are: numbers of cells that were deleted are left out.
    kind = np.asarray(of_cells)[np.searchsorted(mesh.cvid(), numbers)]
    return [(one, np.flatnonzero(kind == index)) for index, one in enumerate(objects) if (kind == index).any()]


def _ordered(variable: str, element: gf.Fem) -> tuple[str, np.ndarray]:
    """Type of the cells with this element, and its nodes in the order of ``fmc_contact``."""
    if element.is_lagrange() and element.target_dim() == 1 and "DISCONTINUOUS" not in element.char():
        found = of_places(element.pts().T)
        if found is not None:
            return found
    raise LayoutError(
        f"'{variable}' has the element {element.char()}, which contact cannot read: expected continuous Lagrange elements of first or "
        "second order"
    )


def _points(
    variable: str, mesh: gf.Mesh, numbers: np.ndarray, chosen: np.ndarray, element: gf.Fem, transforms: list
) -> np.ndarray:
    """Points of the mesh at the nodes of an element, (cells, nodes), −1 where there is none."""
    places = element.pts().T
    found = np.full((len(chosen), len(places)), -1)
    for transform, of_it in transforms:
        here = np.isin(chosen, of_it)
        if not here.any():
            continue
        node, all_there = nearest(transform.pts().T, places)
        if not all_there:
            raise LayoutError(
                f"'{variable}' has cells of {transform.char()}, more curved than its element {element.char()}: expected the same "
                "order"
            )
        points = mesh.pid_from_cvid(numbers[chosen[here]])[0].reshape(here.sum(), -1)
        found[np.ix_(here, node)] = points
    return found
