//! Bad meshes never pass silently: every kind has an error of its own, which names the index.

use crate::scene::{exact, lines};
use fmc_contact::{Bodies, CellBlock, CellType, Contact, Error, Options, Surface};
use fmc_shapes::{Diagonals, cuboid_surface, cuboid_tet4, polygon, rectangle_tri3};

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

fn of_cells<const D: usize>(coords: &[[f64; D]], cell_type: CellType, conn: &[u32]) -> Result<Surface<D>, Error> {
    Surface::from_cells(coords, &[CellBlock { cell_type, conn }], Bodies::Connected)
}

fn of_facets<const D: usize>(coords: &[[f64; D]], facets: &[[u32; D]]) -> Result<Surface<D>, Error> {
    Surface::from_facets(coords, facets, Bodies::Connected)
}

/// The error, and that its sentence holds these numbers or names.
pub(crate) fn refused<T>(result: Result<T, Error>, expected: Error, words: &[&str]) {
    let Err(error) = result else { panic!("{expected:?} is not noticed") };
    assert_eq!(error, expected);
    let sentence = error.to_string();
    assert!(words.iter().all(|word| sentence.contains(word)), "'{sentence}' lacks one of {words:?}");
}

#[test]
fn nothing_to_compute_with() {
    refused(of_cells::<2>(&[], CellType::Tri3, &[]), Error::Empty, &["no cells"]);
    refused(Surface::<3>::from_cells(&[], &[], Bodies::Connected), Error::Empty, &[]);
    refused(of_facets::<3>(&[], &[]), Error::Empty, &["no facets"]);
}

#[test]
fn wrong_lengths() {
    let expected = Error::Length { array: "conn", expected: 3, found: 4 };
    refused(of_cells(&SQUARE, CellType::Tri3, &[0, 1, 2, 3]), expected, &["conn", "4"]);
    let block = [CellBlock { cell_type: CellType::Tri3, conn: &[0, 1, 2, 0, 2, 3] }];
    let expected = Error::Length { array: "body_ids", expected: 2, found: 1 };
    refused(Surface::from_cells(&SQUARE, &block, Bodies::Ids(&[7])), expected, &["body_ids", "2", "1"]);
    let edges = polygon(&SQUARE, 1).facets();
    let expected = Error::Length { array: "body_ids", expected: 4, found: 3 };
    refused(Surface::from_facets(&SQUARE, &edges, Bodies::Ids(&[0; 3])), expected, &["body_ids"]);
    let contact = Contact::new(of_cells(&SQUARE, CellType::Quad4, &[0, 1, 2, 3]).unwrap(), exact()).unwrap();
    let expected = Error::Length { array: "coords", expected: 4, found: 3 };
    refused(contact.evaluate(&SQUARE[..3]), expected, &["coords", "4", "3"]);
}

#[test]
fn cells_of_another_dimension() {
    let blocks = [
        CellBlock { cell_type: CellType::Tri3, conn: &[0, 1, 2] },
        CellBlock { cell_type: CellType::Tet4, conn: &[0, 1, 2, 3] },
    ];
    let expected = Error::Dimension { block: 1, expected: 2, found: 3 };
    refused(Surface::from_cells(&SQUARE, &blocks, Bodies::Connected), expected, &["block 1"]);
}

#[test]
fn nodes_that_are_not_there_or_there_twice() {
    let expected = Error::NodeOutOfRange { cell: 1, node: 4, node_count: 4 };
    refused(of_cells(&SQUARE, CellType::Tri3, &[0, 1, 2, 0, 2, 4]), expected, &["cell or facet 1", "node 4"]);
    let expected = Error::NodeOutOfRange { cell: 2, node: u32::MAX.into(), node_count: 4 };
    refused(of_facets(&SQUARE, &[[0, 1], [1, 2], [2, u32::MAX]]), expected, &["4294967295"]);
    // Counted over all blocks.
    let blocks = [
        CellBlock { cell_type: CellType::Tri3, conn: &[0, 1, 2] },
        CellBlock { cell_type: CellType::Quad4, conn: &[0, 2, 3, 2] },
    ];
    let expected = Error::RepeatedNode { cell: 1, node: 2 };
    refused(Surface::from_cells(&SQUARE, &blocks, Bodies::Connected), expected, &["cell or facet 1", "node 2"]);
    let expected = Error::RepeatedNode { cell: 1, node: 3 };
    refused(of_facets(&SQUARE, &[[0, 1], [3, 3]]), expected, &["node 3 twice"]);
}

#[test]
fn coordinates_that_are_no_numbers() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut coords = SQUARE;
        coords[2][1] = bad;
        let expected = Error::NonFiniteCoordinate { node: 2, axis: 1 };
        refused(of_cells(&coords, CellType::Quad4, &[0, 1, 2, 3]), expected.clone(), &["coordinate 1 of node 2"]);
        refused(of_facets(&coords, &polygon(&SQUARE, 1).facets()), expected.clone(), &[]);
        // Also with the check of cells switched off, and for surfaces without cells.
        for check_cells in [false, true] {
            let options = Options { check_cells, ..lines(0.1, 0) };
            let surface = of_cells(&SQUARE, CellType::Quad4, &[0, 1, 2, 3]).unwrap();
            refused(Contact::new(surface, options).unwrap().evaluate(&coords), expected.clone(), &[]);
            let surface = of_facets(&SQUARE, &polygon(&SQUARE, 1).facets()).unwrap();
            refused(Contact::new(surface, options).unwrap().evaluate(&coords), expected.clone(), &[]);
        }
    }
}

#[test]
fn cells_inside_out() {
    // A bow tie: positive at two corners, negative at two. It has no area at all; a dart has, and is concave at one.
    let tie = Error::InvertedCells { cells: vec![0], bow_ties: 1 };
    refused(of_cells(&SQUARE, CellType::Quad4, &[0, 1, 3, 2]), tie, &["the first is 0", "bow tie"]);
    // All of them are counted.
    let row: Vec<[f64; 2]> = (0..8).map(|k| [f64::from(k / 2), f64::from(k % 2)]).collect();
    let ties = Error::InvertedCells { cells: vec![0, 2], bow_ties: 2 };
    refused(
        of_cells(&row, CellType::Quad4, &[0, 2, 1, 3, 2, 4, 5, 3, 4, 6, 5, 7]),
        ties.clone(),
        &["2 cells are inverted", "the first is 0", "cross in 2"],
    );
    assert_eq!(ties.counted_from(1), Error::InvertedCells { cells: vec![1, 3], bow_ties: 2 });
    let dart = [[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]];
    refused(of_cells(&dart, CellType::Quad4, &[0, 1, 2, 3]), Error::InvertedCell { cell: 0 }, &["cell 0", "inverted"]);
    // A triangle folded over its neighbour, while the body as a whole is positive.
    let mesh = rectangle_tri3([0.0; 2], [1.0; 2], [3, 3], Diagonals::Same);
    let mut coords = mesh.coords.clone();
    coords[5] = [0.4, 0.9];
    let Err(Error::InvertedCells { cells, bow_ties: 0 }) = of_cells(&coords, CellType::Tri3, &mesh.conn) else {
        panic!("not noticed")
    };
    // By the area of each triangle, all of which are counter-clockwise before.
    let area = |t: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|k| coords[t[k] as usize]);
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let folded: Vec<usize> =
        (0..).zip(mesh.conn.chunks_exact(3)).filter(|(_, t)| area(t) < 0.0).map(|(k, _)| k).collect();
    assert_eq!(cells, folded);
    let cell = cells[0];
    // The same in an evaluation, where it can be allowed.
    let surface = of_cells(&mesh.coords, CellType::Tri3, &mesh.conn).unwrap();
    let contact = Contact::new(surface.clone(), exact()).unwrap();
    refused(contact.evaluate(&coords), Error::InvertedCell { cell }, &[]);
    assert!(Contact::new(surface, Options { check_cells: false, ..exact() }).unwrap().evaluate(&coords).is_ok());
}

#[test]
fn cells_and_facets_of_no_measure() {
    let flat = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 1.0], [1.0, 1.0]];
    refused(of_cells(&flat, CellType::Tri3, &[0, 1, 3, 0, 1, 2]), Error::ZeroMeasure { cell: 1 }, &["cell or facet 1"]);
    refused(of_facets(&flat, &[[0, 1], [1, 4], [4, 3], [3, 0]]), Error::ZeroMeasure { cell: 1 }, &[]);
    let mesh = cuboid_tet4([0.0; 3], [1.0; 3], [2; 3]);
    let mut coords = mesh.coords.clone();
    let surface = of_cells(&coords, CellType::Tet4, &mesh.conn).unwrap();
    coords.iter_mut().for_each(|x| x[2] = 0.5);
    refused(Contact::new(surface, exact()).unwrap().evaluate(&coords), Error::ZeroMeasure { cell: 0 }, &[]);
}

#[test]
fn surfaces_with_a_border() {
    let mut edges = polygon(&SQUARE, 1).facets();
    edges.remove(2);
    let Err(Error::OpenSurface { facet, nodes }) = of_facets(&SQUARE, &edges) else { panic!("not noticed") };
    assert!(edges[facet].contains(&(nodes[0] as u32)) && nodes[0] == nodes[1]);
    let mesh = cuboid_surface([0.0; 3], [1.0; 3], [2; 3]);
    let mut facets = mesh.facets();
    let missing = facets.remove(17);
    let Err(Error::OpenSurface { facet, nodes }) = of_facets(&mesh.coords, &facets) else { panic!("not noticed") };
    assert!(nodes.iter().all(|n| missing.contains(&(*n as u32)) && facets[facet].contains(&(*n as u32))));
}

#[test]
fn more_than_two_at_an_edge() {
    // Two squares that share a corner: four edges meet there.
    let coords = [SQUARE.as_slice(), &[[2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]].concat();
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [2, 4], [4, 5], [5, 6], [6, 2]];
    refused(of_facets(&coords, &edges), Error::NonManifold { facet: 4, nodes: [2, 2] }, &["facet or cell 4", "2"]);
    // As two bodies they are in order.
    assert!(Surface::from_facets(&coords, &edges, Bodies::Ids(&[0, 0, 0, 0, 1, 1, 1, 1])).is_ok());
    // Three triangles at an edge.
    let coords = [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0], [0.5, -1.0], [0.6, 2.0]];
    let conn = [0, 1, 2, 1, 0, 3, 0, 1, 4];
    let Err(Error::NonManifold { facet, nodes }) = of_cells(&coords, CellType::Tri3, &conn) else {
        panic!("not noticed")
    };
    assert_eq!((facet, nodes), (2, [0, 1]));
    // Three tetrahedra at a face.
    let coords = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.3, 0.3, 2.0]];
    let conn = [0, 1, 2, 3, 0, 2, 1, 4, 0, 1, 2, 5];
    let Err(Error::NonManifold { facet: 2, .. }) = of_cells(&coords, CellType::Tet4, &conn) else {
        panic!("not noticed")
    };
}

#[test]
fn a_cell_that_is_there_twice() {
    let twice = |cell_type, coords: &[[f64; 2]], conn: &[u32]| of_cells(coords, cell_type, conn);
    // By itself, in either direction, and beside another cell.
    for conn in [&[0, 1, 2, 0, 1, 2][..], &[0, 1, 2, 0, 2, 1], &[0, 1, 2, 2, 0, 1, 0, 2, 3]] {
        let error = Error::RepeatedCell { cells: [0, 1] };
        refused(twice(CellType::Tri3, &SQUARE, conn), error, &["cells 0 and 1 have the same nodes"]);
    }
    let error = Error::RepeatedCell { cells: [0, 2] };
    refused(twice(CellType::Tri3, &SQUARE, &[0, 1, 2, 0, 2, 3, 1, 2, 0]), error, &["is a duplicate"]);
    // As two bodies they are in order.
    let blocks = [CellBlock { cell_type: CellType::Tri3, conn: &[0, 1, 2, 0, 1, 2] }];
    assert!(Surface::from_cells(&SQUARE, &blocks, Bodies::Ids(&[0, 1])).is_ok());
}

#[test]
fn neighbours_that_disagree_about_the_outside() {
    let mesh = cuboid_surface([0.0; 3], [1.0; 3], [2; 3]);
    let mut facets = mesh.facets();
    facets[9].swap(0, 1);
    let Err(Error::InconsistentOrientation { nodes, .. }) = of_facets(&mesh.coords, &facets) else {
        panic!("not noticed")
    };
    assert!(nodes.iter().all(|n| facets[9].contains(&(*n as u32))));
    let mut edges = polygon(&SQUARE, 1).facets();
    edges[1].swap(0, 1);
    let Err(Error::InconsistentOrientation { .. }) = of_facets(&SQUARE, &edges) else { panic!("not noticed") };
    // A band of quadrilaterals that closes with a twist has no sides to be told apart.
    let coords: Vec<[f64; 2]> = (0..8).map(|n| [(n / 2) as f64, (n % 2) as f64]).collect();
    let band = [0, 2, 3, 1, 2, 4, 5, 3, 4, 6, 7, 5, 6, 1, 0, 7];
    let Err(Error::InconsistentOrientation { .. }) = of_cells(&coords, CellType::Quad4, &band) else {
        panic!("not noticed")
    };
}

#[test]
fn surfaces_that_point_inwards() {
    let mesh = cuboid_surface([0.0; 3], [1.0; 3], [2; 3]);
    let facets: Vec<[u32; 3]> = mesh.facets().iter().map(|f| [f[0], f[2], f[1]]).collect();
    let ids = vec![42; facets.len()];
    let result = Surface::from_facets(&mesh.coords, &facets, Bodies::Ids(&ids));
    refused(result, Error::InvertedSurface { body: 42 }, &["body 42"]);
    refused(of_facets(&mesh.coords, &facets), Error::InvertedSurface { body: 0 }, &["body 0"]);
}
