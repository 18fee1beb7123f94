"""Which displacements can be read, and what a rank knows of their nodes."""

from __future__ import annotations

from typing import Any

import basix
import numpy as np

from .versions import cell_dofs, cell_geometry, cell_name


class LayoutError(TypeError):
    """The degrees of freedom of a space are not those of a displacement that contact can read."""


class Displacement:
    """A space of displacements, checked: Lagrange of order 1 or 2, a block of ``dim`` unknowns at every node."""

    def __init__(self, space: Any) -> None:
        mesh = getattr(space, "mesh", None)
        if mesh is None or not hasattr(space, "dofmap"):
            raise LayoutError(f"a function space is wanted, this is a {type(space).__name__}")
        self.space, self.mesh, self.dim = space, mesh, mesh.geometry.dim
        self.facet_dim = mesh.topology.dim - 1
        if mesh.topology.dim != self.dim or self.dim not in (2, 3):
            raise LayoutError(
                f"the mesh has dimension {mesh.topology.dim} in {self.dim}D: bodies are wanted, no shells"
            )
        if space.dofmap.index_map_bs != self.dim:
            raise LayoutError(
                f"the space has {space.dofmap.index_map_bs} unknowns at a node, {self.dim} are wanted: a displacement"
            )
        self.kind = cell_name(mesh)
        cell = getattr(basix.CellType, self.kind)
        self.topology, self.layout = basix.topology(cell), space.dofmap.dof_layout
        self.has_faces_of_two_shapes = self.kind in ("prism", "pyramid")
        self.order = self._order()
        corners = cell_geometry(mesh).shape[1]
        if corners != len(self.topology[0]):
            raise LayoutError(
                f"the cells have {corners} geometry nodes, straight ones are wanted: {len(self.topology[0])}"
            )
        self.owned = space.dofmap.index_map.size_local
        """Blocks that this rank owns; they come first."""

    def _order(self) -> int:
        counts = [{len(self.layout.entity_dofs(d, e)) for e in range(len(self.topology[d]))} for d in range(self.dim)]
        quads = self.dim == 3 and self.kind == "hexahedron"
        if counts == [{1}, {0}, {0}][: self.dim]:
            return 1
        if counts == [{1}, {1}, {1} if quads else {0}][: self.dim]:
            return 2
        raise LayoutError(
            f"the nodes of the space are not those of Lagrange elements of order 1 or 2 on cells of type {self.kind}"
        )

    def corner_blocks(self) -> np.ndarray:
        """Blocks of the corners of all cells here, ghosts last, (cells, corners), as the geometry counts them."""
        local = [self.layout.entity_dofs(0, corner)[0] for corner in range(len(self.topology[0]))]
        return cell_dofs(self.space)[:, local]

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
            raise ValueError(f"the displacement has shape {values.shape} here, ({count},) is wanted")
        return values[:count].reshape(-1, self.dim)

    def facet_nodes(self) -> list[tuple[list[int], list[int]]]:
        """For every facet of a cell its corners, in order around it, and its nodes as ``fmc_contact.trace`` draws
        them."""
        if self.has_faces_of_two_shapes:
            raise LayoutError(f"the faces of {self.kind}s are of two shapes and cannot be divided: pass the whole mesh")
        edges = {frozenset(edge): number for number, edge in enumerate(self.topology[1])}
        found = []
        for facet, corners in enumerate(self.topology[self.facet_dim]):
            around = list(corners) if len(corners) < 4 else [corners[k] for k in (0, 1, 3, 2)]
            for turned in (around, around[::-1]):
                nodes = [self.layout.entity_dofs(0, corner)[0] for corner in turned]
                if self.order == 2:
                    sides = [(turned[0], turned[1])] if self.dim == 2 else list(zip(turned, turned[1:] + turned[:1]))
                    nodes += [self.layout.entity_dofs(1, edges[frozenset(side)])[0] for side in sides]
                    if len(turned) == 4:
                        nodes.append(self.layout.entity_dofs(2, facet)[0])
                found.append((turned, nodes))
        return found
