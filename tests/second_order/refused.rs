//! Cells that do not fit, and cells that are inverted, are refused by name.

use crate::rectangles;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, Options, Surface};

fn surface(coords: &[[f64; 2]], blocks: &[(CellType, &[u32])]) -> Result<Surface<2>, Error> {
    let blocks: Vec<_> = blocks.iter().map(|&(cell_type, conn)| CellBlock { cell_type, conn }).collect();
    Surface::from_cells(coords, &blocks, Bodies::Connected)
}

/// Two triangles of a square; nodes 4 to 8 are the middles of 01, 12, 20, 23, 30.
const SQUARE: [[f64; 2]; 9] =
    [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0.5, 0.], [1., 0.5], [0.5, 0.5], [0.5, 1.], [0., 0.5]];

#[test]
fn a_middle_that_a_neighbour_does_not_know() {
    let tri6: &[u32] = &[0, 1, 2, 4, 5, 6];
    let refused = surface(&SQUARE, &[(CellType::Tri6, tri6), (CellType::Tri3, &[0, 2, 3])]);
    assert_eq!(refused.err(), Some(Error::NonConforming { cells: [0, 1] }));
    let whole = surface(&SQUARE, &[(CellType::Tri6, &[0, 1, 2, 4, 5, 6, 0, 2, 3, 6, 7, 8])]).expect("two cells");
    assert_eq!((whole.body_count(), whole.facet_count(), whole.node_count()), (1, 8, 9));
    // Another node in the same middle, a corner that is a middle elsewhere.
    let coords = [&SQUARE[..], &[[0.5, 0.5]]].concat();
    let refused = surface(&coords, &[(CellType::Tri6, &[0, 1, 2, 4, 5, 6, 0, 2, 3, 9, 7, 8])]);
    assert_eq!(refused.err(), Some(Error::NonConforming { cells: [0, 1] }));
    let refused = surface(&SQUARE, &[(CellType::Tri3, &[0, 6, 3]), (CellType::Tri6, tri6)]);
    assert_eq!(refused.err(), Some(Error::NonConforming { cells: [0, 1] }));
}

#[test]
fn an_inverted_cell_is_named_as_given() {
    let mesh = rectangles([0.0; 2], [1.0; 2], [2, 2]).swap_remove(0);
    let cells: &[(CellType, &[u32])] = &[(CellType::Tri6, &mesh.conn)];
    // The middle of an edge of cell 5 beyond the opposite corner.
    let mut coords = mesh.coords.clone();
    let cell = &mesh.conn[5 * 6..6 * 6];
    let (corner, middle) = (mesh.coords[cell[2] as usize], cell[3] as usize);
    let from = coords[middle];
    coords[middle] = std::array::from_fn(|i| corner[i] + 0.5 * (corner[i] - from[i]));
    let refused = surface(&coords, cells).err();
    assert!(matches!(refused, Some(Error::FoldedCell { cell: 4 | 5, .. })), "{refused:?}");
    let contact = Contact::new(surface(&mesh.coords, cells).expect("a mesh"), Options::new(EnergyLaw::volume(1.0)));
    let refused = contact.expect("options").evaluate(&coords).err();
    assert!(matches!(refused, Some(Error::FoldedCell { cell: 4 | 5, .. })), "{refused:?}");
}

#[test]
fn numbers_are_checked() {
    let of = |conn: &[u32]| surface(&SQUARE, &[(CellType::Tri6, conn)]).err();
    assert_eq!(of(&[0, 1, 2, 4, 5, 9]), Some(Error::NodeOutOfRange { cell: 0, node: 9, node_count: 9 }));
    assert_eq!(of(&[0, 1, 2, 4, 4, 6]), Some(Error::RepeatedNode { cell: 0, node: 4 }));
    assert_eq!(of(&[0, 1, 2, 4, 5]), Some(Error::Length { array: "conn", expected: 6, found: 5 }));
    let tet10 = surface(&SQUARE, &[(CellType::Tet10, &[0; 10])]).err();
    assert_eq!(tet10, Some(Error::Dimension { block: 0, expected: 2, found: 3 }));
    let mut coords = SQUARE;
    coords[6][1] = f64::NAN;
    let found = surface(&coords, &[(CellType::Tri6, &[0, 1, 2, 4, 5, 6])]).err();
    assert_eq!(found, Some(Error::NonFiniteCoordinate { node: 6, axis: 1 }));
    // Nodes that nothing uses may be anything.
    coords[6][1] = 0.5;
    coords[8][0] = f64::NAN;
    assert!(surface(&coords, &[(CellType::Tri6, &[0, 1, 2, 4, 5, 6])]).is_ok());
}
