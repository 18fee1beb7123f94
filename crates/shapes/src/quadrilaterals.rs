//! Outlines that several quadrilaterals make together.

use crate::{Mesh, quadrilateral_quad4};

/// Convex quadrilaterals, each given by its corners, counter-clockwise, and its cells along the first and the second side; joined
/// where their nodes meet, which common sides must be divided alike for.
pub fn quadrilaterals_quad4(parts: &[([[f64; 2]; 4], [usize; 2])]) -> Mesh<2> {
    let mut blocks = parts.iter().map(|&(corners, cells)| quadrilateral_quad4(corners, cells));
    let mut mesh = blocks.next().expect("at least one quadrilateral");
    blocks.for_each(|block| mesh.append(&block));
    let size = mesh.coords.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    mesh.welded(1e-9 * size)
}

#[cfg(test)]
mod tests {
    use super::quadrilaterals_quad4;

    #[test]
    fn quadrilaterals_become_one_body() {
        let bar = ([[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]], [6, 2]);
        let head = ([[3.0, 0.0], [4.0, -1.0], [4.0, 1.0], [3.0, 1.0]], [3, 2]);
        let mesh = quadrilaterals_quad4(&[bar, head]);
        assert!((mesh.measure() - 4.5).abs() < 1e-13 && mesh.smallest_jacobian() > 0.0);
        assert_eq!((mesh.euler_characteristic(), mesh.cell_count(), mesh.coords.len()), (1, 18, 10 * 3));
        assert_eq!(mesh.boundary().cell_count(), 2 * (6 + 3 + 2));
    }
}
