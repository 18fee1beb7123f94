//! One cell: its faces, its volume, and what is refused.

use crate::scene::{Scene, distance, exact, norm};
use crate::shaken;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, Error, Options, Surface};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4};

/// A cell of each type with its volume: the corners of a unit cube or of half of it, the apex above the middle of its base.
fn cells() -> [(CellType, Vec<[f64; 3]>, f64); 4] {
    let cube = cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]);
    let of = |corners: &[usize]| corners.iter().map(|&k| cube.coords[cube.conn[k] as usize]).collect::<Vec<_>>();
    let pyramid = [of(&[0, 1, 2, 3]), vec![[0.5, 0.5, 1.0]]].concat();
    [
        (CellType::Tet4, of(&[0, 1, 3, 4]), 1.0 / 6.0),
        (CellType::Hex8, of(&[0, 1, 2, 3, 4, 5, 6, 7]), 1.0),
        (CellType::Wedge6, of(&[0, 1, 3, 4, 5, 7]), 0.5),
        (CellType::Pyramid5, pyramid, 1.0 / 3.0),
    ]
}

fn minus(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| x[i] - y[i])
}

fn cross(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
}

fn dot(x: [f64; 3], y: [f64; 3]) -> f64 {
    (0..3).map(|i| x[i] * y[i]).sum()
}

/// The triangles of a cell's faces, outward; quadrilaterals in four about their centroids.
fn triangles(cell_type: CellType, coords: &[[f64; 3]]) -> Vec<[[f64; 3]; 3]> {
    let mut all = Vec::new();
    for face in cell_type.faces() {
        let x: Vec<[f64; 3]> = face.iter().map(|&k| coords[k]).collect();
        if let [p, q, r] = x[..] {
            all.push([p, q, r]);
            continue;
        }
        let middle = std::array::from_fn(|i| x.iter().map(|x| x[i]).sum::<f64>() / 4.0);
        all.extend((0..4).map(|k| [x[k], x[(k + 1) % 4], middle]));
    }
    all
}

fn surface(cell_type: CellType, coords: &[[f64; 3]], conn: &[u32]) -> Result<Surface<3>, Error> {
    Surface::from_cells(coords, &[CellBlock { cell_type, conn }], Bodies::Connected)
}

/// A cell within a large box of tetrahedra: all of it overlaps.
fn in_a_box(cell_type: CellType, coords: &[[f64; 3]]) -> Scene<3> {
    let cell = Mesh { coords: coords.to_vec(), conn: (0..coords.len() as u32).collect(), nodes_per_cell: coords.len() };
    assert_eq!(cell_type.node_count(), coords.len());
    Scene::of(&[&cell, &cuboid_tet4([-2.0; 3], [2.5; 3], [2; 3])])
}

#[test]
fn closed_outward_and_full() {
    for (cell_type, flat, volume) in cells() {
        for seed in 0..20 {
            let coords = shaken(&flat, if seed == 0 { 0.0 } else { 0.15 }, seed);
            let (mut areas, mut enclosed) = ([0.0; 3], 0.0);
            for [p, q, r] in triangles(cell_type, &coords) {
                let area = cross(minus(q, p), minus(r, p)).map(|a| 0.5 * a);
                areas = std::array::from_fn(|i| areas[i] + area[i]);
                enclosed += dot(std::array::from_fn(|i| (p[i] + q[i] + r[i]) / 3.0), area) / 3.0;
            }
            assert!(areas.iter().all(|a| a.abs() < 1e-14), "{cell_type:?}: {areas:?}");
            if seed == 0 {
                assert!((enclosed - volume).abs() < 1e-15, "{cell_type:?}: {enclosed} for {volume}");
            }
            let found = in_a_box(cell_type, &coords).evaluate(exact()).volume;
            assert!((found - enclosed).abs() < 1e-13, "{cell_type:?}: {found} for {enclosed}");
            let jacobian = dot(
                cross(minus(coords[1], coords[0]), minus(coords[2], coords[0])),
                minus(*coords.last().expect("nodes"), coords[0]),
            );
            assert!(jacobian > 0.0);
        }
    }
}

/// VTK's wedge has its first triangle the other way round: the same cell, with the same surface, volume and forces.
#[test]
fn mirrored_orders_are_the_same_cells() {
    let mirrored = |cell_type: CellType| match cell_type {
        CellType::Tet4 => vec![0, 2, 1, 3],
        CellType::Wedge6 => vec![0, 2, 1, 3, 5, 4],
        CellType::Pyramid5 => vec![0, 3, 2, 1, 4],
        _ => vec![0, 3, 2, 1, 4, 7, 6, 5],
    };
    let block = cuboid_hex8([-1.0, -1.0, -1.0], [2.0, 2.0, 0.3], [2, 2, 2]);
    for (cell_type, flat, _) in cells() {
        let coords = shaken(&flat, 0.05, 3);
        let cell = Mesh { conn: (0..coords.len() as u32).collect(), nodes_per_cell: coords.len(), coords };
        let other = Mesh { conn: mirrored(cell_type), ..cell.clone() };
        let [one, two] = [cell, other].map(|cell| Scene::of(&[&cell, &block]).evaluate(exact()));
        assert!((one.volume - two.volume).abs() < 1e-15 && one.volume > 0.01);
        assert!(distance(&one.forces, &two.forces) < 1e-14 * norm(&one.forces));
    }
}

/// Wedges in VTK's order beside hexahedra in theirs: what is outside follows from the faces that they share.
#[test]
fn both_orders_in_one_body() {
    let mixed = fmc_shapes::cuboid_mixed([0.0; 3], [1.0; 3], [2, 2, 3]);
    let block = cuboid_hex8([-1.0, -1.0, 0.8], [2.0, 2.0, 2.0], [2, 2, 2]);
    let mut turned = mixed.clone();
    turned[1].conn.chunks_exact_mut(6).for_each(|cell| [1, 4].into_iter().for_each(|k| cell.swap(k, k + 1)));
    let [one, two] = [mixed, turned].map(|body| Scene::new().with_mixed(&body, 0).with(&block, 1).evaluate(exact()));
    assert!((one.volume - 0.2).abs() < 1e-14 && (two.volume - 0.2).abs() < 1e-14);
    assert!(distance(&one.forces, &two.forces) < 1e-13 * norm(&one.forces));
}

#[test]
fn inverted_and_flat_cells_are_named() {
    // A block before it, whose cells are counted first.
    let before = cuboid_tet4([5.0; 3], [6.0; 3], [1; 3]);
    for (cell_type, coords, _) in cells() {
        let refused = |coords: &[[f64; 3]]| {
            let all = [&before.coords[..], coords].concat();
            let first = before.coords.len() as u32;
            let conn: Vec<u32> = (first..first + coords.len() as u32).collect();
            let blocks =
                [CellBlock { cell_type: CellType::Tet4, conn: &before.conn }, CellBlock { cell_type, conn: &conn }];
            Surface::from_cells(&all, &blocks, Bodies::Connected).err()
        };
        assert_eq!(refused(&coords), None);
        let flat: Vec<[f64; 3]> = coords.iter().map(|x| [x[0], x[1], 0.25]).collect();
        assert_eq!(refused(&flat), Some(Error::ZeroMeasure { cell: 6 }), "{cell_type:?}");
        if cell_type != CellType::Tet4 {
            // The second node beyond the other end of its edges: negative at a corner, positive as a whole.
            let mut turned = coords.clone();
            turned[1] = [-0.3, 0.6, 0.0];
            assert_eq!(refused(&turned), Some(Error::InvertedCell { cell: 6 }), "{cell_type:?}");
        }
        // In an evaluation, where it can be allowed.
        let conn: Vec<u32> = (0..coords.len() as u32).collect();
        let surface = surface(cell_type, &coords, &conn).expect("a valid cell");
        let mirrored: Vec<[f64; 3]> = coords.iter().map(|x| [x[0], x[1], -x[2]]).collect();
        let contact = Contact::new(surface.clone(), exact()).expect("valid options");
        assert_eq!(contact.evaluate(&mirrored).err(), Some(Error::InvertedCell { cell: 0 }));
        let options = Options { check_cells: false, ..exact() };
        assert!(Contact::new(surface, options).expect("valid options").evaluate(&mirrored).is_ok());
    }
}
