//! Three bodies and more: overlaps are counted pair by pair.

use crate::scene::table::{by_laws, laws};
use crate::scene::{Scene, distance, exact, lines, norm};
use fmc_contact::overlap::Partner;
use fmc_shapes::{Diagonals, Mesh, ball_tet4, cuboid_tet4, disc_tri3, rectangle_quad4, rectangle_tri3};

/// What all pairs have is what every two bodies have without the others.
fn pairs_add_up<const D: usize>(meshes: &[Mesh<D>], spacing: f64) {
    for options in by_laws([exact(), lines(spacing, 1)], &laws(1.0)) {
        let all = Scene::of(&meshes.iter().collect::<Vec<_>>());
        let whole = all.evaluate(options);
        let (mut volume, mut energy, mut forces) = (0.0, 0.0, vec![[0.0; D]; all.coords.len()]);
        let mut pairs = whole.pairs.iter();
        for i in 0..meshes.len() {
            for j in i + 1..meshes.len() {
                let pair = Scene::of(&[&meshes[i], &meshes[j]]).evaluate(options);
                if pair.volume == 0.0 {
                    continue;
                }
                let found = pairs.next().unwrap();
                assert_eq!((found.a, found.b), (Partner::Body(i), Partner::Body(j)));
                assert_eq!(found.volume, pair.volume);
                volume += pair.volume;
                energy += pair.energy;
                for (node, force) in all.nodes_of(i).chain(all.nodes_of(j)).zip(&pair.forces) {
                    (0..D).for_each(|axis| forces[node][axis] += force[axis]);
                }
            }
        }
        assert!(pairs.next().is_none());
        // Sums of a few numbers.
        assert!((whole.volume / volume - 1.0).abs() < 1e-14 && (whole.energy / energy - 1.0).abs() < 1e-14);
        assert!(distance(&whole.forces, &forces) < 1e-14 * norm(&forces));
    }
}

#[test]
fn pairs_add_up_in_2d() {
    let discs: Vec<Mesh<2>> = (0..6)
        .map(|k| disc_tri3(1.0, 12 + k).rotated(k as f64).translated([1.3 * (k % 3) as f64, 1.4 * (k / 3) as f64]))
        .collect();
    pairs_add_up(&discs, 0.02);
}

#[test]
fn pairs_add_up_in_3d() {
    let balls: Vec<Mesh<3>> = (0..4)
        .map(|k| {
            ball_tet4(1.0, 1, 1).rotated([1.0, 1.0, 0.3], k as f64).translated([
                1.4 * (k % 2) as f64,
                0.2 * k as f64,
                1.3 * (k / 2) as f64,
            ])
        })
        .collect();
    pairs_add_up(&balls, 0.08);
}

/// Where three bodies meet in one place, that place counts three times.
#[test]
fn three_blocks_in_one_place() {
    let block = |x: f64, y: f64| rectangle_quad4([x, y], [x + 1.0, y + 1.0], [3, 3]);
    let scene = Scene::of(&[&block(0.0, 0.0), &block(0.5, 0.25), &block(0.25, 0.5)]);
    let volume = 0.5 * 0.75 + 0.75 * 0.5 + 0.75 * 0.75;
    assert!((scene.evaluate(exact()).volume - volume).abs() < 1e-14);
    // Three pairs of some 500 lines, each off by half a spacing at its ends, at random.
    assert!((scene.evaluate(lines(0.004, 1)).volume - volume).abs() < 5e-4);
}

/// A body squeezed from both sides feels no resultant; the two that squeeze it are pushed away.
#[test]
fn block_between_two_others() {
    let block = |y: f64| cuboid_tet4([0.0, y, 0.0], [1.0, y + 1.0, 1.0], [2, 2, 2]);
    let wide = |y: f64| cuboid_tet4([-0.5, y, -0.5], [1.5, y + 1.0, 1.5], [3, 2, 3]);
    let scene = Scene::of(&[&wide(-0.9), &block(0.0), &wide(0.9)]);
    // Lines: 50² of a family on a face of 1; at its rim, 4 long, a strip of a spacing is counted at random.
    for (options, tolerance) in [(exact(), 1e-14), (lines(0.02, 1), 1e-2)] {
        let contact = scene.evaluate(options);
        assert_eq!(contact.pairs.len(), 2);
        let along = |body: usize| contact.bodies[body].force[1];
        assert!((along(0) + 1.0).abs() < tolerance, "{}", along(0));
        assert!((along(2) - 1.0).abs() < tolerance, "{}", along(2));
        assert!(along(1).abs() < 2.0 * tolerance);
        assert!((contact.volume - 0.2).abs() < tolerance);
    }
}

/// Connected components are bodies too, numbered by their first cells.
#[test]
fn connected_components_are_bodies() {
    use fmc_contact::{Bodies, CellBlock, CellType, contact_force};
    let mut mesh = rectangle_tri3([0.0; 2], [1.0; 2], [3, 2], Diagonals::Same);
    for k in 1..4 {
        mesh.append(
            &rectangle_tri3([0.0; 2], [1.0; 2], [3, 2], Diagonals::Same).translated([0.9 * k as f64, 0.1 * k as f64]),
        );
    }
    let blocks = [CellBlock { cell_type: CellType::Tri3, conn: &mesh.conn }];
    let contact = contact_force(&mesh.coords, &blocks, Bodies::Connected, &exact()).unwrap();
    assert_eq!(contact.bodies.iter().map(|b| b.id).collect::<Vec<_>>(), [0, 1, 2, 3]);
    assert!((contact.volume - 3.0 * 0.1 * 0.9).abs() < 1e-14);
}
