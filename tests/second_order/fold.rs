//! A curved strip bent to a U whose arms touch, one body against itself, beside its arms as two bodies.

use crate::scene::{Scene, distance, norm, table::exactly};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, ContactForces, EnergyLaw, Estimator, FiberOptions, Options, Resolution};
use fmc_shapes::{Mesh, patch_quad4, second_order};
use std::f64::consts::PI;

/// Half of the distance between the arms at their ends, their thickness and length.
const HALF: f64 = 0.5;
const THICK: f64 = 0.4;
const LENGTH: f64 = 4.0;
/// Cells along an arm and along the bend.
const ARM: usize = 16;
const BEND: usize = 12;

/// How far each arm bulges to the other, without deformation and where they touch.
const BULGES: [f64; 2] = [0.1, 0.53];

/// Place at `u` along the strip, in cells, and `v` across it, inwards: up the left arm is 0 to [`ARM`], then the bend, then down
/// the right arm.
fn place([u, v]: [f64; 2], bulge: f64) -> [f64; 2] {
    let (arm, bend) = (ARM as f64, BEND as f64);
    let outwards = THICK * (1.0 - v);
    if u > arm && u < arm + bend {
        let (s, c) = (PI * (u - arm) / bend).sin_cos();
        return [-(HALF + outwards) * c, LENGTH + (HALF + outwards) * s];
    }
    let (along, side) = if u <= arm { (u / arm, -1.0) } else { ((arm + arm + bend - u) / arm, 1.0) };
    // Level at the bend, so that the strip has no corner there.
    let bulge = bulge * (PI * along).sin().powi(2);
    [side * (HALF + outwards - bulge), LENGTH * along]
}

/// Cells from `first` to `last` along the strip, by places along and across.
fn strip(first: usize, last: usize, nodes_per_cell: usize) -> Mesh<2> {
    // Counter-clockwise, as the strip runs clockwise.
    let straight = patch_quad4([last - first, 2], |u, v| [first as f64 + (last - first) as f64 * u, 1.0 - v]);
    let straight = if nodes_per_cell == 6 { straight.triangulated() } else { straight };
    second_order(&straight, nodes_per_cell)
}

/// Bodies at rest, all nodes on the curves, and where they are when they touch.
struct Bent {
    contact: Contact<2>,
    touching: Vec<[f64; 2]>,
}

impl Bent {
    fn new(along: &Scene<2>, options: Options) -> Self {
        let at = |bulge: f64| along.clone().mapped(|x| place(x, bulge));
        Self { contact: at(BULGES[0]).contact(options), touching: at(BULGES[1]).coords }
    }

    fn evaluate(&self) -> ContactForces<2> {
        self.contact.evaluate(&self.touching).expect("forces")
    }
}

fn all_options() -> Vec<Options> {
    let lines = FiberOptions { resolution: Resolution::Spacing(0.002), seed: 5, ..FiberOptions::default() };
    let sampled = |law| Options { estimator: Estimator::Fibers(lines), ..Options::new(law) };
    let [volume, fiber] = [EnergyLaw::volume(1.0), EnergyLaw::fiber(5.0)];
    vec![exactly(volume), sampled(volume), exactly(fiber), sampled(fiber), exactly(EnergyLaw::depth(5.0))]
}

/// The arms are the strip without its bend, which touches nothing. The law `depth` measures two bodies on their curves, and a body against
/// itself on straight facets, which lie h²/72R = 5e-5 beside them here.
#[test]
fn a_curved_fold_is_like_two_bodies() {
    for nodes in [6, 8, 9] {
        let whole = Scene::of(&[&strip(0, 2 * ARM + BEND, nodes)]);
        let two = Scene::of(&[&strip(0, ARM, nodes), &strip(ARM + BEND, 2 * ARM + BEND, nodes)]);
        let of_whole = |x: &[f64; 2]| whole.coords.iter().position(|y| distance(&[*x], &[*y]) < 1e-9);
        let same: Vec<usize> = two.coords.iter().map(|x| of_whole(x).expect("a node of the strip")).collect();
        for options in all_options() {
            let expected = Bent::new(&two, options).evaluate();
            let found = Bent::new(&whole, Options { self_contact: true, ..options }).evaluate();
            assert_eq!((found.pairs[0].a, found.pairs[0].b), (Partner::Body(0), Partner::Body(0)));
            assert_eq!((found.pairs.len(), found.bodies.len()), (1, 1));
            // Some cells of either arm, and no more.
            assert!(expected.volume > 1e-2 && expected.volume < 0.1);
            let forces: Vec<_> = same.iter().map(|&node| found.forces[node]).collect();
            let (off, size) = (distance(&forces, &expected.forces), norm(&expected.forces));
            let elsewhere = norm(&found.forces).powi(2) - norm(&forces).powi(2);
            let what = format!("{nodes} {options:?}");
            let within = if matches!(options.law, EnergyLaw::Depth { .. }) { 1e-3 } else { 1e-12 };
            assert!(
                off < within * size && elsewhere.abs() < 1e-12 * size * size,
                "{what}: {off} of {size}, {elsewhere}"
            );
            assert!((found.energy / expected.energy - 1.0).abs() < within, "{what}");
        }
    }
}
