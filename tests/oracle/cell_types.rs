//! One body, meshed in several ways, gives one answer.

use crate::halfspaces::overlap;
use crate::scene::{Scene, consistent_lines, distance, exact, lines, norm};
use fmc_contact::ContactForces;
use fmc_shapes::{Diagonals, Mesh, ball_tet4, cuboid_hex8, cuboid_tet4, disc_quad4, rectangle_quad4, rectangle_tri3};
use std::collections::HashMap;

/// Roundoff of some hundreds of operations, as long as the sampled lines are the same.
const ROUNDING: f64 = 1e-12;

fn same_resultants<const D: usize>(x: &ContactForces<D>, y: &ContactForces<D>) {
    assert!((x.volume / y.volume - 1.0).abs() < ROUNDING, "{} against {}", x.volume, y.volume);
    for (x, y) in x.bodies.iter().zip(&y.bodies) {
        let size = x.force.iter().map(|f| f.abs()).sum::<f64>();
        assert!((0..D).all(|i| (x.force[i] - y.force[i]).abs() < ROUNDING * size));
        assert!((0..3).all(|i| (x.moment[i] - y.moment[i]).abs() < 3.0 * ROUNDING * size));
    }
}

/// A block whose left half is in quadrilaterals and whose right half is in triangles, on the nodes of `quads`.
fn mixed(quads: &Mesh<2>, triangles: &Mesh<2>) -> Scene<2> {
    let mut scene = Scene::of(&[quads]);
    scene.blocks.clear();
    let left = |cell: usize| quads.coords[quads.conn[4 * cell] as usize][0] < 0.49;
    let cells = 0..quads.cell_count();
    let conn = |mesh: &Mesh<2>, per_quad: usize, keep: bool| -> Vec<u32> {
        let size = per_quad * mesh.nodes_per_cell;
        cells.clone().filter(|c| left(*c) == keep).flat_map(|c| mesh.conn[c * size..(c + 1) * size].to_vec()).collect()
    };
    scene.blocks.push((fmc_contact::CellType::Quad4, conn(quads, 1, true)));
    scene.blocks.push((fmc_contact::CellType::Tri3, conn(triangles, 2, false)));
    scene.ids = vec![0; scene.blocks.iter().map(|(t, conn)| conn.len() / t.node_count()).sum()];
    scene
}

#[test]
fn plane_blocks_of_triangles_quadrilaterals_both_and_edges_alone() {
    let quads = rectangle_quad4([0.0; 2], [1.0, 0.6], [8, 5]);
    let triangles = rectangle_tri3([0.0; 2], [1.0, 0.6], [8, 5], Diagonals::Alternating);
    let disc = disc_quad4(0.4, 24).translated([0.45, 0.85]);
    for options in [exact(), lines(0.01, 4)] {
        let reference = Scene::of(&[&quads, &disc]).evaluate(options);
        let mut blocks = vec![Scene::of(&[&triangles]), mixed(&quads, &triangles)];
        blocks.iter_mut().for_each(|s| *s = s.clone().with(&disc, 1));
        for scene in &blocks {
            let contact = scene.evaluate(options);
            same_resultants(&contact, &reference);
            assert!(distance(&contact.forces, &reference.forces) < ROUNDING * norm(&reference.forces));
        }
        // The edges of the block, on nodes of their own.
        same_resultants(&Scene::of(&[&quads.boundary(), &disc.boundary()]).evaluate(options), &reference);
    }
}

#[test]
fn facets_without_cells_give_the_forces_of_the_cells() {
    let block = cuboid_tet4([-1.0, -1.0, -2.0], [1.0, 1.0, 0.0], [3, 4, 3]);
    let ball = ball_tet4(0.8, 2, 2).rotated([1.0, 0.3, 0.2], 0.5).translated([0.1, -0.2, 0.6]);
    for options in [exact(), lines(0.03, 4)] {
        let of_cells = Scene::of(&[&block, &ball]).evaluate(options);
        // The whole node array, with the boundary faces of the cells as facets.
        let mut scene = Scene::of(&[&block, &ball]);
        let faces =
            [(&block, 0), (&ball, 1)].map(|(m, body)| (m.boundary_faces(), scene.first_node[body] as u32, body));
        scene.blocks.clear();
        scene.ids.clear();
        for (faces, first, body) in faces {
            scene.ids.extend(std::iter::repeat_n(body as i64, faces.len()));
            scene.facets.extend(faces.iter().map(|f| [f[0] + first, f[1] + first, f[2] + first]));
        }
        let of_facets = scene.evaluate(options);
        same_resultants(&of_facets, &of_cells);
        assert!(distance(&of_facets.forces, &of_cells.forces) < ROUNDING * norm(&of_cells.forces));
    }
}

/// A hexahedral mesh in tetrahedra: every face in four triangles about its centroid, every cell in 24 tetrahedra about
/// its own. Also the four corners of every face centroid.
fn split(hexahedra: &Mesh<3>) -> (Mesh<3>, Vec<(usize, [u32; 4])>) {
    const FACES: [[usize; 4]; 6] = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    let mut mesh = Mesh { coords: hexahedra.coords.clone(), conn: Vec::new(), nodes_per_cell: 4 };
    let (mut known, mut centroids) = (HashMap::new(), Vec::new());
    let mean = |nodes: &[u32]| -> [f64; 3] {
        std::array::from_fn(|i| {
            nodes.iter().map(|&n| hexahedra.coords[n as usize][i]).sum::<f64>() / nodes.len() as f64
        })
    };
    for cell in hexahedra.cells() {
        let centre = mesh.coords.len() as u32;
        mesh.coords.push(mean(cell));
        for face in FACES {
            let corners = face.map(|k| cell[k]);
            let mut key = corners;
            key.sort_unstable();
            let middle = *known.entry(key).or_insert_with(|| {
                centroids.push((mesh.coords.len(), corners));
                mesh.coords.push(mean(&corners));
                mesh.coords.len() as u32 - 1
            });
            for k in 0..4 {
                mesh.conn.extend([corners[(k + 1) % 4], corners[k], middle, centre]);
            }
        }
    }
    (mesh, centroids)
}

/// Also with faces that are not flat.
#[test]
fn hexahedra_are_their_24_tetrahedra() {
    for amplitude in [0.0, 0.3] {
        let hexahedra = |cells: [usize; 3], seed| {
            cuboid_hex8([-0.5; 3], [0.5, 0.6, 0.7], cells).jittered(amplitude, seed, |_| true)
        };
        let a = hexahedra([3, 2, 3], 1);
        let b = hexahedra([2, 3, 2], 2).rotated([1.0, 2.0, 0.5], 0.6).translated([0.4, 0.5, 0.3]);
        let contact = Scene::of(&[&a, &b]).evaluate(exact());
        let ((tetrahedra_a, centroids_a), (tetrahedra_b, centroids_b)) = (split(&a), split(&b));
        let (volume, mut of_a, mut of_b) = overlap(&tetrahedra_a, &tetrahedra_b);
        for (gradient, centroids) in [(&mut of_a, centroids_a), (&mut of_b, centroids_b)] {
            for (centroid, corners) in centroids {
                let g = gradient[centroid];
                corners.iter().for_each(|&n| (0..3).for_each(|i| gradient[n as usize][i] += 0.25 * g[i]));
            }
        }
        assert!((contact.volume / volume - 1.0).abs() < ROUNDING, "{} instead of {volume}", contact.volume);
        let mut gradient = of_a[..a.coords.len()].to_vec();
        gradient.extend_from_slice(&of_b[..b.coords.len()]);
        let forces: Vec<[f64; 3]> = contact.forces.iter().map(|f| f.map(|f| -f)).collect();
        assert!(distance(&forces, &gradient) < ROUNDING * norm(&gradient));
        // Those tetrahedra, given as cells, are the same body. (A momentum correction would see other nodes.)
        for options in [exact(), consistent_lines(0.03, 5)] {
            let whole = Scene::of(&[&a, &b]).evaluate(options);
            let parts = Scene::of(&[&tetrahedra_a, &tetrahedra_b]).evaluate(options);
            same_resultants(&whole, &parts);
        }
    }
}

/// A block with flat faces, however meshed, leaves the same forces on a ball, whose mesh stays as it is.
#[test]
fn hexahedra_or_tetrahedra_against_a_ball() {
    let box_of = |make: fn([f64; 3], [f64; 3], [usize; 3]) -> Mesh<3>| make([0.0; 3], [1.0, 0.8, 0.6], [3, 3, 2]);
    let ball = ball_tet4(0.5, 2, 1).translated([0.9, 0.7, 0.5]);
    // (A momentum correction would see other nodes on the block.)
    for options in [exact(), consistent_lines(0.02, 3)] {
        let of_hexahedra = Scene::of(&[&box_of(cuboid_hex8), &ball]).evaluate(options);
        let of_tetrahedra = Scene::of(&[&box_of(cuboid_tet4), &ball]).evaluate(options);
        same_resultants(&of_hexahedra, &of_tetrahedra);
        let x = &of_hexahedra.forces[box_of(cuboid_hex8).coords.len()..];
        let y = &of_tetrahedra.forces[box_of(cuboid_tet4).coords.len()..];
        assert!(distance(x, y) < ROUNDING * norm(y));
    }
}
