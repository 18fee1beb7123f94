//! Cells whose map folds at a node or a quadrature point are refused by name; shape functions from the literature, derivatives by
//! differences.

use crate::{boxes, rectangles, shaken};
use fmc_contact::CellType::{Hex20, Hex27, Pyramid13, Quad8, Quad9, Tet10, Tri6, Wedge15};
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, MapPoint, Options, Surface};

const QUAD: [[usize; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];
const HEX: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
const FACES: [[usize; 4]; 6] = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];

/// Where the nodes stand in the coordinates of the shape functions.
fn places(cell_type: CellType) -> Vec<[f64; 3]> {
    let square = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let cube = [square, square.map(|[x, y, _]| [x, y, 1.])].concat();
    let triangle = [square[0], square[1], square[3]];
    let (mut at, edges): (Vec<[f64; 3]>, &[[usize; 2]]) = match cell_type {
        Tri6 => (triangle.to_vec(), &[[0, 1], [1, 2], [2, 0]]),
        Quad8 | Quad9 => (square.to_vec(), &QUAD),
        Tet10 => ([&triangle[..], &[[0., 0., 1.]]].concat(), &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]]),
        Hex20 | Hex27 => (cube, &HEX),
        Wedge15 => (
            triangle.into_iter().chain(triangle.map(|[x, y, _]| [x, y, 1.])).collect(),
            &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]],
        ),
        _ => (
            vec![[-1., -1., 0.], [1., -1., 0.], [1., 1., 0.], [-1., 1., 0.], [0., 0., 1.]],
            &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]],
        ),
    };
    for &[p, q] in edges {
        at.push(std::array::from_fn(|axis| (at[p][axis] + at[q][axis]) / 2.));
    }
    if cell_type == Quad9 {
        at.push([0.5, 0.5, 0.]);
    }
    if cell_type == Hex27 {
        for face in FACES {
            at.push(std::array::from_fn(|axis| face.iter().map(|&corner| at[corner][axis]).sum::<f64>() / 4.));
        }
        at.push([0.5; 3]);
    }
    at
}

/// Shape function of the node that stands at `node`.
fn shape(cell_type: CellType, node: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    let quadratic = |at: f64, x: f64| match at {
        0.0 => (1. - x) * (1. - 2. * x),
        1.0 => x * (2. * x - 1.),
        _ => 4. * x * (1. - x),
    };
    // Of a simplex: L (2 L − 1) at a corner, 4 L L' between two.
    let simplex = |lambda: &[f64], of_node: &[f64]| {
        let on: Vec<usize> = (0..lambda.len()).filter(|&k| of_node[k] != 0.).collect();
        match on[..] {
            [k] => lambda[k] * (2. * lambda[k] - 1.),
            _ => 4. * lambda[on[0]] * lambda[on[1]],
        }
    };
    let [a, b, c] = node;
    match cell_type {
        Tri6 => simplex(&[1. - x - y, x, y], &[1. - a - b, a, b]),
        Tet10 => simplex(&[1. - x - y - z, x, y, z], &[1. - a - b - c, a, b, c]),
        Quad9 => quadratic(a, x) * quadratic(b, y),
        Hex27 => quadratic(a, x) * quadratic(b, y) * quadratic(c, z),
        Quad8 | Hex20 => {
            let dim = if cell_type == Quad8 { 2 } else { 3 };
            let both = [(a, x), (b, y), (c, z)].map(|(a, x)| (2. * a - 1., 2. * x - 1.));
            let axes = &both[..dim];
            let linear: f64 = axes.iter().map(|(a, x)| (1. + a * x) / 2.).product();
            match axes.iter().find(|(a, _)| *a == 0.) {
                Some((_, x)) => 2. * linear * (1. - x * x),
                None => linear * (axes.iter().map(|(a, x)| a * x).sum::<f64>() - dim as f64 + 1.),
            }
        }
        Wedge15 => {
            let (lambda, of_node) = ([1. - x - y, x, y], [1. - a - b, a, b]);
            let (u, s) = (2. * c - 1., 2. * z - 1.);
            match of_node.iter().position(|l| *l == 1.) {
                Some(k) if u == 0. => lambda[k] * (1. - s * s),
                Some(k) => lambda[k] / 2. * ((2. * lambda[k] - 1.) * (1. + u * s) - (1. - s * s)),
                None => simplex(&lambda, &of_node) / 2. * (1. + u * s),
            }
        }
        _ => {
            let w = 1. - z;
            match (a, b, c) {
                (_, _, 1.0) => z * (2. * z - 1.),
                (_, _, 0.5) => z * (w + 2. * a * x) * (w + 2. * b * y) / w,
                (0.0, _, _) => (w * w - x * x) * (w + b * y) / (2. * w),
                (_, 0.0, _) => (w * w - y * y) * (w + a * x) / (2. * w),
                _ => 0.25 * (a * x + b * y - 1.) * ((1. + a * x) * (1. + b * y) - z + a * b * x * y * z / w),
            }
        }
    }
}

/// Determinant of ∂x/∂ξ by differences.
fn determinant<const D: usize>(cell_type: CellType, x: &[[f64; D]], at: [f64; 3]) -> f64 {
    let places = places(cell_type);
    let map = |at: [f64; 3]| -> [f64; D] {
        let weights: Vec<f64> = places.iter().map(|&node| shape(cell_type, node, at)).collect();
        std::array::from_fn(|axis| x.iter().zip(&weights).map(|(x, w)| w * x[axis]).sum())
    };
    let h = 1e-5;
    let mut j = [[0.0; 3], [0.0; 3], [0.0, 0.0, 1.0]];
    for (axis, line) in j.iter_mut().take(D).enumerate() {
        let step = |h: f64| std::array::from_fn(|k| at[k] + if k == axis { h } else { 0. });
        let (plus, minus) = (map(step(h)), map(step(-h)));
        (0..D).for_each(|k| line[k] = (plus[k] - minus[k]) / (2. * h));
    }
    let [a, b, c] = j;
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

fn quadrature(cell_type: CellType) -> Vec<[f64; 3]> {
    let three = [0.5 - 0.15f64.sqrt(), 0.5, 0.5 + 0.15f64.sqrt()];
    let triangle = [[1. / 6., 1. / 6.], [2. / 3., 1. / 6.], [1. / 6., 2. / 3.]];
    let (mut all, aside) = (Vec::new(), 0.138_196_601_125_010_5);
    match cell_type {
        Tri6 => all.extend(triangle.map(|[x, y]| [x, y, 0.])),
        Quad8 | Quad9 => three.iter().for_each(|&y| all.extend(three.map(|x| [x, y, 0.]))),
        Tet10 => {
            all = vec![[aside; 3]; 4];
            (0..3).for_each(|axis| all[axis + 1][axis] = 1. - 3. * aside);
        }
        Wedge15 => three.iter().for_each(|&z| all.extend(triangle.map(|[x, y]| [x, y, z]))),
        Pyramid13 => {
            let two = [-1.0, 1.0].map(|side: f64| side / 3.0f64.sqrt());
            for z in two.map(|z| (1. + z) / 2.) {
                two.iter().for_each(|&y| all.extend(two.map(|x| [(1. - z) * x, (1. - z) * y, z])));
            }
        }
        _ => {
            for &z in &three {
                three.iter().for_each(|&y| all.extend(three.map(|x| [x, y, z])));
            }
        }
    }
    all
}

fn of_cell<const D: usize>(cell_type: CellType, x: &[[f64; D]]) -> Result<Surface<D>, Error> {
    let conn: Vec<u32> = (0..x.len() as u32).collect();
    Surface::from_cells(x, &[CellBlock { cell_type, conn: &conn }], Bodies::Connected)
}

fn check_random_cells<const D: usize>(cell_type: CellType, cell: &[[f64; D]]) {
    let places = places(cell_type);
    let nodes = || places.iter().enumerate().filter(|(node, _)| cell_type != Pyramid13 || *node != 4);
    let points = quadrature(cell_type);
    let sign = determinant(cell_type, cell, points[0]).signum();
    let (mut valid, mut folded) = (0, 0);
    for seed in 0..300 {
        let by = 0.001 * seed as f64;
        let x = shaken(cell, by, seed).iter().map(|x| x.map(|x| x + 7.0)).collect::<Vec<_>>();
        let at = |place: [f64; 3]| sign * determinant(cell_type, &x, place);
        let least =
            nodes().map(|(_, place)| at(*place)).chain(points.iter().map(|&place| at(place))).fold(1., f64::min);
        match of_cell(cell_type, &x) {
            Ok(_) => {
                assert!(least > -1e-6, "{cell_type:?} {seed}: {least}");
                valid += 1;
            }
            Err(Error::FoldedCell { cell, at: point, determinant }) => {
                let place = match point {
                    MapPoint::Node(node) => places[node],
                    MapPoint::Quadrature(point) => points[point],
                };
                let found = at(place);
                let error = (found.abs() - determinant.abs()).abs();
                assert!(
                    cell == 0 && determinant < 0. && error < 1e-6,
                    "{cell_type:?} {seed} {point:?}: {determinant} {found}"
                );
                // Seen from the other side where most of the cell is turned.
                folded += usize::from(found < 0.);
            }
            // A straight part that is turned while the map is not.
            Err(error) => {
                assert!(matches!(error, Error::InvertedCell { cell: 0 }) && least > -1e-6, "{error:?} {least}")
            }
        }
    }
    assert!(valid > 30 && folded > 30, "{cell_type:?}: {valid} valid, {folded} folded");
}

#[test]
fn random_cells_are_refused_where_they_fold() {
    for (cell_type, mesh) in [Tri6, Quad8, Quad9].into_iter().zip(rectangles([0.; 2], [1.; 2], [1, 1])) {
        let first = &mesh.conn[..cell_type.node_count()];
        check_random_cells(cell_type, &first.iter().map(|&node| mesh.coords[node as usize]).collect::<Vec<_>>());
    }
    let types = [Tet10, Hex20, Hex27, Wedge15, Pyramid13];
    for (cell_type, mesh) in types.into_iter().zip(boxes([0.; 3], [1.; 3], [1; 3])) {
        let first = &mesh.conn[..cell_type.node_count()];
        check_random_cells(cell_type, &first.iter().map(|&node| mesh.coords[node as usize]).collect::<Vec<_>>());
    }
}

/// Middles of all edges at corner 0 drawn to it: J is singular there with a quarter, which is how tips of cracks are meshed, and
/// folds beyond. Elsewhere in the cell nothing is wrong.
#[test]
fn quarter_points_are_taken_and_no_less() {
    fn with_middles_at<const D: usize>(cell_type: CellType, part: f64, edges: usize) -> Result<Surface<D>, Error> {
        let (c, s) = (0.3f64.cos(), 0.3f64.sin());
        let corners = match cell_type {
            Tri6 => 3,
            Quad8 | Tet10 => 4,
            _ => 8,
        };
        let mut x = places(cell_type);
        let ends: Vec<usize> = (1..corners).filter(|&k| x[k].iter().sum::<f64>() == 1.).collect();
        for end in ends.into_iter().take(edges) {
            let middle = x.iter().position(|at| (0..3).all(|axis| at[axis] == x[end][axis] / 2.)).expect("a middle");
            x[middle] = x[end].map(|x| part * x);
        }
        let turned = |[x, y, z]: [f64; 3]| [c * x - s * y + 11., s * x + c * y - 3., z + 0.1];
        let x: Vec<[f64; D]> = x.into_iter().map(|x| std::array::from_fn(|axis| turned(x)[axis])).collect();
        of_cell(cell_type, &x)
    }
    fn check<const D: usize>(cell_type: CellType) {
        for edges in 1..=D {
            assert!(with_middles_at::<D>(cell_type, 0.25, edges).is_ok(), "{cell_type:?}");
        }
        // With two edges turned the determinant at the corner is positive again; with one or three it is not.
        for edges in (1..=D).step_by(2) {
            let refused = with_middles_at::<D>(cell_type, 0.24, edges).err();
            let is_told = matches!(refused, Some(Error::FoldedCell { cell: 0, at: MapPoint::Node(0), determinant }) if determinant < 0.);
            assert!(is_told, "{cell_type:?}: {refused:?}");
        }
    }
    check::<2>(Tri6);
    check::<2>(Quad8);
    check::<3>(Tet10);
    check::<3>(Hex20);
}

/// What folds at a node only, as iterates of a solver may, is no cell to begin with, but one that goes on: a host integrates at
/// its quadrature points.
#[test]
fn on_the_way_only_quadrature_points_count() {
    [Tri6, Quad8].into_iter().for_each(on_the_way::<2>);
    [Tet10, Hex20].into_iter().for_each(on_the_way::<3>);
}

fn on_the_way<const D: usize>(cell_type: CellType) {
    let x: Vec<[f64; D]> = places(cell_type).iter().map(|x| std::array::from_fn(|axis| x[axis])).collect();
    let end = (1..x.len()).find(|&k| x[k].iter().sum::<f64>() == 1.).expect("a neighbour of the first corner");
    let middle = x.iter().position(|at| (0..D).all(|axis| at[axis] == x[end][axis] / 2.)).expect("a middle");
    let mut folded = x.clone();
    folded[middle] = x[end].map(|x| 0.24 * x);
    let mut contact =
        Contact::new(of_cell(cell_type, &x).expect("a cell"), Options::new(EnergyLaw::volume(1.0))).expect("options");
    assert!(contact.evaluate(&folded).is_ok(), "{cell_type:?}");
    let refused = contact.set_reference(&folded).expect_err("folded at a node");
    assert!(matches!(refused, Error::FoldedCell { cell: 0, at: MapPoint::Node(0), .. }), "{cell_type:?}: {refused:?}");
    // Farther, it folds at a quadrature point too.
    folded[middle] = x[end].map(|x| -0.9 * x);
    let refused = contact.evaluate(&folded).expect_err("folded");
    assert!(
        matches!(refused, Error::FoldedCell { cell: 0, at: MapPoint::Quadrature(_), .. }),
        "{cell_type:?}: {refused:?}"
    );
}

/// What a contact keeps of earlier checks does not show: at every step its answer is that of a new contact.
#[test]
fn kept_checks_answer_as_new_ones() {
    let types = [Tet10, Hex20, Hex27, Wedge15, Pyramid13];
    for (cell_type, mesh) in types.into_iter().zip(boxes([0.; 3], [1.; 3], [3, 2, 2])) {
        let new = || {
            let blocks = [CellBlock { cell_type, conn: &mesh.conn }];
            let surface = Surface::from_cells(&mesh.coords, &blocks, Bodies::Connected).expect("a mesh");
            Contact::new(surface, Options::new(EnergyLaw::volume(1.0))).expect("options")
        };
        let kept = new();
        let (mut passed, mut folded) = (0, 0);
        for step in 0..40 {
            let turned = mesh.clone().rotated([1., 2., 3.], 0.03 * f64::from(step)).coords;
            let coords = shaken(&turned, 0.003 * f64::from(step), 5);
            let found = kept.evaluate(&coords).map(|forces| forces.volume);
            assert_eq!(found, new().evaluate(&coords).map(|forces| forces.volume), "{cell_type:?} {step}");
            match found {
                Ok(_) => passed += 1,
                Err(error) => folded += usize::from(matches!(error, Error::FoldedCell { .. })),
            }
        }
        assert!(passed > 5 && folded > 5, "{cell_type:?}: {passed} passed, {folded} folded");
    }
}
