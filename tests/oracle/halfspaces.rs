//! Convex regions as sets of half-spaces n·x ≤ c, and meshes of simplices as sums of such regions.
//!
//! Written without a look at the module, in space coordinates and pair by pair, for meshes in general position: no facet
//! of one body lies in the plane of a face of the other.

use fmc_shapes::Mesh;

pub(crate) fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    (0..D).map(|i| a[i] * b[i]).sum()
}

pub(crate) fn subtract<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Along the outward normal, as long as the facet's measure: the edge turned clockwise (2D), half the cross product (3D).
pub(crate) fn area_vector<const D: usize>(x: &[[f64; D]; D]) -> [f64; D] {
    let e = subtract(&x[1], &x[0]);
    if D == 2 {
        return std::array::from_fn(|i| if i == 0 { e[1] } else { -e[0] });
    }
    let f = subtract(&x[2], &x[0]);
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        0.5 * (e[j] * f[k] - e[k] * f[j])
    })
}

/// Intersection of half-spaces.
pub(crate) struct Convex<const D: usize>(Vec<([f64; D], f64)>);

impl<const D: usize> Convex<D> {
    /// Simplex with these D + 1 corners, in any order.
    pub(crate) fn simplex(corners: &[[f64; D]]) -> Self {
        let plane = |k: usize| {
            let others: Vec<[f64; D]> = (0..=D).filter(|&c| c != k).map(|c| corners[c]).collect();
            let face: [[f64; D]; D] = others.try_into().unwrap();
            let n = area_vector(&face);
            let (n, c) = (n, dot(&n, &face[0]));
            if dot(&n, &corners[k]) <= c { (n, c) } else { (n.map(|n| -n), -c) }
        };
        Self((0..=D).map(plane).collect())
    }

    /// n·x ≤ level.
    pub(crate) fn half_space(n: [f64; D], level: f64) -> Self {
        Self(vec![(n, level)])
    }

    /// Volume of the part of a mesh in a single half-space, and its derivative by the nodes. With the origin on the plane,
    /// the plane adds nothing to the volume.
    pub(crate) fn bounded(&self, mesh: &Mesh<D>) -> (f64, Vec<[f64; D]>) {
        let (n, level) = self.0[0];
        let origin = n.map(|n| n * level);
        let (mut volume, mut gradient) = (0.0, vec![[0.0; D]; mesh.coords.len()]);
        for face in mesh.boundary_faces() {
            let corners: [[f64; D]; D] = std::array::from_fn(|k| mesh.coords[face[k] as usize]);
            let whole = area_vector(&corners);
            let normal = whole.map(|x| x / dot(&whole, &whole).sqrt());
            let shares = self.shares(&corners);
            volume += shares.iter().sum::<f64>() * dot(&normal, &subtract(&corners[0], &origin)) / D as f64;
            for (share, &node) in shares.iter().zip(&face) {
                gradient[node as usize] = std::array::from_fn(|i| gradient[node as usize][i] + share * normal[i]);
            }
        }
        (volume, gradient)
    }

    /// Part of an edge (2D) or triangle (3D) inside, as a convex polygon with two corners in 2D.
    fn clip(&self, facet: &[[f64; D]; D]) -> Vec<[f64; D]> {
        let mut piece = facet.to_vec();
        for (n, c) in &self.0 {
            let height: Vec<f64> = piece.iter().map(|x| dot(n, x) - c).collect();
            let sides = if D == 2 { piece.len().saturating_sub(1) } else { piece.len() };
            let mut kept = Vec::new();
            for k in 0..piece.len() {
                let next = (k + 1) % piece.len();
                if height[k] <= 0.0 {
                    kept.push(piece[k]);
                }
                if k < sides && height[k] * height[next] < 0.0 {
                    let s = height[k] / (height[k] - height[next]);
                    kept.push(std::array::from_fn(|i| piece[k][i] + s * (piece[next][i] - piece[k][i])));
                }
            }
            piece = kept;
        }
        piece
    }

    /// ∫ N_a dA over the part of a facet inside, for every corner a.
    pub(crate) fn shares(&self, facet: &[[f64; D]; D]) -> [f64; D] {
        let piece = self.clip(facet);
        if piece.len() < D {
            return [0.0; D];
        }
        let whole = area_vector(facet);
        let measure_squared = dot(&whole, &whole);
        // N_a at x: the part of the facet that lies opposite to corner a as seen from x.
        let hats = |x: &[f64; D]| -> [f64; D] {
            std::array::from_fn(|a| {
                let mut part = *facet;
                part[a] = *x;
                dot(&area_vector(&part), &whole) / measure_squared
            })
        };
        let mut sums = [0.0; D];
        for k in 1..=piece.len() + 1 - D {
            let simplex: [[f64; D]; D] = std::array::from_fn(|c| if c == 0 { piece[0] } else { piece[k + c - 1] });
            let measure = dot(&area_vector(&simplex), &whole).abs() / measure_squared.sqrt();
            for (sum, a) in sums.iter_mut().zip(0..D) {
                *sum += measure * simplex.iter().map(|x| hats(x)[a]).sum::<f64>() / D as f64;
            }
        }
        sums
    }
}

/// Volume of the overlap of two meshes of simplices, and its derivative by the nodes of either.
pub(crate) fn overlap<const D: usize>(a: &Mesh<D>, b: &Mesh<D>) -> (f64, Vec<[f64; D]>, Vec<[f64; D]>) {
    // Near the overlap, so that a small one is not the difference of large moments.
    let (p, q) = (ranges(&a.coords), ranges(&b.coords));
    let origin = std::array::from_fn(|i| 0.5 * (p[i].0.max(q[i].0) + p[i].1.min(q[i].1)));
    let (of_a, volume_a) = bounded(a, b, &origin);
    let (of_b, volume_b) = bounded(b, a, &origin);
    (volume_a + volume_b, of_a, of_b)
}

/// What the boundary of `a` inside `b` adds to the derivative by the nodes of `a`, and to the volume by the divergence
/// theorem, V = 1/D ∫ n·(x − origin) dA.
fn bounded<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, origin: &[f64; D]) -> (Vec<[f64; D]>, f64) {
    let at = |mesh: &Mesh<D>, nodes: &[u32]| -> Vec<[f64; D]> {
        nodes.iter().map(|&node| mesh.coords[node as usize]).collect()
    };
    let cells: Vec<(Vec<[f64; D]>, Convex<D>)> = b
        .cells()
        .map(|cell| {
            let corners = at(b, cell);
            let convex = Convex::simplex(&corners);
            (corners, convex)
        })
        .collect();
    let (mut gradient, mut volume) = (vec![[0.0; D]; a.coords.len()], 0.0);
    for face in a.boundary_faces() {
        let corners: [[f64; D]; D] = at(a, &face).try_into().unwrap();
        let whole = area_vector(&corners);
        let n = whole.map(|x| x / dot(&whole, &whole).sqrt());
        for (simplex, cell) in &cells {
            if apart(&corners, simplex) {
                continue;
            }
            let shares = cell.shares(&corners);
            for (share, &node) in shares.iter().zip(&face) {
                gradient[node as usize] = std::array::from_fn(|i| gradient[node as usize][i] + share * n[i]);
            }
            volume += shares.iter().sum::<f64>() * dot(&n, &subtract(&corners[0], origin)) / D as f64;
        }
    }
    (gradient, volume)
}

fn apart<const D: usize>(x: &[[f64; D]], y: &[[f64; D]]) -> bool {
    ranges(x).iter().zip(ranges(y)).any(|(p, q)| p.0 > q.1 || q.0 > p.1)
}

/// Least and largest coordinate along every axis.
fn ranges<const D: usize>(x: &[[f64; D]]) -> [(f64, f64); D] {
    std::array::from_fn(|i| {
        x.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x[i]), high.max(x[i])))
    })
}

/// The oracle itself, against numbers from a school book.
#[test]
fn half_of_a_square_lies_under_its_diagonal() {
    let triangle = |x: [[f64; 2]; 3]| Mesh { coords: x.to_vec(), conn: vec![0, 1, 2], nodes_per_cell: 3 };
    let a = triangle([[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]);
    let b = triangle([[1.5, 1.5], [-0.5, 1.5], [1.5, -0.5]]);
    // a is x, y ≥ 0, x + y ≤ 2; b is x, y ≤ 3/2, x + y ≥ 1: a square of side 3/2 less two corners of legs 1.
    let (volume, of_a, _) = overlap(&a, &b);
    assert!((volume - (2.25 - 0.5 - 0.5)).abs() < 1e-15);
    // Moving a to the right: its long side (height 1 inside b) gains, its left side (from 1 to 3/2) loses.
    let along_x: f64 = of_a.iter().map(|g| g[0]).sum();
    assert!((along_x - (1.0 - 0.5)).abs() < 1e-15);
}
