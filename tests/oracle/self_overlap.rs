//! A body folded over itself: where its cells cover a place twice, it overlaps itself.

use crate::membership::{cover, thrown};
use crate::scene::table::{by_laws, laws};
use crate::scene::{Scene, distance, exact, fibers, lines, norm};
use fmc_contact::overlap::Partner;
use fmc_contact::{Estimator, FiberOptions, Options};
use fmc_shapes::{Mesh, cuboid_tet4, patch_quad4};
use std::f64::consts::TAU;

/// A strip 0.3 wide along a circle of radius 1 that goes a little more than once around, rising by `rise`: its end
/// crosses over its beginning.
fn loop_strip(cells: usize, turns: f64, rise: f64) -> Mesh<2> {
    patch_quad4([cells, 3], |u, v| {
        let radius = 1.15 - 0.3 * v + rise * u;
        let (s, c) = (TAU * turns * u).sin_cos();
        // Counter-clockwise along u, inwards along v.
        [radius * c, radius * s]
    })
}

fn with_self_contact(options: Options) -> Options {
    Options { self_contact: true, ..options }
}

/// Σ over pairs of covers: 1 where a point is covered twice.
fn pairs_of(covers: usize) -> usize {
    covers * covers.saturating_sub(1) / 2
}

#[test]
fn strip_that_ends_on_its_beginning() {
    for (rise, turns) in [(0.0, 1.1), (0.13, 1.13), (-0.1, 1.2)] {
        let strip = loop_strip(40, turns, rise).triangulated();
        let scene = Scene::of(&[&strip]);
        assert_eq!(scene.evaluate(exact()).volume, 0.0);
        let by_clipping = scene.evaluate(with_self_contact(exact()));
        let [volume, error] = thrown([[-1.6; 2], [1.6; 2]], 400_000, 1, |x| pairs_of(cover(&strip, x)));
        assert!((by_clipping.volume - volume).abs() < 4.0 * error, "{} against {volume} ± {error}", by_clipping.volume);
        let pair = &by_clipping.pairs[0];
        assert_eq!((pair.a, pair.b), (Partner::Body(0), Partner::Body(0)));
        // Some 300 lines per family in the overlap.
        let by_lines = scene.evaluate(with_self_contact(lines(0.001, 2)));
        assert!((by_lines.volume / by_clipping.volume - 1.0).abs() < 2e-3);
        assert!(distance(&by_lines.forces, &by_clipping.forces) < 2e-2 * norm(&by_clipping.forces));
    }
}

/// Two blocks joined by a bridge of cells that goes around: the same blocks as bodies of their own overlap as much.
#[test]
fn body_against_itself_is_like_two_bodies() {
    let lower = cuboid_tet4([0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [4, 2, 2]);
    let upper = cuboid_tet4([0.0, 0.0, 0.9], [1.0, 1.0, 1.9], [2, 2, 2]).translated([0.1, 0.05, 0.0]);
    let two = Scene::of(&[&lower, &upper]);
    // One body by its id, though its parts do not hang together.
    let mut one = two.clone();
    one.ids.fill(7);
    // Depth is that of pieces that are apart, else the surface of the one would lie within the other.
    let mut apart = two.coords.clone();
    apart[two.nodes_of(1)].iter_mut().for_each(|x| x[2] += 5.0);
    let evaluate = |scene: &Scene<3>, options: Options| {
        let mut contact = scene.contact(options);
        contact.set_reference(&apart).unwrap();
        contact.evaluate(&scene.coords).unwrap()
    };
    for options in by_laws([exact(), lines(0.02, 3)], &laws(1.0)) {
        let (two, one) = (evaluate(&two, options), evaluate(&one, with_self_contact(options)));
        assert!((one.energy / two.energy - 1.0).abs() < 1e-12);
        assert_eq!(one.bodies.len(), 1);
        // The lines are the same, but the momentum correction and the sums run otherwise.
        assert!((one.volume / two.volume - 1.0).abs() < 1e-12);
        let tolerance = if options.estimator == Estimator::Exact { 1e-12 } else { 1e-3 };
        assert!(distance(&one.forces, &two.forces) < tolerance * norm(&two.forces));
    }
}

/// An ordinary body does not overlap itself, at any of its inner faces.
#[test]
fn body_in_one_piece_does_not_overlap_itself() {
    let strip = loop_strip(40, 0.9, 0.1);
    let cube = cuboid_tet4([0.0; 3], [1.0; 3], [3; 3]).jittered(0.2, 1, |_| true).rotated([1.0, 2.0, 3.0], 0.3);
    for options in by_laws([exact(), fibers(FiberOptions::default())], &laws(1.0)) {
        let options = with_self_contact(options);
        let flat = Scene::of(&[&strip]).evaluate(options);
        assert!(flat.volume == 0.0 && norm(&flat.forces) == 0.0, "{options:?}: {:e}", flat.volume);
        let solid = Scene::of(&[&cube]).evaluate(options);
        assert!(solid.volume == 0.0 && norm(&solid.forces) == 0.0, "{options:?}: {:e}", solid.volume);
    }
}

/// Self-contact and contact with others go on side by side.
#[test]
fn folded_strip_against_another_body() {
    let strip = loop_strip(40, 1.1, 0.1).triangulated();
    let block = cuboid(0.9);
    let both = Scene::of(&[&strip, &block]).evaluate(with_self_contact(exact()));
    let alone = Scene::of(&[&strip]).evaluate(with_self_contact(exact()));
    let other = Scene::of(&[&strip, &block]).evaluate(exact());
    assert_eq!(both.pairs.len(), 2);
    assert!((both.volume - alone.volume - other.volume).abs() < 1e-14);
}

fn cuboid(y: f64) -> Mesh<2> {
    fmc_shapes::rectangle_tri3([-0.3, y], [0.4, y + 1.0], [3, 3], fmc_shapes::Diagonals::Same)
}
