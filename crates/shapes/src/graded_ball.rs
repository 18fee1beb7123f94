//! Half-balls whose cells are small about the point where they will be pressed: the graded half-disc of the plane, turned
//! about its axis.

use crate::Mesh;
use crate::graded_disc::on_ring;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// The part x, y ≥ 0 of a half-ball in tetrahedra: its pole at the origin, its flat side at z = `radius`.
///
/// Shells about the pole, spheres there and the flat side at last, each in `edges`² triangles; the first has the radius
/// `finest`, and every other is as much farther out as its triangles are wide.
pub fn graded_quarter_half_ball_tet4(radius: f64, finest: f64, edges: usize) -> Mesh<3> {
    assert!(finest > 0.0 && finest < radius && edges > 1, "shells of {edges} edges from {finest} to {radius}");
    let growth = (SQRT_2 * radius / finest).ln();
    let shells = (growth / (FRAC_PI_2 / edges as f64).ln_1p()).round().max(1.0) as usize;
    let mut coords = vec![[0.0; 3]];
    for shell in 0..=shells {
        let r = if shell == shells { SQRT_2 * radius } else { finest * (growth * shell as f64 / shells as f64).exp() };
        for row in 0..=edges {
            let [rho, z] = on_ring(radius, r, row as f64 / edges as f64);
            coords.extend((0..=row).map(|k| {
                let (sine, cosine) = (FRAC_PI_2 * k as f64 / row.max(1) as f64).sin_cos();
                // The planes of symmetry exactly.
                [if k == row && row > 0 { 0.0 } else { rho * cosine }, if k == 0 { 0.0 } else { rho * sine }, z]
            }));
        }
    }
    let node = |row: usize, k: usize| (row * (row + 1) / 2 + k) as u32;
    let up = (0..edges).flat_map(|row| (0..=row).map(move |k| [(row, k), (row + 1, k), (row + 1, k + 1)]));
    let down = (0..edges).flat_map(|row| (0..row).map(move |k| [(row, k), (row + 1, k + 1), (row, k + 1)]));
    let triangles: Vec<[u32; 3]> = up.chain(down).map(|t| t.map(|(row, k)| node(row, k))).collect();
    let per_shell = node(edges + 1, 0);
    let mut conn = Vec::new();
    for triangle in &triangles {
        conn.extend([0, 1 + triangle[0], 1 + triangle[1], 1 + triangle[2]]);
        for shell in 0..shells as u32 {
            // A prism in three, about its node of lowest number; every side is cut from its own.
            let mut a = triangle.map(|n| 1 + n + shell * per_shell);
            a.sort_unstable();
            let b = a.map(|n| n + per_shell);
            conn.extend([a[0], b[0], b[1], b[2]]);
            conn.extend([a[0], a[1], a[2], b[2]]);
            conn.extend([a[0], a[1], b[1], b[2]]);
        }
    }
    Mesh { coords, conn, nodes_per_cell: 4 }.oriented()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn graded_half_balls_are_round_and_whole() {
        let (radius, edges) = (50.0, 12);
        let mesh = graded_quarter_half_ball_tet4(radius, 1.0, edges);
        let volume = std::f64::consts::PI * radius.powi(3) / 6.0;
        assert!(mesh.smallest_jacobian() > 0.0);
        assert!((mesh.measure() / volume - 1.0).abs() < 0.02, "{} of {volume}", mesh.measure());
        // Pole, sphere, two planes of symmetry and the flat side: every face of the boundary lies on one of them.
        for face in mesh.boundary_faces() {
            let on = |test: &dyn Fn([f64; 3]) -> bool| face.iter().all(|&n| test(mesh.coords[n as usize]));
            let sphere = |x: [f64; 3]| (x[0].hypot(x[1]).hypot(x[2] - radius) - radius).abs() < 1e-9;
            let flat = |x: [f64; 3]| (x[2] - radius).abs() < 1e-9;
            assert!(on(&sphere) || on(&flat) || on(&|x| x[0] == 0.0) || on(&|x| x[1] == 0.0));
        }
    }
}
