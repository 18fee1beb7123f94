//! Shape functions of cells of second order.
//!
//! With the barycentric coordinates L of a simplex, and with c the place of a node in the square or cube [−1, 1]ᴰ:
//!
//! ```text
//! Tri6, Tet10     corner L (2L − 1)                          middle of an edge 4 L_p L_q
//! Quad9, Hex27    Π_i ½ ξ_i (ξ_i + c_i) or, where c_i = 0, 1 − ξ_i²
//! Quad8, Hex20    corner Π_i ½ (1 + ξ_i c_i) (Σ ξ_i c_i − D + 1)
//!                 middle of an edge along m  (1 − ξ_m²) Π_(i≠m) ½ (1 + ξ_i c_i)
//! ```

use super::wedge;
use fmc_contact::CellType;

/// Corners of the square and cube in the order of `Quad4` and `Hex8`.
pub(super) const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

const QUAD_MIDDLES: [&[usize]; 5] = [&[0, 1], &[1, 2], &[2, 3], &[3, 0], &[0, 1, 2, 3]];
const TET_MIDDLES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
const HEX_MIDDLES: [&[usize]; 19] = [
    &[0, 1],
    &[1, 2],
    &[2, 3],
    &[3, 0],
    &[4, 5],
    &[5, 6],
    &[6, 7],
    &[7, 4],
    &[0, 4],
    &[1, 5],
    &[2, 6],
    &[3, 7],
    &[0, 4, 7, 3],
    &[1, 2, 6, 5],
    &[0, 1, 5, 4],
    &[3, 7, 6, 2],
    &[0, 3, 2, 1],
    &[4, 5, 6, 7],
    &[0, 1, 2, 3, 4, 5, 6, 7],
];

/// Corners about the nodes of a cell that are no corners, in their order.
pub(super) fn middles(cell_type: CellType) -> Vec<Vec<usize>> {
    let count = cell_type.node_count() - cell_type.straight().node_count();
    match cell_type {
        CellType::Tri6 | CellType::Tet10 => TET_MIDDLES[..count].iter().map(|edge| edge.to_vec()).collect(),
        CellType::Quad8 | CellType::Quad9 => QUAD_MIDDLES[..count].iter().map(|around| around.to_vec()).collect(),
        CellType::Hex20 | CellType::Hex27 => HEX_MIDDLES[..count].iter().map(|around| around.to_vec()).collect(),
        CellType::Wedge15 => wedge::MIDDLES.iter().map(|edge| edge.to_vec()).collect(),
        _ => Vec::new(),
    }
}

/// A shape function and its derivatives by the reference coordinates, zero beyond the dimension.
pub(super) type Shape = (f64, [f64; 3]);

/// Shape functions of a cell of second order at a place of its reference cell; `None` for other cells.
pub(super) fn second_order(cell_type: CellType, xi: [f64; 3]) -> Option<Vec<Shape>> {
    let count = cell_type.node_count();
    Some(match cell_type {
        CellType::Tri6 => simplex::<3>(&TET_MIDDLES[..3], xi),
        CellType::Tet10 => simplex::<4>(&TET_MIDDLES, xi),
        CellType::Quad8 | CellType::Quad9 => cube(2, &QUAD_MIDDLES[..count - 4], count == 9, xi),
        CellType::Hex20 | CellType::Hex27 => cube(3, &HEX_MIDDLES[..count - 8], count == 27, xi),
        _ => return None,
    })
}

/// Shape functions of an edge with a node in its middle, which comes last, at a place from 0 to 1.
pub(super) fn second_order_edge(place: f64) -> Vec<Shape> {
    simplex::<2>(&[[0, 1]], [place, 0.0, 0.0])
}

fn simplex<const N: usize>(edges: &[[usize; 2]], xi: [f64; 3]) -> Vec<Shape> {
    // L_0 = 1 − Σ ξ_i, L_i = ξ_i.
    let slope = |k: usize| -> [f64; 3] {
        std::array::from_fn(|axis| match k {
            0 if axis + 1 < N => -1.0,
            _ if k == axis + 1 => 1.0,
            _ => 0.0,
        })
    };
    let l = |k: usize| if k == 0 { 1.0 - xi[..N - 1].iter().sum::<f64>() } else { xi[k - 1] };
    let corners = (0..N).map(|k| (l(k) * (2.0 * l(k) - 1.0), slope(k).map(|d| (4.0 * l(k) - 1.0) * d)));
    let middles = edges.iter().map(|&[p, q]| {
        let (dp, dq) = (slope(p), slope(q));
        (4.0 * l(p) * l(q), std::array::from_fn(|axis| 4.0 * (dp[axis] * l(q) + l(p) * dq[axis])))
    });
    corners.chain(middles).collect()
}

fn cube(dimension: usize, middles: &[&[usize]], is_full: bool, xi: [f64; 3]) -> Vec<Shape> {
    let middle = |around: &&[usize]| -> [f64; 3] {
        std::array::from_fn(|i| around.iter().map(|&k| CORNERS[k][i]).sum::<f64>() / around.len() as f64)
    };
    let places = CORNERS[..1 << dimension].iter().copied().chain(middles.iter().map(middle));
    places.map(|place| if is_full { full(dimension, place, xi) } else { serendipity(dimension, place, xi) }).collect()
}

/// Product of a function of each coordinate and of its slope, by the product rule.
fn product(dimension: usize, factors: [(f64, f64); 3]) -> Shape {
    let others = |axis: usize| (0..dimension).filter(move |&i| i != axis);
    let value = factors[..dimension].iter().map(|factor| factor.0).product();
    let slope = |axis: usize| factors[axis].1 * others(axis).map(|i| factors[i].0).product::<f64>();
    (value, std::array::from_fn(|axis| if axis < dimension { slope(axis) } else { 0.0 }))
}

fn full(dimension: usize, c: [f64; 3], xi: [f64; 3]) -> Shape {
    let factor = |i: usize| match c[i] {
        0.0 => (1.0 - xi[i] * xi[i], -2.0 * xi[i]),
        c => (0.5 * xi[i] * (xi[i] + c), xi[i] + 0.5 * c),
    };
    product(dimension, std::array::from_fn(factor))
}

fn serendipity(dimension: usize, c: [f64; 3], xi: [f64; 3]) -> Shape {
    let factor = |i: usize| match c[i] {
        0.0 => (1.0 - xi[i] * xi[i], -2.0 * xi[i]),
        c => (0.5 * (1.0 + xi[i] * c), 0.5 * c),
    };
    let (value, slope) = product(dimension, std::array::from_fn(factor));
    if c[..dimension].contains(&0.0) {
        return (value, slope);
    }
    let sum = (0..dimension).map(|i| xi[i] * c[i]).sum::<f64>() + 1.0 - dimension as f64;
    (value * sum, std::array::from_fn(|i| if i < dimension { slope[i] * sum + value * c[i] } else { 0.0 }))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TYPES: [CellType; 6] =
        [CellType::Tri6, CellType::Quad8, CellType::Quad9, CellType::Tet10, CellType::Hex20, CellType::Hex27];

    /// Nodes of the reference cell, as the mesh maker that knows nothing of shape functions sees them.
    fn nodes(cell_type: CellType) -> Vec<[f64; 3]> {
        let count = cell_type.node_count();
        let corners = cell_type.straight().node_count();
        let is_simplex = corners == cell_type.dimension() + 1;
        let corner = |k: usize| match is_simplex {
            true => std::array::from_fn(|axis| f64::from(axis + 1 == k)),
            false => CORNERS[k],
        };
        fn raised<const D: usize>(corners: Vec<[f64; D]>, count: usize) -> Vec<[f64; 3]> {
            let conn = (0..corners.len() as u32).collect();
            let cell = fmc_shapes::Mesh { nodes_per_cell: corners.len(), coords: corners, conn };
            let mesh = fmc_shapes::second_order(&cell, count);
            let place = |node: &u32| std::array::from_fn(|axis| *mesh.coords[*node as usize].get(axis).unwrap_or(&0.0));
            mesh.conn.iter().map(place).collect()
        }
        match cell_type.dimension() {
            2 => raised((0..corners).map(|k| [corner(k)[0], corner(k)[1]]).collect(), count),
            _ => raised((0..corners).map(corner).collect(), count),
        }
    }

    #[test]
    fn shape_functions_are_one_at_their_node_and_zero_at_the_others() {
        for cell_type in TYPES {
            for (node, place) in nodes(cell_type).into_iter().enumerate() {
                // The third coordinate of a flat cell means nothing.
                let shapes = second_order(cell_type, place).unwrap();
                assert_eq!(shapes.len(), cell_type.node_count());
                for (other, (value, _)) in shapes.iter().enumerate() {
                    assert!((value - f64::from(node == other)).abs() < 1e-15, "{cell_type:?}: {other} at {node}");
                }
            }
        }
        assert!(second_order(CellType::Pyramid13, [0.0; 3]).is_none());
    }

    /// Every quadratic polynomial is met with its derivatives.
    #[test]
    fn quadratic_polynomials_are_met() {
        let f = |x: [f64; 3]| {
            let [x, y, z] = x;
            1.0 + 2.0 * x - y + 3.0 * z + x * x - 2.0 * y * y + 0.5 * z * z + x * y - y * z + 2.0 * x * z
        };
        let slope = |x: [f64; 3]| {
            let [x, y, z] = x;
            [2.0 + 2.0 * x + y + 2.0 * z, -1.0 - 4.0 * y + x - z, 3.0 + z - y + 2.0 * x]
        };
        for cell_type in TYPES {
            let dimension = cell_type.dimension();
            let mut xi = [0.21, 0.37, 0.13];
            xi[dimension..].fill(0.0);
            let values: Vec<f64> = nodes(cell_type).into_iter().map(f).collect();
            let shapes = second_order(cell_type, xi).unwrap();
            let value: f64 = shapes.iter().zip(&values).map(|(shape, value)| shape.0 * value).sum();
            assert!((value - f(xi)).abs() < 1e-14, "{cell_type:?}: {value}");
            for axis in 0..dimension {
                let along: f64 = shapes.iter().zip(&values).map(|(shape, value)| shape.1[axis] * value).sum();
                assert!((along - slope(xi)[axis]).abs() < 1e-13, "{cell_type:?}, axis {axis}: {along}");
            }
        }
    }
}
