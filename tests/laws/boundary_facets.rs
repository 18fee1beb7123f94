//! The boundary facets that a host is told of, against the mesh that it gave.

use crate::scene::Scene;
use fmc_contact::{Bodies, BoundaryFacet, CellBlock, CellType, Contact, Options, Surface};
use fmc_shapes::{
    Mesh, cuboid_hex8, cuboid_pyramid5, cuboid_surface, cuboid_tet4, cuboid_wedge6, disc_quad4, disc_tri3,
    rectangle_quad4,
};

/// Faces as in VTK's documentation, by the places of their nodes in the cell.
fn vtk_faces(cell_type: CellType) -> &'static [&'static [usize]] {
    match cell_type {
        CellType::Tri3 => &[&[0, 1], &[1, 2], &[2, 0]],
        CellType::Quad4 => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
        CellType::Tet4 => &[&[0, 1, 3], &[1, 2, 3], &[2, 0, 3], &[0, 2, 1]],
        CellType::Wedge6 => &[&[0, 1, 2], &[3, 5, 4], &[0, 3, 4, 1], &[1, 4, 5, 2], &[2, 5, 3, 0]],
        CellType::Pyramid5 => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
        _ => &[&[0, 4, 7, 3], &[1, 2, 6, 5], &[0, 1, 5, 4], &[3, 7, 6, 2], &[0, 3, 2, 1], &[4, 5, 6, 7]],
    }
}

fn minus<const D: usize>(a: [f64; D], b: [f64; D]) -> [f64; D] {
    std::array::from_fn(|i| a[i] - b[i])
}

fn mean<const D: usize>(points: impl Iterator<Item = [f64; D]>) -> [f64; D] {
    let points: Vec<[f64; D]> = points.collect();
    std::array::from_fn(|i| points.iter().map(|x| x[i]).sum::<f64>() / points.len() as f64)
}

/// Corners of a facet, by what the documentation says of its nodes.
fn corners<const D: usize>(facet: &BoundaryFacet, coords: &[[f64; D]]) -> Vec<[f64; D]> {
    let nodes: Vec<[f64; D]> = facet.nodes.iter().map(|&node| coords[node as usize]).collect();
    if nodes.len() == 4 { vec![nodes[0], nodes[1], mean(nodes.iter().copied())] } else { nodes }
}

/// Area vector of a facet.
fn area<const D: usize>(corners: &[[f64; D]]) -> [f64; D] {
    let e = minus(corners[1], corners[0]);
    let mut area = [0.0; D];
    if D == 2 {
        (area[0], area[1]) = (e[1], -e[0]);
    } else {
        let f = minus(corners[2], corners[0]);
        (0..3).for_each(|i| area[i] = 0.5 * (e[(i + 1) % 3] * f[(i + 2) % 3] - e[(i + 2) % 3] * f[(i + 1) % 3]));
    }
    area
}

fn check<const D: usize>(surface: &Surface<D>, mesh: &Mesh<D>, cell_type: CellType, face_measure: f64) {
    let facets = surface.boundary_facets();
    assert_eq!(facets.len(), surface.facet_count());
    let cells: Vec<&[u32]> = mesh.conn.chunks_exact(cell_type.node_count()).collect();
    let mut sums = vec![([0.0; D], 0.0); surface.body_count()];
    for facet in &facets {
        let (cell, face) = (cells[facet.cell.unwrap()], vtk_faces(cell_type)[facet.local_face.unwrap()]);
        assert_eq!(facet.given, None);
        let mut of_face: Vec<u32> = face.iter().map(|&place| cell[place]).collect();
        let mut nodes = facet.nodes.clone();
        of_face.sort_unstable();
        nodes.sort_unstable();
        assert_eq!(nodes, of_face, "{facet:?}");
        // Outwards: away from the middle of its cell, whichever way that is numbered.
        let (corners, inside) =
            (corners(facet, &mesh.coords), mean(cell.iter().map(|&node| mesh.coords[node as usize])));
        let (area, out) = (area(&corners), minus(corners[0], inside));
        assert!((0..D).map(|i| area[i] * out[i]).sum::<f64>() > 0.0, "{facet:?}");
        let (sum, measure) = &mut sums[facet.body];
        sum.iter_mut().zip(area).for_each(|(sum, a)| *sum += a);
        *measure += area.iter().map(|a| a * a).sum::<f64>().sqrt();
    }
    for (sum, measure) in sums {
        assert!(sum.iter().all(|s| s.abs() < 1e-13 * measure), "{sum:?}");
        assert!((measure - face_measure).abs() < 1e-12 * face_measure, "{measure} {face_measure}");
    }
    let bodies: Vec<usize> = facets.iter().map(|facet| facet.body).collect();
    assert!(bodies.is_sorted());
}

/// Every second cell numbered the other way round: simplices with two nodes exchanged.
fn mirrored<const D: usize>(mut mesh: Mesh<D>) -> Mesh<D> {
    mesh.conn.chunks_exact_mut(D + 1).step_by(2).for_each(|cell| cell.swap(0, 1));
    mesh
}

fn surface<const D: usize>(mesh: &Mesh<D>, cell_type: CellType) -> Surface<D> {
    Surface::from_cells(&mesh.coords, &[CellBlock { cell_type, conn: &mesh.conn }], Bodies::Connected).unwrap()
}

#[test]
fn facets_are_faces_of_their_cells_outwards_and_closed() {
    let cube = cuboid_hex8([0.0; 3], [1.0, 1.0, 1.0], [2, 3, 2]);
    check(&surface(&cube, CellType::Hex8), &cube, CellType::Hex8, 6.0);
    let one = cuboid_hex8([0.0; 3], [1.0, 2.0, 3.0], [1; 3]);
    check(&surface(&one, CellType::Hex8), &one, CellType::Hex8, 22.0);
    for cube in [cuboid_tet4([0.0; 3], [1.0; 3], [2, 1, 3]), mirrored(cuboid_tet4([0.0; 3], [1.0; 3], [2, 1, 3]))] {
        check(&surface(&cube, CellType::Tet4), &cube, CellType::Tet4, 6.0);
    }
    let wedges = cuboid_wedge6([0.0; 3], [1.0; 3], [2, 1, 3]);
    check(&surface(&wedges, CellType::Wedge6), &wedges, CellType::Wedge6, 6.0);
    let pyramids = cuboid_pyramid5([0.0; 3], [1.0; 3], [2, 1, 3]);
    check(&surface(&pyramids, CellType::Pyramid5), &pyramids, CellType::Pyramid5, 6.0);
    let square = rectangle_quad4([0.0; 2], [2.0, 1.0], [3, 2]);
    check(&surface(&square, CellType::Quad4), &square, CellType::Quad4, 6.0);
    let (disc, edges) = (disc_tri3(1.0, 24), 24.0f64);
    let round = 2.0 * edges * (std::f64::consts::PI / edges).sin();
    check(&surface(&disc, CellType::Tri3), &disc, CellType::Tri3, round);
    let disc = mirrored(disc);
    check(&surface(&disc, CellType::Tri3), &disc, CellType::Tri3, round);
}

/// Two bodies, the first cells being of the second body.
#[test]
fn bodies_come_one_after_the_other_and_cells_keep_their_numbers() {
    let mut mesh = rectangle_quad4([0.0; 2], [1.0, 1.0], [2, 2]);
    mesh.append(&rectangle_quad4([3.0, 0.0], [4.0, 1.0], [2, 2]));
    let ids = [7, 7, 7, 7, -1, -1, -1, -1];
    let block = CellBlock { cell_type: CellType::Quad4, conn: &mesh.conn };
    let surface = Surface::from_cells(&mesh.coords, &[block], Bodies::Ids(&ids)).unwrap();
    check(&surface, &mesh, CellType::Quad4, 4.0);
    let facets = surface.boundary_facets();
    assert!(facets.iter().all(|facet| (facet.cell.unwrap() < 4) == (facet.body == 1)));
}

/// A quadrilateral face is four facets, one on each of its edges.
#[test]
fn quadrilateral_faces_come_once_from_each_edge() {
    let cube = cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]);
    let facets = surface(&cube, CellType::Hex8).boundary_facets();
    let mut edges: Vec<[u32; 2]> = facets.iter().map(|facet| [facet.nodes[0], facet.nodes[1]]).collect();
    edges.sort_unstable();
    edges.dedup();
    // Each of the twelve edges in both directions, from its two faces.
    assert_eq!(edges.len(), 24);
    assert!(edges.iter().all(|[p, q]| edges.contains(&[*q, *p])));
}

/// A surface without cells: facets keep their own numbers.
#[test]
fn facets_that_were_given_are_told_by_their_numbers() {
    let mut mesh = cuboid_surface([0.0; 3], [1.0; 3], [2; 3]);
    let count = mesh.facets().len();
    mesh.append(&cuboid_surface([3.0; 3], [4.0; 3], [1; 3]));
    let given = mesh.facets();
    let ids: Vec<i64> = (0..given.len()).map(|facet| i64::from(facet < count)).collect();
    let facets = Surface::from_facets(&mesh.coords, &given, Bodies::Ids(&ids)).unwrap().boundary_facets();
    assert_eq!(facets.len(), given.len());
    for facet in &facets {
        assert_eq!((facet.cell, facet.local_face), (None, None));
        assert_eq!(facet.nodes, given[facet.given.unwrap()]);
        assert_eq!(facet.body, usize::from(facet.given.unwrap() < count));
    }
}

/// What friction carries names facets by this order: a facet that was pressed has slip, the others have none.
#[test]
fn slip_is_in_the_order_of_the_facets() {
    use fmc_contact::contact::Friction;
    use fmc_contact::overlap::Partner;
    use fmc_contact::{EnergyLaw, Obstacle, Pose, Shape};
    let block = disc_quad4(1.0, 24);
    let scene = Scene::of(&[&block]);
    let mut options = Options::new(EnergyLaw::depth(10.0));
    options.friction = Friction { coefficient: 0.5, ..Friction::default() };
    let mut contact: Contact<2> = scene.contact(options);
    let lowest = scene.coords.iter().map(|x| x[1]).fold(f64::INFINITY, f64::min);
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, lowest + 0.1]) }).unwrap();
    contact.begin_step(&scene.coords).unwrap();
    let moved: Vec<[f64; 2]> = scene.coords.iter().map(|x| [x[0] + 0.01, x[1]]).collect();
    contact.commit_step(&moved).unwrap();
    let (facets, slip) = (contact.boundary_facets(), contact.slip().unwrap());
    let carries: Vec<usize> =
        slip.iter().filter(|one| one.slip.iter().any(|s| *s != 0.0)).map(|one| one.facet).collect();
    assert!(carries.is_sorted_by(|a, b| a < b) && slip.iter().all(|one| one.partner == Partner::Obstacle(0)));
    for (number, facet) in facets.iter().enumerate() {
        let is_pressed = facet.nodes.iter().any(|&node| moved[node as usize][1] < lowest + 0.1);
        assert_eq!(carries.contains(&number), is_pressed, "{facet:?} {slip:?}");
    }
}
