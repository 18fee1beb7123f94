//! Spheres from the icosahedron.

use crate::Mesh;
use std::collections::HashMap;

/// Sphere about the origin: the icosahedron, its triangles divided in four `level` times, all nodes on the sphere.
///
/// 20·4^level triangles; level 5 has 20 480.
pub fn icosphere(radius: f64, level: usize) -> Mesh<3> {
    let mut mesh = icosahedron();
    for _ in 0..level {
        mesh = divided(&mesh);
    }
    mesh.mapped(|x| on_sphere(x, radius))
}

fn on_sphere(x: [f64; 3], radius: f64) -> [f64; 3] {
    let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
    x.map(|x| x * (radius / length))
}

/// Corners (0, ±1, ±φ) and their cyclic permutations, φ the golden ratio.
fn icosahedron() -> Mesh<3> {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let mut coords = Vec::new();
    for axis in 0..3 {
        for signs in [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]] {
            let mut x = [0.0; 3];
            x[(axis + 1) % 3] = signs[0];
            x[(axis + 2) % 3] = signs[1] * phi;
            coords.push(on_sphere(x, 1.0));
        }
    }
    // Triangles are the triples at edge distance, 2/√(1 + φ²) on the unit sphere, turned outwards.
    let near = |a: usize, b: usize| {
        let squared_distance: f64 = (0..3).map(|i: usize| (coords[a][i] - coords[b][i]).powi(2)).sum();
        squared_distance < 1.2
    };
    let mut conn = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in (b + 1..12).filter(|&c| near(a, b) && near(b, c) && near(a, c)) {
                let (x, y, z) = (coords[a], coords[b], coords[c]);
                let triple: f64 =
                    (0..3).map(|i| x[i] * (y[(i + 1) % 3] * z[(i + 2) % 3] - y[(i + 2) % 3] * z[(i + 1) % 3])).sum();
                conn.extend(if triple > 0.0 { [a, b, c] } else { [a, c, b] }.map(|node| node as u32));
            }
        }
    }
    Mesh { coords, conn, nodes_per_cell: 3 }
}

/// Every triangle in four, the new nodes pushed out to the unit sphere.
fn divided(mesh: &Mesh<3>) -> Mesh<3> {
    let mut coords = mesh.coords.clone();
    let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            let (x, y) = (coords[a as usize], coords[b as usize]);
            coords.push(on_sphere(std::array::from_fn(|i| x[i] + y[i]), 1.0));
            coords.len() as u32 - 1
        })
    };
    let mut conn = Vec::with_capacity(4 * mesh.conn.len());
    for t in mesh.cells() {
        let (a, b, c) = (t[0], t[1], t[2]);
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        conn.extend([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]);
    }
    Mesh { coords, conn, nodes_per_cell: 3 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn icosahedron_volume() {
        let edge = 4.0 / (10.0 + 20f64.sqrt()).sqrt(); // of the unit sphere
        let volume = 5.0 / 12.0 * (3.0 + 5f64.sqrt()) * edge.powi(3);
        assert!((icosphere(1.0, 0).measure() - volume).abs() < 1e-14);
    }

    #[test]
    fn spheres_are_closed_and_converge() {
        let mut last = f64::INFINITY;
        for level in 0..=5 {
            let mesh = icosphere(2.0, level);
            assert_eq!(mesh.cell_count(), 20 << (2 * level));
            assert_eq!(mesh.euler_characteristic(), 2);
            assert!(mesh.boundary_faces().is_empty());
            let error = 1.0 - mesh.measure() / (32.0 / 3.0 * PI);
            assert!(error > 0.0 && error < last / 3.0); // second order: a quarter each time, in the limit
            last = error;
        }
    }
}
