//! What part of the surface belongs to a node.

use fmc_contact::Surface;

/// Area (2D: length) of surface that belongs to every node, `[node_count]`: an equal part of each face it is a corner
/// of. A quadrilateral face is the four triangles about its centroid.
pub(super) fn surface_areas<const D: usize>(surface: &Surface<D>, coords: &[[f64; D]]) -> Vec<f64> {
    let mut areas = vec![0.0; coords.len()];
    for (_, face) in surface.faces() {
        let corners: Vec<[f64; D]> = face.iter().map(|&node| coords[node as usize]).collect();
        let area = match corners[..] {
            [a, b] => norm(&minus(&b, &a)),
            [a, b, c] => triangle(&a, &b, &c),
            _ => {
                let mean =
                    std::array::from_fn(|axis| corners.iter().map(|x| x[axis]).sum::<f64>() / corners.len() as f64);
                let next = corners.iter().cycle().skip(1);
                corners.iter().zip(next).map(|(a, b)| triangle(a, b, &mean)).sum()
            }
        };
        for &node in &face {
            areas[node as usize] += area / face.len() as f64;
        }
    }
    areas
}

fn minus<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn norm<const D: usize>(a: &[f64; D]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// ½ √(|p|²|q|² − (p·q)²) for the edges p, q.
fn triangle<const D: usize>(a: &[f64; D], b: &[f64; D], c: &[f64; D]) -> f64 {
    let (p, q) = (minus(b, a), minus(c, a));
    let dot: f64 = p.iter().zip(&q).map(|(x, y)| x * y).sum();
    0.5 * ((norm(&p) * norm(&q)).powi(2) - dot * dot).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmc_contact::{Bodies, CellBlock, CellType};
    use fmc_shapes::{cuboid_hex8, cuboid_tet4, rectangle_quad4};

    #[test]
    fn node_areas_sum_to_the_surface() {
        fn total<const D: usize>(mesh: &fmc_shapes::Mesh<D>, cell_type: CellType) -> f64 {
            let blocks = [CellBlock { cell_type, conn: &mesh.conn }];
            let surface = Surface::from_cells(&mesh.coords, &blocks, Bodies::Connected).unwrap();
            surface_areas(&surface, &mesh.coords).iter().sum()
        }
        assert!((total(&rectangle_quad4([0.0; 2], [2.0, 3.0], [4, 5]), CellType::Quad4) - 10.0).abs() < 1e-12);
        assert!((total(&cuboid_tet4([0.0; 3], [1.0, 2.0, 3.0], [2, 3, 4]), CellType::Tet4) - 22.0).abs() < 1e-12);
        assert!((total(&cuboid_hex8([0.0; 3], [1.0, 2.0, 3.0], [2, 3, 4]), CellType::Hex8) - 22.0).abs() < 1e-12);
    }
}
