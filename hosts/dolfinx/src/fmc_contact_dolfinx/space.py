"""Supported displacements, and a rank's data of their nodes."""

from __future__ import annotations

from typing import Any

import basix
import numpy as np
from fmc_contact.other_basis import ROUNDING
from fmc_contact.second_order import MIDDLES, readings

from .cells import CELL_TYPES, SECOND_ORDER, TENSOR_ORDER, faces, places
from .versions import cell_dofs, cell_geometry, cell_name, geometry_layout


class LayoutError(TypeError):
    """Contact cannot read the degrees of freedom of a space as a displacement."""


def displacements(spaces: Any) -> list[Displacement]:
    """Spaces, checked: of one dimension, each of other bodies. Errors: ``LayoutError``."""
    found: list[Displacement] = []
    for number, space in enumerate(spaces):
        one = Displacement(space)
        for earlier, other in enumerate(found):
            if other.dim != one.dim:
                raise LayoutError(f"spaces[{earlier}] is in {other.dim}D and spaces[{number}] in {one.dim}D")
            if other.mesh is one.mesh:
                raise LayoutError(
                    f"spaces[{earlier}] and spaces[{number}] are on the same mesh, so that their bodies would be at the same "
                    "place: one space has all bodies of a mesh, and other spaces have other meshes"
                )
        found.append(one)
    return found


class Displacement:
    """A space of displacements, checked: Lagrange of order 1 or 2, a block of ``dim`` unknowns at every node, or another
    continuous element, blocks of unknowns of which the nodes are combinations."""

    def __init__(self, space: Any) -> None:
        mesh = getattr(space, "mesh", None)
        if mesh is None or not hasattr(space, "dofmap"):
            raise LayoutError(f"expected a function space, not a {type(space).__name__}")
        self.space, self.mesh, self.dim = space, mesh, mesh.geometry.dim
        self.facet_dim = mesh.topology.dim - 1
        if mesh.topology.dim != self.dim or self.dim not in (2, 3):
            raise LayoutError(
                f"the mesh has dimension {mesh.topology.dim} in {self.dim}D: expected bodies, not shells"
            )
        if space.dofmap.index_map_bs != self.dim:
            raise LayoutError(
                f"the space has {space.dofmap.index_map_bs} unknowns at a node, expected {self.dim}: a displacement"
            )
        self.kind = cell_name(mesh)
        cell = getattr(basix.CellType, self.kind)
        self.topology, self.layout = basix.topology(cell), space.dofmap.dof_layout
        self.has_faces_of_two_shapes = self.kind in ("prism", "pyramid")
        self.order = self._order()
        self.reading = self._reading() if self.order > 2 else None
        """Nodes of a cell by its unknowns, (nodes, unknowns), where these are not the nodes: ``order`` is then 3."""
        straight = CELL_TYPES[self.kind]
        self.cell_type = straight if self.order == 1 else SECOND_ORDER[self.kind]
        """As ``fmc_contact`` calls it."""
        self.places = places(self.kind, self.cell_type)
        """Dimension and number of what every node of a cell stands on, in the order of ``fmc_contact``."""
        self.faces = faces(self.kind)
        """The number that ``fmc_contact`` gives every facet of a cell."""
        self._geometry = geometry_layout(mesh)
        self.is_curved = self._geometry.num_dofs != len(self.topology[0])
        """Whether the middles of the cells' edges are given."""
        if self.is_curved and self.order > 2:
            raise LayoutError("curved cells need a displacement of Lagrange's second order")
        if self.is_curved and (self.order == 1 or self._geometry.num_dofs != len(self.places)):
            raise LayoutError(
                f"the cells have {self._geometry.num_dofs} geometry nodes, the displacement has "
                f"{len(self.places)}: expected straight cells, with {len(self.topology[0])}, or the same number"
            )
        self.owned = space.dofmap.index_map.size_local
        """Blocks that this rank owns; they come first."""

    def _order(self) -> int:
        """By the numbers of nodes on vertices, edges, ...; those inside straight cells, or simplices, move no face."""
        counts = [{len(self.layout.entity_dofs(d, e)) for e in range(len(of))} for d, of in enumerate(self.topology)]
        if counts[: self.dim] == [{1}, {0}, {0}][: self.dim]:
            return 1
        # A quadrilateral or a hexahedron has a node in its own middle too.
        is_tensor = self.kind in ("quadrilateral", "hexahedron")
        wanted = [{1}] * (self.dim + 1) if is_tensor else [{1}, {1}, {0}][: self.dim]
        if self.kind in SECOND_ORDER and counts[: len(wanted)] == wanted:
            return 2
        if self.kind in SECOND_ORDER and counts[0] == {1}:
            return 3
        raise LayoutError(
            f"the space does not have the nodes of Lagrange elements of order 1 or 2 on cells of type {self.kind}, "
            "nor does it have another continuous element on triangles, quadrilaterals, tetrahedra or hexahedra"
        )

    def _reading(self) -> np.ndarray:
        element = self.space.element
        if element.needs_dof_transformations:
            raise LayoutError(
                "the functions of the space are turned from cell to cell: expected Lagrange elements, or serendipity of second "
                "order"
            )
        straight = CELL_TYPES[self.kind]
        corners = basix.geometry(getattr(basix.CellType, self.kind))[TENSOR_ORDER[straight]]
        places_, weights, unread = readings(SECOND_ORDER[self.kind], corners)
        values = np.asarray(element.basix_element.tabulate(0, places_))[0]
        values = values.reshape(len(places_), -1)
        if values.shape[1] != self.layout.num_dofs:
            raise LayoutError("the functions of the space are vectors: expected one component per block")
        if len(unread) and np.abs(unread @ values).max() > ROUNDING:
            raise LayoutError(
                "the space has functions on the faces of tetrahedra that nodes of second order cannot follow: expected Lagrange "
                "elements of order 1 or 2"
            )
        return weights @ values

    def node_blocks(self) -> np.ndarray:
        """Blocks of the nodes of all cells here, ghosts last, (cells, nodes), in the order of ``fmc_contact``."""
        return cell_dofs(self.space)[:, [self.layout.entity_dofs(*place)[0] for place in self.places]]

    def corner_geometry(self) -> np.ndarray:
        """Geometry nodes of the corners of all cells here, ghosts last, (cells, corners), as dolfinx counts them."""
        local = [self._geometry.entity_dofs(0, corner)[0] for corner in range(len(self.topology[0]))]
        return cell_geometry(self.mesh)[:, local]

    def given_geometry(self, count: int) -> np.ndarray:
        """Geometry nodes of the first cells' nodes in the order of ``fmc_contact``: of corners, or, where they are
        curved, of all."""
        given = self.places if self.is_curved else self.places[: len(self.topology[0])]
        return cell_geometry(self.mesh)[:count][:, [self._geometry.entity_dofs(*place)[0] for place in given]]

    def node_coords(self, count: int) -> np.ndarray:
        """Undeformed places of the nodes of the first cells, (count, nodes, dim), in the order of ``fmc_contact``."""
        x = self.mesh.geometry.x[self.given_geometry(count)][:, :, : self.dim]
        if self.is_curved:
            return x
        middles = [x[:, list(ends)].mean(axis=1) for ends in MIDDLES.get(self.cell_type, [])]
        return np.concatenate([x, *(at[:, None] for at in middles)], axis=1)

    def global_blocks(self, blocks: np.ndarray) -> np.ndarray:
        """Numbers over all ranks, int64, of blocks of this rank, in their shape."""
        index_map = self.space.dofmap.index_map
        flat = np.ascontiguousarray(blocks, np.int32).ravel()
        return np.asarray(index_map.local_to_global(flat), np.int64).reshape(np.shape(blocks))

    def owned_values(self, u: Any) -> np.ndarray:
        """Values of the blocks that this rank owns, (owned, dim), of a function, a PETSc vector or an array."""
        if hasattr(u, "x"):
            values = u.x.array
        elif hasattr(u, "array_r"):
            values = u.array_r
        else:
            values = np.asarray(u)
        count = self.owned * self.dim
        if values.ndim != 1 or len(values) < count:
            raise ValueError(f"the displacement has shape {values.shape} here, expected ({count},)")
        return values[:count].reshape(-1, self.dim)

    def facet_nodes(self) -> list[tuple[list[int], list[int]]]:
        """For every facet of a cell its corners, in order around it, and their nodes, both ways round: first order."""
        if self.has_faces_of_two_shapes:
            raise LayoutError(f"the faces of {self.kind}s are of two shapes and cannot be divided: pass the whole mesh")
        found = []
        for corners in self.topology[self.facet_dim]:
            around = list(corners) if len(corners) < 4 else [corners[k] for k in (0, 1, 3, 2)]
            for turned in (around, around[::-1]):
                found.append((turned, [self.layout.entity_dofs(0, corner)[0] for corner in turned]))
        return found
