//! The straight cells into which a cell of second order is divided.

use super::entities::Entities;
use crate::geometry::CellType;

/// A straight cell of a division.
#[derive(Clone, Debug)]
pub(super) struct Child {
    pub(super) cell_type: CellType,
    /// Its nodes, points of the division.
    pub(super) nodes: Vec<usize>,
    /// For every face of the child the face of the whole cell in which it lies.
    pub(super) faces: Vec<Option<usize>>,
}

/// What lies between the cells at the corners.
fn inner(cell_type: CellType) -> &'static [(CellType, &'static [usize])] {
    match cell_type {
        CellType::Tri6 => &[(CellType::Tri3, &[3, 4, 5])],
        // The octahedron of the six middles, about its diagonal from edge 20 to edge 13.
        CellType::Tet10 => &[
            (CellType::Tet4, &[6, 8, 4, 5]),
            (CellType::Tet4, &[6, 8, 5, 9]),
            (CellType::Tet4, &[6, 8, 9, 7]),
            (CellType::Tet4, &[6, 8, 7, 4]),
        ],
        CellType::Wedge15 => {
            &[(CellType::Wedge6, &[6, 7, 8, 15, 16, 17]), (CellType::Wedge6, &[15, 16, 17, 9, 10, 11])]
        }
        // Below the pyramid at the apex one that stands on its head, and a tetrahedron at every side.
        CellType::Pyramid13 => &[
            (CellType::Pyramid5, &[9, 12, 11, 10, 13]),
            (CellType::Tet4, &[10, 5, 9, 13]),
            (CellType::Tet4, &[11, 6, 10, 13]),
            (CellType::Tet4, &[12, 7, 11, 13]),
            (CellType::Tet4, &[9, 8, 12, 13]),
        ],
        _ => &[],
    }
}

/// All of them: one at every corner, half as large as the cell, then what lies between.
pub(super) fn children(cell_type: CellType, entities: &Entities) -> Vec<Child> {
    let straight = cell_type.straight();
    let at = |corner| (straight, (0..entities.corners).map(|other| entities.between(corner, other)).collect());
    let between = inner(cell_type).iter().map(|(of_type, nodes)| (*of_type, nodes.to_vec()));
    let all = (0..entities.corners).map(at).chain(between);
    all.map(|(cell_type_of_child, nodes): (CellType, Vec<usize>)| {
        // A point lies in a face if all corners around it do.
        let lies_in = |face: &[usize], point: usize| entities.around(point).iter().all(|corner| face.contains(corner));
        let whole_face = |face: &&[usize]| {
            straight.faces().iter().position(|whole| face.iter().all(|&local| lies_in(whole, nodes[local])))
        };
        let faces = cell_type_of_child.faces().iter().map(whole_face).collect();
        Child { cell_type: cell_type_of_child, nodes, faces }
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    const TYPES: [CellType; 8] = [
        CellType::Tri6,
        CellType::Quad8,
        CellType::Quad9,
        CellType::Tet10,
        CellType::Hex20,
        CellType::Hex27,
        CellType::Wedge15,
        CellType::Pyramid13,
    ];

    fn corners(straight: CellType) -> Vec<[f64; 3]> {
        let square = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let above = |x: [f64; 3]| [x[0], x[1], 1.0];
        match straight {
            CellType::Tri3 => vec![square[0], square[1], square[3]],
            CellType::Quad4 => square.to_vec(),
            CellType::Tet4 => vec![square[0], square[1], square[3], [0., 0., 1.]],
            CellType::Wedge6 => {
                vec![square[0], square[1], square[3], above(square[0]), above(square[1]), above(square[3])]
            }
            CellType::Pyramid5 => [square.to_vec(), vec![[0.5, 0.5, 1.0]]].concat(),
            _ => square.into_iter().chain(square.map(above)).collect(),
        }
    }

    /// Six times the volume (twice the area) as that of tetrahedra from every corner's edges, right for these cells.
    fn size(cell_type: CellType, x: &[Vector3<f64>]) -> f64 {
        let corners = cell_type.corners();
        let det = |corner: &[usize]| {
            let edge = |k: usize| x[corner[k]] - x[corner[0]];
            if cell_type.dimension() == 2 { edge(1).cross(&edge(2)).z } else { edge(1).cross(&edge(2)).dot(&edge(3)) }
        };
        let mean = corners.iter().map(|corner| det(corner)).sum::<f64>() / corners.len() as f64;
        mean * match cell_type {
            CellType::Tri3 => 0.5,
            CellType::Tet4 => 1.0 / 6.0,
            CellType::Wedge6 => 0.5,
            CellType::Pyramid5 => 1.0 / 3.0,
            _ => 1.0,
        }
    }

    #[test]
    fn they_fill_the_cell() {
        for cell_type in TYPES {
            let entities = Entities::of(cell_type).expect("of second order");
            let straight = cell_type.straight();
            let at: Vec<Vector3<f64>> = corners(straight).into_iter().map(Vector3::from).collect();
            let mean = |around: Vec<usize>| around.iter().map(|&k| at[k]).sum::<Vector3<f64>>() / around.len() as f64;
            let x: Vec<_> = (0..entities.count()).map(|point| mean(entities.around(point))).collect();
            let sizes = children(cell_type, &entities).into_iter().map(|child| {
                let of_child: Vec<_> = child.nodes.iter().map(|&point| x[point]).collect();
                size(child.cell_type, &of_child)
            });
            let sizes: Vec<f64> = sizes.collect();
            assert!(sizes.iter().all(|&size| size > 0.0), "{cell_type:?}: {sizes:?}");
            let whole = size(straight, &at);
            assert!((sizes.iter().sum::<f64>() - whole).abs() < 1e-14, "{cell_type:?}: {sizes:?} of {whole}");
        }
    }

    /// Every face of the whole is made of four of the children's, an edge of two; the others meet in pairs.
    #[test]
    fn their_faces_are_those_of_the_cell() {
        for cell_type in TYPES {
            let entities = Entities::of(cell_type).expect("of second order");
            let mut found = vec![0; cell_type.faces().len()];
            let mut inside = std::collections::BTreeMap::new();
            for child in children(cell_type, &entities) {
                for (face, whole) in child.cell_type.faces().iter().zip(&child.faces) {
                    let mut key: Vec<usize> = face.iter().map(|&local| child.nodes[local]).collect();
                    key.sort_unstable();
                    match whole {
                        Some(whole) => found[*whole] += 1,
                        None => *inside.entry(key).or_insert(0) += 1,
                    }
                }
            }
            let expected = if cell_type.dimension() == 2 { 2 } else { 4 };
            assert!(found.iter().all(|&count| count == expected), "{cell_type:?}: {found:?}");
            assert!(inside.values().all(|&count| count == 2), "{cell_type:?}: {inside:?}");
        }
    }
}
