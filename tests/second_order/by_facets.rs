//! Surfaces given by facets of second order, without cells: as the skins of cells.

use crate::scene::{Scene, distance, exact, norm, table::exactly};
use crate::{boxes, pair, rectangles, shaken};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{
    Bodies, Contact, EnergyLaw, Error, Estimator, FacetBlock, FacetType, FiberOptions, Options, Resolution, Surface,
};
use fmc_shapes::Mesh;

/// The facets of all bodies by type, and the body of each.
fn skin<const D: usize>(meshes: &[&Mesh<D>]) -> (Vec<(FacetType, Vec<u32>)>, Vec<i64>) {
    let (mut blocks, mut ids, mut first) = (Vec::<(FacetType, Vec<u32>)>::new(), Vec::<Vec<i64>>::new(), 0);
    for (body, mesh) in meshes.iter().enumerate() {
        for face in mesh.boundary_faces() {
            let facet_type = match (D, face.len()) {
                (2, 3) => FacetType::Line3,
                (3, 6) => FacetType::Tri6,
                (3, 8) => FacetType::Quad8,
                (3, 9) => FacetType::Quad9,
                other => panic!("no facet of second order: {other:?}"),
            };
            let place = blocks.iter().position(|(of_type, _)| *of_type == facet_type).unwrap_or_else(|| {
                blocks.push((facet_type, Vec::new()));
                ids.push(Vec::new());
                blocks.len() - 1
            });
            blocks[place].1.extend(face.into_iter().map(|node| node + first));
            ids[place].push(body as i64);
        }
        first += mesh.coords.len() as u32;
    }
    (blocks, ids.concat())
}

fn by_facets<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[(FacetType, Vec<u32>)],
    bodies: Bodies,
) -> Result<Surface<D>, Error> {
    let blocks: Vec<_> = blocks.iter().map(|(facet_type, conn)| FacetBlock { facet_type: *facet_type, conn }).collect();
    Surface::from_facet_blocks(coords, &blocks, bodies)
}

fn same<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, options: Options, seed: u64) {
    let scene = pair(lower, upper);
    let coords = shaken(&scene.coords, 0.02, seed);
    let (blocks, ids) = skin(&[lower, upper]);
    let facets = by_facets(&coords, &blocks, Bodies::Ids(&ids)).expect("a closed surface");
    let (cells, facets) = (scene.contact(options), Contact::new(facets, options).expect("options"));
    assert_eq!(cells.surface().facet_count(), facets.surface().facet_count());
    let [of_cells, of_facets] = [&cells, &facets]
        .map(|contact| contact.evaluate_tangent(&coords, TangentPart::Full).expect("valid coordinates"));
    let what = format!("{:?} {:?}, {:?}", scene.blocks[0].0, options.law, options.estimator);
    let size = norm(&of_cells.0.forces);
    assert!(size > 1e-3, "{what}");
    let off = distance(&of_cells.0.forces, &of_facets.0.forces);
    assert!(off < 1e-12 * size, "{what}: {off} of {size}");
    assert!((of_cells.0.volume - of_facets.0.volume).abs() < 1e-12 * of_cells.0.volume, "{what}");
    let direction = shaken(&vec![[0.0; D]; coords.len()], 1.0, seed + 1);
    let [one, other] = [of_cells.1, of_facets.1].map(|tangent| tangent.product(&direction));
    let off = distance(&one, &other);
    assert!(off < 1e-11 * norm(&one), "{what}: tangent {off} of {}", norm(&one));
}

fn all_options() -> Vec<Options> {
    let sampled = FiberOptions { resolution: Resolution::Spacing(0.05), seed: 3, ..FiberOptions::default() };
    let laws = [EnergyLaw::volume(1.0), EnergyLaw::Volume { stiffness: 2.0, exponent: 1.5 }, EnergyLaw::fiber(5.0)];
    let with =
        |law| [exactly(law), Options { estimator: Estimator::Fibers(sampled), ..Options::new(law) }, Options::new(law)];
    laws.into_iter().flat_map(with).collect()
}

#[test]
fn forces_are_those_of_cells_in_the_plane() {
    let lower = rectangles([0.0, -1.0], [1.5, 0.0], [3, 3]);
    let upper = rectangles([0.3, -0.2], [1.3, 0.6], [2, 3]);
    for k in 0..lower.len() {
        let above = &upper[(k + 1) % upper.len()];
        all_options().into_iter().for_each(|options| same(&lower[k], above, options, k as u64));
    }
}

#[test]
fn forces_are_those_of_cells_in_space() {
    let lower = boxes([0.0, 0.0, -1.0], [1.5, 1.2, 0.0], [2, 2, 2]);
    let upper = boxes([0.3, 0.1, -0.2], [1.3, 1.0, 0.6], [1, 2, 1]);
    for k in 0..lower.len() {
        let above = &upper[(k + 2) % upper.len()];
        all_options().into_iter().for_each(|options| same(&lower[k], above, options, k as u64));
    }
}

/// The same with friction, whose slip is that of straight facets.
#[test]
fn friction_is_that_of_cells() {
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [2; 3]);
    let upper = boxes([0.0, 0.0, -1e-2], [1.0, 1.0, 1.0], [2; 3]);
    for k in 0..lower.len() {
        let scene = pair(&lower[k], &upper[k]);
        let start = shaken(&scene.coords, 1e-3, k as u64);
        let (blocks, ids) = skin(&[&lower[k], &upper[k]]);
        let facets = by_facets(&start, &blocks, Bodies::Ids(&ids)).expect("a closed surface");
        let friction = Friction { stiffness: Some(1e4), ..Friction::coulomb(0.3) };
        let options = Options { friction, ..exactly(EnergyLaw::fiber(10.0)) };
        let contacts = [scene.contact(options), Contact::new(facets, options).expect("options")];
        let mut end = start.clone();
        scene.nodes_of(1).for_each(|node| end[node][0] += 0.01);
        let [(one, energy), (other, of_facets)] = contacts.map(|mut contact| {
            contact.begin_step(&start).expect("a step");
            let at = contact.evaluate(&end).expect("forces");
            contact.commit_step(&end).expect("a step");
            let (slip, count) = (contact.slip().expect("slip"), contact.surface().facet_count());
            assert!(!slip.is_empty() && slip.iter().all(|one| one.facet < count));
            (at.forces, at.friction.dissipated)
        });
        assert!(energy > 0.0 && (energy - of_facets).abs() < 1e-12 * energy, "{energy} {of_facets}");
        assert!(distance(&one, &other) < 1e-12 * norm(&one), "{:?}", blocks[0].0);
    }
}

/// Points are told in the numbers that cells have, facets in those given.
#[test]
fn facets_are_told_as_given() {
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [2; 3]);
    let upper = boxes([0.0, 0.0, -1e-2], [1.0, 1.0, 1.0], [2; 3]);
    for k in 0..lower.len() {
        let scene = pair(&lower[k], &upper[k]);
        let (blocks, ids) = skin(&[&lower[k], &upper[k]]);
        let surface = by_facets(&scene.coords, &blocks, Bodies::Ids(&ids)).expect("a closed surface");
        let given: Vec<&[u32]> =
            blocks.iter().flat_map(|(of_type, conn)| conn.chunks_exact(of_type.node_count())).collect();
        let facets = surface.boundary_facets();
        assert!(facets.iter().all(|facet| (facet.cell, facet.local_face) == (None, None)));
        let mut parts = vec![0; given.len()];
        for facet in &facets {
            let number = facet.given.expect("a number");
            parts[number] += 1;
            assert_eq!(facet.body as i64, ids[number]);
            // One node of every part is a corner of the whole, or three are middles of a triangle.
            let named = facet.nodes.iter().filter(|node| given[number].contains(node)).count();
            assert!(named >= 3, "{:?} of {:?}", facet.nodes, given[number]);
        }
        assert!(parts.iter().zip(&given).all(|(parts, nodes)| *parts == if nodes.len() == 6 { 4 } else { 16 }));
        let mut whole: Vec<_> = surface.faces().into_iter().map(|(body, corners)| (body as i64, corners)).collect();
        let corners = |nodes: &[u32]| nodes[..if nodes.len() == 6 { 3 } else { 4 }].to_vec();
        let mut expected: Vec<_> = ids.iter().copied().zip(given.iter().map(|nodes| corners(nodes))).collect();
        whole.sort();
        expected.sort();
        assert_eq!(whole, expected);
        let contact = Contact::new(surface, exactly(EnergyLaw::fiber(7.0))).expect("options");
        let weights = contact.point_weights();
        let points = contact.contact_points(&scene.coords).expect("points");
        assert!(!points.is_empty());
        for side in points.iter().flat_map(|point| &point.sides) {
            assert_eq!(side.cell, None);
            assert!(side.nodes[..side.node_count].iter().all(|&point| (point as usize) < weights.point_count()));
        }
        let lifts: f64 = points.iter().map(|point| point.pressure * point.area).sum();
        let up: f64 = contact.evaluate(&scene.coords).expect("forces").bodies[1].force[2];
        assert!((lifts - up).abs() < 1e-12 * up, "{lifts} {up}");
        let field = contact.nodal_contact(&scene.coords).expect("a contact");
        let of_cells = scene.contact(exactly(EnergyLaw::fiber(7.0))).nodal_contact(&scene.coords).expect("a contact");
        assert_eq!(field.pressure.len(), scene.coords.len());
        for (one, other) in field.pressure.iter().zip(&of_cells.pressure) {
            assert!((one - other).abs() < 1e-10, "{one} {other}");
        }
        let gaps = contact.gap_constraints(&scene.coords, 0.2).expect("gaps");
        let of_cells = scene.contact(exactly(EnergyLaw::fiber(7.0))).gap_constraints(&scene.coords, 0.2).expect("gaps");
        assert_eq!(gaps.gaps.len(), of_cells.gaps.len());
        let sum = |gaps: &[f64]| gaps.iter().sum::<f64>();
        assert!((sum(&gaps.gaps) - sum(&of_cells.gaps)).abs() < 1e-12, "{:?}", blocks[0].0);
    }
}

#[test]
fn bodies_are_connected_by_nodes() {
    let (lower, upper) =
        (&rectangles([0.0, -1.0], [1.5, 0.0], [3, 3])[0], &rectangles([0.3, -0.2], [1.3, 0.6], [2, 3])[2]);
    let scene = pair(lower, upper);
    let (blocks, ids) = skin(&[lower, upper]);
    let connected = by_facets(&scene.coords, &blocks, Bodies::Connected).expect("a surface");
    assert_eq!(connected.body_ids(), [0, 1]);
    assert_eq!(connected.faces().len(), ids.len());
    let found = Contact::new(connected, exact()).expect("options").evaluate(&scene.coords).expect("forces");
    assert!((found.volume / 0.2 - 1.0).abs() < 1e-12, "{}", found.volume);
}

const SQUARE: [[f64; 2]; 8] = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0.5, -0.3], [1.1, 0.5], [0.5, 1.0], [0., 0.5]];

fn square(conn: &[u32]) -> Result<Surface<2>, Error> {
    by_facets(&SQUARE, &[(FacetType::Line3, conn.to_vec())], Bodies::Connected)
}

/// In the plane straight edges stand beside curved ones, also between the same nodes: Archimedes' segment.
#[test]
fn a_parabola_and_its_chord() {
    let coords = [&SQUARE[..], &[[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]]].concat();
    let edges = (FacetType::Line2, vec![1, 0, 8, 9, 9, 10, 10, 11, 11, 8]);
    let curved = (FacetType::Line3, vec![0, 1, 4]);
    let surface = by_facets(&coords, &[curved, edges], Bodies::Ids(&[0, 0, 1, 1, 1, 1])).expect("two bodies");
    assert_eq!((surface.facet_count(), surface.faces().len()), (7, 6));
    let found = Contact::new(surface, exact()).expect("options").evaluate(&coords).expect("forces");
    assert!((found.volume - 2.0 / 3.0 * 0.3).abs() < 1e-14, "{}", found.volume);
}

/// Two quadrilaterals of nine nodes with all edges in common, the middles above and below: a pillow.
#[test]
fn facets_with_all_edges_in_common() {
    let mut coords: Vec<[f64; 3]> = Vec::new();
    for (x, y) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (0.5, 0.), (1., 0.5), (0.5, 1.), (0., 0.5)] {
        coords.push([x, y, 0.0]);
    }
    coords.extend([[0.5, 0.5, 0.3], [0.5, 0.5, -0.1]]);
    let conn = vec![0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 3, 2, 1, 7, 6, 5, 4, 9];
    let block = fmc_shapes::cuboid_surface([-1.0; 3], [2.0; 3], [1; 3]);
    let facets = (FacetType::Tri3, block.facets().iter().flatten().map(|node| node + 10).collect::<Vec<_>>());
    coords.extend_from_slice(&block.coords);
    let pillow = by_facets(&coords, &[(FacetType::Quad9, conn), facets], Bodies::Connected).expect("two bodies");
    let found = Contact::new(pillow, exact()).expect("options").evaluate(&coords).expect("forces");
    // The bubble's integral is 4/9; its point is 16/9 as high, and the straight facets enclose a quarter of that.
    assert!((found.volume - 0.4 * 4.0 / 9.0).abs() < 1e-14, "{}", found.volume);
}

#[test]
fn what_does_not_fit_is_refused() {
    let whole = [0, 1, 4, 1, 2, 5, 2, 3, 6, 3, 0, 7];
    assert!(square(&whole).is_ok());
    // The middle of one edge as the corner of another.
    let refused = square(&[0, 1, 4, 1, 2, 5, 2, 4, 6, 4, 0, 7]).err();
    assert_eq!(refused, Some(Error::NonConforming { cells: [0, 2] }));
    let open = square(&whole[..9]).err();
    assert!(matches!(open, Some(Error::OpenSurface { facet: 0 | 2, .. })), "{open:?}");
    let turned = square(&[0, 1, 4, 2, 1, 5, 2, 3, 6, 3, 0, 7]).err();
    assert!(matches!(turned, Some(Error::InconsistentOrientation { facet: 1 | 2, .. })), "{turned:?}");
    let inwards = square(&[1, 0, 4, 2, 1, 5, 3, 2, 6, 0, 3, 7]).err();
    assert_eq!(inwards, Some(Error::InvertedSurface { body: 0 }));
    assert_eq!(square(&whole[..4]).err(), Some(Error::Length { array: "conn", expected: 3, found: 4 }));
    assert_eq!(square(&[0, 1, 8]).err(), Some(Error::NodeOutOfRange { cell: 0, node: 8, node_count: 8 }));
    assert_eq!(square(&[0, 1, 4, 1, 2, 1]).err(), Some(Error::RepeatedNode { cell: 1, node: 1 }));
    assert_eq!(square(&[]).err(), Some(Error::Empty));
    let in_space = by_facets(&SQUARE, &[(FacetType::Tri6, vec![0; 6])], Bodies::Connected).err();
    assert_eq!(in_space, Some(Error::Dimension { block: 0, expected: 2, found: 3 }));
    let blocks = [FacetBlock { facet_type: FacetType::Line3, conn: &whole }];
    let ids = Surface::from_facet_blocks(&SQUARE, &blocks, Bodies::Ids(&[0; 8])).err();
    assert_eq!(ids, Some(Error::Length { array: "body_ids", expected: 4, found: 8 }));
    let moved = |node: usize, x: [f64; 2]| {
        let mut coords = SQUARE;
        coords[node] = x;
        Surface::from_facet_blocks(&coords, &blocks, Bodies::Connected).err()
    };
    assert_eq!(moved(6, [f64::NAN, 1.0]), Some(Error::NonFiniteCoordinate { node: 6, axis: 0 }));
    // A node nearer than an eighth of its edge to an end of it, along the edge.
    assert_eq!(moved(6, [0.874, 1.2]), None);
    assert_eq!(moved(6, [0.876, 1.2]), Some(Error::InvertedCell { cell: 2 }));
}

/// A straight facet on an edge with a node in its middle, and facets that have different nodes there.
#[test]
fn edges_in_space_are_straight_or_curved_for_both() {
    let mesh = &boxes([0.0; 3], [1.0; 3], [1; 3])[0];
    let scene = Scene::of(&[mesh]);
    let (blocks, _) = skin(&[mesh]);
    let conn = &blocks[0].1;
    let mixed = |last: (FacetType, Vec<u32>), coords: &[[f64; 3]]| {
        let first = (FacetType::Tri6, conn[..conn.len() - 6].to_vec());
        by_facets(coords, &[first, last], Bodies::Connected).err()
    };
    let last = &conn[conn.len() - 6..];
    let number = conn.len() / 6 - 1;
    let straight = mixed((FacetType::Tri3, last[..3].to_vec()), &scene.coords);
    assert!(matches!(straight, Some(Error::NonConforming { cells: [_, other] }) if other == number), "{straight:?}");
    let mut other = last.to_vec();
    other[4] = scene.coords.len() as u32;
    let coords = [&scene.coords[..], &[scene.coords[last[4] as usize]]].concat();
    let other = mixed((FacetType::Tri6, other), &coords);
    assert!(matches!(other, Some(Error::NonConforming { cells: [_, second] }) if second == number), "{other:?}");
    assert_eq!(mixed((FacetType::Tri6, last.to_vec()), &scene.coords), None);
}

/// Straight triangles and quadrilaterals in one surface: quadrilaterals as the faces of hexahedra.
#[test]
fn straight_facets_of_several_types() {
    let block = |low: [f64; 3], high: [f64; 3]| fmc_shapes::cuboid_hex8(low, high, [2; 3]);
    let scene = pair(&block([0.0, 0.0, -1.0], [1.0, 1.0, 0.0]), &block([0.1, 0.2, -0.1], [0.9, 0.9, 0.7]));
    let mut conn = [Vec::new(), Vec::new()];
    let mut ids = [Vec::new(), Vec::new()];
    for (number, (body, corners)) in scene.surface().faces().into_iter().enumerate() {
        match number % 3 {
            0 => {
                conn[1].extend([corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]]);
                ids[1].extend([body as i64; 2]);
            }
            _ => {
                conn[0].extend(corners);
                ids[0].push(body as i64);
            }
        }
    }
    let [quads, triangles] = conn;
    let blocks = [(FacetType::Quad4, quads), (FacetType::Tri3, triangles)];
    let surface = by_facets(&scene.coords, &blocks, Bodies::Ids(&ids.concat())).expect("two bodies");
    let found = Contact::new(surface, exact()).expect("options").evaluate(&scene.coords).expect("forces");
    assert!((found.volume / 0.056 - 1.0).abs() < 1e-12, "{}", found.volume);
    assert!((found.bodies[1].force[2] / 0.56 - 1.0).abs() < 1e-12, "{:?}", found.bodies[1].force);
}
