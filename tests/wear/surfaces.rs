//! Worn surfaces: what contact makes of them, and what it does not.

use crate::scene::Scene;
use crate::scene::energy_gradient::Differences;
use crate::{DELTA, WEAR, in_plane, in_space, laws, moved, on_a_plane, wearing};
use fmc_contact::contact::PairOptions;
use fmc_contact::contact::TangentPart;
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, Options, Pose};
use fmc_shapes::{Splitmix, rectangle_quad4};

/// A contact in mid-wear, and where its next step begins.
fn worn<const D: usize>(scene: &Scene<D>, options: Options) -> (Contact<D>, Vec<[f64; D]>) {
    let mut contact = wearing(scene, options);
    contact.begin_step(&scene.coords).expect("a step");
    for step in 1..=3 {
        contact.commit_step(&moved(scene, 1, [0.3 * f64::from(step), 0.0])).expect("a step");
    }
    let depth = contact.wear().expect("a step").depth.into_iter().fold(0.0, f64::max);
    assert!(depth > 0.1 * DELTA && depth < DELTA, "{depth}");
    (contact, moved(scene, 1, [0.9, 0.0]))
}

/// Surfaces lie fixed beside their nodes within a step: forces are the gradient of the energy, and the tangent theirs.
fn derivatives<const D: usize>(scene: &Scene<D>, options: Options) {
    let (contact, mut coords) = worn(scene, options);
    let mut random = Splitmix::new(3);
    coords.iter_mut().flatten().for_each(|x| *x += 0.05 * DELTA * random.between(-1.0, 1.0));
    // Energies of 1e-4 round by 1e-16, by steps of 1e-6 and forces of 0.1; kinks lie elsewhere for another step.
    Differences { steps: &[3e-7, 1e-6, 3e-6], tolerance: 1e-6, loaded: 3, others: 0 }.check(&contact, &coords);
    let tangent = contact.tangent(&coords, TangentPart::Full).expect("a tangent");
    let way: Vec<[f64; D]> = coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
    let at = |h: f64| -> Vec<f64> {
        let moved: Vec<[f64; D]> =
            coords.iter().zip(&way).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
        contact.evaluate(&moved).expect("forces").forces.into_iter().flatten().collect()
    };
    let (plus, minus, product) = (at(1e-9), at(-1e-9), tangent.product(&way));
    let largest = product.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    for ((p, m), product) in plus.iter().zip(&minus).zip(product.iter().flatten()) {
        let slope = (m - p) / 2e-9;
        // Differences of forces of 0.1 that round by 1e-16, by 1e-9, of 1e3.
        assert!((slope - product).abs() < 1e-5 * largest, "{slope} {product} {largest}");
    }
}

#[test]
fn forces_and_tangent_are_those_of_one_energy() {
    let options = laws(0.0)[0];
    in_plane().iter().for_each(|scene| derivatives(scene, options));
    in_space().iter().for_each(|scene| derivatives(scene, options));
}

/// Both bodies turned as one, after wear: the worn surface turns, forces too, and nothing slips.
#[test]
fn worn_surfaces_turn_with_the_bodies() {
    for options in laws(0.3) {
        let scene = &in_plane()[0];
        let (mut contact, coords) = worn(scene, options);
        let [before, wear] = [contact.evaluate(&coords), contact.evaluate(&coords)].map(|found| found.expect("forces"));
        assert_eq!(before.forces, wear.forces);
        let depth = contact.wear().expect("a step");
        let (mut sine, mut cosine) = (0.0, 1.0);
        for step in 1..=9 {
            (sine, cosine) = (0.1 * f64::from(step)).sin_cos();
            let turned: Vec<[f64; 2]> =
                coords.iter().map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y]).collect();
            contact.commit_step(&turned).expect("a step");
        }
        let turned: Vec<[f64; 2]> =
            coords.iter().map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y]).collect();
        let after = contact.evaluate(&turned).expect("forces").forces;
        let largest = before.forces.iter().flatten().fold(0.0f64, |most, f| most.max(f.abs()));
        for ([x, y], f) in before.forces.iter().zip(&after) {
            let expected = [cosine * x - sine * y, sine * x + cosine * y];
            // The surface turns where steps begin: by a tenth of a turn less within one, of a depth of 1e-3, and then not at all.
            assert!((f[0] - expected[0]).hypot(f[1] - expected[1]) < 1e-2 * largest, "{f:?} {expected:?}");
        }
        let now = contact.wear().expect("a step");
        for (one, other) in depth.depth.iter().zip(&now.depth) {
            // Within a step that turns, the worn surface lies aside by its depth times the angle: a slip of a few percent of that.
            assert!((one - other).abs() < 2e-3 * DELTA, "{one} {other}");
        }
    }
}

/// The same bits as without wear, until a step is accepted, and of bodies without coefficients ever.
#[test]
fn nothing_changes_where_nothing_wears() {
    for options in laws(0.3) {
        let scene = &in_space()[1];
        let mut contacts = [wearing(scene, options), scene.contact(options), scene.contact(options)];
        let pair = [Partner::Body(0), Partner::Body(1)];
        contacts[2].set_pair_options(pair, Some(PairOptions::with_wear([0.0; 2]))).expect("a pair");
        let coords = moved(scene, 1, [0.02, 0.0]);
        let found = contacts.each_mut().map(|contact| {
            contact.begin_step(&scene.coords).expect("a step");
            contact.evaluate_tangent(&coords, TangentPart::Full).map(|found| format!("{found:?}")).expect("forces")
        });
        assert!(found[0] == found[1] && found[1] == found[2]);
        let after = contacts.each_mut().map(|contact| {
            contact.commit_step(&coords).expect("a step");
            format!("{:?} {:?}", contact.evaluate(&coords), contact.tangent(&coords, TangentPart::Full))
        });
        assert!(after[0] != after[1] && after[1] == after[2]);
        assert!(contacts[2].wear().expect("no wear").depth.iter().all(|depth| *depth == 0.0));
    }
}

/// What sticks does not wear, and a step that is not accepted neither.
#[test]
fn neither_stick_nor_a_rejected_step_wears() {
    for options in laws(0.3) {
        let scene = &in_plane()[0];
        let mut contact = wearing(scene, options);
        contact.begin_step(&scene.coords).expect("a step");
        for part in [0.5, 0.9, -0.9] {
            contact.commit_step(&moved(scene, 1, [0.3 * DELTA * part, 0.0])).expect("a step");
        }
        assert_eq!(contact.wear().expect("a step").volumes, [0.0; 2]);
        assert!(contact.worn_facets().is_empty());
        contact.evaluate(&moved(scene, 1, [0.1, 0.0])).expect("forces");
        assert!(contact.worn_facets().is_empty());
        contact.commit_step(&moved(scene, 1, [0.1, 0.0])).expect("a step");
        assert!(!contact.worn_facets().is_empty());
    }
}

/// A pin that is tied to its holder: its worn end does not pull at the tie.
#[test]
fn ties_do_not_feel_wear() {
    let pin = rectangle_quad4([0.0, -DELTA], [1.0, 0.25], [4, 1]);
    let holder = rectangle_quad4([0.0, 0.25], [1.0, 1.0], [3, 2]);
    let scene = Scene::of(&[&pin, &holder]);
    let mut contact = on_a_plane(&scene, laws(0.0)[0]);
    let pair = [Partner::Body(0), Partner::Body(1)];
    contact.set_pair_options(pair, Some(PairOptions::tied(0.0))).expect("a tie");
    contact.begin_step(&scene.coords).expect("a step");
    contact.set_pose(0, Pose::at([1.0, 0.0])).expect("the plane");
    contact.commit_step(&scene.coords).expect("a step");
    let worn = contact.wear().expect("a step").depth.into_iter().fold(0.0, f64::max);
    assert!((worn - WEAR[0] * 1e3 * DELTA).abs() < 1e-12);
    let forces = contact.evaluate(&scene.coords).expect("forces").forces;
    for node in scene.nodes_of(1) {
        assert!(forces[node].iter().all(|f| f.abs() < 1e-12), "{:?}", forces[node]);
    }
}
