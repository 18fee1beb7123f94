//! Cells with repeated nodes, as Abaqus and Ansys write them, against the cells that they are.

use crate::scene::Scene;
use crate::shaken;
use fmc_contact::contact::TangentPart;
use fmc_contact::{Bodies, CellBlock, CellType, Contact, EnergyLaw, Error, Options, Surface};
use fmc_shapes::{cuboid_mixed, rectangle_quad4};
use std::collections::{BTreeMap, BTreeSet};

type Blocks = Vec<(CellType, Vec<u32>)>;

/// A cell as another one that names nodes repeatedly: where in the larger cell its nodes stand.
const AS_OTHERS: [(CellType, CellType, &[usize]); 12] = [
    (CellType::Wedge6, CellType::Hex8, &[0, 1, 2, 2, 3, 4, 5, 5]),
    (CellType::Wedge6, CellType::Hex8, &[0, 0, 1, 2, 3, 3, 4, 5]),
    // A face that has become an edge.
    (CellType::Wedge6, CellType::Hex8, &[1, 0, 3, 4, 2, 2, 5, 5]),
    (CellType::Pyramid5, CellType::Hex8, &[0, 1, 2, 3, 4, 4, 4, 4]),
    (CellType::Pyramid5, CellType::Hex8, &[4, 4, 4, 4, 3, 2, 1, 0]),
    (CellType::Pyramid5, CellType::Wedge6, &[1, 0, 4, 2, 3, 4]),
    (CellType::Tet4, CellType::Hex8, &[0, 1, 2, 2, 3, 3, 3, 3]),
    (CellType::Tet4, CellType::Hex8, &[0, 1, 2, 0, 3, 3, 3, 3]),
    (CellType::Tet4, CellType::Wedge6, &[0, 1, 2, 3, 3, 3]),
    (CellType::Tet4, CellType::Pyramid5, &[0, 1, 2, 2, 3]),
    (CellType::Tri3, CellType::Quad4, &[0, 1, 2, 2]),
    (CellType::Tri3, CellType::Quad4, &[0, 1, 2, 0]),
];

/// All cells of a mesh that can be written in this way as `host`; `choice` goes round among several ways.
fn collapsed(blocks: &Blocks, host: CellType) -> Blocks {
    let mut found: Blocks = Vec::new();
    for (cell_type, conn) in blocks {
        let ways: Vec<_> = AS_OTHERS.iter().filter(|way| (way.0, way.1) == (*cell_type, host)).collect();
        for (choice, nodes) in conn.chunks_exact(cell_type.node_count()).enumerate() {
            let (as_type, nodes) = match ways.get(choice % ways.len().max(1)) {
                Some((_, _, places)) => (host, places.iter().map(|&place| nodes[place]).collect()),
                None => (*cell_type, nodes.to_vec()),
            };
            match found.last_mut() {
                Some((last, all)) if *last == as_type => all.extend(nodes),
                _ => found.push((as_type, nodes)),
            }
        }
    }
    found
}

fn surface<const D: usize>(scene: &Scene<D>, blocks: &Blocks) -> Result<Surface<D>, Error> {
    let blocks: Vec<_> = blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
    Surface::from_cells(&scene.coords, &blocks, Bodies::Ids(&scene.ids))
}

/// Energy, volume, forces and tangent of both, and what they say of their surfaces. On curved faces in space the law `depth` sums points
/// up, on triangles that depend on the order of the corners.
fn are_the_same<const D: usize>(scene: &Scene<D>, given: &Blocks, what: &str) {
    let surfaces = [&scene.blocks, given].map(|blocks| surface(scene, blocks).expect("cells"));
    let faces = |surface: &Surface<D>| -> BTreeSet<(usize, Vec<u32>)> {
        let sorted = |mut nodes: Vec<u32>| {
            nodes.sort_unstable();
            nodes
        };
        surface.faces().into_iter().map(|(body, nodes)| (body, sorted(nodes))).collect()
    };
    assert_eq!(faces(&surfaces[0]), faces(&surfaces[1]), "{what}");
    let is_curved = scene.blocks.iter().any(|(cell_type, _)| cell_type.straight() != *cell_type);
    for (law, within) in [
        (EnergyLaw::depth(1.0), if is_curved { [1e-7, 1e-4] } else { [1e-12; 2] }),
        (EnergyLaw::volume(1.0), [1e-12; 2]),
    ] {
        let [expected, found] = surfaces.clone().map(|surface| {
            let contact = Contact::new(surface, Options::new(law)).expect("options");
            let tangent = contact.tangent(&scene.coords, TangentPart::Full).expect("a tangent");
            let direction = shaken_directions(scene.coords.len());
            (contact.evaluate(&scene.coords).expect("forces"), tangent.product(&direction))
        });
        let size: f64 = expected.0.forces.iter().flatten().map(|f| f.abs()).sum();
        assert!(expected.0.volume > 1e-3 && size > 1e-3, "{what}: no contact");
        let close = |x: f64, y: f64, of: f64| assert!((x - y).abs() <= of, "{what}, {law:?}: {x} {y}");
        close(expected.0.volume, found.0.volume, within[0] * expected.0.volume);
        close(expected.0.energy, found.0.energy, within[0] * expected.0.energy);
        for (f, g) in expected.0.forces.iter().flatten().zip(found.0.forces.iter().flatten()) {
            close(*f, *g, within[0] * size);
        }
        let size: f64 = expected.1.iter().flatten().map(|f| f.abs()).sum();
        for (f, g) in expected.1.iter().flatten().zip(found.1.iter().flatten()) {
            close(*f, *g, within[1] * size);
        }
    }
}

fn shaken_directions<const D: usize>(count: usize) -> Vec<[f64; D]> {
    let mut random = fmc_shapes::Splitmix::new(9);
    (0..count).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect()
}

/// Two blocks of hexahedra, wedges, pyramids and tetrahedra, disturbed, one in the other.
fn in_space() -> Scene<3> {
    let lower = cuboid_mixed([0.0; 3], [1.0; 3], [2, 1, 3]);
    let upper = cuboid_mixed([0.2, 0.15, 0.9], [1.1, 1.2, 1.8], [1, 2, 3]);
    let mut scene = Scene::new().with_mixed(&lower, 0).with_mixed(&upper, 1);
    scene.coords = shaken(&scene.coords, 0.02, 5);
    scene
}

#[test]
fn of_first_order_in_space() {
    let scene = in_space();
    for host in [CellType::Hex8, CellType::Wedge6, CellType::Pyramid5] {
        let given = collapsed(&scene.blocks, host);
        assert_ne!(given, scene.blocks);
        are_the_same(&scene, &given, &format!("as {host:?}"));
    }
}

#[test]
fn in_the_plane() {
    let triangles = |low, high| {
        let mut mesh = rectangle_quad4(low, high, [3, 3]);
        mesh.conn = mesh.conn.chunks_exact(4).flat_map(|c| [c[0], c[1], c[2], c[0], c[2], c[3]]).collect();
        mesh.nodes_per_cell = 3;
        mesh
    };
    let scene = Scene::of(&[&triangles([0.0, 0.0], [1.0, 1.0]), &triangles([0.13, 0.9], [0.8, 1.7])]);
    are_the_same(&scene, &collapsed(&scene.blocks, CellType::Quad4), "as Quad4");
}

/// Nodes in the middle of all edges, one for edges that have become one, the corner for one that has become none.
fn with_middles<const D: usize>(
    blocks: &Blocks,
    coords: &mut Vec<[f64; D]>,
    known: &mut BTreeMap<[u32; 2], u32>,
) -> Blocks {
    let mut found = Vec::new();
    for (cell_type, conn) in blocks {
        let (raised, edges) = raised(*cell_type);
        let mut all = Vec::new();
        for nodes in conn.chunks_exact(cell_type.node_count()) {
            all.extend_from_slice(nodes);
            for word in edges.split(' ') {
                let [a, b] = [0, 1].map(|k| nodes[usize::from(word.as_bytes()[k] - b'0')]);
                let middle = *known.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    if a == b {
                        return a;
                    }
                    // A little off the chord, so that faces are curved.
                    let bend = 0.001 * f64::from((a * 7 + b * 3) % 5);
                    let ends = [a, b].map(|node| coords[node as usize]);
                    coords.push(std::array::from_fn(|axis| 0.5 * (ends[0][axis] + ends[1][axis]) + bend));
                    coords.len() as u32 - 1
                });
                all.push(middle);
            }
        }
        found.push((raised, all));
    }
    found
}

fn raised(straight: CellType) -> (CellType, &'static str) {
    match straight {
        CellType::Tri3 => (CellType::Tri6, "01 12 20"),
        CellType::Quad4 => (CellType::Quad8, "01 12 23 30"),
        CellType::Tet4 => (CellType::Tet10, "01 12 20 03 13 23"),
        CellType::Wedge6 => (CellType::Wedge15, "01 12 20 34 45 53 03 14 25"),
        CellType::Pyramid5 => (CellType::Pyramid13, "01 12 23 30 04 14 24 34"),
        _ => (CellType::Hex20, "01 12 23 30 45 56 67 74 04 15 26 37"),
    }
}

#[test]
fn of_second_order() {
    for host in [CellType::Hex8, CellType::Wedge6, CellType::Pyramid5] {
        let mut scene = in_space();
        let given = collapsed(&scene.blocks, host);
        let mut known = BTreeMap::new();
        let straight = std::mem::take(&mut scene.blocks);
        scene.blocks = with_middles(&straight, &mut scene.coords, &mut known);
        let nodes = scene.coords.len();
        let given = with_middles(&given, &mut scene.coords, &mut known);
        assert_eq!(scene.coords.len(), nodes);
        are_the_same(&scene, &given, &format!("of second order as {host:?}"));
    }
}

/// Cells and their faces count as the host has them: by cell, the nodes of VTK's faces of what was given.
#[test]
fn faces_are_those_that_were_given() {
    /// Of `vtkHexahedron`.
    const FACES: [[usize; 4]; 6] = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];
    let scene = in_space();
    let given = collapsed(&scene.blocks, CellType::Hex8);
    let [(CellType::Hex8, conn)] = &given[..] else { panic!("{given:?}") };
    let facets = surface(&scene, &given).unwrap().boundary_facets();
    assert!(!facets.is_empty());
    for facet in facets {
        let cell = &conn[8 * facet.cell.unwrap()..][..8];
        let face: BTreeSet<u32> = FACES[facet.local_face.unwrap()].iter().map(|&k| cell[k]).collect();
        assert_eq!(face, facet.nodes.iter().copied().collect(), "{facet:?}");
    }
}

#[test]
fn errors_name_the_cell_as_given() {
    let coords = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [0., 0., -1.], [1., 1., 0.], [1., 1., 1.]];
    let of = |conn: &[u32]| {
        let blocks = [CellBlock { cell_type: CellType::Hex8, conn }];
        Surface::from_cells(&coords, &blocks, Bodies::Connected).err()
    };
    let sound = [0, 1, 2, 2, 3, 3, 3, 3];
    assert_eq!(of(&sound), None);
    // Two opposite corners of a face, seven nodes, an edge of one triangle of a wedge, nothing but an edge: no cells.
    for bad in
        [[0, 1, 0, 2, 3, 3, 3, 3], [0, 1, 5, 2, 3, 4, 6, 6], [0, 1, 2, 2, 3, 6, 6, 6], [0, 1, 1, 0, 0, 1, 1, 0], [0; 8]]
    {
        let found = of(&[&sound[..], &bad].concat());
        assert!(matches!(found, Some(Error::RepeatedNode { cell: 1, .. })), "{bad:?}: {found:?}");
    }
    assert_eq!(of(&[&sound[..], &[0, 1, 2, 2, 5, 5, 5, 5]].concat()), Some(Error::ZeroMeasure { cell: 1 }));
    assert_eq!(
        of(&[&sound[..], &[0, 1, 2, 2, 9, 9, 9, 9]].concat()),
        Some(Error::NodeOutOfRange { cell: 1, node: 9, node_count: 7 })
    );
    assert_eq!(of(&[sound, [1, 2, 0, 0, 3, 3, 3, 3]].concat()), Some(Error::RepeatedCell { cells: [0, 1] }));
    // A middle node that belongs to neither end, and a cell whose faces have nodes in their middle.
    let square = [[0., 0.], [1., 0.], [0., 1.], [0.5, 0.], [0.5, 0.5], [0., 0.5], [0.3, 0.3]];
    let of = |cell_type, conn: &[u32]| {
        Surface::from_cells(&square, &[CellBlock { cell_type, conn }], Bodies::Connected).err()
    };
    assert_eq!(of(CellType::Quad8, &[0, 1, 2, 2, 3, 4, 2, 5]), None);
    for (cell_type, conn) in [
        (CellType::Quad8, &[0, 1, 2, 2, 3, 4, 6, 5][..]),
        (CellType::Quad8, &[0, 1, 2, 2, 3, 3, 2, 5]),
        (CellType::Quad9, &[0, 1, 2, 2, 3, 4, 2, 5, 6]),
    ] {
        let found = of(cell_type, conn);
        assert!(matches!(found, Some(Error::RepeatedNode { cell: 0, .. })), "{conn:?}: {found:?}");
    }
}
