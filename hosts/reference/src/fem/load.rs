//! Loads that do not follow the deformation.

use super::elements::circumference;
use super::face_quadrature::{FacePoint, face_points};
use super::{Face, Model};

impl<const D: usize> Model<D> {
    /// Nodal forces ∫ N_a t dA of a traction on undeformed faces: `traction(x, n)` in Pa at place x, n the unit outward
    /// normal.
    ///
    /// Exact for constant and linear tractions on edges, triangles and parallelograms, and for uniform pressure on curved faces
    /// of second order.
    pub fn surface_load(&self, faces: &[Face], traction: impl Fn(&[f64; D], &[f64; D]) -> [f64; D]) -> Vec<[f64; D]> {
        let mut load = vec![[0.0; D]; self.node_count()];
        for face in faces {
            let x: Vec<[f64; D]> = face.nodes.iter().map(|&node| self.coords()[node as usize]).collect();
            for FacePoint { shape, slopes, weight } in face_points(D, face.nodes.len()) {
                let place: [f64; D] = std::array::from_fn(|i| x.iter().zip(&shape).map(|(x, s)| x[i] * s).sum());
                let area = normal(match slopes {
                    None => straight_tangents(&x, &shape),
                    Some(slopes) => curved_tangents(&x, &slopes),
                });
                let length = area.iter().map(|a| a * a).sum::<f64>().sqrt();
                let t = traction(&place, &area.map(|a| a / length));
                let size = if self.is_axisymmetric() { length * circumference(place[0]) } else { length };
                for (&node, s) in face.nodes.iter().zip(&shape) {
                    (0..D).for_each(|axis| load[node as usize][axis] += weight * size * s * t[axis]);
                }
            }
        }
        load
    }

    /// Nodal forces ∫ N_a b dV of a force b per undeformed volume (ρ g for weight) in all of a part.
    pub fn body_load(&self, part: usize, force_density: [f64; D]) -> Vec<[f64; D]> {
        let mut load = vec![[0.0; D]; self.node_count()];
        for elements in self.elements_of(part) {
            for (&node, share) in elements.conn.iter().zip(&elements.shares) {
                (0..D).for_each(|axis| load[node as usize][axis] += share * force_density[axis]);
            }
        }
        load
    }
}

/// Change of the place with the coordinates in which the weights add up to the reference measure: 1 for edges and
/// quadrilaterals, ½ for triangles.
fn straight_tangents<const D: usize>(x: &[[f64; D]], shape: &[f64]) -> [[f64; D]; 2] {
    let mut tangents = [[0.0; D]; 2];
    for i in 0..D {
        (tangents[0][i], tangents[1][i]) = match x.len() {
            2 => (x[1][i] - x[0][i], 0.0),
            3 => (x[1][i] - x[0][i], x[2][i] - x[0][i]),
            _ => {
                let s = shape[1] + shape[2];
                let t = shape[2] + shape[3];
                let along_s = (1.0 - t) * (x[1][i] - x[0][i]) + t * (x[2][i] - x[3][i]);
                (along_s, (1.0 - s) * (x[3][i] - x[0][i]) + s * (x[2][i] - x[1][i]))
            }
        };
    }
    tangents
}

/// The same of a face of second order.
fn curved_tangents<const D: usize>(x: &[[f64; D]], slopes: &[[f64; 3]]) -> [[f64; D]; 2] {
    let along = |axis: usize, i: usize| x.iter().zip(slopes).map(|(x, slope)| x[i] * slope[axis]).sum();
    [0, 1].map(|axis| std::array::from_fn(|i| along(axis, i)))
}

/// Outward normal of a face, as long as its tangents span area (2D: length).
fn normal<const D: usize>([a, b]: [[f64; D]; 2]) -> [f64; D] {
    match D {
        // The body lies on the left: the normal points to the right.
        2 => std::array::from_fn(|i| if i == 0 { a[1] } else { -a[0] }),
        _ => std::array::from_fn(|i| a[(i + 1) % D] * b[(i + 2) % D] - a[(i + 2) % D] * b[(i + 1) % D]),
    }
}
