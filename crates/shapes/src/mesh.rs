//! Coordinates and connectivity.

/// Mesh of cells or facets of one kind, which `D` and `nodes_per_cell` tell:
///
/// | | 2 | 3 | 4 | 5 | 6 | 8 | 9 | 10 | 13 | 15 | 20 | 27 |
/// | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
/// | `D = 2` | edges (facets) | Tri3 | Quad4 | | Tri6 | Quad8 | Quad9 | | | | | |
/// | `D = 3` | | triangles (facets) | Tet4 | Pyramid5 | Wedge6 | Hex8 | | Tet10 | Pyramid13 | Wedge15 | Hex20 | Hex27 |
///
/// Node order is that of meshio. Cells have a positive Jacobian; facets have the body on their left (2D) or are
/// counter-clockwise seen from outside (3D).
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh<const D: usize> {
    /// Node coordinates, `[node_count, D]`.
    pub coords: Vec<[f64; D]>,
    /// Node ids, zero-based, `[cell_count, nodes_per_cell]`.
    pub conn: Vec<u32>,
    /// Nodes of a cell or facet.
    pub nodes_per_cell: usize,
}

impl<const D: usize> Mesh<D> {
    /// Number of cells (or facets).
    pub fn cell_count(&self) -> usize {
        self.conn.len() / self.nodes_per_cell
    }

    /// Node ids, cell by cell.
    pub fn cells(&self) -> impl Iterator<Item = &[u32]> {
        self.conn.chunks_exact(self.nodes_per_cell)
    }

    /// Facets of a surface mesh.
    ///
    /// # Panics
    /// For a mesh of cells; [`Mesh::boundary`] gives their facets.
    pub fn facets(&self) -> Vec<[u32; D]> {
        assert_eq!(self.nodes_per_cell, D, "a mesh of cells has no separate facets");
        self.cells().map(|facet| facet.try_into().unwrap()).collect()
    }

    /// Adds the cells and nodes of another mesh; its node ids are shifted by the nodes already here.
    ///
    /// # Panics
    /// If the cells are of another kind.
    pub fn append(&mut self, other: &Self) {
        assert_eq!(self.nodes_per_cell, other.nodes_per_cell, "meshes of two kinds of cells");
        let offset = self.coords.len() as u32;
        self.coords.extend_from_slice(&other.coords);
        self.conn.extend(other.conn.iter().map(|node| node + offset));
    }

    /// Only the nodes that a cell names, in their order.
    pub(crate) fn without_unused_nodes(self) -> Self {
        let mut used = vec![false; self.coords.len()];
        self.conn.iter().for_each(|&node| used[node as usize] = true);
        let mut coords = Vec::new();
        let mut new_id = vec![u32::MAX; self.coords.len()];
        for (node, x) in self.coords.iter().enumerate().filter(|(node, _)| used[*node]) {
            new_id[node] = coords.len() as u32;
            coords.push(*x);
        }
        Self { coords, conn: self.conn.iter().map(|&node| new_id[node as usize]).collect(), ..self }
    }
}

#[cfg(test)]
mod tests {
    use crate::rectangle_quad4;

    #[test]
    fn appended_ids_are_shifted() {
        let one = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [1, 1]);
        let mut two = one.clone();
        two.append(&one);
        assert_eq!(two.cells().nth(1).unwrap(), one.conn.iter().map(|n| n + 4).collect::<Vec<_>>());
    }
}
