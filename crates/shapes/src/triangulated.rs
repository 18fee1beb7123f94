//! Quadrilaterals cut into triangles.

use crate::Mesh;

impl Mesh<2> {
    /// `Quad4` cells cut into two `Tri3` each, where `forward(cell, corners)` says so along 0–2, else along 1–3.
    pub(crate) fn cut(self, forward: impl Fn(usize, [[f64; 2]; 4]) -> bool) -> Self {
        assert_eq!(self.nodes_per_cell, 4, "only quadrilaterals can be cut");
        let conn = self
            .cells()
            .enumerate()
            .flat_map(|(cell, q)| {
                let corners = std::array::from_fn(|k| self.coords[q[k] as usize]);
                if forward(cell, corners) {
                    [q[0], q[1], q[2], q[0], q[2], q[3]]
                } else {
                    [q[0], q[1], q[3], q[1], q[2], q[3]]
                }
            })
            .collect();
        Self { coords: self.coords, conn, nodes_per_cell: 3 }
    }

    /// `Quad4` cells cut along their shorter diagonal.
    pub fn triangulated(self) -> Self {
        let squared_distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2);
        self.cut(|_, x| squared_distance(x[0], x[2]) <= squared_distance(x[1], x[3]))
    }
}

#[cfg(test)]
mod tests {
    use crate::quadrilateral_quad4;

    #[test]
    fn shorter_diagonal_is_cut() {
        let mesh = quadrilateral_quad4([[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [1.0, 1.0]], [1, 1]).triangulated();
        assert_eq!((mesh.conn.len(), mesh.measure()), (6, 1.0));
        assert!((mesh.smallest_jacobian() - 1.0).abs() < 1e-15);
    }
}
