//! Ties that are made, refused, released, and found again on another mesh without deformation.

use crate::scene::Scene;
use crate::{K, in_the_plane, tied};
use fmc_contact::contact::{GradientRequest, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::overlap::Warning;
use fmc_contact::{EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;

#[test]
fn what_cannot_be_tied_is_refused_and_changes_nothing() {
    let scene = &in_the_plane(0.2)[0];
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0]) }).expect("an obstacle");
    let mut refused = |partners, options| contact.set_pair_options(partners, Some(options)).expect_err("no tie");
    let apart = refused([Body(0), Body(1)], PairOptions::tied(0.1));
    let Error::Untied { bodies: [0, 1], distances: [reach, nearest], .. } = apart else { panic!("{apart}") };
    assert!(reach == 0.1 && (nearest - 0.2).abs() < 1e-12, "{apart}");
    let named = ["within 1.0000e-1", "2.0000e-1 apart"];
    assert!(named.iter().all(|part| apart.to_string().contains(part)), "{apart}");
    // A tenth of edges of 1/2.
    let by_default = refused([Body(1), Body(0)], PairOptions::tied(0.0));
    assert!(matches!(by_default, Error::Untied { bodies: [0, 1], distances: [0.05, _], .. }), "{by_default}");
    for options in [PairOptions::tied(-0.1), PairOptions::tied(f64::NAN), PairOptions::tied(f64::INFINITY)] {
        assert!(matches!(refused([Body(0), Body(1)], options), Error::OfPair { .. }));
    }
    let offset = PairOptions { gap_offset: -0.1, ..PairOptions::tied(0.3) };
    for (partners, options) in [
        ([Body(0), Rigid(0)], PairOptions::tied(0.3)),
        ([Body(0), Body(0)], PairOptions::tied(0.3)),
        ([Body(0), Body(1)], offset),
        // What would have no effect.
        ([Body(0), Body(1)], PairOptions { excluded: true, ..PairOptions::tied(0.3) }),
        ([Body(0), Body(1)], PairOptions { friction_coefficient: Some(0.3), ..PairOptions::tied(0.3) }),
    ] {
        assert!(matches!(refused(partners, options), Error::OfPair { .. }));
    }
    // The law volume has no stiffness by area: such a tie would hold nothing.
    let by_volume = PairOptions { law: Some(EnergyLaw::volume(K)), ..PairOptions::tied(0.3) };
    assert!(matches!(refused([Body(0), Body(1)], by_volume), Error::OfPair { .. }));
    assert_eq!(contact.tie([0, 1]), Ok(None));
    assert_eq!(contact.pair_options([Body(0), Body(1)]), Ok(None));
    assert!(contact.tie_nodes(&scene.coords).expect("no nodes").is_empty());
}

/// What is tied is in no contact; what is released is again, and all other pairs are as without the tie, to the bit.
#[test]
fn a_tie_takes_the_place_of_the_contact() {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.0, 0.49], [1.0, 1.0], [3, 1]);
    let third = rectangle_quad4([0.2, 0.98], [0.8, 1.4], [2, 1]);
    let scene = Scene::of(&[&below, &above, &third]);
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    let before = contact.evaluate(&scene.coords).expect("an evaluation");
    assert_eq!(before.pairs.len(), 2);
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(0.0))).expect("a tie");
    let tied = contact.evaluate(&scene.coords).expect("an evaluation");
    assert_eq!(tied.pairs.len(), 2);
    assert!(tied.pairs[0].energy < 1e-24 && tied.pairs[0].penetration == 0.0);
    assert_eq!(tied.pairs[1], before.pairs[1]);
    contact.set_pair_options([Body(0), Body(1)], None).expect("options");
    assert_eq!(contact.evaluate(&scene.coords).expect("an evaluation"), before);
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::excluded())).expect("options");
    assert_eq!(contact.evaluate(&scene.coords).expect("an evaluation").pairs.len(), 1);
}

/// A tie is that of the reference coordinates in force, whatever came first.
#[test]
fn the_order_of_calls_does_not_matter() {
    let scene = &in_the_plane(0.0)[1];
    let apart: Vec<_> = scene.coords.iter().map(|x| if x[1] > 0.5 { [x[0], x[1] + 0.2] } else { *x }).collect();
    let wide: Vec<_> = scene.coords.iter().map(|x| [1.5 * x[0], x[1]]).collect();
    let shifted: Vec<_> = scene.coords.iter().map(|x| [x[0] + 0.01 * x[1], x[1] + 0.02 * x[0] * x[1]]).collect();
    let mut late = tied(scene, 0.0);
    late.set_reference(&wide).expect("a reference");
    let mut early = scene.contact(Options::new(EnergyLaw::depth(K)));
    early.set_reference(&wide).expect("a reference");
    early.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(0.0))).expect("a tie");
    assert_eq!(early.evaluate(&shifted), late.evaluate(&shifted));
    assert_eq!(early.tie([0, 1]).expect("bodies").expect("a tie").area, 1.5);
    // Without the upper body's lower nodes nothing is left of the tie: every evaluation says so.
    let mut torn = tied(scene, 0.0);
    let lifted: Vec<_> = (0..)
        .zip(&apart)
        .map(|(node, x)| if node >= scene.first_node[1] && x[1] == 0.5 { [x[0], 0.6] } else { *x })
        .collect();
    torn.set_reference(&lifted).expect("a reference");
    assert!(matches!(torn.evaluate(&shifted), Err(Error::Untied { bodies: [0, 1], .. })));
    assert!(matches!(torn.tie([0, 1]), Err(Error::Untied { .. })));
    torn.set_reference(&scene.coords).expect("a reference");
    assert_eq!(torn.evaluate(&shifted), tied(scene, 0.0).evaluate(&shifted));
    // With axisymmetry lengths are rings.
    let axisymmetric = Options { axisymmetric: true, ..Options::new(EnergyLaw::depth(K)) };
    torn.set_options(axisymmetric).expect("options");
    let mut rings = scene.contact(axisymmetric);
    rings.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(0.0))).expect("a tie");
    assert_eq!(torn.evaluate(&shifted), rings.evaluate(&shifted));
}

/// A gap within reach is kept or bridged where faces are nearer than the reach, in a wedge only there.
#[test]
fn a_wedge_is_tied_as_far_as_it_is_within_reach() {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [4, 1]);
    let above = rectangle_quad4([0.0, 0.5], [1.0, 1.0], [3, 1]).mapped(|[x, y]| [x, y + 0.1 * x * (1.0 - y) / 0.5]);
    let scene = Scene::of(&[&below, &above]);
    let tie = tied(&scene, 0.04).tie([0, 1]).expect("bodies").expect("a tie");
    assert!((tie.area - 0.4).abs() < 0.4 * 0.01 && (0.035..0.04).contains(&tie.largest_gap), "{tie:?}");
}

/// What hosts differentiate: by coordinates with the tie, and by nothing else that a tie has a part in.
#[test]
fn gradients_have_the_tie_or_are_refused() {
    let scene = &in_the_plane(0.03)[1];
    let contact = tied(scene, 0.1);
    let coords: Vec<_> = scene.coords.iter().map(|x| [x[0] + 0.02 * x[1], x[1] + 0.03 * x[0] * x[1]]).collect();
    let by_coords = GradientRequest { coords: true, ..GradientRequest::default() };
    let found = contact.vjp(&coords, 1.0, None, &by_coords).expect("a gradient");
    let forces = contact.evaluate(&coords).expect("an evaluation").forces;
    let off = found.coords.iter().zip(&forces).flat_map(|(g, f)| (0..2).map(|i| (g[i] + f[i]).abs()));
    assert!(off.fold(0.0, f64::max) < 1e-12 * K && forces.iter().flatten().any(|f| f.abs() > 1e-4 * K));
    let adjoint: Vec<_> = coords.iter().map(|x| [x[1], -0.3 * x[0]]).collect();
    let found = contact.vjp(&coords, 0.0, Some(&adjoint), &by_coords).expect("a gradient");
    let product = contact.tangent(&coords, TangentPart::Full).expect("a tangent").product(&adjoint);
    let off = found.coords.iter().zip(&product).flat_map(|(g, p)| (0..2).map(|i| (g[i] + p[i]).abs()));
    assert!(off.fold(0.0, f64::max) < 1e-12 * K);
    for request in [
        GradientRequest { reference: true, ..by_coords },
        GradientRequest { stiffness: true, ..by_coords },
        GradientRequest { gap_offsets: true, ..by_coords },
        GradientRequest { friction: true, ..by_coords },
    ] {
        assert!(matches!(contact.vjp(&coords, 1.0, None, &request), Err(Error::Unsupported { .. })));
    }
}

/// Multipliers that are set, or taken away, are all there are: those of ties go, too. The law cannot become one that holds nothing.
#[test]
fn multipliers_of_ties_are_released_with_all_others() {
    let scene = &in_the_plane(0.0)[1];
    let mut contact = tied(scene, 0.0);
    let start = scene.first_node[1];
    let mut coords = scene.coords.clone();
    coords[start..].iter_mut().for_each(|x| x[1] += 1e-3);
    let before = contact.evaluate(&coords).expect("an evaluation");
    assert!(!contact.augment(&coords, 0.0, 1e-9).expect("an update").is_enough);
    let after = contact.evaluate(&coords).expect("an evaluation");
    assert!((after.bodies[0].force[1] - 2.0 * before.bodies[0].force[1]).abs() < 1e-9 * K);
    contact.set_multipliers(&[]).expect("none");
    assert_eq!(contact.evaluate(&coords).expect("an evaluation"), before);
    assert!(contact.set_options(Options::new(EnergyLaw::volume(K))).is_err());
    assert_eq!(contact.evaluate(&coords).expect("an evaluation"), before);
}

/// A gap that is the reach but for rounding is within it.
#[test]
fn a_gap_as_large_as_the_reach_is_tied() {
    for (at, gap) in [(0.5, 0.1), (0.3, 0.3), (1e3, 0.1)] {
        let below = rectangle_quad4([0.0, at - 1.0], [1.0, at], [2, 1]);
        let above = rectangle_quad4([0.0, at + gap], [1.0, at + gap + 1.0], [3, 1]);
        let mut contact = Scene::of(&[&below, &above]).contact(Options::new(EnergyLaw::depth(K)));
        contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(gap))).expect("a tie");
        let tie = contact.tie([0, 1]).expect("bodies").expect("a tie");
        // As far as rounding of the coordinates lets the gap be known.
        assert!((tie.area - 1.0).abs() < 1e-12 && (tie.largest_gap - gap).abs() < 1e-12 * at, "{tie:?}");
    }
}

/// Below a face that rises by 0.4 over its length of 1, a reach of 0.1 ties a quarter: the rest is told, and with a larger reach there is none.
#[test]
fn faces_that_are_tied_in_part_are_told() {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [1, 1]);
    let mut above = rectangle_quad4([0.0, 1.0], [1.0, 2.0], [1, 1]);
    above.coords.iter_mut().filter(|x| x[0] == 1.0 && x[1] == 1.0).for_each(|x| x[1] = 1.4);
    let scene = Scene::of(&[&below, &above]);
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(0.1))).expect("a tie");
    let found = contact.evaluate(&scene.coords).expect("an evaluation").warnings;
    let [Warning::TiedInPart { a: Body(0), b: Body(1), tied, left_out, distances: [reach, farthest] }] = found[..]
    else {
        panic!("{found:?}")
    };
    // Gaps are measured across the face that holds, the slanted one: a part of it that is as long as its normal is steep.
    let whole = tied + left_out;
    assert!(((1.0..1.1).contains(&whole)) && (tied / whole - 0.25).abs() < 0.05, "{found:?}");
    assert!(reach == 0.1 && (0.3..0.41).contains(&farthest), "{found:?}");
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(0.5))).expect("a tie");
    assert!(contact.evaluate(&scene.coords).expect("an evaluation").warnings.is_empty());
}
